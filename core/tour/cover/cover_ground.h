// The area that a tool is to cover, as samples.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/poller.h"
#include "core/tour/cover/tool_lines.h"
#include "lasius/grid/geometry.h"
#include "lasius/plan/planner.h"

namespace lasius::tour {

/// Whether the tool can go from one place to another, and back; of a point and where it cannot that
/// is known without a search. Stopped: no.
bool reaches(const Planner& planner, Point from, Point to, const StopCondition& stop);

/// Samples of a map's area, an odd number a cell along each axis, each in the middle of its square:
/// four a width or more; with a radius eight of it and of a cell, where these are not too many.
class CoverGround {
 public:
  /// For a tool of some width, whose centre goes where `lines` let it, from `start`, or without one
  /// in the largest region. Empty if stopped.
  static std::optional<CoverGround> make(const Planner& planner, const ToolLines& lines,
                                         double width, const std::optional<Point>& start,
                                         const StopCondition& stop);

  /// How many a width and a radius ask for at least.
  static double samples_asked(const Grid& grid, double width, double radius) noexcept;

  double half_width() const noexcept { return half_; }
  double spacing() const noexcept { return 1.0 / per_cell_; }
  std::int64_t samples() const noexcept { return static_cast<std::int64_t>(wanted_.size()); }
  std::int64_t free_samples() const noexcept { return free_; }
  std::int64_t wanted_samples() const noexcept { return wanted_count_; }
  /// Is the sample free, and within half a width of a place of the tool in its own region of cells?
  bool wanted(std::int64_t sample) const noexcept { return wanted_[sample] != 0; }
  double area(std::int64_t of_samples) const noexcept {
    return static_cast<double>(of_samples) * spacing() * spacing();
  }
  /// Samples within half a width of a segment, about; never 0.
  std::int64_t samples_near(double length) const noexcept {
    return 64 + static_cast<std::int64_t>(2 * half_ * (length + 2 * half_) * per_cell_ * per_cell_);
  }
  Point at(std::int64_t sample) const noexcept {
    const std::int64_t column = sample % columns_, row = sample / columns_;
    return {(static_cast<double>(column) + 0.5) * spacing(),
            (static_cast<double>(row) + 0.5) * spacing()};
  }
  /// A place of the region; none where the tool has no place.
  const std::optional<Point>& place() const noexcept { return place_; }

  /// Calls body(first, last) with the samples within half a width of a segment, row by row.
  template <class Body>
  void each_row_near(Point a, Point b, const Body& body) const {
    each_row_within(half_, a, b, body);
  }

 private:
  CoverGround(const Grid& grid, double width, double radius, bool tight);
  template <class Body>
  void each_row_within(double r, Point a, Point b, const Body& body) const;
  void mark_blocked(const Grid& grid, const ToolLines& lines);
  std::optional<Point> clear_beside(const Planner& planner, std::int64_t sample) const;
  bool choose_region(const Planner& planner, const std::optional<Point>& start,
                     const StopCondition& stop);
  void flood(std::int64_t from, std::uint8_t was, std::uint8_t becomes, std::int64_t& size);
  void widen(const Grid& grid);

  double half_;
  int per_cell_;
  double slack_;  // that a place may be off, where lines of places are between samples
  int columns_, rows_;
  std::vector<std::uint8_t> wanted_;
  std::vector<std::int64_t> waiting_;
  std::int64_t free_ = 0, wanted_count_ = 0;
  std::optional<Point> place_;
};

template <class Body>
void CoverGround::each_row_within(double r, Point a, Point b, const Body& body) const {
  constexpr double kRim = 1e-9;
  const double dx = b.x - a.x, dy = b.y - a.y, length = std::sqrt(dx * dx + dy * dy);
  const double nx = length > 0 ? -dy / length * r : 0, ny = length > 0 ? dx / length * r : 0;
  const Point box[4] = {
      {a.x + nx, a.y + ny}, {b.x + nx, b.y + ny}, {b.x - nx, b.y - ny}, {a.x - nx, a.y - ny}};
  const auto sample = [&](double v, bool up) {
    const double place = v * per_cell_ - 0.5;
    return static_cast<std::int64_t>(up ? std::ceil(place - kRim) : std::floor(place + kRim));
  };
  const std::int64_t first = std::max<std::int64_t>(0, sample(std::min(a.y, b.y) - r, true));
  const std::int64_t last =
      std::min<std::int64_t>(rows_ - 1, sample(std::max(a.y, b.y) + r, false));
  for (std::int64_t row = first; row <= last; ++row) {
    const double y = (static_cast<double>(row) + 0.5) * spacing();
    double least = columns_, most = -1;  // the capsule is convex: the hull of what is met of it
    const auto meet = [&](double x) {
      least = std::min(least, x);
      most = std::max(most, x);
    };
    for (const Point end : {a, b}) {
      const double square = r * r - (y - end.y) * (y - end.y);
      if (square < -kRim) continue;
      const double half = std::sqrt(std::max(0.0, square));
      meet(end.x - half);
      meet(end.x + half);
    }
    for (int i = 0; i < 4; ++i) {
      const Point p = box[i], q = box[(i + 1) % 4];
      if ((p.y <= y) == (q.y <= y)) continue;
      meet(p.x + (q.x - p.x) * ((y - p.y) / (q.y - p.y)));
    }
    const std::int64_t from = std::max<std::int64_t>(0, sample(least, true));
    const std::int64_t to = std::min<std::int64_t>(columns_ - 1, sample(most, false));
    if (from <= to) body(row * columns_ + from, row * columns_ + to);
  }
}

}  // namespace lasius::tour
