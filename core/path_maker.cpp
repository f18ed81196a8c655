#include "path_maker.h"

namespace lasius {

std::span<const Cell> PathMaker::cut(const Grid& grid, std::span<const Cell> walk, bool diagonal,
                                     Corners corners, const StopCondition& stop,
                                     std::span<const kernels::PackedCell> more) {
  const auto way = cutter_.cut(grid, walk, diagonal, corners, stop, more);
  return way.empty() ? walk : way;
}

void PathMaker::polish(const Grid& grid, std::span<const Cell> walk, Polish polish, Corners corners,
                       const StopCondition& stop, std::vector<Point>& path) {
  path.clear();
  straightener_.run(grid, walk, stop);
  if (polish == Polish::taut) {
    tautener_.run(grid, straightener_.vertices(), corners, stop);
    const auto points = tautener_.path();
    path.assign(points.begin(), points.end());
    return;
  }
  straightener_.tighten(grid, stop);
  for (const Cell c : straightener_.vertices()) path.push_back(centre(c));
}

}  // namespace lasius
