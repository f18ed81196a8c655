#include "core/cost/cell_chords.h"

#include <algorithm>
#include <array>
#include <cmath>
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

/// What is looked up of a cell's values. An interval's are a plane wave that goes on beyond it: at
/// a place base + slope * foot on its line, and no way from the interval costs less than `rise`
/// times the place's distance from that line makes the wave rise, or fall.
struct Waves {
  static constexpr std::size_t kMost = std::size_t{4} * CellChords::kMostIntervals;
  double base[kMost], slope[kMost], rise[kMost];
  double low[kMost], high[kMost];  // values of the interval
  double values[2 * kMost + 4];    // of places, twice over; 0 beyond
};

LASIUS_WIDE void find_waves(const double* values, int k, double weight, Waves& waves) noexcept {
  const int places = 4 * k;
  const double share = 1.0 / k;
  std::copy(values, values + places, waves.values);
  std::copy(values, values + places, waves.values + places);
  std::fill_n(waves.values + static_cast<std::ptrdiff_t>(2) * places, 4, 0.0);
  for (int edge = 0; edge < places; edge += k) {
    for (int along = 0; along < k; ++along) {
      const int e = edge + along;
      const double a = waves.values[e], b = waves.values[e + 1];
      const double slope = (b - a) * k, left = weight * weight - slope * slope;
      const double rise = std::sqrt(left > 0 ? left : 0);
      waves.slope[e] = slope;
      waves.base[e] = a - slope * (along * share);
      waves.rise[e] = left < 0 ? -kSteep : rise;
      waves.low[e] = a < b ? a : b;
      waves.high[e] = a < b ? b : a;
    }
  }
}

/// Says of each interval whether some place's value may be too far from its values: farther than
/// the wave rises, and than the cheapest straight way of all, `apart` long. `count`, of places off
/// an edge, is a multiple of 4.
LASIUS_WIDE void find_beyond(const Waves& waves, const double* foot, const double* off,
                             const double* apart, int k, int count, double weight, double tolerance,
                             std::uint8_t* found) noexcept {
  for (int e = 0; e < 4 * k; ++e) {
    const double* after = waves.values + static_cast<std::ptrdiff_t>(e / k + 1) * k + 1;
    const double* shortest = apart + static_cast<std::ptrdiff_t>(e % k) * count;
    const double base = waves.base[e], slope = waves.slope[e], rise = waves.rise[e];
    const double low = waves.low[e], high = waves.high[e];
    double most[4] = {-1e300, -1e300, -1e300, -1e300};
    for (int i = 0; i < count; i += 4) {
      for (int j = 0; j < 4; ++j) {
        const double value = after[i + j];
        const double wave = std::abs(value - (base + slope * foot[i + j])) - rise * off[i + j];
        const double above = value - low, below = high - value;
        const double range = (above > below ? above : below) - weight * shortest[i + j];
        const double least = wave < range ? wave : range;
        most[j] = least > most[j] ? least : most[j];
      }
    }
    found[e] = std::max(std::max(most[0], most[1]), std::max(most[2], most[3])) > tolerance;
  }
}

