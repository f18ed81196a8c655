// What the library throws, and when: only for bad input and failed input or output.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "lasius/export.h"

namespace lasius {

enum class ErrorCode {
  invalid_parameter,  ///< a parameter is out of its range, or does not compose with another
  file_missing,       ///< a file cannot be opened for reading
  file_broken,        ///< a file's content is not what its format asks for
  file_unsupported,   ///< a well-formed file of a kind that is not read, or too large
  output_failed,      ///< a file cannot be written
};

/// The name, as in "file_broken".
LASIUS_EXPORT std::string_view to_string(ErrorCode code) noexcept;

/// Thrown for bad input and failed I/O. `what()` is one sentence that names the value, the place
/// and the remedy; the parts are kept apart for programs.
class LASIUS_EXPORT Error : public std::runtime_error {
 public:
  /// Where in a file an error was found. Text formats count lines from 1, binary ones bytes from 0.
  struct Place {
    std::string file;          ///< its name; empty where it is in none
    std::int64_t line = -1;    ///< -1 where it does not apply
    std::int64_t offset = -1;  ///< -1 where it does not apply
  };

  /// An error that is in no file.
  Error(ErrorCode code, std::string problem, std::string remedy);
  /// An error in a file.
  Error(ErrorCode code, Place place, std::string problem, std::string remedy);
  ~Error() override;

  ErrorCode code() const noexcept { return code_; }                 ///< its kind
  const Place& place() const noexcept { return place_; }            ///< where in a file, if in one
  const std::string& problem() const noexcept { return problem_; }  ///< what is wrong
  const std::string& remedy() const noexcept { return remedy_; }    ///< what to do about it

 private:
  ErrorCode code_;
  Place place_;
  std::string problem_;
  std::string remedy_;
};

}  // namespace lasius
