// Kinds of weight, and long queries, for the benchmark of costs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "bench/query_set.h"
#include "lasius/cost/field.h"

namespace lasius::bench {

/// inflation: around what is blocked, 1 to 5; noise: smooth at three scales, 1 to 5; checker: 24 x
/// 24 cells alike, 1 to 10; white: each cell by itself, 1 to 9.
inline const std::vector<std::string> kWeightKinds{"inflation", "noise", "checker", "white"};

/// Weights of one of the kinds.
CostField make_weights(const Grid& grid, const std::string& kind);

/// Random starts, and goals from the cells that are at least 0.6 times as many steps away as the
/// farthest one. @throws Error(invalid_parameter) where no two cells are joined.
std::vector<Query> long_queries(const Grid& grid, std::size_t count, std::uint64_t seed);

}  // namespace lasius::bench
