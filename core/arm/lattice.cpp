#include "core/arm/lattice.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <thread>

#include "kernels/base/power.h"

namespace lasius::arm {
namespace {

constexpr double kBend = 0.3;  // radians or metres

/// Points of the padded box.
Node count_nodes(const std::array<int, 3>& low, const std::array<int, 3>& high) {
  Node count = 1;
  for (int i = 0; i < 3; ++i) count *= high[i] - low[i] + 3;
  return count;
}

}  // namespace

Lattice::Lattice(const Kinematics& kinematics, const Sensor& sensor, std::span<const double> start,
                 double pitch, std::array<int, 3> low, std::array<int, 3> high,
                 std::array<int, 3> goal, Vec3 goal_position, const Params& parameters)
    : kinematics_(kinematics),
      sensor_(sensor),
      joints_(kinematics.size()),
      pitch_(pitch),
      gamma_(parameters.gamma),
      joint_step_(parameters.joint_step),
      low_(low),
      high_(high),
      goal_at_(goal),
      nodes_(count_nodes(low, high)),
      goal_position_(goal_position),
      values_(nodes_ * joints_),
      guidance_(nodes_ * 8),
      solved_(nodes_),
      position_(nodes_),
      edges_(3 * nodes_) {
  const Node row = high[0] - low[0] + 3, layer = row * (high[1] - low[1] + 3);
  delta_ = {1, -1, row, -row, layer, -layer};
  start_ = node({0, 0, 0});
  goal_ = node(goal);
  Kinematics::Poses poses;
  kinematics_.place(start, poses);
  origin_ = kinematics_.tip(poses);
  std::copy(start.begin(), start.end(), values_.at(start_ * joints_));
  solved_[start_] = kYes;
  fill_guidance(start_);
}

std::array<int, 3> Lattice::coordinates(Node v) const noexcept {
  const Node row = delta_[2], layer = delta_[4];
  return {static_cast<int>(v % row) - 1 + low_[0], static_cast<int>(v % layer / row) - 1 + low_[1],
          static_cast<int>(v / layer) - 1 + low_[2]};
}

Node Lattice::node(std::array<int, 3> v) const noexcept {
  return (v[0] - low_[0] + 1) + (v[1] - low_[1] + 1) * delta_[2] + (v[2] - low_[2] + 1) * delta_[4];
}

bool Lattice::outside(Node v) const noexcept {
  const auto at = coordinates(v);
  for (int i = 0; i < 3; ++i) {
    if (at[i] < low_[i] || at[i] > high_[i]) return true;
  }
  return false;
}

int Lattice::manhattan(Node v) const noexcept {
  const auto at = coordinates(v);
  int moves = 0;
  for (int i = 0; i < 3; ++i) moves += std::abs(at[i] - goal_at_[i]);
  return moves;
}

Vec3 Lattice::position(Node v) const noexcept {
  if (v == goal_) return goal_position_;
  const auto [x, y, z] = coordinates(v);
  return origin_ +
         pitch_ * Vec3{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
}

template <class Find>
bool Lattice::answer_once(std::uint8_t& answer, const Find& find) {
  const std::atomic_ref state(answer);
  for (;;) {
    std::uint8_t seen = state.load(std::memory_order_acquire);
    if (seen == kYes || seen == kNo) return seen == kYes;
    if (seen == kUnknown && state.compare_exchange_strong(seen, kAsking)) break;
    std::this_thread::yield();
  }
  // A sensor that throws leaves the question open.
  struct Settle {
    std::atomic_ref<std::uint8_t> state;
    std::uint8_t found = kUnknown;
    ~Settle() { state.store(found, std::memory_order_release); }
  } settle{state};
  const bool yes = find();
  settle.found = yes ? kYes : kNo;
  return yes;
}

const double* Lattice::configuration(Node v) const {
  const std::uint8_t known = load(solved_[v]);
  if (known == kYes || known == kNo) return known == kYes ? values_.at(v * joints_) : nullptr;
  // Two threads may solve the same point: they find the same, and one of them enters it.
  JointArray q;
  const bool found = solve(v, q);
  const bool yes = answer_once(solved_[v], [&] {
    if (!found) return false;
    std::copy_n(q.begin(), joints_, values_.at(v * joints_));
    fill_guidance(v);
    return true;
  });
  return yes ? values_.at(v * joints_) : nullptr;
}

bool Lattice::solve(Node v, JointArray& q) const {
  if (outside(v)) return false;
  // Towards the start along the axis that is furthest from it; ties to x, then y.
  const auto at = coordinates(v);
  std::array<int, 3> axes{0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(),
                   [&](int a, int b) { return std::abs(at[a]) > std::abs(at[b]); });
  // Stretched out, an arm is drawn in by no small change of its joints: a second try bends it
  // first.
  for (const double bend : {0.0, kBend}) {
    JointArray rest;
    std::copy_n(values_.at(start_ * joints_), joints_, rest.begin());
    kinematics_.bend({rest.data(), static_cast<std::size_t>(joints_)}, bend);
    for (const int axis : axes) {
      if (at[axis] == 0) break;
      const Node parent = to(v, 2 * axis + (at[axis] > 0 ? 1 : 0));
      const double* from = configuration(parent);
      if (from == nullptr) continue;
      std::copy_n(from, joints_, q.begin());
      const std::span values(q.data(), static_cast<std::size_t>(joints_));
      kinematics_.bend(values, bend);
      if (kinematics_.reach_for(position(v), {rest.data(), values.size()}, values)) return true;
    }
  }
  return false;
}

void Lattice::fill_guidance(Node v) const noexcept {
  const auto at = coordinates(v);
  double square = 0;
  for (int i = 0; i < 3; ++i) square += (goal_at_[i] - at[i]) * (goal_at_[i] - at[i]);
  for (int k = 0; k < kMoves; ++k) {
    const double along = (k % 2 == 0 ? 1 : -1) * (goal_at_[k / 2] - at[k / 2]);
    const double across = std::sqrt(std::max(square - along * along, 0.0));
    const double theta = kernels::angle_between(1, 0, along, across);
    guidance_[v * 8 + k] = static_cast<float>(kernels::power(1 / (1 + theta), gamma_));
  }
}

bool Lattice::reachable_by_joints(Node a, Node b) const noexcept {
  const double *p = values_.at(a * joints_), *q = values_.at(b * joints_);
  for (int j = 0; j < joints_; ++j) {
    if (std::abs(p[j] - q[j]) > joint_step_) return false;
  }
  return true;
}

bool Lattice::position_free(Node v) const {
  return answer_once(position_[v], [&] {
    positions_asked_.fetch_add(1, std::memory_order_relaxed);
    return sensor_.position_free(joint_values(v));
  });
}

bool Lattice::open(Node v, int move) const {
  std::uint8_t& answer = edges_[edge(v, move)];
  if (const std::uint8_t known = load(answer); known == kYes || known == kNo) return known == kYes;
  const Node w = to(v, move);
  const bool reachable = configuration(w) != nullptr && reachable_by_joints(v, w);
  return answer_once(answer, [&] {
    if (!reachable || !position_free(w)) return false;
    // Always in the same direction, so that the answer does not depend on who comes first.
    motions_asked_.fetch_add(1, std::memory_order_relaxed);
    return sensor_.motion_free(joint_values(std::min(v, w)), joint_values(std::max(v, w)));
  });
}

bool Lattice::maybe_open(Node v, int move) const {
  const std::uint8_t known = load(edges_[edge(v, move)]);
  if (known == kYes || known == kNo) return known == kYes;
  const Node w = to(v, move);
  if (outside(w) || known_blocked(w)) return false;
  return configuration(w) != nullptr && reachable_by_joints(v, w);
}

}  // namespace lasius::arm