/// By how much each place's value is too far from those of an interval: where it is above the wave,
/// too high for the cheapest way there, else too low for the dearest place of the interval.
LASIUS_WIDE void miss_all(const double* after, const double* foot, const double* off, int count,
                          double base, double slope, double leaning, double first, double begin,
                          double end, double weight, double* out) noexcept {
  for (int i = 0; i < count; ++i) {
    const double over = after[i] - (base + slope * foot[i]);
    double t = foot[i] + (over > 0 ? -off[i] : off[i]) * leaning;
    t = t < begin ? begin : t;
    t = t > end ? end : t;
    const double along = t - foot[i];
    const double apart = after[i] - (first + slope * (t - begin));
    out[i] = (over > 0 ? apart : -apart) - weight * std::sqrt(off[i] * off[i] + along * along);
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
  for (int along = 0; along < k_; ++along) {
    for (std::size_t i = 0; i < foot_.size(); ++i) {
      const double beside = foot_[i] - std::clamp(foot_[i], along * share_, (along + 1) * share_);
      apart_.push_back(std::sqrt(off_[i] * off_[i] + beside * beside) * (1 - 1e-12));
    }
  }
}

void CellChords::reach(int interval, double low, double high, double weight,
                       double* out) const noexcept {
  const double begin = interval % k_ * share_, slope = (high - low) * k_;
  reach_all(foot_.data(), off_.data(), static_cast<int>(foot_.size()), begin, begin + share_, low,
            slope, lean(slope, weight), weight, out);
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
  each_violation_beside(values, weight, tolerance, found);
  each_violation_apart(values, weight, tolerance, found);
}

// Of chords along an edge, and of those between the intervals beside a corner.
template <class Found>
void CellChords::each_violation_beside(double* values, double weight, double tolerance,
                                       Found& found) const {
  const double step = weight * share_;
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
}

// Of a chord between two intervals that do not touch, one end is a place.
template <class Found>
void CellChords::each_violation_apart(double* values, double weight, double tolerance,
                                      Found& found) const {
  Waves waves;
  std::array<std::uint8_t, Waves::kMost> beyond;
  std::array<double, Waves::kMost> miss;
  find_waves(values, k_, weight, waves);
  const int off_edge = 3 * k_ - 1, count = static_cast<int>(foot_.size());
  // So that rounding hides nothing from what follows.
  const double most = *std::max_element(values, values + places_);
  find_beyond(waves, foot_.data(), off_.data(), apart_.data(), k_, count, weight,
              tolerance - 1e-15 * most, beyond.data());
  for (int e = 0; e < places_; ++e) {
    if (beyond[e] == 0) continue;
    const int e1 = next(e), first = (e / k_ + 1) * k_ + 1;
    const double begin = e % k_ * share_, end = begin + share_;
    double slope = (values[e1] - values[e]) * k_, leaning = lean(slope, weight);
    miss_all(waves.values + first, foot_.data(), off_.data(), off_edge, values[e] - slope * begin,
             slope, leaning, values[e], begin, end, weight, miss.data());
    for (int i = 0; i < off_edge; ++i) {
      if (!(miss[i] > tolerance)) continue;
      // The same again: values may have been lowered since.
      const int place = first + i < places_ ? first + i : first + i - places_;
      const double foot = foot_[i], off = off_[i];
      const bool over = values[place] > values[e] + slope * (foot - begin);
      const double t = std::clamp(foot + (over ? -off : off) * leaning, begin, end);
      const double way = weight * std::sqrt(off * off + (t - foot) * (t - foot));
      const double apart = values[place] - (values[e] + slope * (t - begin));
      const double by = (over ? apart : -apart) - way;
      if (!(by > tolerance)) continue;
      const double least = apart_[static_cast<std::size_t>(e % k_) * count + i];
      if (over)
        found(place, by, least);
      else if (t == begin)
        found(e, by, least);
      else if (t == end)
        found(e1, by, least);
      else
        found.between(e, (t - begin) * k_, by, least);
      for (const int changed : {place, e, e1})
        waves.values[changed] = waves.values[changed + places_] = values[changed];
      slope = (values[e1] - values[e]) * k_;
      leaning = lean(slope, weight);
    }
  }
}

// found(interval, by): somewhere on the interval the value is too great by `by`.
template <class Found>
void CellChords::each_violation_from(Point from, double* values, double weight,
                                     const Found& found) const {
  // By edge: where the point is along it, and how far from it.
  const double along[] = {from.x, from.y, 1 - from.x, 1 - from.y};
  const double apart[] = {from.y, 1 - from.x, 1 - from.y, from.x};
  for (int interval = 0; interval < places_; ++interval) {
    const double a = along[interval / k_], d = apart[interval / k_];
    const double low = values[interval], high = values[(interval + 1) % places_];
    const double begin = interval % k_ * share_, slope = (high - low) * k_;
    const double t = std::clamp(a + d * lean(slope, weight), begin, begin + share_);
    const double by = low + slope * (t - begin) - weight * std::sqrt(d * d + (t - a) * (t - a));
    if (by > 0) found(interval, by);
  }
}

void CellChords::lower_from(Point from, double* values, double weight) const {
  each_violation_from(from, values, weight, [&](int interval, double by) {
    values[interval] -= by;
    values[(interval + 1) % places_] -= by;
  });
}

double CellChords::excess_from(Point from, const double* values, double weight) const {
  double most = 1;
  const double least = weight * std::min({from.x, from.y, 1 - from.x, 1 - from.y});
  std::array<double, std::size_t{4} * kMostIntervals> kept;
  std::copy(values, values + places_, kept.begin());
  // By least way: what is too great at one place is nowhere more than that.
  each_violation_from(from, kept.data(), weight,
                      [&](int, double by) { most = std::max(most, 1 + by / least); });
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
  double kept[4 * kMostIntervals] = {};
  std::copy(values, values + places_, kept);
  each_violation(kept, weight, 0, excess);
  return excess.most;
}

}  // namespace lasius::cost
