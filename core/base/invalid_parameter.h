// What is thrown for a value that a caller gave.
#pragma once

#include <string>
#include <utility>

#include "lasius/error.h"

namespace lasius {

/// `problem` names the value, `remedy` says what it may be.
inline Error invalid_parameter(std::string problem, std::string remedy) {
  return {ErrorCode::invalid_parameter, std::move(problem), std::move(remedy)};
}

}  // namespace lasius
