#include "core/drive/kept_way.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/base/poller.h"
#include "core/drive/vehicle_window.h"
#include "core/grid/cell_set.h"
#include "core/vehicle/angle.h"
#include "core/vehicle/outline.h"
#include "core/vehicle/steering.h"

namespace lasius::vehicle {
namespace {

/// An angle driven, of `most`: below 0 and above it the nearer end.
double clamped_angle(double angle, double most) noexcept {
  const double a = turned(angle);
  if (a <= most) return a;
  return a - most < kTurn - a ? most : 0;
}

/// Of a clothoid: from the nearest of some poses on along the tangent, again and again.
double nearest_on_clothoid(const Segment& s, const Pose& pose) noexcept {
  constexpr int kSteps = 20;
  const int pieces = std::max(2, static_cast<int>(std::ceil(2 * s.length)));
  double at = 0, least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= pieces; ++i) {
    const Pose p = s.pose(s.length * i / pieces);
    const double dx = pose.x - p.x, dy = pose.y - p.y;
    if (dx * dx + dy * dy >= least) continue;
    least = dx * dx + dy * dy;
    at = s.length * i / pieces;
  }
  for (int i = 0; i < kSteps; ++i) {
    const Pose p = s.pose(at);
    const auto [sine, cosine] = kernels::sine_cosine(p.yaw);
    at += s.gear * ((pose.x - p.x) * cosine + (pose.y - p.y) * sine);
    at = std::clamp(at, 0.0, s.length);
  }
  return at;
}

/// The extent of a motion at the place nearest to a pose, by its point; in place by its yaw.
double nearest(const Segment& s, const Pose& pose) noexcept {
  if (s.gear == 0) {
    const double turn = pose.yaw - s.begin.yaw;
    return clamped_angle(s.angle < 0 ? -turn : turn, s.extent());
  }
  if (s.curvature_rate != 0) return nearest_on_clothoid(s, pose);
  const auto [sine, cosine] = kernels::sine_cosine(half_turned(s.begin.yaw + s.angle));
  const double dx = pose.x - s.begin.x, dy = pose.y - s.begin.y;
  if (s.curvature == 0) return std::clamp(s.gear * (dx * cosine + dy * sine), 0.0, s.length);
  // About the centre of the circle.
  const double r = 1 / s.curvature;
  const double ax = sine * r, ay = -cosine * r;
  const double bx = ax + dx, by = ay + dy;
  const double angle = direction(ax * by - ay * bx, ax * bx + ay * by);
  const double bend = std::fabs(s.curvature);
  return clamped_angle((s.curvature < 0 ? -s.gear : s.gear) * angle, s.length * bend) / bend;
}

/// By which a footprint of this radius is moved from one pose to the other, at most.
double apart(const Pose& a, const Pose& b, double around) noexcept {
  const double dx = a.x - b.x, dy = a.y - b.y;
  return std::sqrt(dx * dx + dy * dy) + around * std::fabs(half_turned(a.yaw - b.yaw));
}

/// Cells by which a motion moves the reference point, or in place the farthest point.
double moved_by(const Segment& s, double around) noexcept {
  return s.gear == 0 ? around * s.extent() : s.length;
}

/// All that a vehicle can do at once from a pose: arcs, sideways lines, turns in place; as long as
/// asked for, a quarter of a turn at most.
std::vector<Segment> single_motions(const Vehicle& vehicle, const Pose& pose, double length) {
  std::vector<Segment> motions;
  const Segment still{.begin = pose, .length = 0};
  for (const int gear : {1, -1}) {
    if (gear < 0 && !vehicle.reverse) continue;
    const double bend = vehicle.turning_radius > 0 ? 1 / vehicle.turning_radius : 0;
    for (const double share : {0.0, 0.5, -0.5, 1.0, -1.0}) {
      if (bend == 0 && share != 0) continue;
      Segment motion = still;
      motion.curvature = share * bend;
      motion.gear = gear;
      motion.length = length;
      motions.push_back(motion);
    }
  }
  for (int side = 1; side < 16 && vehicle.sideways; ++side) {
    Segment motion = still;
    motion.angle = half_turned(side * (kTurn / 16));
    motion.length = length;
    motions.push_back(motion);
  }
  for (const int turn : {1, -1}) {
    if (!vehicle.rotate_in_place) continue;
    Segment motion = still;
    motion.gear = 0;
    motion.angle = turn * kPi / 2;
    motions.push_back(motion);
  }
  return motions;
}

}  // namespace

