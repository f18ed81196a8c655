// The cells that a footprint meets at a pose, row by row.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "core/vehicle/angle.h"
#include "lasius/vehicle/vehicle.h"

namespace lasius::vehicle {

/// A whole number not above `v`, |v| at most 2^20.
inline int floor_of(double v) noexcept { return static_cast<int>(v + 1048576) - 1048576; }

/// A footprint, with what is asked of it again and again.
class Outline {
 public:
  static constexpr double kMargin = 1e-9;  ///< what is nearer than that is met

  explicit Outline(const Vehicle& vehicle);

  double around() const noexcept { return around_; }  ///< radius of the circle that holds it
  double inside() const noexcept { return inside_; }  ///< radius of the disc in it

  /// A disc in the frame of the vehicle. All together hold the footprint; each has within it a
  /// smaller one that lies in the footprint.
  struct Cover {
    Point centre;
    double outer = 0, inner = 0;  ///< radii; inner is 0 where the centre lies outside
  };
  std::span<const Cover> covers() const noexcept { return {covers_.data(), covers_count_}; }

  /// Calls visit(row, first column, last column) for the cells whose closed squares the footprint
  /// meets once every point of it is moved by up to `grown` along each axis. Cells may be told
  /// twice. Ends early with true as soon as a visit returns true.
  template <class Visit>
  bool visit_cells(const Pose& pose, double grown, Visit&& visit) const {
    const int left = floor_of(pose.x);
    const int top = floor_of(pose.y);
    Corners corners;
    turn(pose, left, top, corners);
    const double g = grown + kMargin;
    const auto shifted = [&](int row, double low, double high) {
      return visit(row + top, floor_of(low) + left, floor_of(high) + left);
    };
    return convex_ ? visit_convex(corners, g, shifted) : visit_any(corners, g, shifted);
  }

 private:
  static constexpr int kCorners = 256;
  static constexpr int kRows = 2200;
  using Corners = std::array<Point, kCorners + 1>;

  void turn(const Pose& pose, int left, int top, Corners& to) const noexcept {
    const auto [sine, cosine] = kernels::sine_cosine(pose.yaw);
    const double x = pose.x - left;
    const double y = pose.y - top;
    for (int i = 0; i < count_; ++i) {
      const Point p = corners_[i];
      to[i] = {x + p.x * cosine - p.y * sine, y + p.x * sine + p.y * cosine};
    }
    to[count_] = to[0];
  }

  /// Calls put(row, low, high) for the columns of an edge in every row's band, both grown.
  template <class Put>
  static bool visit_edge(Point a, Point b, double g, Put&& put) {
    if (a.y > b.y) std::swap(a, b);
    const int last = floor_of(b.y + g);
    const double slope = b.y > a.y ? (b.x - a.x) / (b.y - a.y) : 0;
    const double least = std::min(a.x, b.x);
    const double most = std::max(a.x, b.x);
    for (int row = floor_of(a.y - g); row <= last; ++row) {
      double from = row - g > a.y ? a.x + (row - g - a.y) * slope : a.x;
      double to = row + 1 + g < b.y ? a.x + (row + 1 + g - a.y) * slope : b.x;
      if (from > to) std::swap(from, to);
      if (put(row, std::max(from, least) - g, std::min(to, most) + g)) return true;
    }
    return false;
  }

  template <class Visit>
  bool visit_convex(const Corners& corners, double g, Visit&& visit) const {
    double top = corners[0].y;
    double bottom = top;
    for (int i = 1; i < count_; ++i) {
      top = std::min(top, corners[i].y);
      bottom = std::max(bottom, corners[i].y);
    }
    const int first = floor_of(top - g);
    const int rows = floor_of(bottom + g) - first + 1;
    std::array<double, kRows> low;
    std::array<double, kRows> high;
    std::fill_n(low.begin(), rows, 1e9);
    std::fill_n(high.begin(), rows, -1e9);
    for (int i = 0; i < count_; ++i) {
      visit_edge(corners[i], corners[i + 1], g, [&](int row, double from, double to) {
        low[row - first] = std::min(low[row - first], from);
        high[row - first] = std::max(high[row - first], to);
        return false;
      });
    }
    for (int row = 0; row < rows; ++row) {
      if (visit(row + first, low[row], high[row])) return true;
    }
    return false;
  }

  // What no edge meets lies inside or outside as a whole, as its middle line does.
  template <class Visit>
  bool visit_any(const Corners& corners, double g, Visit&& visit) const {
    int first = 1 << 20;
    int last = -first;
    for (int i = 0; i < count_; ++i) {
      if (visit_edge(corners[i], corners[i + 1], g, visit)) return true;
      first = std::min(first, floor_of(corners[i].y));
      last = std::max(last, floor_of(corners[i].y));
    }
    std::array<double, kCorners> crossings;
    for (int row = first; row <= last; ++row) {
      int met = 0;
      for (int i = 0; i < count_; ++i) {
        const Point a = corners[i];
        const Point b = corners[i + 1];
        if ((a.y > row + 0.5) == (b.y > row + 0.5)) continue;
        crossings[met++] = a.x + (row + 0.5 - a.y) * (b.x - a.x) / (b.y - a.y);
      }
      std::sort(crossings.begin(), crossings.begin() + met);
      for (int i = 0; i + 1 < met; i += 2) {
        if (visit(row, crossings[i], crossings[i + 1])) return true;
      }
    }
    return false;
  }

  static constexpr int kSlices = 8;
  void lay_covers(const Vehicle& vehicle);

  std::array<Point, kCorners> corners_{};
  std::array<Cover, kSlices + 2> covers_{};
  std::size_t covers_count_ = 0;
  int count_;
  bool convex_;
  double around_, inside_;
};

}  // namespace lasius::vehicle
