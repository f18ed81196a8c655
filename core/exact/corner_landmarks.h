// Distances from a few places to every corner: bounds of what is left to go.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "lasius/geometry.h"

namespace lasius::exact {

/// Landmarks L and their distances |L v| from the corners v of a map, along shortest paths. The
/// distance from a corner to a goal t is at least | |L t| - |L v| |.
///
/// Kept distances are floats, off by at most 2^-23 of themselves; those of a goal, made from them
/// and rounded once more, by 2^-22. With |L v| <= |L t| + |v t| the difference is off by less than
/// 2^-21 |L t| + 2^-21 |v t|: the first is taken off in Goal, the second in bound().
class Landmarks {
 public:
  static constexpr int kCount = 8;
  /// Not a number where a landmark is missing or cannot be reached: then it bounds nothing.
  using Distances = std::array<float, kCount>;
  static constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

  /// How far a goal is from the landmarks, at least and at most.
  struct Goal {
    Distances low, high;
    Goal() noexcept {
      low.fill(kUnknown);
      high.fill(kUnknown);
    }
    void set(std::size_t landmark, double distance) noexcept {
      low[landmark] = static_cast<float>(distance * (1 - kSlack));
      high[landmark] = static_cast<float>(distance * (1 + kSlack));
    }
  };

  Landmarks() = default;
  Landmarks(std::vector<Cell> cells, std::vector<Distances> distances)
      : cells_(std::move(cells)), distances_(std::move(distances)) {}

  bool empty() const noexcept { return cells_.empty(); }
  /// A landmark is the centre of a cell.
  const std::vector<Cell>& cells() const noexcept { return cells_; }
  const Distances& distances(std::uint32_t corner) const noexcept { return distances_[corner]; }

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
  static constexpr std::size_t kLanes = 4;
  static_assert(kCount % kLanes == 0);

  std::vector<Cell> cells_;
  std::vector<Distances> distances_;  // by corner
};

}  // namespace lasius::exact
