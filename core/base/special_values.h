// Lengths of what is not there.
#pragma once

#include <limits>

namespace lasius {

/// More than any length or cost.
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Neither more nor less than any.
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

}  // namespace lasius
