// What is found out about nodes and edges of a lattice, each once: joint values by kinematics, what
// is free by the sensor.
#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <optional>
#include <thread>

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

const double* Lattice::configuration(Node v) {
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

bool Lattice::continued(Node v, const double* from, double bend, std::span<const double> rest,
                        JointArray& q) const {
  if (from == nullptr) return false;
  std::copy_n(from, joints_, q.begin());
  const std::span span(q.data(), static_cast<std::size_t>(joints_));
  kinematics_.bend(span, bend);
  return kinematics_.reach_for(position(v), rest, span);
}

bool Lattice::solve(Node v, JointArray& q) {
  if (outside(v)) return false;
  // Towards the start along the axis that is furthest from it; ties to x, then y.
  const auto at = coordinates(v);
  std::array<int, 3> axes{0, 1, 2};
  std::ranges::stable_sort(axes, [&](int a, int b) { return std::abs(at[a]) > std::abs(at[b]); });
  // No small change of its joints draws in an arm stretched out: a second try bends it first.
  constexpr double kBend = 0.3;  // radians or metres
  const double* const start = values_.at(start_ * joints_);
  for (const double bend : {0.0, kBend}) {
    JointArray values;
    std::copy_n(start, joints_, values.begin());
    const std::span rest(values.data(), static_cast<std::size_t>(joints_));
    kinematics_.bend(rest, bend);
    if (at[axes[0]] == 0 && continued(v, start, bend, rest, q)) return true;
    for (const int axis : axes) {
      if (at[axis] == 0) break;
      const Node nearer = to(v, 2 * axis + (at[axis] > 0 ? 1 : 0));
      if (continued(v, configuration(nearer), bend, rest, q)) return true;
    }
  }
  return false;
}

/// Moves of the tip, and to an end, are short ones.
bool Lattice::reachable_by_joints(Node a, int move) const noexcept {
  return move == kTipMoves ||
         largest_change(joint_values(a), joint_values(to(a, move))) <= joint_step_;
}

bool Lattice::position_free(Node v) {
  return answer_once(position_[v], [&]() -> std::optional<bool> {
    positions_asked_.fetch_add(1, std::memory_order_relaxed);
    return sensor_.position_free(joint_values(v));
  });
}

bool Lattice::open(Node v, int move) {
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

bool Lattice::maybe_open(Node v, int move) {
  const std::uint8_t known = load(edges_[edge(v, move)]);
  if (known == kYes || known == kNo) return known == kYes;
  const Node w = to(v, move);
  if (outside(w) || known_blocked(w)) return false;
  return configuration(w) != nullptr && reachable_by_joints(v, move);
}

}  // namespace lasius::arm
