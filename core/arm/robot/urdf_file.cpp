#include "core/arm/robot/urdf_file.h"

#include <console_bridge/console.h>
#include <tinyxml.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <exception>
#include <mutex>
#include <set>
#include <thread>
#include <utility>

#include "core/arm/robot/refusals.h"

namespace lasius::arm {
namespace {

constexpr std::size_t kMostLinks = 2000;  // urdfdom lets go of a chain by recursion

/// Catches what urdfdom would print: its first message is our reason, and comes of the part that
/// follows those which it has told to be read.
class UrdfdomMessages final : public console_bridge::OutputHandler {
 public:
  UrdfdomMessages()
      : thread_(std::this_thread::get_id()),
        handler_(console_bridge::getOutputHandler()),
        level_(console_bridge::getLogLevel()) {
    console_bridge::useOutputHandler(this);
    console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_DEBUG);
  }
  UrdfdomMessages(const UrdfdomMessages&) = delete;
  UrdfdomMessages& operator=(const UrdfdomMessages&) = delete;
  ~UrdfdomMessages() override {
    console_bridge::setLogLevel(level_);
    console_bridge::useOutputHandler(handler_);
  }

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (std::this_thread::get_id() != thread_ || !first_.empty())
      return;  // the handler is the program's
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR) first_ = text;
    if (text.starts_with("urdfdom: successfully added a new ")) ++added_;
  }
  const std::string& first() const { return first_; }
  std::size_t added() const { return added_; }  ///< parts before it: materials, links, joints

 private:
  std::thread::id thread_;
  console_bridge::OutputHandler* handler_;
  console_bridge::LogLevel level_;
  std::string first_;
  std::size_t added_ = 0;
};

/// A joint, and the line of its tag.
struct Edge {
  std::string name, parent, child;
  std::int64_t line;
};

/// The joint above each link.
using Above = std::map<std::string_view, const Edge*>;

/// Tells the loop that a joint is in. Precondition: it is in one.
[[noreturn]] void refuse_loop(const Edge& joint, const Above& above, Error::Place place) {
  constexpr int kMostNames = 10;
  const auto next = [&](const Edge* at) { return above.at(at->parent); };
  const Edge* first = &joint;
  for (const Edge* at = next(&joint); at != &joint; at = next(at))
    if (at->line < first->line) first = at;
  std::string names = in_quotes(first->child);
  int count = 1;
  for (const Edge* at = next(first); at != first; at = next(at))
    if (++count <= kMostNames) names.insert(0, in_quotes(at->child) + ", ");
  if (count > kMostNames) names.insert(0, "..., ");
  place.line = first->line;
  broken(place, "the links " + names + " are joined in a loop", "take one of its joints out");
}

/// urdfdom hangs each link on the last joint that names it, and lets links hang on one another.
void check_tree(const std::vector<Edge>& joints, const Error::Place& whole) {
  Above above;
  for (const Edge& joint : joints) {
    Error::Place place = whole;
    place.line = joint.line;
    if (joint.parent == joint.child)
      broken(
          place,
          "joint " + in_quotes(joint.name) + " joins link " + in_quotes(joint.child) + " to itself",
          "name another link as its parent or its child");
    const auto [known, is_new] = above.emplace(joint.child, &joint);
    if (!is_new)
      broken(place,
             "link " + in_quotes(joint.child) + " is the child of two joints, " +
                 in_quotes(known->second->name) + " (line " + std::to_string(known->second->line) +
                 ") and " + in_quotes(joint.name),
             "a link has one parent: take one of the two joints out");
  }
  std::set<std::string_view> hung;  // links that hang on a root
  for (const Edge& joint : joints) {
    std::vector<std::string_view> walk;
    for (const Edge* at = &joint; at != nullptr && !hung.contains(at->child);) {
      if (walk.size() == joints.size()) refuse_loop(*at, above, whole);
      walk.push_back(at->child);
      const auto next = above.find(at->parent);
      at = next == above.end() ? nullptr : next->second;
    }
    hung.insert(walk.begin(), walk.end());
  }
}

}  // namespace

UrdfFile::UrdfFile(std::string_view text, std::string file) : file_(std::move(file)) {
  check_xml(text, file_);
  const std::string copy(text);
  read_xml(copy);
  parse(copy);
}

/// Notes the lines, which urdfdom does not keep, and where the XML is broken. Names given
/// twice are left to urdfdom to tell.
void UrdfFile::read_xml(const std::string& text) {
  TiXmlDocument document;
  document.Parse(text.c_str());
  if (document.Error()) broken_line_ = document.ErrorRow();
  const TiXmlElement* const robot = document.FirstChildElement("robot");
  if (document.Error() || robot == nullptr) return;
  refuse_xacro(*robot, file_, "urdf");
  const std::string version = attribute(robot, "version");
  if (attribute(robot, "name").empty() || (!version.empty() && version != "1.0"))
    part_lines_.push_back(robot->Row());
  each_child(*robot, "material", [&](const TiXmlElement& at) { part_lines_.push_back(at.Row()); });
  each_child(*robot, "link", [&](const TiXmlElement& link) {
    part_lines_.push_back(link.Row());
    links_.emplace(attribute(&link, "name"), link.Row());
  });
  std::vector<Edge> joints;
  bool twice = false;
  each_child(*robot, "joint", [&](const TiXmlElement& joint) {
    joints.push_back({attribute(&joint, "name"),
                      attribute(joint.FirstChildElement("parent"), "link"),
                      attribute(joint.FirstChildElement("child"), "link"), joint.Row()});
    part_lines_.push_back(joint.Row());
    const Edge& edge = joints.back();
    const bool is_new = joints_.emplace(edge.name, edge.line).second;
    twice |= !is_new;
    if (edge.parent.empty() || edge.child.empty())
      broken(line(edge.line),
             "joint " + in_quotes(edge.name) + " has no " +
                 (edge.parent.empty() ? "<parent link=...>" : "<child link=...>"),
             "name the links that it joins");
  });
  if (std::max(links_.size(), joints.size()) > kMostLinks)
    unsupported(whole(), "the robot has too many links",
                "at most " + std::to_string(kMostLinks) + " are read");
  if (!twice) check_tree(joints, whole());
}

void UrdfFile::parse(const std::string& text) {
  static std::mutex one_at_a_time;  // the handler is the program's
  const std::scoped_lock lock(one_at_a_time);
  std::string fault, complaint;
  std::size_t part = 0;
  {
    UrdfdomMessages messages;
    try {
      model_ = urdf::parseURDF(text);
    } catch (const std::exception& e) {
      fault = e.what();
    }
    complaint = messages.first();
    part = messages.added();
  }
  const std::int64_t row =
      broken_line_ < 0 && part < part_lines_.size() ? part_lines_[part] : broken_line_;
  if (model_ == nullptr) {
    if (!fault.empty()) complaint = fault;
    broken(line(row),
           "this is no URDF (" + (complaint.empty() ? "urdfdom does not say why" : complaint) + ")",
           "check it with check_urdf");
  }
  // What the parser cannot read it leaves out: a link would pass through obstacles.
  if (!complaint.empty())
    broken(line(row), "a part of it cannot be read (" + complaint + ")",
           "check it with check_urdf");
}

}  // namespace lasius::arm
