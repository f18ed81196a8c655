// XML of others, before TinyXML reads it.
#pragma once

#include <tinyxml.h>

#include <string>
#include <string_view>

namespace lasius::arm {

/// The parser recurses, as deep as elements nest, compares each attribute with all others of its
/// tag, ends at a zero byte, and what follows the first element is read by none. @throws
/// Error(file_broken) with the line, where that would hurt.
void check_xml(std::string_view text, const std::string& file);

/// @throws Error(file_unsupported) with the line where elements or attributes are xacro's, from
/// which a file of this ending is made. What is in <gazebo> is not looked at.
void refuse_xacro(const TiXmlElement& root, const std::string& file, const std::string& ending);

inline std::string in_quotes(const std::string& name) { return '"' + name + '"'; }

/// Calls visit(child) for the elements right in this one that have the tag.
template <class Visit>
void each_child(const TiXmlElement& element, const char* tag, const Visit& visit) {
  for (const TiXmlElement* at = element.FirstChildElement(tag); at != nullptr;
       at = at->NextSiblingElement(tag)) {
    visit(*at);
  }
}

/// Empty where there is no such element or attribute.
inline std::string attribute(const TiXmlElement* element, const char* name) {
  const char* const value = element != nullptr ? element->Attribute(name) : nullptr;
  return value != nullptr ? value : "";
}

}  // namespace lasius::arm
