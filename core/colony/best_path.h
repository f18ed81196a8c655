// The best path of a colony on a bitmap so far, and which ant found it.
#pragma once

#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "core/base/special_values.h"
#include "core/colony/polish.h"
#include "core/colony/tour_measures.h"
#include "core/colony/update.h"
#include "core/colony/walkers.h"
#include "kernels/base/moves.h"
#include "lasius/grid/geometry.h"
#include "lasius/path/path.h"

namespace lasius {

/// The shortest path that was offered, or none.
class BestPath {
 public:
  bool none() const noexcept { return points_.empty(); }
  const std::vector<Point>& points() const noexcept { return points_; }
  /// Leaves none.
  std::vector<Point> give() noexcept { return std::move(points_); }
  /// PolishedPath::of_point; of no meaning for a tour, or without a disc.
  double of_point() const noexcept { return of_point_; }
  /// NaN without one.
  double length() const noexcept { return length_ < kInfinity ? length_ : kNaN; }
  /// The ant of the last offer that it is of, by index; -1 where it is an older one.
  int finder() const noexcept { return finder_; }
  /// Length of the shortest path or tour that was offered since begin_iteration(), NaN without one.
  double iteration_best() const noexcept { return iteration_best_; }

  bool shorter_than(const BestPath& other) const noexcept { return length_ < other.length_; }

  void begin_iteration() noexcept { iteration_best_ = kNaN; }
  void drop() noexcept {
    points_.clear();
    length_ = of_point_ = kInfinity;
  }
  /// Offers every path as the best one, ties to the lower index. Of tours that are not polished, by
  /// choice or for lack of time, the shortest is offered. `paths` may be of more ants than `tours`.
  void offer(std::span<const PolishedPath> paths, std::span<const Tour> tours,
             const kernels::Moves& moves, Cell start, const TourMeasure& measure) {
    finder_ = -1;
    int left = -1;
    double shortest = length_;
    for (int a = 0; a < static_cast<int>(tours.size()); ++a) {
      const bool polished = !std::isnan(paths[a].length);
      iteration_best_ = std::fmin(iteration_best_, polished ? paths[a].length : tours[a].length);
      if (polished && paths[a].points.empty()) continue;
      if (paths[a].length < length_) {
        finder_ = a;
        length_ = paths[a].length;
      } else if (!polished && tours[a].length < shortest) {
        left = a;
        shortest = tours[a].length;
      }
    }
    if (finder_ >= 0) {
      points_ = paths[finder_].points;
      of_point_ = paths[finder_].of_point;
    }
    if (!(shortest < length_)) return;
    std::vector<Point> path;
    path.reserve(tours[left].moves.size() + 1);
    along_tour(tours[left].moves, moves, start, [&](Cell c) { path.push_back(centre(c)); });
    const double length = measure.of(path);
    if (!(length < length_)) return;  // by rounding it was
    finder_ = left;
    length_ = of_point_ = length;
    points_ = std::move(path);
  }

 private:
  std::vector<Point> points_;
  double length_ = kInfinity;
  double of_point_ = kInfinity;
  int finder_ = -1;
  double iteration_best_ = kNaN;
};

}  // namespace lasius
