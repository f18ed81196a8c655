// Where along a straight line the centre of a tool may be.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/grid/distance.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"

namespace lasius::tour {

/// A direction of swaths, of length 1. A line is all points t along, c across.
struct Heading {
  double x = 1, y = 0;
  double degrees = 0;
  bool straight() const noexcept { return x == 0 || y == 0; }
  Heading across() const noexcept { return {-y, x, degrees < 90 ? degrees + 90 : degrees - 90}; }
  Point at(double t, double c) const noexcept { return {t * x - c * y, t * y + c * x}; }
  double along(Point p) const noexcept { return p.x * x + p.y * y; }
  double aside(Point p) const noexcept { return p.y * x - p.x * y; }
};

/// Directions that are tried, eight of them.
const std::vector<Heading>& headings();

/// From one t of a line to another.
struct Stretch {
  double from = 0, to = 0;
  double length() const noexcept { return to - from; }
};

/// The places of a tool's centre, line by line. Exact, but that the ends of stretches are drawn in
/// (a point's along an axis are not), and that a point keeps as much away from corners.
class ToolLines {
 public:
  /// Of a radius of 0 or more. Holds no grid; takes 8 bytes a run of blocked cells.
  ToolLines(const Grid& grid, double radius);

  /// Blocked cells of a row that are neighbours: from a column to before another.
  struct Run {
    int from, end;
  };
  std::span<const Run> runs(int row) const noexcept {
    return {runs_.data() + first_run_[row], runs_.data() + first_run_[row + 1]};
  }

  double radius() const noexcept { return radius_; }
  /// Are there corridors, along axes, that are just as wide as the tool?
  bool tight() const noexcept { return tight_; }
  static bool fits_tightly(double radius) noexcept;
  static constexpr double kDrawnIn = 1e-3;  ///< cells
  /// Replaces `places` by the stretches of a line that keep the radius from blocked cells and from
  /// what lies outside the map, rising; those shorter than ten times what they are drawn in by are
  /// left out. Only what is within a part of the line.
  void on_line(const Heading& heading, double c, std::vector<Stretch>& places,
               const Stretch& within = {-kAnywhere, kAnywhere}) const;
  static constexpr double kAnywhere = 1e9;
  /// Is the straight way between two places of places?
  bool straight_between(Point a, Point b) const;
  /// A place of a point that is within rounding of sides of cells, at them: planners tell such
  /// places from walls no more. Places of a disc as they are.
  Point settled(Point p) const noexcept;
  /// For a poller: of what it takes to find these places.
  std::int64_t work_of_line(const std::vector<Stretch>& places) const noexcept {
    return 8 * (std::int64_t{height_} + static_cast<std::int64_t>(places.size()));
  }
  /// The least and greatest c of any point of the map.
  Stretch extent(const Heading& heading) const noexcept;

 private:
  bool hull(const Heading& heading, double c, const Run& run, int row, Stretch& met) const noexcept;

  int width_, height_;
  double radius_, kept_;
  bool tight_;
  std::vector<Run> runs_;                // row by row
  std::vector<std::int64_t> first_run_;  // of each row
};

}  // namespace lasius::tour
