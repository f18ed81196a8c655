#include "core/cost/cell_chords.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/special_values.h"
#include "core/cost/terrain.h"

// The thread sanitizer's code may not run as early as a choice between clones is made.
#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define LASIUS_ONE_CLONE
#endif
#endif

#if defined(__x86_64__) && defined(__GNUC__) && !defined(LASIUS_ONE_CLONE)
#define LASIUS_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define LASIUS_WIDE
#endif

namespace lasius::cost {
namespace {

constexpr double kSteep = 1e30;

/// How far from the foot, for each unit of distance from the line, the cheapest way leaves a line
/// along which values rise with `slope`.
double lean(double slope, double weight) noexcept {
  const double left = weight * weight - slope * slope;
  if (left > 0) return slope / std::sqrt(left);
  return slope > 0 ? kSteep : -kSteep;
}

// Plain loops, one operation after the other on every value: the same on any processor.
LASIUS_WIDE void reach_all(const double* foot, const double* off, int count, double begin,
                           double end, double low, double slope, double leaning, double weight,
                           double* out) noexcept {
  for (int i = 0; i < count; ++i) {
    double t = foot[i] - leaning * off[i];
    t = t < begin ? begin : t;
    t = t > end ? end : t;
    const double along = t - foot[i];
    out[i] = low + slope * (t - begin) + weight * std::sqrt(off[i] * off[i] + along * along);
  }
}

/// An interval's values as a plane wave that goes on beyond it: at a place they are
/// base + slope * foot on its line and rise by `rise` with the distance from it. No way from the
/// interval costs less than the wave rises, or falls.
struct Wave {
  double base, slope, rise;
};

/// Says of each interval whether the value at some place is farther from what its wave is on its
/// line than the wave rises on the way. `values` holds the places twice over; `count`, of places
/// off an edge, is a multiple of 4.
LASIUS_WIDE void find_beyond(const double* values, const Wave* waves, const double* foot,
                             const double* off, int k, int count, double tolerance,
                             std::uint8_t* found) noexcept {
  for (int edge = 0; edge < 4; ++edge) {
    const double* after = values + static_cast<std::ptrdiff_t>(edge + 1) * k + 1;
    for (int e = edge * k; e < (edge + 1) * k; ++e) {
      const Wave wave = waves[e];
      double most[4] = {-1e300, -1e300, -1e300, -1e300};
      for (int i = 0; i < count; i += 4) {
        for (int j = 0; j < 4; ++j) {
          const double apart = std::abs(after[i + j] - (wave.base + wave.slope * foot[i + j])) -
                               wave.rise * off[i + j];
          most[j] = apart > most[j] ? apart : most[j];
        }
      }
      found[e] = std::max(std::max(most[0], most[1]), std::max(most[2], most[3])) > tolerance;
    }
  }
}

}  // namespace

CellChords::CellChords(int intervals)
    : k_(intervals), places_(4 * intervals), share_(1.0 / intervals) {
  for (int place = 0; place < places_; ++place) {
    const double along = place % k_ * share_;
    const Point on_edge[4] = {{along, 0}, {1, along}, {1 - along, 1}, {0, 1 - along}};
    at_.push_back(on_edge[place / k_]);
  }
  for (int after = k_ + 1; after < places_; ++after) {
    foot_.push_back(at_[after].x);
    off_.push_back(at_[after].y);
  }
  // Places that nothing is too far from.
  while (foot_.size() % 4 != 0) {
    foot_.push_back(0);
    off_.push_back(kSteep);
  }
}

void CellChords::reach(int interval, double low, double high, double weight,
                       double* out) const noexcept {
  const double begin = interval % k_ * share_, slope = (high - low) * k_;
  reach_all(foot_.data(), off_.data(), 3 * k_ - 1, begin, begin + share_, low, slope,
            lean(slope, weight), weight, out);
}

CellChords::Exit CellChords::cheapest(Point from, const double* values,
                                      double weight) const noexcept {
  Exit best{kInfinity, kInfinity, {}, -1};
  const double off[4] = {from.y, 1 - from.x, 1 - from.y, from.x};
  const double foot[4] = {from.x, from.y, 1 - from.x, 1 - from.y};
  for (int interval = 0; interval < places_; ++interval) {
    const int edge = interval / k_;
    const double low = values[interval], high = values[(interval + 1) % places_];
    if (off[edge] == 0 || !(low < kInfinity) || !(high < kInfinity)) continue;
    const double begin = interval % k_ * share_, slope = (high - low) * k_;
    double t = foot[edge] - lean(slope, weight) * off[edge];
    t = std::clamp(t, begin, begin + share_);
    const double along = t - foot[edge];
    const double value = low + slope * (t - begin);
    const double cost = value + weight * std::sqrt(off[edge] * off[edge] + along * along);
    if (!(cost < best.cost)) continue;
    const Point on_edge[4] = {{t, 0}, {1, t}, {1 - t, 1}, {0, 1 - t}};
    best = {cost, value, on_edge[edge], interval};
  }
  return best;
}

// found(place, by, apart): the value at `place` is too great by `by` for a chord that is at least
// `apart` long. found.between(interval, share, by, apart): so is that at a share of an interval.
// They may lower values.
template <class Found>
void CellChords::each_violation(double* values, double weight, double tolerance,
                                Found& found) const {
  const double step = weight * share_;
  const auto next = [this](int place) { return place + 1 < places_ ? place + 1 : 0; };
  for (int p = 0; p < places_; ++p) {
    const int q = next(p);
    const double rise = values[q] - values[p];
    if (rise > step + tolerance) found(q, rise - step, share_);
    if (-rise > step + tolerance) found(p, -rise - step, share_);
  }
  for (int corner = 0; corner < places_; corner += k_) {
    const int before = corner > 0 ? corner - 1 : places_ - 1, after = corner + 1;
    const bool up = values[before] < values[corner];
    const int low = up ? before : after, high = up ? after : before;
    const double first = values[corner] - values[low], second = values[high] - values[corner];
    if (!(first > 0 && second > 0) || first * first + second * second <= step * step) continue;
    const double by = second - std::sqrt(std::max(0.0, step * step - first * first));
    // The steepest chord between the two intervals decides by how much the weight is too small.
    const double over = std::sqrt(first * first + second * second) / step - 1;
    if (by > tolerance) found(high, by, over > 0 ? by / (weight * over) : share_);
  }
  // Of a chord between two intervals that do not touch, one end is a place.
  std::array<double, std::size_t{8} * kMostIntervals + 4> twice{};
  std::array<Wave, std::size_t{4} * kMostIntervals> waves{};
  std::array<std::uint8_t, std::size_t{4} * kMostIntervals> beyond;
  const auto wave_of = [&](int interval) {
    const double low = values[interval], slope = (values[next(interval)] - low) * k_;
    const double left = weight * weight - slope * slope;
    return Wave{low - slope * (interval % k_ * share_), slope,
                left >= 0 ? std::sqrt(left) : -kSteep};
  };
  const auto take = [&](int place) { twice[place] = twice[place + places_] = values[place]; };
  double most = 0;
  for (int p = 0; p < places_; ++p) {
    take(p);
    waves[p] = wave_of(p);
    most = std::max(most, values[p]);
  }
  const int off_edge = 3 * k_ - 1;
  // So that rounding hides nothing from what follows.
  const double least = tolerance - 1e-15 * most;
  find_beyond(twice.data(), waves.data(), foot_.data(), off_.data(), k_,
              static_cast<int>(foot_.size()), least, beyond.data());
  for (int e = 0; e < places_; ++e) {
    if (beyond[e] == 0) continue;
    const int e1 = next(e), first = (e / k_ + 1) * k_ + 1;
    const double begin = e % k_ * share_, end = begin + share_;
    Wave wave = wave_of(e);
    for (int i = 0; i < off_edge; ++i) {
      const double foot = foot_[i], off = off_[i];
      const double over = twice[first + i] - (wave.base + wave.slope * foot);
      if (std::abs(over) - wave.rise * off <= least) continue;
      const int place = first + i < places_ ? first + i : first + i - places_;
      const double leaning = (over > 0 ? -off : off) * lean(wave.slope, weight);
      const double t = std::clamp(foot + leaning, begin, end);
      const double way = weight * std::sqrt(off * off + (t - foot) * (t - foot));
      const double there = values[e] + wave.slope * (t - begin);
      const double by = (over > 0 ? values[place] - there : there - values[place]) - way;
      if (!(by > tolerance)) continue;
      const double beside = foot - std::clamp(foot, begin, end);
      const double apart = std::sqrt(off * off + beside * beside);
      if (over > 0)
        found(place, by, apart);
      else if (t == begin)
        found(e, by, apart);
      else if (t == end)
        found(e1, by, apart);
      else
        found.between(e, (t - begin) * k_, by, apart);
      for (const int changed : {place, e, e1}) take(changed);
      wave = wave_of(e);
    }
  }
}

// found(interval, by, way): somewhere on the interval the value is too great by `by`.
template <class Found>
void CellChords::each_violation_from_centre(double* values, double weight,
                                            const Found& found) const {
  for (int interval = 0; interval < places_; ++interval) {
    const double low = values[interval], high = values[(interval + 1) % places_];
    const double begin = interval % k_ * share_, slope = (high - low) * k_;
    const double t = std::clamp(0.5 + 0.5 * lean(slope, weight), begin, begin + share_);
    const double way = weight * std::sqrt(0.25 + (t - 0.5) * (t - 0.5));
    const double by = low + slope * (t - begin) - way;
    if (by > 0) found(interval, by, way);
  }
}

void CellChords::lower_from_centre(double* values, double weight) const {
  each_violation_from_centre(values, weight, [&](int interval, double by, double) {
    values[interval] -= by;
    values[(interval + 1) % places_] -= by;
  });
}

double CellChords::excess_from_centre(const double* values, double weight) const {
  double most = 1;
  std::array<double, std::size_t{4} * kMostIntervals> kept;
  std::copy(values, values + places_, kept.begin());
  // By least way: what is too great at one place is nowhere more than that.
  each_violation_from_centre(kept.data(), weight, [&](int, double by, double) {
    most = std::max(most, 1 + by / (0.5 * weight));
  });
  return most;
}

namespace {

/// Lowers what is too great.
struct Lowering {
  double* values;
  std::uint8_t* lowered;
  int places;
  bool any = false;

