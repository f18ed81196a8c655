#include "core/cost/crossings.h"

#include <algorithm>

namespace lasius::cost {
namespace {

/// Lengths are smoothed by this in derivatives: two crossings may lie at one corner.
constexpr double kSmooth = 1e-7;

}  // namespace

double cost_through(Point from, Point to, std::span<const Crossing> crossings,
                    std::span<const double> weights) noexcept {
  double sum = 0;
  Point before = from;
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    const Point at = crossings[i].point();
    sum += weights[i] * distance(before, at);
    before = at;
  }
  return sum + weights[crossings.size()] * distance(before, to);
}

// The cost is convex in all t together: Newton's method, projected on [0, 1].
double CrossingsOptimizer::optimize(Point from, Point to, std::span<Crossing> crossings,
                                    std::span<const double> weights, int most_steps) {
  double cost = cost_through(from, to, crossings, weights);
  if (crossings.empty()) return cost;
  double damping = 1e-6;
  trial_.assign(crossings.begin(), crossings.end());
  bool moved = true;
  for (int step = 0; step < most_steps && damping < 1e6; ++step) {
    if (moved) derive_within(from, to, crossings, weights);
    solve(damping);
    double gain = 0;
    for (double share = 1; share > 0.1; share /= 2) {
      for (std::size_t i = 0; i < crossings.size(); ++i)
        trial_[i].t = std::clamp(crossings[i].t + share * move_[i], 0.0, 1.0);
      const double there = cost_through(from, to, trial_, weights);
      if (!(there < cost)) continue;
      gain = cost - there;
      cost = there;
      break;
    }
    moved = gain > 0;
    if (moved) {
      std::ranges::copy(trial_, crossings.begin());
      damping = std::max(1e-9, damping * 0.1);
      if (gain < 1e-13 * cost) break;
    } else {
      damping *= 100;
    }
  }
  return cost;
}

// The same, save that what is pushed out at an end stays there.
void CrossingsOptimizer::derive_within(Point from, Point to, std::span<const Crossing> crossings,
                                       std::span<const double> weights) {
  derive(from, to, crossings, weights);
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    const double t = crossings[i].t;
    if ((t > 0 || slope_[i] < 0) && (t < 1 || slope_[i] > 0)) continue;
    slope_[i] = 0;
    bend_[i] = 1;
    coupling_[i] = 0;
    if (i > 0) coupling_[i - 1] = 0;
  }
}

void CrossingsOptimizer::derive(Point from, Point to, std::span<const Crossing> crossings,
                                std::span<const double> weights) {
  const std::size_t n = crossings.size();
  slope_.assign(n, 0);
  bend_.assign(n, 0);
  coupling_.assign(n, 0);
  Point before = from;
  for (std::size_t i = 0; i <= n; ++i) {
    const Point at = i < n ? crossings[i].point() : to;
    const double dx = at.x - before.x, dy = at.y - before.y;
    const double length = std::sqrt(dx * dx + dy * dy + kSmooth * kSmooth);
    const double ux = dx / length, uy = dy / length, stiff = weights[i] / length;
    const auto along = [&](const Crossing& c) { return c.level ? ux : uy; };
    if (i < n) {
      const double u = along(crossings[i]);
      slope_[i] += weights[i] * u;
      bend_[i] += stiff * (1 - u * u);
    }
    if (i > 0) {
      const double u = along(crossings[i - 1]);
      slope_[i - 1] -= weights[i] * u;
      bend_[i - 1] += stiff * (1 - u * u);
      if (i < n) {
        const double same = crossings[i].level == crossings[i - 1].level ? 1 : 0;
        coupling_[i - 1] = -stiff * (same - u * along(crossings[i]));
      }
    }
    before = at;
  }
}

// Tridiagonal: one sweep down, one up.
void CrossingsOptimizer::solve(double damping) {
  const std::size_t n = slope_.size();
  move_.resize(n);
  scratch_.resize(n);
  double pivot = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double below = i > 0 ? coupling_[i - 1] : 0;
    pivot = bend_[i] * (1 + damping) + damping - (i > 0 ? below * scratch_[i - 1] : 0);
    pivot = std::max(pivot, 1e-12);
    scratch_[i] = coupling_[i] / pivot;
    move_[i] = (-slope_[i] - (i > 0 ? below * move_[i - 1] : 0)) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 0;) move_[i] -= scratch_[i] * move_[i + 1];
}

}  // namespace lasius::cost
