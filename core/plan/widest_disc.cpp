// How wide a disc can be that goes from one cell to another.
#include <cmath>

#include "core/plan/planner_impl.h"

namespace lasius {

// The narrowest place of the widest way lies midway between two points of blocked squares that hold
// the disc there, which are lattice points or straight across from one, or it is one of the ends. So
// four times the square of the radius is a whole number: the half lies among those up to it.
std::optional<double> Planner::widest_disc(Cell a, Cell b, const StopCondition& stop) const {
  const Grid& map = impl_->map();
  if (map.blocked(a) || map.blocked(b)) return std::nullopt;
  const auto radius = [](int squared_half_cells) { return std::sqrt(1.0 * squared_half_cells) / 2; };
  int open = 0;
  int closed = static_cast<int>(4 * disc::kLargestRadius * disc::kLargestRadius) + 1;
  while (closed - open > 1) {
    const int middle = open + (closed - open) / 2;
    const auto space = disc::DiscSpace::make(map, radius(middle), stop);
    if (!space) return std::nullopt;
    const bool joined = space->clear(centre(a)) && space->clear(centre(b)) &&
                        space->joined(centre(a), centre(b));
    (joined ? open : closed) = middle;
  }
  // Cells that are joined at all are by doors as wide as a cell.
  return open > 0 ? std::optional(radius(open)) : std::nullopt;
}

}  // namespace lasius