  void operator()(int place, double by, double) {
    any = true;
    values[place] -= by;
    lowered[place] = 1;
  }
  // With many intervals each end by its part in the value between them, which lowers least in all;
  // with few, both alike: then less is lowered after it (measured).
  void between(int interval, double share, double by, double apart) {
    const int end = interval + 1 < places ? interval + 1 : 0;
    const double norm = (1 - share) * (1 - share) + share * share;
    const bool alike = places < 32;
    (*this)(interval, alike ? by : by * (1 - share) / norm, apart);
    (*this)(end, alike ? by : by * share / norm, apart);
  }
};

/// The greatest factor that a weight is too small by.
struct Excess {
  double weight;
  double most = 1;

  void operator()(int, double by, double apart) {
    most = std::max(most, 1 + by / (weight * apart));
  }
  void between(int place, double, double by, double apart) { (*this)(place, by, apart); }
};

}  // namespace

bool CellChords::lower(double* values, double weight, double tolerance,
                       std::uint8_t* lowered) const {
  Lowering lowering{values, lowered, places_};
  for (int round = 0; round < 8; ++round) {
    const bool before = std::exchange(lowering.any, false);
    each_violation(values, weight, tolerance, lowering);
    if (!lowering.any) return before;
  }
  return true;
}

double CellChords::excess(const double* values, double weight) const {
  Excess excess{weight};
  double kept[4 * kMostIntervals];
  std::copy(values, values + places_, kept);
  each_violation(kept, weight, 0, excess);
  return excess.most;
}

}  // namespace lasius::cost
