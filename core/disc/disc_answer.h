// What a search for a disc's path answers.
#pragma once

#include "core/disc/curve.h"
#include "core/exact/exact_answer.h"

namespace lasius::disc {

/// As of a point: `path` is the polyline of the curve (polyline_of), `length` the curve's own,
/// which is the one that `lower_bound` and `optimal` are about.
struct DiscAnswer : ExactAnswer {
  Curve curve;  ///< start to goal; empty without one
};

/// Says what a search came to: as exact::conclude, for a curve.
inline void conclude(double lower, double upper, StopCondition::Cause cause, double target_gap,
                     Curve curve, const DiscSpace& space, DiscAnswer& answer) {
  answer.curve = std::move(curve);
  answer.path = polyline_of(answer.curve, space);
  exact::conclude(lower, upper, cause, target_gap, answer);
  if (answer.path.empty()) return;
  answer.length = curve_length(answer.curve);
  if (answer.optimal) answer.lower_bound = answer.length;
}

}  // namespace lasius::disc
