// What is thrown for a value that a caller gave.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "core/base/number_text.h"
#include "lasius/base/error.h"

namespace lasius {

/// `problem` names the value, `remedy` says what it may be.
inline Error invalid_parameter(std::string problem, std::string remedy) {
  return {ErrorCode::invalid_parameter, std::move(problem), std::move(remedy)};
}

/// @throws Error(invalid_parameter), as above.
[[noreturn]] inline void refuse(std::string problem, std::string remedy) {
  throw invalid_parameter(std::move(problem), std::move(remedy));
}

/// @throws Error(invalid_parameter) "NAME is VALUE" with what it must be, unless that is good.
template <class Number>
void require_parameter(bool good, std::string_view name, Number value, std::string_view remedy) {
  if (good) return;
  throw invalid_parameter(std::string(name) + " is " + number_text(value), std::string(remedy));
}

}  // namespace lasius
