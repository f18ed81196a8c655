// What an exact search is asked and answers, and how it words its answer.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/held_bytes.h"
#include "core/base/poller.h"
#include "core/base/special_values.h"
#include "core/exact/query_end.h"
#include "kernels/sight/sight.h"
#include "lasius/base/stop.h"
#include "lasius/grid/geometry.h"
#include "lasius/path/path.h"

namespace lasius {

namespace exact {
class Anytime;
}

/// Called with each shorter path, its length and a lower bound; false asks the search to end.
using OnImproved =
    std::function<bool(const std::vector<Point>& path, double length, double lower_bound)>;

struct ExactOptions {
  /// Stop once (length - lower_bound) / lower_bound is at most this, which is not negative.
  double target_gap = 0;
  const OnImproved* improved = nullptr;  ///< null: nobody looks on; must outlive the search
  /// Tells of no path before the stop condition was polled for the first time, and then of the best
  /// so far: a search that ends before that cannot be cut short, so its path need not be told.
  bool improved_once_polled = false;
  exact::Anytime* beside = nullptr;  ///< takes turns with the search, unless null; outlives it
};

/// How a search ended.
enum class ExactEnd {
  proven,       ///< the path is a shortest one
  target_gap,   ///< the path is within the target gap
  unreachable,  ///< there is no path
  stopped,      ///< by the stop condition; a path or none
};

struct ExactAnswer {
  ExactEnd end = ExactEnd::unreachable;
  StopCondition::Cause cause = StopCondition::Cause::none;
  std::vector<Point> path;  ///< start to goal; empty without one
  double length = kNaN;
  /// No path is shorter; infinite where none exists. The length itself when that is proven to be
  /// the optimum, up to exact::kRounding of it; else less by exact::rounding.
  double lower_bound = 0;
  bool optimal = false;
  /// All legs of the path but the first and the last are made of edges that were in sight when the
  /// map was prepared.
  bool stored_legs = false;
};

namespace exact {

/// Lengths are sums of square roots, one for each bend and one more, every operation rounded to
/// 2^-53. Bends are at least a cell apart, so a length below 2^22 cells is off by less than this
/// fraction of itself.
constexpr double kRounding = 1e-9;

/// By how much a length of any size may be off, as a fraction of it.
constexpr double rounding(double length) noexcept { return std::max(kRounding, length * 0x1p-52); }
/// rounding() of the longest path that there can be, of 2^30 cells.
constexpr double kWorstRounding = 0x1p-22;

/// In cells, between places in half cells: exact but for the square root where they are whole.
inline double distance(double x0, double y0, double x1, double y1) noexcept {
  const double dx = x1 - x0;
  const double dy = y1 - y0;
  return 0.5 * std::sqrt(dx * dx + dy * dy);
}

/// A path made from its goal back to its start; corners at which it is straight left out.
class BackwardPath {
 public:
  BackwardPath(const QueryEnd& goal, std::vector<Point>& path) : path_(path), last_(goal.fine()) {
    path_.assign(1, goal.point());
  }
  /// The next corner, in half cells, and where the path comes from.
  void corner(kernels::HalfPoint at, kernels::FinePoint parent) {
    const kernels::FinePoint here = kernels::fine(at);
    if (kernels::turn_sign(parent, here, last_) == 0) return;
    path_.push_back({0.5 * at.x, 0.5 * at.y});
    last_ = here;
  }
  void start(const QueryEnd& at) {
    path_.push_back(at.point());
    std::reverse(path_.begin(), path_.end());
  }

 private:
  std::vector<Point>& path_;
  kernels::FinePoint last_;
};

/// A certified bound that leaves room for the rounding of what it was computed from.
constexpr double rounded_down(double lower) noexcept { return lower * (1 - rounding(lower)); }

/// Work between two looks at the stop condition, 20 to 100 microseconds.
constexpr std::int64_t kWordsPerPoll = 8192;
/// What an expansion counts for, besides the words that it scans.
constexpr std::int64_t kWordsPerExpansion = 16;
/// Of frontiers, in cells.
constexpr double kBucketWidth = 0.03125;
/// W of the weighted search that runs now and then, but for the bounding one; the number of
/// expansions before it first runs, and its share of the expansions since.
constexpr double kDefaultWeight = 1.2;
constexpr std::int64_t kFirstWeighted = 16;
constexpr std::int64_t kWeightedShare = 8;

/// Tells whoever looks on of each shorter path, once.
class Improvements {
 public:
  void begin(const ExactOptions& options) noexcept {
    told_ = options.improved;
    once_polled_ = options.improved_once_polled;
    least_ = kInfinity;
  }
  /// False where the search is to end. `trace(path)` makes the path of length `upper`, if finite,
  /// and returns its length.
  /// @param poller  of the search; null when it has ended
  template <class Trace>
  bool tell(double lower, double upper, const Poller* poller, const Trace& trace) {
    if (told_ == nullptr || !(upper < least_)) return true;
    if (once_polled_ && (poller == nullptr || !poller->polled())) return true;
    least_ = upper;
    const double length = trace(path_);
    return (*told_)(path_, length, rounded_down(lower));
  }
  std::int64_t bytes() const noexcept { return held_bytes(path_); }

 private:
  const OnImproved* told_ = nullptr;
  bool once_polled_ = false;
  double least_ = 0;
  std::vector<Point> path_;
};

/// Says what a search that ended with these bounds found; `answer` has the path if there is one.
void conclude(double lower, double upper, StopCondition::Cause cause, double target_gap,
              ExactAnswer& answer);

}  // namespace exact
}  // namespace lasius
