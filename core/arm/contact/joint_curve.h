// How joints go from one posture to another: straight, or along cubics.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "core/arm/robot/kinematics.h"

namespace lasius::arm {

/// q(s) = q + d first + d^2 / 2 second + d^3 / 6 third with d = s - begin, up to the next one's.
struct CurvePiece {
  double begin = 0;
  JointArray q{}, first{}, second{}, third{};

  CurvePiece() = default;
  /// Straight, s from 0 to 1.
  CurvePiece(std::span<const double> from, std::span<const double> to) {
    for (std::size_t j = 0; j < from.size(); ++j) {
      q[j] = from[j];
      first[j] = to[j] - from[j];
    }
  }
  double at(std::size_t j, double s) const noexcept {
    const double d = s - begin;
    return q[j] + d * (first[j] + d * (second[j] / 2 + d * third[j] / 6));
  }
  double rate(std::size_t j, double s) const noexcept {
    const double d = s - begin;
    return first[j] + d * (second[j] + d * third[j] / 2);
  }
  double bend(std::size_t j, double s) const noexcept {
    return std::abs(second[j] + (s - begin) * third[j]);
  }
};

/// Pieces one after another, q and its first derivative going on, over s from 0 to 1.
class JointCurve {
 public:
  /// Of so many joints; the pieces must outlive it. Precondition: the first begins at 0 or before.
  JointCurve(std::size_t joints, std::span<const CurvePiece> pieces)
      : joints_(joints), pieces_(pieces) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const double from = std::max(0.0, pieces[i].begin), to = end(i);
      for (std::size_t j = 0; j < joints_; ++j)
        way_ += std::abs(pieces[i].at(j, to) - pieces[i].at(j, from));
    }
  }

  std::size_t size() const noexcept { return joints_; }
  const CurvePiece& piece(double s) const noexcept {
    std::size_t i = 0;
    while (i + 1 < pieces_.size() && pieces_[i + 1].begin <= s) ++i;
    return pieces_[i];
  }
  /// By joint, the largest size of the second derivative from s - h to s + h.
  void bends(double s, double h, JointArray& most) const noexcept {
    most.fill(0);
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const double from = std::max(s - h, pieces_[i].begin), to = std::min(s + h, end(i));
      if (from > to) continue;
      for (std::size_t j = 0; j < joints_; ++j)
        most[j] = std::max({most[j], pieces_[i].bend(j, from), pieces_[i].bend(j, to)});
    }
  }
  /// About how far all joints go together.
  double way() const noexcept { return way_; }

 private:
  double end(std::size_t i) const noexcept {
    return i + 1 < pieces_.size() ? std::min(1.0, pieces_[i + 1].begin) : 1;
  }

  std::size_t joints_;
  std::span<const CurvePiece> pieces_;
  double way_ = 0;
};

}  // namespace lasius::arm
