// Whether a YAML text holds one document and nothing behind it: YAML::Load reads the first alone.
// For modules that have yaml-cpp.
#pragma once

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/parser.h>

#include <sstream>
#include <string>

namespace lasius {

/// Takes what a parser finds, and keeps nothing.
class YamlIgnored final : public YAML::EventHandler {
  using Mark = YAML::Mark;
  using Anchor = YAML::anchor_t;
  void OnDocumentStart(const Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const Mark&, Anchor) override {}
  void OnAlias(const Mark&, Anchor) override {}
  void OnScalar(const Mark&, const std::string&, Anchor, const std::string&) override {}
  void OnSequenceStart(const Mark&, const std::string&, Anchor,
                       YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const Mark&, const std::string&, Anchor, YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}
};

/// 0, 1, or 2 for more. LoadAll of yaml-cpp 0.7 never ends on a text such as ", a: b".
/// @throws YAML::Exception for what is no YAML.
inline int documents_in(const std::string& text) {
  std::istringstream in(text);
  YAML::Parser parser(in);
  YamlIgnored nobody;
  int count = 0;
  while (count < 2 && parser.HandleNextDocument(nobody)) ++count;
  return count;
}

inline constexpr const char* kMoreDocuments = "something follows the document";
inline constexpr const char* kOneDocument = "keep one document a file";

}  // namespace lasius
