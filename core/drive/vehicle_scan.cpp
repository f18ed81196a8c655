#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "core/base/invalid_parameter.h"
#include "kernels/base/sine.h"
#include "lasius/vehicle/scan.h"

namespace lasius::vehicle {
namespace {

constexpr double kBeyond = 0.01;  // cells, by which what is met lies behind a range
constexpr double kFar = 1e5;      // cells

bool before(Cell a, Cell b) noexcept { return a.y != b.y ? a.y < b.y : a.x < b.x; }

/// Gathers what rays cross and meet.
class Rays {
 public:
  Rays(const WorldFrame& frame, int width, int height)
      : frame_(frame), width_(width), height_(height) {}

  /// A ray from one place to another, metres; `meets`: it ends at something.
  void add(Point from, Point to, bool meets) {
    const Point a = frame_.to_cells(from, height_);
    Point b = frame_.to_cells(to, height_);
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double length = std::sqrt(dx * dx + dy * dy);
    if (!(std::fabs(a.x) < kFar && std::fabs(a.y) < kFar && length < kFar)) return;
    if (meets && length > 0) b = {b.x + dx / length * kBeyond, b.y + dy / length * kBeyond};
    cross(a, b, meets);
  }
  SeenCells cells() {
    SeenCells seen;
    sort(free_);
    sort(blocked_);
    std::ranges::set_difference(free_, blocked_, std::back_inserter(seen.free), before);
    seen.blocked = std::move(blocked_);
    return seen;
  }

 private:
  // Cell after cell, by the nearer of the next borders (Amanatides & Woo 1987).
  void cross(Point a, Point b, bool meets) {
    Cell at{floored(a.x), floored(a.y)};
    const Cell last{floored(b.x), floored(b.y)};
    const double dx = b.x - a.x, dy = b.y - a.y;
    const int step_x = dx > 0 ? 1 : -1, step_y = dy > 0 ? 1 : -1;
    constexpr double kNever = std::numeric_limits<double>::infinity();
    for (int left = std::abs(last.x - at.x) + std::abs(last.y - at.y); left > 0; --left) {
      note(at, free_);
      const double to_x = dx == 0 ? kNever : (at.x + (dx > 0 ? 1 : 0) - a.x) / dx;
      const double to_y = dy == 0 ? kNever : (at.y + (dy > 0 ? 1 : 0) - a.y) / dy;
      const bool across = at.y == last.y || (at.x != last.x && to_x < to_y);
      (across ? at.x : at.y) += across ? step_x : step_y;
    }
    note(last, meets ? blocked_ : free_);
  }
  void note(Cell c, std::vector<Cell>& cells) const {
    if (c.x >= 0 && c.y >= 0 && c.x < width_ && c.y < height_) cells.push_back(c);
  }
  static int floored(double v) { return static_cast<int>(std::floor(v)); }
  static void sort(std::vector<Cell>& cells) {
    std::ranges::sort(cells, before);
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  }

  const WorldFrame& frame_;
  int width_, height_;
  std::vector<Cell> free_, blocked_;
};

void check_most(double most) {
  require_parameter(most > 0 && most <= 1e6, "most", most, "give a range above 0 metres");
}

}  // namespace

SeenCells seen_cells(const Scan& scan, const WorldFrame& frame, int width, int height) {
  check_most(scan.most);
  require_parameter(std::fabs(scan.first_angle) <= 100, "first_angle", scan.first_angle,
                    "give radians of at most 100");
  require_parameter(std::fabs(scan.sensor.yaw) <= 1e5, "the sensor's yaw", scan.sensor.yaw,
                    "give radians of at most 100000");
  const double turned = scan.step * static_cast<double>(scan.ranges.size());
  require_parameter(std::fabs(turned) <= 100, "step", scan.step,
                    "give radians; all ranges together turn by at most 100");
  Rays rays(frame, width, height);
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double range = scan.ranges[i];
    if (std::isnan(range) || range < scan.least) continue;
    const double yaw = scan.sensor.yaw + scan.first_angle + scan.step * static_cast<double>(i);
    const auto [sine, cosine] = kernels::sine_cosine(yaw);
    const double reach = std::min(range, scan.most);
    const Point from{scan.sensor.x, scan.sensor.y};
    rays.add(from, {from.x + reach * cosine, from.y + reach * sine}, range < scan.most);
  }
  return rays.cells();
}

SeenCells seen_cells(Point sensor, std::span<const Point> points, double most,
                     const WorldFrame& frame, int width, int height) {
  check_most(most);
  Rays rays(frame, width, height);
  for (const Point& p : points) {
    const double dx = p.x - sensor.x, dy = p.y - sensor.y;
    const double range = std::sqrt(dx * dx + dy * dy);
    if (!(range < std::numeric_limits<double>::infinity())) continue;
    const double share = range > most ? most / range : 1;
    rays.add(sensor, {sensor.x + share * dx, sensor.y + share * dy}, range <= most);
  }
  return rays.cells();
}

}  // namespace lasius::vehicle
