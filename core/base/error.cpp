#include "lasius/base/error.h"

#include <utility>

#include "core/base/printable.h"
#include "lasius/base/enum_names.h"

namespace lasius {
namespace {

std::string sentence(const Error::Place& place, const std::string& problem,
                     const std::string& remedy) {
  std::string text;
  if (!place.file.empty()) {
    text = place.file;
    if (place.line >= 0) text += ", line " + std::to_string(place.line);
    if (place.offset >= 0) text += ", byte " + std::to_string(place.offset);
    text += ": ";
  }
  text += problem;
  if (!remedy.empty()) text += "; " + remedy;
  return printable(text);
}

}  // namespace

std::string_view to_string(ErrorCode code) noexcept {
  static constexpr std::array<std::string_view, 5> kNames{
      "invalid_parameter", "file_missing", "file_broken", "file_unsupported", "output_failed"};
  return name_of(code, kNames);
}

Error::Error(ErrorCode code, std::string problem, std::string remedy)
    : Error(code, Place{}, std::move(problem), std::move(remedy)) {}

Error::Error(ErrorCode code, Place place, std::string problem, std::string remedy)
    : std::runtime_error(sentence(place, problem, remedy)),
      code_(code),
      place_(std::move(place)),
      problem_(std::move(problem)),
      remedy_(std::move(remedy)) {}

Error::~Error() = default;

}  // namespace lasius
