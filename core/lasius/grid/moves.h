// Which steps from cell to cell there are.
#pragma once

#include <array>
#include <string_view>

#include "lasius/base/enum_names.h"

namespace lasius {

/// When a diagonal step between two free cells is allowed, by its two side cells.
enum class Corners {
  forbid,    ///< both side cells must be free
  one_side,  ///< at least one side cell must be free
  allow,     ///< always
};
/// Their names, in the same order.
inline constexpr std::array<std::string_view, 3> kCornersNames{"forbid", "one-side", "allow"};
/// The name of a value.
constexpr std::string_view to_string(Corners v) noexcept { return name_of(v, kCornersNames); }

/// Moves of an ant. Moves of more than one cell need every cell that they sweep to be free.
enum class Neighbours {
  four,            ///< along x or y
  eight,           ///< all around
  sixteen,         ///< the 8 directions at 1 and 2 cells
  sixteen_knight,  ///< 8 and the knight's moves
  twenty_four,     ///< all of the 5 x 5 square
  thirty_two,      ///< 24 and the 8 directions at 3 cells
};
/// Their names, in the same order.
inline constexpr std::array<std::string_view, 6> kNeighboursNames{"4",   "8",  "16",
                                                                  "16k", "24", "32"};
/// The name of a value.
constexpr std::string_view to_string(Neighbours v) noexcept { return name_of(v, kNeighboursNames); }

}  // namespace lasius
