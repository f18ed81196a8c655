// What is found out about nodes and edges of a lattice, each once: joint values by kinematics, what
// is free by the sensor.
#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "core/arm/lattice.h"

namespace lasius::arm {

template <class Find>
bool Lattice::answer_once(std::uint8_t& answer, const Find& find) {
  const std::atomic_ref state(answer);
  for (;;) {
    std::uint8_t seen = state.load(std::memory_order_acquire);
    if (seen == kYes || seen == kNo) return seen == kYes;
    if (seen == kUnknown && state.compare_exchange_strong(seen, kAsking)) break;
    std::this_thread::yield();
  }
  // A sensor that throws, or is told to stop, leaves the question open.
  struct Settle {
    std::atomic_ref<std::uint8_t> state;
    std::uint8_t found = kUnknown;
    ~Settle() { state.store(found, std::memory_order_release); }
  } settle{state};
  const std::optional<bool> yes = find();
  if (yes) settle.found = *yes ? kYes : kNo;
  return yes.value_or(false);
}

const double* Lattice::configuration(Node v) const {
  const std::uint8_t known = load(solved_[v]);
  if (known == kYes || known == kNo) return known == kYes ? values_.at(v * joints_) : nullptr;
  // Two threads may solve the same point: they find equal values, and one of them enters them.
  JointArray q;
  const bool found = solve(v, q);
  const bool yes = answer_once(solved_[v], [&]() -> std::optional<bool> {
    if (!found) return false;
    std::copy_n(q.begin(), joints_, values_.at(v * joints_));
    fill_guidance(v);
    return true;
  });
  return yes ? values_.at(v * joints_) : nullptr;
}

bool Lattice::continued(Node v, Node from, double bend, std::span<const double> rest,
                        JointArray& q) const {
  const double* values = from < 0 ? seeds_[v / points_].q.data() : configuration(from);
  if (values == nullptr) return false;
  std::copy_n(values, joints_, q.begin());
  const std::span span(q.data(), static_cast<std::size_t>(joints_));
  kinematics_.bend(span, bend);
  return kinematics_.reach_for(position(v), rest, span, most_postures_ > 1);
}

bool Lattice::solve(Node v, JointArray& q) const {
  const auto posture = static_cast<std::size_t>(v / points_);
  if (posture >= seeds_.size() || outside(v)) return false;
  const Seed& seed = seeds_[posture];
  // Towards the seed along the axis that is furthest from it; ties to x, then y.
  auto at = coordinates(v);
  for (int i = 0; i < 3; ++i) at[i] -= seed.at[i];
  std::array<int, 3> axes{0, 1, 2};
  std::ranges::stable_sort(axes, [&](int a, int b) { return std::abs(at[a]) > std::abs(at[b]); });
  // Stretched out, an arm is drawn in by no small change of its joints: a second try bends it
  // first; where there are other postures, near the seed only.
  constexpr double kBend = 0.3;  // radians or metres
  const bool near = std::abs(at[0]) + std::abs(at[1]) + std::abs(at[2]) <= 3;
  for (const double bend : {0.0, kBend}) {
    if (bend > 0 && most_postures_ > 1 && !near) break;
    JointArray values;
    std::copy_n(seed.q.data(), joints_, values.begin());
    const std::span rest(values.data(), static_cast<std::size_t>(joints_));
    kinematics_.bend(rest, bend);
    if (at[axes[0]] == 0 && continued(v, -1, bend, rest, q)) return true;
    for (const int axis : axes) {
      if (at[axis] == 0) break;
      if (continued(v, to(v, 2 * axis + (at[axis] > 0 ? 1 : 0)), bend, rest, q)) return true;
    }
  }
  return false;
}

/// Postures may change by any motion, which is seen to be free; moves of the tip are short ones.
bool Lattice::reachable_by_joints(Node a, int move) const noexcept {
  if (move >= kTipMoves) return true;
  return largest_change(joint_values(a), joint_values(to(a, move))) <= joint_step_;
}

bool Lattice::position_free(Node v) const {
  return answer_once(position_[v], [&]() -> std::optional<bool> {
    positions_asked_.fetch_add(1, std::memory_order_relaxed);
    return sensor_.position_free(joint_values(v));
  });
}

int Lattice::end_by_way_of(const JointVector& via) const {
  constexpr std::size_t kTried = 3;
  positions_asked_.fetch_add(1, std::memory_order_relaxed);
  if (!sensor_.position_free(via)) return -1;
  const auto free = [&](const JointRef& from, const JointRef& to) {
    if (spent()) return false;
    motions_asked_.fetch_add(1, std::memory_order_relaxed);
    return sensor_.try_motion(from, to, stop_).value_or(false);
  };
  if (!free(joint_values(start_), via)) return -1;
  std::vector<std::pair<double, int>> nearest;
  for (std::size_t i = 0; i < targets_.ends.size(); ++i)
    nearest.emplace_back(largest_change(via, targets_.ends[i].q), static_cast<int>(i));
  std::ranges::sort(nearest);
  if (nearest.size() > kTried) nearest.resize(kTried);
  for (const auto& [change, end] : nearest) {
    if (free(via, targets_.ends[end].q)) return end;
  }
  return -1;
}

bool Lattice::open(Node v, int move) const {
  std::uint8_t& answer = edges_[edge(v, move)];
  if (const std::uint8_t known = load(answer); known == kYes || known == kNo) return known == kYes;
  const Node w = to(v, move);
  const bool reachable = configuration(w) != nullptr && reachable_by_joints(v, move);
  return answer_once(answer, [&]() -> std::optional<bool> {
    if (!reachable || !position_free(w)) return false;
    // Always in the same direction, so that the answer does not depend on who comes first.
    motions_asked_.fetch_add(1, std::memory_order_relaxed);
    const auto free =
        sensor_.try_motion(joint_values(std::min(v, w)), joint_values(std::max(v, w)), stop_);
    if (!free) cut_ = true;
    return free;
  });
}

bool Lattice::maybe_open(Node v, int move) const {
  const std::uint8_t known = load(edges_[edge(v, move)]);
  if (known == kYes || known == kNo) return known == kYes;
  const Node w = to(v, move);
  if (outside(w) || known_blocked(w)) return false;
  return configuration(w) != nullptr && reachable_by_joints(v, move);
}

}  // namespace lasius::arm
