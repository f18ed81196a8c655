// A way among known obstacles: two trees of straight motions, from the start and from the goals,
// that grow until they meet (Kuffner & LaValle 2000).
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/arm/ends.h"

namespace lasius::arm {

/// A way of the trees, or why there is none.
struct TreesWay {
  std::vector<JointVector> waypoints;  // empty: none was found
  int goal = -1;
};

/// Joint values evenly spread within the limits, one after another; of a joint that turns freely
/// within a turn of the start.
class SpreadValues {
 public:
  SpreadValues(const Robot& robot, const JointVector& start, std::uint64_t seed);
  void next(JointVector& q);

 private:
  JointVector low_, width_;
  std::array<double, Robot::kMaxJoints> turn_;  // each seed shifts all, round and round
  struct Digit {
    int value;
    double share;  // that it stands for
  };
  std::array<std::vector<Digit>, Robot::kMaxJoints> digits_;  // of the number of values so far
};

/// Joint values and how each was come by.
class MotionTree {
 public:
  explicit MotionTree(int joints) : joints_(joints) {}
  void add(const JointVector& q, int parent) {
    values_.insert(values_.end(), q.begin(), q.end());
    parents_.push_back(parent);
  }
  int size() const noexcept { return static_cast<int>(parents_.size()); }
  int parent(int node) const noexcept { return parents_[node]; }
  Eigen::Map<const JointVector> at(int node) const {
    return {values_.data() + static_cast<std::ptrdiff_t>(node) * joints_, joints_};
  }
  /// The one nearest to `q` in joint travel, the first of several.
  int nearest(const JointVector& q) const noexcept;

 private:
  std::ptrdiff_t joints_;
  std::vector<double> values_;
  std::vector<int> parents_;  // -1: a root
};

/// The way from the start to a node of the first tree, which is one of the second, too, and on.
inline TreesWay joined(const std::array<MotionTree, 2>& trees, int first, int second,
                       std::span<const End> ends) {
  TreesWay way;
  for (int n = first; n >= 0; n = trees[0].parent(n)) way.waypoints.push_back(trees[0].at(n));
  std::ranges::reverse(way.waypoints);
  int root = second;
  for (int n = trees[1].parent(root); n >= 0; n = trees[1].parent(n)) {
    way.waypoints.push_back(trees[1].at(n));
    root = n;
  }
  way.goal = ends[static_cast<std::size_t>(root)].goal;
  return way;
}

/// Draws `most` joint values at most, evenly spread (Halton), each edge asked about at once, in one
/// thread: the same way with any number of threads. `may_ask` is called before each question, which
/// it may refuse: then the trees end. Precondition: start and ends are free.
template <class MayAsk>
TreesWay grow_two_trees(const Robot& robot, const Sensor& sensor, const Request& request,
                        std::span<const End> ends, int most, std::uint64_t seed,
                        const MayAsk& may_ask) {
  constexpr double kStep = 1.5;  // joint travel of an edge, at most
  std::array<MotionTree, 2> trees{MotionTree(robot.size()), MotionTree(robot.size())};
  trees[0].add(request.start, -1);
  for (const End& end : ends) trees[1].add(end.q, -1);
  SpreadValues values(robot, request.start, seed);
  bool stopped = false;
  JointVector wanted(robot.size()), next(robot.size()), met(robot.size());
  enum class Step { there, on_the_way, blocked };
  // Goes from a node towards `to`, a step at most.
  const auto step = [&](MotionTree& tree, int from, const JointVector& to) {
    const auto here = tree.at(from);
    const double far = joint_travel(here, to);
    const bool whole = far <= kStep;
    next = to;
    if (!whole) next = here + (kStep / far) * (to - here);
    if (!may_ask()) {
      stopped = true;
      return Step::blocked;
    }
    const std::optional<bool> free = sensor.try_motion(here, next, request.stop);
    if (!free.value_or(false)) return Step::blocked;
    tree.add(next, from);
    return whole ? Step::there : Step::on_the_way;
  };
  for (int i = 0; i < most && !stopped; ++i) {
    const int grown = trees[0].size() <= trees[1].size() ? 0 : 1;
    MotionTree &tree = trees[grown], &other = trees[1 - grown];
    values.next(wanted);
    if (step(tree, tree.nearest(wanted), wanted) == Step::blocked) continue;
    met = next;  // which steps change
    int at = other.nearest(met);
    Step gone = other.at(at) == met ? Step::there : Step::on_the_way;
    while (gone == Step::on_the_way) {
      gone = step(other, at, met);
      if (gone != Step::blocked) at = other.size() - 1;
    }
    if (gone == Step::blocked) continue;
    const int mine = tree.size() - 1;
    return grown == 0 ? joined(trees, mine, at, ends) : joined(trees, at, mine, ends);
  }
  return {};
}

}  // namespace lasius::arm
