// Distances from a few places to every corner: bounds of what is left to go.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "lasius/grid/geometry.h"

namespace lasius::exact {

/// Landmarks L, and for each a number p(v) for each corner v such that |p(v) - p(w)| <= |vw| for
/// every edge vw of the graph: distances from L along shortest paths.
///
/// From a corner v where a shortest path bends it goes to a goal t along edges of the graph to a
/// corner w that t sees. So |vt| = |vw| + |wt|, and p(w) is from p(v) - |vw| to p(v) + |vw|. With
/// low, the least of p(w) + |wt| over all corners that t sees, and high, the largest of
/// p(w) - |wt|, follows |vt| >= low - p(v) and |vt| >= p(v) - high.
///
/// All p are multiples of a grain, a power of two, and lengths of edges count as rounded down to
/// such. So sums and differences are exact in floats.
/// Low and high are off by at most 2^-23 of themselves, a difference by as much once more:
/// 2^-21 of each is taken off, in Goal and in bound().
class Landmarks {
 public:
  static constexpr int kCount = 8;
  /// Not a number where a landmark is missing or cannot be reached: then it bounds nothing. Along
  /// edges all are known or none.
  using Distances = std::array<float, kCount>;
  static constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

  /// What corners in sight of a goal know: the least p + length and the largest p - length.
  struct Goal {
    Distances low, high;
    Goal() noexcept {
      low.fill(kUnknown);
      high.fill(kUnknown);
    }
    void set(std::size_t landmark, double least, double largest) noexcept {
      low[landmark] = static_cast<float>(least - kSlack * std::abs(least));
      high[landmark] = static_cast<float>(largest + kSlack * std::abs(largest));
    }
  };

  /// The grain for numbers up to `most`.
  static double grain(double most) noexcept { return std::ldexp(1, std::ilogb(most) - kDigits); }
  /// A length rounded down to grains.
  static double whole_grains(double length, double grain) noexcept {
    return static_cast<double>(static_cast<std::int64_t>(length / grain)) * grain;
  }

  Landmarks() = default;
  Landmarks(std::vector<Cell> cells, std::vector<Distances> distances, double grain)
      : grain_(grain), cells_(std::move(cells)), distances_(std::move(distances)) {}

  double grain() const noexcept { return grain_; }
  bool empty() const noexcept { return cells_.empty(); }
  /// A landmark is the centre of a cell.
  const std::vector<Cell>& cells() const noexcept { return cells_; }
  const Distances& distances(std::uint32_t corner) const noexcept { return distances_[corner]; }
  float& at(std::uint32_t corner, std::size_t landmark) noexcept {
    return distances_[corner][landmark];
  }

  /// The length of an edge in whole grains.
  float way(int x, int y) const noexcept {
    const double dx = x, dy = y;
    return static_cast<float>(whole_grains(std::sqrt(dx * dx + dy * dy), grain_));
  }

  void prefetch(std::uint32_t corner) const noexcept {
    __builtin_prefetch(distances_.data() + corner);
  }
  /// A lower bound of the way from a corner to a goal; 0 if there is none.
  double bound(std::uint32_t corner, const Goal& goal) const noexcept {
    const Distances& here = distances_[corner];
    std::array<float, kLanes> most{};
    for (std::size_t i = 0; i < kCount; i += kLanes) {
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const float before = goal.low[i + lane] - here[i + lane];
        const float behind = here[i + lane] - goal.high[i + lane];
        most[lane] = before > most[lane] ? before : most[lane];
        most[lane] = behind > most[lane] ? behind : most[lane];
      }
    }
    const float a = most[0] > most[1] ? most[0] : most[1];
    const float b = most[2] > most[3] ? most[2] : most[3];
    return (a > b ? a : b) * (1 - kSlack);
  }

  std::int64_t bytes() const noexcept {
    return static_cast<std::int64_t>(distances_.size() * sizeof(Distances));
  }

 private:
  static constexpr double kSlack = 1.0 / (1 << 21);
  static constexpr int kDigits = 23;  // of a float, after the first
  static constexpr std::size_t kLanes = 4;
  static_assert(kCount % kLanes == 0);

  double grain_ = 1;
  std::vector<Cell> cells_;
  std::vector<Distances> distances_;  // by corner
};

}  // namespace lasius::exact