Segment rest_of(const Segment& motion, double at) noexcept {
  Segment rest = motion;
  rest.begin = motion.pose(at);
  rest.curvature = motion.curvature_at(at);
  if (motion.gear == 0)
    rest.angle = motion.angle < 0 ? motion.angle + at : motion.angle - at;
  else
    rest.length = motion.length - at;
  return rest;
}

Segment begin_of(const Segment& motion, double extent) noexcept {
  Segment part = motion;
  if (motion.gear == 0)
    part.angle = motion.angle < 0 ? -extent : extent;
  else
    part.length = extent;
  return part;
}

KeptWay::KeptWay(const Vehicle& vehicle) : around_(circumscribed_radius(vehicle)) {}

void KeptWay::keep(std::vector<Segment> way) {
  way_ = std::move(way);
  place_ = {};
}

double KeptWay::locate(const Pose& robot) {
  // Farther on the way may come back here.
  const double most = 16 + 2 * around_;
  double best = std::numeric_limits<double>::infinity();
  Place found = place_;
  double seen = 0;
  for (std::size_t i = place_.segment; i < way_.size() && seen <= most; ++i) {
    const Segment& s = way_[i];
    const double from = i == place_.segment ? place_.at : 0;
    const double at = std::max(from, nearest(s, robot));
    const double off = apart(s.pose(at), robot, around_);
    if (off < best - 1e-12) {
      best = off;
      found = {i, at};
    }
    const double extent = s.extent();
    if (extent > 0) seen += moved_by(s, around_) * (1 - from / extent);
  }
  place_ = found;
  return best;
}

bool KeptWay::in_first() const noexcept {
  return kept() && place_.segment == 0 && way_[0].extent() - place_.at > kNothing;
}

std::vector<Segment> KeptWay::rest() const {
  std::vector<Segment> rest;
  for (std::size_t i = place_.segment; i < way_.size(); ++i) {
    const double at = i == place_.segment ? place_.at : 0;
    const Segment left = at > 0 ? rest_of(way_[i], at) : way_[i];
    if (left.extent() > kNothing) rest.push_back(left);
  }
  if (rest.empty() && !way_.empty()) rest = {{.begin = way_.back().end(), .length = 0, .gear = 1}};
  return rest;
}

bool meets(const Vehicle& vehicle, std::span<const Segment> way, std::span<const Cell> cells) {
  if (cells.empty()) return false;
  const auto by_rows = [](Cell a, Cell b) { return a.y != b.y ? a.y < b.y : a.x < b.x; };
  std::vector<Cell> sorted(cells.begin(), cells.end());
  std::ranges::sort(sorted, by_rows);
  const auto any_in = [&](const Rectangle& part) {
    for (int y = part.y; y < part.y + part.height; ++y) {
      const auto next = std::ranges::lower_bound(sorted, Cell{part.x, y}, by_rows);
      if (next != sorted.end() && next->y == y && next->x < part.x + part.width) return true;
    }
    return false;
  };
  // Each piece has a window of its own: ways and news may be as wide as a map can be.
  constexpr double kPiece = 8;  // cells
  const double around = circumscribed_radius(vehicle);
  for (const Segment& s : way) {
    const double extent = s.extent();
    const int pieces = std::max(1, static_cast<int>(std::ceil(moved_by(s, around) / kPiece)));
    for (int i = 0; i < pieces; ++i) {
      const double from = extent * i / pieces, to = extent * (i + 1) / pieces;
      const Segment piece = begin_of(rest_of(s, from), to - from);
      const Rectangle part = Window::around(piece.begin, piece.length + around + 2);
      if (!any_in(part)) continue;
      const Window window(vehicle, part,
                          [&](Cell c) { return std::ranges::binary_search(sorted, c, by_rows); });
      if (window.first_contact(piece)) return true;
    }
  }
  return false;
}

