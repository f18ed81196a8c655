#include "core/disc/disc_space.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/base/held_bytes.h"
#include "core/base/invalid_parameter.h"
#include "core/disc/space_builder.h"
#include "core/grid/grid_view.h"

namespace lasius::disc {

namespace {

int column_of(const Grid& grid, double x) noexcept {
  return std::clamp(static_cast<int>(x), 0, grid.width() - 1);
}
int row_of(const Grid& grid, double y) noexcept {
  return std::clamp(static_cast<int>(y), 0, grid.height() - 1);
}

double square(double x) noexcept { return x * x; }

}  // namespace

void check_disc_radius(double radius) {
  require_parameter(
      radius >= kLeastRadius && radius <= kLargestRadius, "radius", radius,
      "for exact a disc's radius is between 0.05 and 54 cells: coarsen the map or ask "
      "a colony for a larger one, plan for a point with radius 0");
}

std::optional<DiscSpace> DiscSpace::make(const Grid& grid, double radius,
                                         const StopCondition& stop) {
  check_disc_radius(radius);
  Poller poller(stop);
  DiscSpace space(grid, radius);
  if (!SpaceBuilder(space, poller).build()) return std::nullopt;
  space.components_ = Components::make(space.blocked_, Components::Connectivity::four, stop);
  if (!space.components_) return std::nullopt;
  return space;
}

DiscSpace::Box DiscSpace::box_of(const BandCell& cell, int x, int y) const noexcept {
  Box box{static_cast<double>(x), static_cast<double>(y), x + 1.0, y + 1.0};
  // From the blocked cell's near side, its steps less one away.
  const double beside = radius_ - kMadeSlack;
  const auto steps = [&](int side) { return cell.box_and_count >> 6 * side & kFar; };
  if (steps(0) != kFar) box.left = std::max(box.left, x + 1.0 - steps(0) + beside);
  if (steps(1) != kFar) box.top = std::max(box.top, y + 1.0 - steps(1) + beside);
  if (steps(2) != kFar) box.right = std::min(box.right, x + 0.0 + steps(2) - beside);
  if (steps(3) != kFar) box.bottom = std::min(box.bottom, y + 0.0 + steps(3) - beside);
  return box;
}

double DiscSpace::clearance(Point p, double most) const noexcept {
  if (!(p.x >= 0 && p.y >= 0 && p.x <= map_.width() && p.y <= map_.height())) return 0;
  const int column = column_of(map_, p.x);
  const int last = std::min(map_.height(), static_cast<int>(p.y + most));
  double least = square(most);
  for (int y = std::max(-1, static_cast<int>(p.y - most) - 1); y <= last; ++y) {
    const double rows = std::max({0.0, y - p.y, p.y - (y + 1)});
    if (square(rows) >= least) continue;
    const auto columns = std::min(blocked_after(map_.row(y), column) - p.x,
                                  p.x - (blocked_before(map_.row(y), column) + 1));
    least = std::min(least, square(rows) + square(std::max(0.0, columns)));
  }
  return std::sqrt(least);
}

bool DiscSpace::clear(Point p) const noexcept { return clearance(p, radius_) >= radius_ - kSlack; }

bool DiscSpace::joined(Point a, Point b) const noexcept {
  const Cell from{column_of(map_, a.x), row_of(map_, a.y)};
  const Cell to{column_of(map_, b.x), row_of(map_, b.y)};
  if (blocked_.blocked(from) || blocked_.blocked(to)) return true;  // by rounding: no proof
  return components_->connected(blocked_, from, to);
}

std::int64_t DiscSpace::bytes() const noexcept {
  return bitmap_bytes(map_) + bitmap_bytes(blocked_) + bitmap_bytes(band_) +
         bitmap_bytes(arc_cells_even_) + bitmap_bytes(arc_cells_odd_) + bitmap_bytes(crowded_) +
         held_bytes(tiles_, cells_, passing_, arcs_) + components_->bytes();
}

}  // namespace lasius::disc
