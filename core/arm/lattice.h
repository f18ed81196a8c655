// The lattice of tip positions, and what is known of it.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/arm/ends.h"
#include "core/arm/robot/kinematics.h"
#include "core/base/large_array.h"
#include "core/base/poller.h"
#include "lasius/arm/plan.h"
#include "lasius/base/stop.h"

namespace lasius::arm {

/// Moves of the tip: +x, -x, +y, -y, +z, -z. After them the move to an end nearby, if there is one.
inline constexpr int kTipMoves = 6;
inline constexpr int kMostMoves = kTipMoves + 1;

/// A point of the lattice, by number; points around the box have numbers too; after them, the ends.
using Node = std::int64_t;

/// What to try where a lattice has no way, for people.
inline constexpr const char* kTryElse = "try a smaller pitch, or the algorithm postures";

/// Where a way through a lattice may end.
struct Targets {
  /// A lattice point that was moved onto a position.
  struct Point {
    std::array<int, 3> at;
    Vec3 position;
    int goal;
  };
  std::vector<Point> points;
  std::vector<End> ends;  // free ones
};

/// The box of a lattice, both bounds inclusive; the start is the point 0, within.
struct Box {
  std::array<int, 3> low, high;
};

/// Lattice points are numbered row by row, with one layer around the box that no ant enters. The
/// posture of a point is continued from that of the neighbour towards the start. What is found out
/// about a node or an edge is kept, by whichever thread comes first; a thread that wants to know
/// what another one is finding out waits for it.
/// The answers depend on the world only, so it does not matter who asks. Whoever may ask holds a
/// reference that is not const.
class Lattice {
 public:
  Lattice(const Robot& robot, const Kinematics& kinematics, const Sensor& sensor,
          const JointVector& start, double pitch, const Box& box, Targets targets,
          const Params& parameters, const StopCondition& stop = {}, const Questions& before = {});

  static constexpr Node kMostNodes = Node{1} << 24;

  Node nodes() const noexcept { return nodes_; }
  Node start() const noexcept { return start_; }
  bool arrived(Node v) const noexcept { return target_of(v) >= 0; }
  /// Which goal of the request a node reaches; -1: none.
  int goal_of(Node v) const noexcept;
  double pitch() const noexcept { return pitch_; }
  int moves() const noexcept { return moves_; }
  /// Precondition: the guidance of the move is not 0.
  Node to(Node v, int move) const noexcept {
    return move < kTipMoves ? v + delta_[move] : first_end_ + nearby_[v] - 1;
  }
  /// True for a point of the layer around the box.
  bool outside(Node v) const noexcept;
  std::array<int, 3> coordinates(Node v) const noexcept;
  Node node(std::array<int, 3> v) const noexcept;

  /// What a move adds to the objective, in unit(): one of `length`. Precondition: both ends have
  /// joint values.
  double cost(Node v, int move);
  /// The least that the way on may cost.
  double least(Node v);
  /// True where a move costs one.
  bool counts_moves() const noexcept { return objective_ == Objective::length; }
  /// The objective's unit, in metres, radians or seconds.
  double unit() const noexcept { return objective_ == Objective::length ? pitch_ : 1; }

  /// The target that is nearest on the lattice, as its point.
  const std::array<int, 3>& nearest_target(Node v) const noexcept;

  /// An undirected edge, by number; below moves() nodes().
  std::int64_t edge(Node v, int move) const noexcept {
    const Node w = to(v, move);
    return v < w ? v * moves_ + move : w * moves_ + (move ^ 1);
  }

  Vec3 position(Node v) const noexcept;
  /// Joint values, null where there are none. Kinematics only.
  const double* configuration(Node v);
  /// u^gamma of the moves() out of a node whose configuration was asked for (eq. 9); 0: no move.
  const float* guidance(Node v) const noexcept { return guidance_.at(v * kRow); }

  /// True when the move can be made. Asks the sensor what is not known. Precondition: `v` has a
  /// configuration that is free.
  bool open(Node v, int move);
  /// False when the move is known to be closed; kinematics is worked out, the sensor not asked.
  bool maybe_open(Node v, int move);
  /// True when the sensor was asked and said no.
  bool known_blocked(Node v) noexcept { return load(position_[v]) == kNo; }
  /// True when the tip gets to a goal, as far as kinematics tells.
  bool has_target();
  /// True when there is no end, and the goals are known to be blocked in the posture that they
  /// have. `ask` the sensor about it.
  bool goals_blocked(bool ask);
  /// Where no way was found, for people.
  std::string not_found() const;