std::vector<Cell> met_cells(const Vehicle& vehicle, const Pose& pose) {
  std::vector<Cell> cells;
  const Outline outline(vehicle);
  (void)outline.visit_cells(pose, 0, [&](int row, int first, int last) {
    for (int x = first; x <= last; ++x) cells.push_back({x, row});
    return false;
  });
  return cells;
}

std::vector<Segment> ways_out(const Vehicle& vehicle, const Grid& map, const Pose& pose,
                              const StopCondition& stop) {
  constexpr double kStep = 0.25;  // cells
  const double around = circumscribed_radius(vehicle);
  const double most = around + 8;
  const Rectangle part = Window::around(pose, 2 * around + most + 2);
  const Window all(vehicle, part, [&](Cell c) { return map.blocked(c); });
  const auto in_part = [&](Cell c) { return Cell{c.x - part.x, c.y - part.y}; };
  const std::vector<Cell> cells = met_cells(vehicle, pose);
  CellSet met;
  met.reset(cells.size());
  for (const Cell c : cells) met.add(in_part(c));
  const Window others(vehicle, part,
                      [&](Cell c) { return map.blocked(c) && !met.has(in_part(c)); });

  std::vector<Segment> out;
  Poller poller(stop);
  const auto work = static_cast<std::int64_t>(cells.size());  // at a pose
  for (const Segment& motion : single_motions(vehicle, pose, most)) {
    const double step = kStep * motion.extent() / moved_by(motion, std::max(1.0, around));
    for (double at = step; at <= motion.extent() && !poller.stop_after(work); at += step) {
      if (!all.free(motion.pose(at))) continue;
      const Segment part_of_it = begin_of(motion, at);
      if (!others.first_contact(part_of_it)) out.push_back(part_of_it);
      break;
    }
  }
  std::ranges::stable_sort(out, {},
                           [&](const Segment& s) { return moved_by(s, std::max(1.0, around)); });
  return out;
}

std::vector<Segment> rejoined(const Vehicle& vehicle, const Grid& map, const Pose& pose, double off,
                              std::span<const Segment> rest, int& back) {
  constexpr int kTries = 4, kWays = 3;
  constexpr double kFarthest = 4;  // cells beside the way, what the vehicle is turned included
  if (!(off <= kFarthest)) return {};
  const double around = circumscribed_radius(vehicle);
  Steering steering(vehicle);
  const double most = cost(vehicle, rest) + 4 * off + 1;
  double ahead = 2 + 2 * off;
  for (int i = 0; i < kTries; ++i, ahead *= 2) {
    // The place so far ahead, or the end.
    double left = ahead;
    std::size_t segment = 0;
    while (segment + 1 < rest.size() && moved_by(rest[segment], around) < left)
      left -= moved_by(rest[segment++], around);
    const Segment& to = rest[segment];
    const double by = moved_by(to, around);
    const double at = by > left ? to.extent() * (left / by) : to.extent();
    steering.aim(pose, to.pose(at), kWays);
    for (int way = 0; way < steering.size(); ++way) {
      std::vector<Segment> found;
      if (!steering.append(way, found)) continue;
      const double length = driven_length(found);
      const auto leading = static_cast<std::ptrdiff_t>(found.size());
      if (at < to.extent()) found.push_back(rest_of(to, at));
      found.insert(found.end(), rest.begin() + static_cast<std::ptrdiff_t>(segment) + 1,
                   rest.end());
      // What winds about to get there, however cheaply, is no better than a new plan.
      if (cost(vehicle, found) > most || length > 2 * ahead + 4 * off + 1) continue;
      const Window window(vehicle, Window::around(pose, length + around + 4),
                          [&](Cell c) { return map.blocked(c); });
      const bool clear =
          std::none_of(found.begin(), found.begin() + leading,
                       [&](const Segment& s) { return window.first_contact(s).has_value(); });
      if (!clear) continue;
      back = static_cast<int>(leading);
      return found;
    }
    if (segment + 1 == rest.size() && at == to.extent()) break;
  }
  return {};
}

}  // namespace lasius::vehicle
