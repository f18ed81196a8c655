#include "core/cost/cell_chords.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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

double to_segment(Point p, Point a, Point b) noexcept {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double t = ((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy);
  const double on = std::clamp(t, 0.0, 1.0);
  return distance(p, {a.x + on * dx, a.y + on * dy});
}

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

/// Says of each interval whether one of the others may be too high for its lowest value.
LASIUS_WIDE void find_low(const double* low, const double* high, const float* apart, int count,
                          double weight, double tolerance, std::uint8_t* found) noexcept {
  for (int e = 0; e < count; ++e, apart += count) {
    double most[4] = {-1e300, -1e300, -1e300, -1e300};
    for (int i = 0; i < count; i += 4) {
      for (int j = 0; j < 4; ++j) {
        const double value = high[i + j] - weight * static_cast<double>(apart[i + j]);
        most[j] = value > most[j] ? value : most[j];
      }
    }
    found[e] =
        std::max(std::max(most[0], most[1]), std::max(most[2], most[3])) > low[e] + tolerance;
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
  apart_.resize(static_cast<std::size_t>(places_) * places_);
  for (int e = 0; e < places_; ++e) {
    for (int f = 0; f < places_; ++f) {
      const Point a = at_[e], b = at_[(e + 1) % places_], c = at_[f], d = at_[(f + 1) % places_];
      const double apart = std::min(
          {to_segment(a, c, d), to_segment(b, c, d), to_segment(c, a, b), to_segment(d, a, b)});
      const bool skip = e / k_ == f / k_ || apart < share_ / 2;
      apart_[static_cast<std::size_t>(e) * places_ + f] =
          skip ? 1e30F : static_cast<float>(apart * (1 - 1e-6));
    }
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

// found(place, by, other, apart): the value at `place`, and that at `other` unless it is -1, are
// too great by `by` for a chord that is at least `apart` long. It may lower values.
template <class Found>
void CellChords::each_violation(double* values, double weight, double tolerance,
                                const Found& found) const {
  const double step = weight * share_;
  const auto next = [this](int place) { return place + 1 < places_ ? place + 1 : 0; };
  for (int p = 0; p < places_; ++p) {
    const int q = next(p);
    const double rise = values[q] - values[p];
    if (rise > step + tolerance) found(q, rise - step, -1, share_);
    if (-rise > step + tolerance) found(p, -rise - step, -1, share_);
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
    if (by > tolerance) found(high, by, -1, over > 0 ? by / (weight * over) : share_);
  }
  std::array<double, std::size_t{4} * kMostIntervals> high, lows;
  std::array<std::uint8_t, std::size_t{4} * kMostIntervals> violated;
  const int places = std::max(places_, 8);  // of two intervals an edge or more
  for (int p = 0; p < places; ++p) {
    high[p] = std::max(values[p], values[next(p)]);
    lows[p] = std::min(values[p], values[next(p)]);
  }
  find_low(lows.data(), high.data(), apart_.data(), places, weight, tolerance, violated.data());
  for (int e = 0; e < places_; ++e) {
    if (violated[e] == 0) continue;
    const int e1 = next(e);
    const double low = std::min(values[e], values[e1]);
    const float* apart = apart_.data() + static_cast<std::size_t>(e) * places_;
    for (int f = 0; f < places_; ++f) {
      const int f1 = next(f);
      const double length = apart[f];
      if (high[f] <= low + weight * length + tolerance) continue;
      // From anywhere on e to the ends of f.
      const double slope_e = (values[e1] - values[e]) * k_, lean_e = lean(slope_e, weight);
      const double begin_e = e % k_ * share_;
      for (const int b : {f, f1}) {
        const int after = (b + places_ - e / k_ * k_) % places_;
        if (after <= k_) continue;  // on the line of e
        const double foot = foot_[after - k_ - 1], off = off_[after - k_ - 1];
        const double t = std::clamp(foot - lean_e * off, begin_e, begin_e + share_);
        const double most = values[e] + slope_e * (t - begin_e) +
                            weight * std::sqrt(off * off + (t - foot) * (t - foot));
        if (values[b] > most + tolerance) found(b, values[b] - most, -1, length);
      }
      // From the ends of e to anywhere on f.
      const double begin_f = f % k_ * share_;
      for (const int a : {e, e1}) {
        const int after = (a + places_ - f / k_ * k_) % places_;
        if (after <= k_) continue;
        const double slope = (values[f1] - values[f]) * k_;
        const double foot = foot_[after - k_ - 1], off = off_[after - k_ - 1];
        const double t = std::clamp(foot + lean(slope, weight) * off, begin_f, begin_f + share_);
        const double by = values[f] + slope * (t - begin_f) -
                          weight * std::sqrt(off * off + (t - foot) * (t - foot)) - values[a];
        if (!(by > tolerance)) continue;
        if (t == begin_f)
          found(f, by, -1, length);
        else if (t == begin_f + share_)
          found(f1, by, -1, length);
        else
          found(f, by, f1, length);
      }
      high[f] = std::max(values[f], values[f1]);
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

bool CellChords::lower(double* values, double weight, double tolerance,
                       std::uint8_t* lowered) const {
  bool any = false;
  for (int round = 0; round < 8; ++round) {
    bool again = false;
    each_violation(values, weight, tolerance, [&](int place, double by, int other, double) {
      again = true;
      values[place] -= by;
      lowered[place] = 1;
      if (other < 0) return;
      values[other] -= by;
      lowered[other] = 1;
    });
    if (!again) return any;
    any = true;
  }
  return any;
}

double CellChords::excess(const double* values, double weight) const {
  double most = 1;
  double kept[4 * kMostIntervals];
  std::copy(values, values + places_, kept);
  each_violation(kept, weight, 0, [&](int, double by, int, double apart) {
    most = std::max(most, 1 + by / (weight * apart));
  });
  return most;
}

}  // namespace lasius::cost
