// What readers and checks of robots and scenes throw.
#pragma once

#include <string>
#include <utility>

#include "lasius/base/error.h"

namespace lasius::arm {

/// @throws Error(file_broken)
[[noreturn]] inline void broken(Error::Place place, const std::string& problem,
                                const std::string& remedy) {
  throw Error(ErrorCode::file_broken, std::move(place), problem, remedy);
}

/// @throws Error(file_unsupported)
[[noreturn]] inline void unsupported(Error::Place place, const std::string& problem,
                                     const std::string& remedy) {
  throw Error(ErrorCode::file_unsupported, std::move(place), problem, remedy);
}

}  // namespace lasius::arm
