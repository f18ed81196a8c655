#include "core/arm/robot/xml_text.h"

#include <algorithm>
#include <deque>
#include <utility>

#include "core/arm/robot/refusals.h"
#include "core/base/text_lines.h"

namespace lasius::arm {
namespace {

/// The end of the tag that the text begins with, what stands in quotes left out; npos for none.
std::size_t end_of_tag(std::string_view text) {
  auto at = text.find_first_of("\"'>");
  while (at != text.npos && text[at] != '>') {
    at = text.find(text[at], at + 1);
    if (at != text.npos) at = text.find_first_of("\"'>", at + 1);
  }
  return at;
}

}  // namespace

void check_xml(std::string_view text, const std::string& file) {
  constexpr int kDeepest = 256;
  constexpr std::size_t kLongestTag = 8192;
  if (const auto zero = text.find('\0'); zero != text.npos)
    broken({.file = file, .line = line_at(text, zero)}, "there is a zero byte",
           "leave it out: XML is text");
  int depth = 0;
  bool rooted = false;
  for (auto at = text.find('<'); at < text.size(); at = text.find('<', at + 1)) {
    const auto tag = text.substr(at);
    if (tag.starts_with("<!--")) {
      at = text.find("-->", at);
    } else if (tag.starts_with("<![CDATA[")) {
      at = text.find("]]>", at);
    } else if (tag.starts_with("</")) {
      depth = std::max(0, depth - 1);
    } else if (!tag.starts_with("<?") && !tag.starts_with("<!")) {
      const auto end = end_of_tag(tag);
      if (end == tag.npos) return;
      if (end > kLongestTag)
        broken({.file = file, .line = line_at(text, at)}, "a tag is too long",
               "none has more than " + std::to_string(kLongestTag) + " bytes");
      if (depth == 0 && std::exchange(rooted, true))
        broken({.file = file, .line = line_at(text, at)}, "a second document follows the first",
               "keep one document a file");
      if (tag[end - 1] != '/') ++depth;
      at += end;
    }
    if (at == text.npos) return;
    if (depth > kDeepest)
      broken({.file = file, .line = line_at(text, at)}, "elements nest too deep",
             "none goes deeper than " + std::to_string(kDeepest));
  }
}

void refuse_xacro(const TiXmlElement& root, const std::string& file, const std::string& ending) {
  const auto refuse_at = [&](int row) {
    unsupported({.file = file, .line = row},
                "this is a xacro file, from which " + ending + " is made",
                "make it first: xacro " + file + " > robot." + ending);
  };
  std::deque<const TiXmlElement*> open{&root};
  for (; !open.empty(); open.pop_front()) {
    const TiXmlElement& element = *open.front();
    if (element.ValueStr().starts_with("xacro:")) refuse_at(element.Row());
    for (const TiXmlAttribute* at = element.FirstAttribute(); at != nullptr; at = at->Next()) {
      for (const char* const expression : {"${", "$(arg ", "$(find "})
        if (at->ValueStr().find(expression) != std::string::npos) refuse_at(element.Row());
    }
    for (const TiXmlElement* at = element.FirstChildElement(); at != nullptr;
         at = at->NextSiblingElement())
      if (at->ValueStr() != "gazebo") open.push_back(at);
  }
}

}  // namespace lasius::arm
