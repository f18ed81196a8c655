// What inflation costs in one cell.
#pragma once

#include <cstdint>
#include <span>

#include "lasius/cost/field.h"

namespace lasius::cost {

/// @throws Error(invalid_parameter) for a number out of its range.
void check_inflation(const Inflation& inflation);
/// @throws Error(invalid_parameter) where weights and the inflation pass what is allowed.
void check_sum(std::span<const double> weights, const Inflation& inflation);
/// @param squared_half_cells  of the distance from the cell's centre to the nearest blocked one's
double inflated(const Inflation& inflation, std::int32_t squared_half_cells) noexcept;

}  // namespace lasius::cost
