// How a search ended.
#pragma once

#include <string_view>

#include "lasius/export.h"

namespace lasius {

/// How a plan ended: outcomes, not errors.
enum class Status {
  solved,       ///< the algorithm ended by its own rule, with a path
  limit,        ///< the deadline ended it; the best path so far, if any
  interrupted,  ///< the stop token ended it; the best path so far, if any
  unreachable,  ///< proven: no path exists
  no_path,      ///< its iterations ended without a path
  invalid,      ///< start or goal outside or blocked
};
LASIUS_EXPORT std::string_view to_string(Status status) noexcept;

}  // namespace lasius
