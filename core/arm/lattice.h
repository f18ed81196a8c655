// The lattice of tip positions, and what is known of it.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <span>
#include <utility>

#include "core/arm/kinematics.h"
#include "core/base/poller.h"
#include "core/base/zero_array.h"
#include "lasius/arm_plan.h"
#include "lasius/stop.h"

namespace lasius::arm {

/// Moves of the tip: +x, -x, +y, -y, +z, -z.
inline constexpr int kMoves = 6;

/// A point of the lattice, by number; the points around the box have numbers too.
using Node = std::int64_t;

/// Lattice points are numbered row by row, with one layer around the box that no ant enters. What
/// is found out about a point or an edge is kept, by whichever thread comes first; a thread that
/// wants to know what another one is finding out waits for it. The answers depend on the world
/// only, so it does not matter who asks.
class Lattice {
 public:
  /// `low` and `high` bound the box, both inclusive, 0 within. The start is the point 0; `goal` is
  /// moved onto `goal_position`.
  Lattice(const Kinematics& kinematics, const Sensor& sensor, std::span<const double> start,
          double pitch, std::array<int, 3> low, std::array<int, 3> high, std::array<int, 3> goal,
          Vec3 goal_position, const Params& parameters);

  static constexpr Node kMostNodes = Node{1} << 24;

  Node nodes() const noexcept { return nodes_; }
  Node start() const noexcept { return start_; }
  Node goal() const noexcept { return goal_; }
  double pitch() const noexcept { return pitch_; }
  Node to(Node v, int move) const noexcept { return v + delta_[move]; }
  /// True for a point of the layer around the box.
  bool outside(Node v) const noexcept;
  std::array<int, 3> coordinates(Node v) const noexcept;
  Node node(std::array<int, 3> v) const noexcept;
  int manhattan(Node v) const noexcept;  ///< moves to the goal if nothing is in the way

  /// The undirected edge of a move, by number; below 3 nodes().
  std::int64_t edge(Node v, int move) const noexcept {
    return 3 * (move % 2 == 0 ? v : v + delta_[move]) + move / 2;
  }

  Vec3 position(Node v) const noexcept;
  /// Joint values, null where there are none. Kinematics only.
  const double* configuration(Node v) const;
  /// u^gamma of the moves out of a point whose configuration was asked for (eq. 9).
  const float* guidance(Node v) const noexcept { return guidance_.at(v * 8); }

  /// True when the move can be made. Asks the sensor what is not known. Precondition: `v` has a
  /// configuration that is free.
  bool open(Node v, int move) const;
  /// The same as far as it is known; kinematics is worked out, the sensor not asked.
  bool maybe_open(Node v, int move) const;
  /// True when the sensor was asked and said no.
  bool known_blocked(Node v) const noexcept { return load(position_[v]) == kNo; }

  bool position_free(Node v) const;
  Questions questions() const noexcept {
    return {.positions = positions_asked_, .motions = motions_asked_};
  }
  /// How many were asked so far, by any thread.
  std::int64_t asked() const noexcept {
    return positions_asked_.load(std::memory_order_relaxed) +
           motions_asked_.load(std::memory_order_relaxed);
  }

 private:
  enum Answer : std::uint8_t { kUnknown, kAsking, kYes, kNo };

  static std::uint8_t load(std::uint8_t& answer) noexcept {
    return std::atomic_ref(answer).load(std::memory_order_acquire);
  }
  /// The answer, found by `find` unless it is known; one thread at a time looks for each.
  template <class Find>
  static bool answer_once(std::uint8_t& answer, const Find& find);

  /// As a sensor takes them, not copied. Precondition: the point has some.
  Eigen::Map<const JointVector> joint_values(Node v) const {
    return {values_.at(v * joints_), joints_};
  }
  bool solve(Node v, JointArray& q) const;
  bool reachable_by_joints(Node a, Node b) const noexcept;
  void fill_guidance(Node v) const noexcept;

  const Kinematics& kinematics_;
  const Sensor& sensor_;
  int joints_;
  double pitch_;
  double gamma_;
  double joint_step_;
  std::array<int, 3> low_, high_, goal_at_;
  std::array<Node, kMoves> delta_;
  Node nodes_, start_, goal_;
  Vec3 origin_, goal_position_;

  // What was worked out or asked so far.
  mutable ZeroArray<double> values_;          // joint values by point
  mutable ZeroArray<float> guidance_;         // 8 a point
  mutable ZeroArray<std::uint8_t> solved_;    // Answer by point: it has joint values
  mutable ZeroArray<std::uint8_t> position_;  // Answer by point: it is free
  mutable ZeroArray<std::uint8_t> edges_;     // Answer by edge: it is open
  mutable std::atomic<std::int64_t> positions_asked_{0}, motions_asked_{0};
};

/// Polls after so many steps, and after every question that was asked: a sensor may take its time.
class LatticePoller {
 public:
  LatticePoller(const Lattice& lattice, const StopCondition& stop, std::int64_t interval) noexcept
      : lattice_(lattice), poller_(stop, interval), interval_(interval), asked_(lattice.asked()) {}

  /// As Poller::stop_after.
  bool stop_after(std::int64_t steps) {
    const auto asked = lattice_.asked();
    return poller_.stop_after(asked != std::exchange(asked_, asked) ? interval_ : steps);
  }
  bool stopped() const noexcept { return poller_.stopped(); }
  StopCondition::Cause cause() const noexcept { return poller_.cause(); }

 private:
  const Lattice& lattice_;
  Poller poller_;
  std::int64_t interval_;
  std::int64_t asked_;
};

}  // namespace lasius::arm
