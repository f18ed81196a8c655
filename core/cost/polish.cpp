#include "core/cost/polish.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace lasius::cost {
namespace {

constexpr std::size_t kWindow = 8;  // crossings on either side that move with a flip

bool share_edge(Cell a, Cell b) noexcept { return std::abs(a.x - b.x) + std::abs(a.y - b.y) == 1; }

/// Cells around a lattice point, in turn.
Cell around(Cell corner, int place) noexcept {
  constexpr int kX[4] = {-1, 0, 0, -1}, kY[4] = {-1, -1, 0, 0};
  return {corner.x + kX[place & 3], corner.y + kY[place & 3]};
}
int place_of(Cell corner, Cell cell) noexcept {
  for (int place = 0; place < 3; ++place)
    if (around(corner, place) == cell) return place;
  return 3;
}

}  // namespace

std::vector<Leg> legs_of(std::span<const Cell> walk) {
  std::vector<Leg> legs;
  for (std::size_t i = 0; i + 1 < walk.size(); ++i) {
    const Cell a = walk[i], b = walk[i + 1];
    const Point middle{(a.x + b.x + 1) / 2.0, (a.y + b.y + 1) / 2.0};
    legs.push_back({a, middle});
    legs.push_back({b, centre(b)});
  }
  return legs;
}

std::vector<Point> Polish::polish(Point start, std::span<const Leg> legs, Poller& poller) {
  start_ = start;
  goal_ = legs.back().to;
  take(legs);
  for (int round = 0; round < 100; ++round) {
    cost_ = optimizer_.optimize(start_, goal_, crossings_, weights_, 60);
    if (poller.stop_after(static_cast<std::int64_t>(crossings_.size()) * 64)) break;
    if (!flip_all(poller)) break;
  }
  std::vector<Point> path{start_};
  for (const Crossing& crossing : crossings_)
    if (const Point at = crossing.point(); at != path.back()) path.push_back(at);
  if (goal_ != path.back() || path.size() == 1) path.push_back(goal_);
  return path;
}

void Polish::take(std::span<const Leg> legs) {
  cells_.assign(1, legs.front().cell);
  weights_.assign(1, terrain_.weight(legs.front().cell.x, legs.front().cell.y));
  crossings_.clear();
  for (std::size_t i = 1; i < legs.size(); ++i) {
    const Cell cell = legs[i].cell, from = cells_.back();
    const Point at = legs[i - 1].to;
    if (cell == from) continue;
    if (!share_edge(from, cell)) {
      const Cell a{from.x, cell.y}, b{cell.x, from.y};
      const double wa = terrain_.weight(a.x, a.y), wb = terrain_.weight(b.x, b.y);
      enter(wa <= wb ? a : b, at);
    }
    enter(cell, at);
  }
  fresh_.assign(crossings_.size(), 1);
}

void Polish::enter(Cell cell, Point at) {
  Crossing crossing = crossing_between(cells_.back(), cell);
  const double t = crossing.level ? at.x - crossing.x : at.y - crossing.y;
  crossing.t = std::clamp(t, 0.0, 1.0);
  crossings_.push_back(crossing);
  cells_.push_back(cell);
  weights_.push_back(terrain_.weight(cell.x, cell.y));
}

bool Polish::flip_all(Poller& poller) {
  bool flipped = false;
  for (std::size_t i = 0; i < crossings_.size();) {
    if (!crossings_[i].at_end()) {
      ++i;
      continue;
    }
    const Cell corner = crossings_[i].corner();
    std::size_t last = i;
    bool fresh = fresh_[i] != 0;
    while (last + 1 < crossings_.size() && crossings_[last + 1].at_end() &&
           crossings_[last + 1].corner() == corner) {
      ++last;
      fresh = fresh || fresh_[last] != 0;
    }
    if (!fresh) {
      i = last + 1;
      continue;
    }
    std::fill(fresh_.begin() + i, fresh_.begin() + last + 1, 0);
    if (poller.stop_after(256)) return false;
    if (flip(i, last)) {
      flipped = true;
      i -= std::min(i, kWindow);
    } else {
      i = last + 1;
    }
  }
  return flipped;
}

// Tries the other way round the corner at which crossings `first` to `last` lie.
bool Polish::flip(std::size_t first, std::size_t last) {
  const Cell corner = crossings_[first].corner();
  const Cell from = cells_[first], to = cells_[last + 1];
  const int begin = place_of(corner, from), end = place_of(corner, to);
  if (begin == end) return replace(first, last, std::span(&from, 1), 0);
  const bool clockwise = around(corner, begin + 1) == cells_[first + 1];
  Cell way[4];
  std::size_t count = 0;
  for (int place = begin;; place += clockwise ? 3 : 1) {
    const Cell cell = way[count++] = around(corner, place);
    if (!terrain_.free(cell.x, cell.y)) return false;
    if (cell == to) break;
  }
  return replace(first, last, std::span(way, count), 0.02) ||
         replace(first, last, std::span(way, count), 0.25);
}

bool Polish::replace(std::size_t first, std::size_t last, std::span<const Cell> cells,
                     double offset) {
  const std::size_t low = first - std::min(first, kWindow);
  const std::size_t high = std::min(crossings_.size(), last + 1 + kWindow);
  const Point from = low > 0 ? crossings_[low - 1].point() : start_;
  const Point to = high < crossings_.size() ? crossings_[high].point() : goal_;
  const Cell corner = crossings_[first].corner();
  window_.assign(crossings_.begin() + low, crossings_.begin() + first);
  window_weights_.assign(weights_.begin() + low, weights_.begin() + first);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    window_weights_.push_back(terrain_.weight(cells[i].x, cells[i].y));
    if (i == 0) continue;
    Crossing crossing = crossing_between(cells[i - 1], cells[i]);
    const bool at_low = crossing.x == corner.x && crossing.y == corner.y;
    crossing.t = at_low ? offset : 1 - offset;
    window_.push_back(crossing);
  }
  window_.insert(window_.end(), crossings_.begin() + last + 1, crossings_.begin() + high);
  window_weights_.insert(window_weights_.end(), weights_.begin() + last + 2,
                         weights_.begin() + high + 1);
  const double before = cost_through(from, to, std::span(crossings_).subspan(low, high - low),
                                     std::span(weights_).subspan(low, high - low + 1));
  const double after = optimizer_.optimize(from, to, window_, window_weights_, 12);
  const bool loop = cells.size() == 1;
  if (!(after < before * (1 - 1e-10)) && !(loop && after <= before)) return false;
  cells_.erase(cells_.begin() + first, cells_.begin() + last + 2);
  cells_.insert(cells_.begin() + first, cells.begin(), cells.end());
  crossings_.erase(crossings_.begin() + low, crossings_.begin() + high);
  crossings_.insert(crossings_.begin() + low, window_.begin(), window_.end());
  weights_.erase(weights_.begin() + low, weights_.begin() + high + 1);
  weights_.insert(weights_.begin() + low, window_weights_.begin(), window_weights_.end());
  fresh_.erase(fresh_.begin() + low, fresh_.begin() + high);
  fresh_.insert(fresh_.begin() + low, window_.size(), 1);
  return true;
}

}  // namespace lasius::cost
