#include "core/smooth/path_ends.h"

#include <algorithm>

#include "core/grid/grid_view.h"
#include "core/smooth/tighten.h"
#include "kernels/sight/sight.h"

namespace lasius {

bool PathEnds::sees(Point a, Point b) const noexcept {
  return disc_ != nullptr
             ? disc_->sees(a, b)
             : kernels::sees_fine(view_of(grid_), kernels::fine(a.x, a.y), kernels::fine(b.x, b.y));
}

std::vector<Point> PathEnds::join(std::span<const Point> path, const StopCondition& stop) {
  if (path.size() == 1 && disc_ == nullptr) return {from_, to_};  // both of one cell
  if (params_.polish == Polish::taut && disc_ == nullptr) {
    std::vector<kernels::HalfPoint> half;
    for (const Point p : path)
      half.push_back({static_cast<int>(2 * p.x), static_cast<int>(2 * p.y)});
    taut_.run(grid_, from_, half, to_, params_.corners, stop);
    return {taut_.path().begin(), taut_.path().end()};
  }
  std::vector<Point> joined{from_};
  const auto add = [&](Point p) {
    if (p != joined.back()) joined.push_back(p);
  };
  for (const Point p : path) add(p);
  add(to_);
  if (params_.polish == Polish::none) return joined;
  for (int end = 0; end < 2; ++end) {
    while (joined.size() > 2 && sees(joined[0], joined[2])) joined.erase(joined.begin() + 1);
    std::ranges::reverse(joined);
  }
  if (params_.polish == Polish::taut) tighten(*disc_, stop, joined);
  return joined;
}

}  // namespace lasius
