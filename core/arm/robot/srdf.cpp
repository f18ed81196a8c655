#include "core/arm/robot/srdf.h"

#include <cmath>

#include "core/arm/robot/refusals.h"
#include "core/arm/robot/xml_text.h"
#include "core/base/file_kind.h"
#include "core/base/number_text.h"
#include "core/map_files/byte_reader.h"

namespace lasius::arm {
namespace {

class Reader {
 public:
  Reader(const std::string& file, const std::vector<std::string_view>& links,
         const std::vector<std::string_view>& joints)
      : file_(file), links_(links), joints_(joints) {}

  Srdf read(const TiXmlElement& root) {
    found_.robot = attribute(&root, "name");
    each_child(root, "disable_default_collisions", [&](const TiXmlElement& at) {
      found_.disabled_links.insert(named(at, "link", links_));
    });
    for (auto* pairs : {&found_.disabled, &found_.enabled}) {
      const bool off = pairs == &found_.disabled;
      each_child(root, off ? "disable_collisions" : "enable_collisions",
                 [&](const TiXmlElement& at) {
                   const std::string a = named(at, "link1", links_), b = named(at, "link2", links_);
                   pairs->emplace(std::min(a, b), std::max(a, b));
                 });
    }
    each_child(root, "group_state", [&](const TiXmlElement& at) { add_state(at); });
    return std::move(found_);
  }

 private:
  Error::Place place(const TiXmlElement& at) const { return {.file = file_, .line = at.Row()}; }

  std::string text(const TiXmlElement& at, const char* name) const {
    std::string value = attribute(&at, name);
    if (value.empty())
      broken(place(at), "<" + at.ValueStr() + "> has no " + name,
             std::string("write it as ") + name + "=\"...\"");
    return value;
  }
  /// A name, which is kept where none of the robot's is that.
  std::string named(const TiXmlElement& at, const char* name,
                    const std::vector<std::string_view>& names) {
    std::string value = text(at, name);
    if (std::ranges::find(names, value) == names.end()) found_.unknown.insert(value);
    return value;
  }
  void add_state(const TiXmlElement& at) {
    Srdf::State state{text(at, "name"), attribute(&at, "group"), {}};
    each_child(at, "joint", [&](const TiXmlElement& joint) {
      const std::string name = named(joint, "name", joints_), value = text(joint, "value");
      const auto number = number_of<double>(value);
      if (!number || !std::isfinite(*number))
        broken(place(joint), "the value \"" + value + "\" of joint \"" + name + "\" is no number",
               "give one number");
      state.values[name] = *number;
    });
    found_.states.push_back(std::move(state));
  }

  const std::string& file_;
  const std::vector<std::string_view>&links_, &joints_;
  Srdf found_;
};

}  // namespace

Srdf read_srdf(const std::string& file, const std::vector<std::string_view>& links,
               const std::vector<std::string_view>& joints) {
  constexpr std::int64_t kMostBytes = 4 << 20;
  const std::string text = read_text(file, kMostBytes);
  constexpr const char* kRemedy =
      "give the SRDF file of the robot, as MoveIt's assistant writes it";
  refuse_other_kinds(text, file, {FileKind::srdf, FileKind::urdf}, kRemedy);
  check_xml(text, file);
  TiXmlDocument document;
  document.Parse(text.c_str());
  if (document.Error())
    broken({.file = file, .line = document.ErrorRow()},
           std::string("this is no XML (") + document.ErrorDesc() + ")", "correct it");
  const TiXmlElement* const root = document.FirstChildElement("robot");
  if (root == nullptr) broken({.file = file}, "there is no <robot>", kRemedy);
  refuse_xacro(*root, file, "srdf");
  for (const char* const tag : {"link", "joint"}) {
    if (const TiXmlElement* const at = root->FirstChildElement(tag))
      unsupported({.file = file, .line = at->Row()}, "this is " + told(FileKind::urdf), kRemedy);
  }
  return Reader(file, links, joints).read(*root);
}

}  // namespace lasius::arm
