// Chords of one cell, between points of its boundary, and values that are linear on k intervals of
// each of its edges.
//
// Places on the boundary are numbered clockwise from the upper left corner: place p is p % k of k
// intervals along edge p / k, of 4 k in all. Interval p lies between the places p and p + 1.
#pragma once

#include <cstdint>
#include <vector>

#include "lasius/grid/geometry.h"

namespace lasius::cost {

/// For one k; immutable.
class CellChords {
 public:
  static constexpr int kMostIntervals = 64;

  /// @param intervals  an edge, 2 to kMostIntervals
  explicit CellChords(int intervals);

  int intervals() const noexcept { return k_; }
  int places() const noexcept { return places_; }
  /// Of a place, within the unit cell.
  Point at(int place) const noexcept { return at_[place]; }

  /// The least of value + weight * distance over interval `interval`, whose values are `low` at its
  /// beginning and `high` at its end, for each place off its edge: of place
  /// (k * (interval / k) + k + 1 + i) % (4 k) in out[i], 3 k - 1 in all, and up to 3 more are
  /// written.
  void reach(int interval, double low, double high, double weight, double* out) const noexcept;

  /// The cheapest way from a point of the cell to its boundary.
  struct Exit {
    double cost;  ///< value there + weight * distance; infinite where there is none
    double value;
    Point at;      ///< within the unit cell
    int interval;  ///< -1 where there is none
  };
  /// Over the intervals that do not lie on a line through an edge that the point is on.
  Exit cheapest(Point from, const double* values, double weight) const noexcept;

  /// Lowers values until no chord between two points a, b of the boundary costs less than the value
  /// at b minus that at a, up to `tolerance`. Returns whether any was lowered; each that was is
  /// marked in `lowered`.
  bool lower(double* values, double weight, double tolerance, std::uint8_t* lowered) const;
  /// Lowers values until none on the boundary is more than the way there from a point inside costs.
  void lower_from(Point from, double* values, double weight) const;
  /// How many times that way the value is at most, over the boundary; at least 1.
  double excess_from(Point from, const double* values, double weight) const;

  /// The least factor by which the weight would have to be greater for all chords to cost enough;
  /// at least 1.
  double excess(const double* values, double weight) const;

 private:
  template <class Found>
  void each_violation_from(Point from, double* values, double weight, const Found& found) const;
  template <class Found>
  void each_violation(double* values, double weight, double tolerance, Found& found) const;
  template <class Found>
  void each_violation_beside(double* values, double weight, double tolerance, Found& found) const;
  template <class Found>
  void each_violation_apart(double* values, double weight, double tolerance, Found& found) const;
  int next(int place) const noexcept { return place + 1 < places_ ? place + 1 : 0; }

  int k_;
  int places_;
  double share_;  // of an edge, one interval
  std::vector<Point> at_;
  std::vector<double> foot_;   // of the places after an edge: along it; a multiple of 4
  std::vector<double> off_;    // from its line
  std::vector<double> apart_;  // from each interval of the edge: no more than that
};

}  // namespace lasius::cost
