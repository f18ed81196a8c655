#include "core/disc/disc_space.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/held_bytes.h"
#include "core/base/invalid_parameter.h"
#include "core/disc/space_builder.h"
#include "core/grid/changed_parts.h"
#include "core/grid/grid_view.h"

namespace lasius::disc {

namespace {

double square(double x) noexcept { return x * x; }

}  // namespace

void check_disc_radius(double radius) {
  require_parameter(
      radius >= kLeastRadius && radius <= kLargestRadius, "radius", radius,
      "for exact a disc's radius is between 0.05 and 54 cells: coarsen the map or ask "
      "a colony for a larger one, plan for a point with radius 0");
}

DiscSpace::DiscSpace(Grid&& grid, double radius)
    : asked_radius_(radius),
      radius_(radius - kRadiusMargin),
      map_(std::move(grid)),
      blocked_(map_.width(), map_.height()),
      band_(map_.width(), map_.height()),
      arc_cells_even_(map_.width(), map_.height()),
      arc_cells_odd_(map_.width(), map_.height()),
      crowded_((map_.width() + 7) / 8, (map_.height() + 7) / 8),
      wall_(static_cast<int>(Reach(radius_).covered.size())),
      starts_(block(0, map_.height())) {}

std::optional<DiscSpace> DiscSpace::make(Grid&& grid, double radius, const StopCondition& stop) {
  check_disc_radius(radius);
  Poller poller(stop);
  std::optional<DiscSpace> space(DiscSpace(std::move(grid), radius));
  if (SpaceBuilder(*space).run(poller)) {
    space->cells_.shrink_to_fit();
    space->passing_.shrink_to_fit();
    space->arcs_.shrink_to_fit();
    space->components_ = Components::make(space->blocked_, Components::Connectivity::four, stop);
    if (space->components_) return space;
  }
  grid = std::move(space->map_);
  return std::nullopt;
}

DiscSpace::Box DiscSpace::box_of(unsigned walls, int x, int y) const noexcept {
  Box box{static_cast<double>(x), static_cast<double>(y), x + 1.0, y + 1.0};
  // From the blocked cell's near side, its steps less one away.
  const double beside = radius_ - kMadeSlack;
  if ((walls & 1) != 0) box.left = std::max(box.left, x + 1.0 - wall_ + beside);
  if ((walls & 2) != 0) box.top = std::max(box.top, y + 1.0 - wall_ + beside);
  if ((walls & 4) != 0) box.right = std::min(box.right, x + 0.0 + wall_ - beside);
  if ((walls & 8) != 0) box.bottom = std::min(box.bottom, y + 0.0 + wall_ - beside);
  return box;
}

bool DiscSpace::update(const Grid& edited, std::span<const Cell> changed,
                       const StopCondition& stop) {
  const ChangedParts found = parts_of(changed, 2 * wall_, map_);
  if (found.most) {
    auto made = make(edited, asked_radius_, stop);
    if (!made) return false;
    *this = *std::move(made);
    return true;
  }
  Poller poller(stop);
  std::vector<Rectangle> blocked;
  std::size_t next = 0;
  for (const auto& [cells, end] : found.parts) {
    for (; next < end; ++next) map_.set_blocked(changed[next], edited.blocked(changed[next]));
    SpaceBuilder builder(*this, cells);
    if (!builder.run(poller)) return false;
    blocked.push_back(builder.changed_blocked());
  }
  if (2 * waste_ > cells_.size() + passing_.size()) compact();
  return components_->update(blocked_, blocked, stop);
}

// Takes the waste out of the lists.
void DiscSpace::compact() {
  std::vector<std::uint32_t> cells, passing{0};
  cells.reserve(cells_.size());
  passing.reserve(passing_.size());
  for (int y0 = 0; y0 < map_.height(); y0 += 8) {
    for (int word = 0; word < map_.words(); ++word) {
      for (int y = y0; y < std::min(y0 + 8, map_.height()); ++y) {
        std::uint32_t& start = starts_[block(word, y)];
        const auto from = cells_.begin() + start;
        start = static_cast<std::uint32_t>(cells.size());
        std::for_each_n(from, count_bits(band_in(word, y)), [&](std::uint32_t cell) {
          if (cell > kSeveral) {
            const auto list = passing_.begin() + (cell - kSeveral);
            cell = kSeveral + static_cast<std::uint32_t>(passing.size());
            passing.insert(passing.end(), list, list + 1 + *list);
          }
          cells.push_back(cell);
        });
      }
    }
  }
  cells_ = std::move(cells);
  passing_ = std::move(passing);
  waste_ = 0;
}

double DiscSpace::clearance(Point p, double most) const noexcept {
  if (!(p.x >= 0 && p.y >= 0 && p.x <= map_.width() && p.y <= map_.height())) return 0;
  const int column = cell_at(p).x;
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

Cell DiscSpace::cell_at(Point p) const noexcept {
  const auto part = [](double v, int side) {
    return static_cast<int>(std::max(0.0, std::min(v, side - 1.0)));
  };
  return {part(p.x, map_.width()), part(p.y, map_.height())};
}

bool DiscSpace::joined(Point a, Point b) const noexcept {
  const Cell from = cell_at(a), to = cell_at(b);
  if (blocked_.blocked(from) || blocked_.blocked(to)) return true;  // by rounding: no proof
  return components_->connected(blocked_, from, to);
}

std::int64_t DiscSpace::bytes() const noexcept {
  return bitmap_bytes(map_) + bitmap_bytes(blocked_) + bitmap_bytes(band_) +
         bitmap_bytes(arc_cells_even_) + bitmap_bytes(arc_cells_odd_) + bitmap_bytes(crowded_) +
         held_bytes(starts_, cells_, passing_, arcs_) + components_->bytes();
}

}  // namespace lasius::disc
