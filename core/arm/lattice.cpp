#include "core/arm/lattice.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/base/number_text.h"
#include "core/base/special_values.h"
#include "kernels/base/power.h"

namespace lasius::arm {
namespace {

/// Points of the padded box.
Node count_points(const Box& box) {
  Node count = 1;
  for (int i = 0; i < 3; ++i) count *= box.high[i] - box.low[i] + 3;
  return count;
}

}  // namespace

Lattice::Lattice(const Robot& robot, const Kinematics& kinematics, const Sensor& sensor,
                 const JointVector& start, double pitch, const Box& box, Targets targets,
                 const Params& parameters, const StopCondition& stop, const Questions& before)
    : kinematics_(kinematics),
      sensor_(sensor),
      stop_(stop),
      joints_(kinematics.size()),
      pitch_(pitch),
      gamma_(parameters.gamma),
      joint_step_(parameters.joint_step),
      objective_(parameters.objective),
      most_asked_(parameters.max_questions),
      targets_(std::move(targets)),
      box_(box),
      moves_(kTipMoves + (targets_.ends.empty() ? 0 : 1)),
      first_end_(count_points(box)),
      nodes_(first_end_ + static_cast<Node>(targets_.ends.size())),
      values_(nodes_ * joints_),
      guidance_(nodes_ * kRow),
      nearby_(targets_.ends.empty() ? 0 : nodes_),
      solved_(nodes_),
      position_(nodes_),
      edges_(moves_ * nodes_),
      positions_asked_(before.positions),
      motions_asked_(before.motions) {
  const Node row = box.high[0] - box.low[0] + 3, layer = row * (box.high[1] - box.low[1] + 3);
  delta_ = {1, -1, row, -row, layer, -layer};
  start_ = node({0, 0, 0});
  for (const Joint& joint : robot.joints) slowness_.push_back(1 / joint.velocity);
  Kinematics::Poses poses;
  kinematics_.place(as_span(start), poses);
  origin_ = kinematics_.tip(poses);
  for (std::size_t i = 0; i < targets_.ends.size(); ++i) {
    const Node end = first_end_ + static_cast<Node>(i);
    end_points_.push_back(rounded((1 / pitch_) * (targets_.ends[i].tip - origin_)));
    enter(end, targets_.ends[i].q);
    position_[end] = kYes;
  }
  enter(start_, start);
  fill_guidance(start_);
}

void Lattice::enter(Node v, const JointVector& q) {
  std::ranges::copy(q, values_.at(v * joints_));
  solved_[v] = kYes;
}

std::array<int, 3> Lattice::coordinates(Node v) const noexcept {
  if (v >= first_end_) return end_points_[v - first_end_];
  const Node row = delta_[2], layer = delta_[4];
  return {static_cast<int>(v % row) - 1 + box_.low[0],
          static_cast<int>(v % layer / row) - 1 + box_.low[1],
          static_cast<int>(v / layer) - 1 + box_.low[2]};
}

Node Lattice::node(std::array<int, 3> v) const noexcept {
  return (v[0] - box_.low[0] + 1) + (v[1] - box_.low[1] + 1) * delta_[2] +
         (v[2] - box_.low[2] + 1) * delta_[4];
}

bool Lattice::outside(Node v) const noexcept {
  const auto at = coordinates(v);
  for (int i = 0; i < 3; ++i)
    if (at[i] < box_.low[i] || at[i] > box_.high[i]) return true;
  return false;
}

int Lattice::manhattan(Node v, const std::array<int, 3>& to) const noexcept {
  const auto at = coordinates(v);
  int moves = 0;
  for (int i = 0; i < 3; ++i) moves += std::abs(at[i] - to[i]);
  return moves;
}

const std::array<int, 3>& Lattice::nearest_target(Node v) const noexcept {
  const std::array<int, 3>* nearest = nullptr;
  int least = 0;
  const auto offer = [&](const std::array<int, 3>& at) {
    const int moves = manhattan(v, at);
    if (nearest != nullptr && moves >= least) return;
    nearest = &at;
    least = moves;
  };
  for (const auto& point : targets_.points) offer(point.at);
  for (const auto& at : end_points_) offer(at);
  return *nearest;
}

int Lattice::target_of(Node v) const noexcept {
  if (v >= first_end_) return static_cast<int>(v - first_end_);
  for (std::size_t i = 0; i < targets_.points.size(); ++i)
    if (v == node(targets_.points[i].at)) return static_cast<int>(i);
  return -1;
}

int Lattice::goal_of(Node v) const noexcept {
  const int target = target_of(v);
  if (target < 0) return -1;
  return v >= first_end_ ? targets_.ends[target].goal : targets_.points[target].goal;
}

Vec3 Lattice::position(Node v) const noexcept {
  if (const int target = target_of(v); target >= 0)
    return v >= first_end_ ? targets_.ends[target].tip : targets_.points[target].position;
  const auto [x, y, z] = coordinates(v);
  return origin_ +
         pitch_ * Vec3{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
}

double Lattice::apart(const double* a, const double* b) const noexcept {
  double most = 0, sum = 0;
  for (int j = 0; j < joints_; ++j) {
    const double change = std::abs(b[j] - a[j]);
    sum += change * change;
    most = std::max(most, change * slowness_[j]);
  }
  return objective_ == Objective::joint ? std::sqrt(sum) : most;
}

double Lattice::cost(Node v, int move) {
  return counts_moves() ? 1 : apart(configuration(v), configuration(to(v, move)));
}

double Lattice::least(Node v) {
  if (arrived(v)) return 0;
  double least = kInfinity;
  const auto offer = [&](double cost) { least = std::min(least, cost); };
  if (objective_ == Objective::length) {
    for (const auto& point : targets_.points) offer(manhattan(v, point.at));
    for (const auto& at : end_points_) offer(std::max(1, manhattan(v, at)));
    return least;
  }
  const double* q = configuration(v);
  if (q == nullptr) return 0;
  for (const auto& point : targets_.points) {
    const double* end = configuration(node(point.at));
    if (end != nullptr) offer(apart(q, end));
  }
  for (Node end = first_end_; end < nodes_; ++end) offer(apart(q, values_.at(end * joints_)));
  return least;
}

void Lattice::find_nearby(Node v) noexcept {
  double least = kInfinity;
  for (std::size_t i = 0; i < end_points_.size(); ++i) {
    const double change = largest_change(joint_values(v), targets_.ends[i].q);
    if (change > joint_step_ || manhattan(v, end_points_[i]) > 1 || change >= least) continue;
    least = change;
    nearby_[v] = static_cast<std::int16_t>(i + 1);
  }
  guidance_[v * kRow + kTipMoves] = least < kInfinity ? 1 : 0;
}

void Lattice::fill_guidance(Node v) noexcept {
  const auto at = coordinates(v), goal = nearest_target(v);
  double square = 0;
  for (int i = 0; i < 3; ++i) square += (goal[i] - at[i]) * (goal[i] - at[i]);
  float* row = guidance_.at(v * kRow);
  const auto weight = [&](double along) {
    const double across = std::sqrt(std::max(square - along * along, 0.0));
    const double theta = kernels::angle_between(1, 0, along, across);
    return static_cast<float>(kernels::power(1 / (1 + theta), gamma_));
  };
  for (int k = 0; k < kTipMoves; ++k)
    row[k] = weight((k % 2 == 0 ? 1 : -1) * (goal[k / 2] - at[k / 2]));
  if (moves_ > kTipMoves) find_nearby(v);
}

bool Lattice::has_target() {
  return !targets_.ends.empty() || std::ranges::any_of(targets_.points, [&](const auto& point) {
    return configuration(node(point.at)) != nullptr;
  });
}

bool Lattice::goals_blocked(bool ask) {
  if (!targets_.ends.empty()) return false;
  bool any = false;
  for (const auto& point : targets_.points) {
    const Node v = node(point.at);
    if (load(solved_[v]) == kNo) continue;
    if (ask && configuration(v) == nullptr) continue;
    if (ask ? position_free(v) : !known_blocked(v)) return false;
    any = true;
  }
  return any;
}

std::string Lattice::not_found() const {
  return "not found in this lattice (pitch " + number_text(pitch_) + " m)";
}

}  // namespace lasius::arm