  bool position_free(Node v);
  Questions questions() const noexcept {
    return {.positions = positions_asked_, .motions = motions_asked_};
  }
  /// How many were asked so far, by any thread.
  std::int64_t asked() const noexcept {
    return positions_asked_.load(std::memory_order_relaxed) +
           motions_asked_.load(std::memory_order_relaxed);
  }
  /// True when the next move to be tried could ask more than may be asked.
  bool spent() const noexcept { return most_asked_ > 0 && asked() + 2 > most_asked_; }
  /// True once a LatticePoller stopped for that reason.
  bool out_of_questions() const noexcept { return out_of_questions_; }
  /// Why a question was left open, which counts as closed until it is asked again.
  StopCondition::Cause cut() const noexcept {
    return cut_ ? stop_.poll() : StopCondition::Cause::none;
  }

 private:
  enum Answer : std::uint8_t { kUnknown, kAsking, kYes, kNo };
  static constexpr int kRow = 8;  // of guidance: kMostMoves, and a round number of bytes

  static std::uint8_t load(std::uint8_t& answer) noexcept {
    return std::atomic_ref(answer).load(std::memory_order_acquire);
  }
  /// The answer, found by `find` unless it is known; one thread at a time looks for each.
  template <class Find>
  static bool answer_once(std::uint8_t& answer, const Find& find);

  /// As a sensor takes them, not copied. Precondition: the node has some.
  Eigen::Map<const JointVector> joint_values(Node v) const {
    return {values_.at(v * joints_), joints_};
  }
  int manhattan(Node v, const std::array<int, 3>& to) const noexcept;
  int target_of(Node v) const noexcept;
  void enter(Node v, const JointVector& q);
  bool solve(Node v, JointArray& q);
  /// The joint values of a node from other ones, bent before.
  bool continued(Node v, const double* from, double bend, std::span<const double> rest,
                 JointArray& q) const;
  bool reachable_by_joints(Node a, int move) const noexcept;
  void fill_guidance(Node v) noexcept;
  void find_nearby(Node v) noexcept;
  double apart(const double* a, const double* b) const noexcept;

  const Kinematics& kinematics_;
  const Sensor& sensor_;
  StopCondition stop_;
  int joints_;
  double pitch_;
  double gamma_;
  double joint_step_;
  Objective objective_;
  std::int64_t most_asked_;
  Targets targets_;
  std::vector<std::array<int, 3>> end_points_;  // next to each end
  std::vector<double> slowness_;                // 1 / velocity, by joint
  Box box_;
  std::array<Node, kTipMoves> delta_;
  int moves_;
  Node first_end_, nodes_, start_;
  Vec3 origin_;

  // What was worked out or asked so far.
  ZeroArray<double> values_;          // joint values by node
  ZeroArray<float> guidance_;         // kRow a node
  ZeroArray<std::int16_t> nearby_;    // number of the end nearby, from 1, by node
  ZeroArray<std::uint8_t> solved_;    // Answer by node: it has joint values
  ZeroArray<std::uint8_t> position_;  // Answer by node: it is free
  ZeroArray<std::uint8_t> edges_;     // Answer by edge: it is open
  std::atomic<std::int64_t> positions_asked_{0}, motions_asked_{0};
  friend class LatticePoller;
  std::atomic<bool> out_of_questions_{false}, cut_{false};
};

/// Polls after so many steps, and after every question that was asked: a sensor may take its time.
class LatticePoller {
 public:
  LatticePoller(Lattice& lattice, const StopCondition& stop, std::int64_t interval) noexcept
      : lattice_(lattice), poller_(stop, interval), interval_(interval), asked_(lattice.asked()) {}

  /// As Poller::stop_after.
  bool stop_after(std::int64_t steps) {
    const auto asked = lattice_.asked();
    const bool any = asked != std::exchange(asked_, asked);
    return poller_.stop_after(any ? interval_ : steps) || lattice_.spent();
  }
  bool stopped() const noexcept { return poller_.stopped() || lattice_.spent(); }
  /// Questions that are spent count as a deadline; that it was they is noted in the lattice.
  StopCondition::Cause cause() const noexcept {
    if (poller_.stopped() || !lattice_.spent()) return poller_.cause();
    lattice_.out_of_questions_ = true;
    return StopCondition::Cause::deadline;
  }

 private:
  Lattice& lattice_;
  Poller poller_;
  std::int64_t interval_;
  std::int64_t asked_;
};

}  // namespace lasius::arm
