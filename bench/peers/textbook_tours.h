// Tours as textbooks find them: 2-opt and Or-opt over lists of neighbours.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace lasius::peers {

/// How a textbook goes on from its first local optimum.
enum class TourMethod {
  two_opt,   ///< not at all, and without Or-opt
  ils,       ///< double bridges of short pieces, kept where the tour gets no dearer
  restarts,  ///< from random tours
};

/// Told each cheaper closed tour's cost; false ends the search.
using TourWatch = std::function<bool(std::int64_t cost)>;

/// Searches over `size` stops and the symmetric costs between them, row by row, from the nearest
/// neighbour's tour, until `watch` or `stop`, asked after each local optimum, ends it. The best
/// tour. At least 8 stops.
std::vector<int> textbook_tour(int size, const std::vector<std::int32_t>& costs, TourMethod method,
                               std::uint64_t seed, const TourWatch& watch,
                               const std::function<bool()>& stop);

}  // namespace lasius::peers
