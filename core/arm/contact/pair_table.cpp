#include "core/arm/contact/pair_table.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "core/arm/contact/motion_bound.h"

namespace lasius::arm {
namespace {

constexpr double kLarger = 1.02;  // than they are: how large cells are when they are looked at

/// All that a set passes in two straight motions and between.
struct SweptTwice {
  const SweptShape &one, &two;
  Vec3 operator()(Vec3 d) const noexcept {
    const Vec3 p = one(d), q = two(d);
    return dot(p, d) >= dot(q, d) ? p : q;
  }
};

}  // namespace

PairTable::PairTable(const Kinematics& arm, const ShapePair& pair, double clearance)
    : arm_(arm), pair_(pair), joints_(pair.body - pair.from), clearance_(clearance) {
  for (int i = 0; i < joints_; ++i) {
    const int joint = pair.from + i;
    round_[i] = !arm.slides(joint);
    low_[i] = round_[i] ? 0 : arm.low(joint);
    width_[i] = (round_[i] ? 2 * std::numbers::pi : arm.high(joint) - arm.low(joint)) / kFine;
    if (!(width_[i] > 0)) width_[i] = 1e-9;
  }
  for (int l = 0; l < kLevels; ++l)
    states_[l] = std::vector<std::atomic<char>>(
        static_cast<std::size_t>(joints_ == 1 ? 1 : kCoarse << l) * (kCoarse << l));
}

PairTable::Doubt PairTable::doubt(std::span<const double> from, std::span<const double> to,
                                  Poller& poller) const {
  constexpr int kMostSteps = 1000;
  constexpr double kStep = 0.25 * (kLarger - 1);  // of the smallest cell: within the larger ones
  std::array<double, 2> begin{}, way{};
  double longest = 0;
  for (int i = 0; i < joints_; ++i) {
    const int joint = pair_.from + i;
    begin[i] = (from[joint] - low_[i]) / width_[i];
    way[i] = (to[joint] - from[joint]) / width_[i];
    longest = std::max(longest, std::abs(way[i]));
    if (!(std::abs(begin[i]) + std::abs(way[i]) < 1e6)) return {0, 1};
  }
  const double step = longest > 0 ? kStep / longest : 1;
  Doubt found;
  double s = 0;
  for (int steps = 0; steps < kMostSteps; ++steps) {
    std::array<double, 2> at{};
    std::array<int, 2> cell{};
    for (int i = 0; i < joints_; ++i) {
      at[i] = begin[i] + s * way[i];
      cell[i] = static_cast<int>(std::floor(at[i]));
      if (!round_[i]) {
        if (at[i] < 0 || at[i] > kFine) return {0, 1};
        cell[i] = std::min(cell[i], kFine - 1);
      }
    }
    int level = 0;
    const auto coarse = [&] { return kLevels - 1 - level; };
    while (level < kLevels && !cell_free(level, cell[0] >> coarse(), cell[1] >> coarse(), poller))
      ++level;
    if (poller.stopped()) return {0, 1};
    const bool doubted = level == kLevels;
    level = std::min(level, kLevels - 1);
    double out = std::numeric_limits<double>::infinity();
    for (int i = 0; i < joints_; ++i) {
      const int first = cell[i] >> coarse() << coarse();
      const int end = way[i] > 0 ? first + (1 << coarse()) : first;
      if (way[i] != 0) out = std::min(out, (end - at[i]) / way[i]);
    }
    const double next = std::min(1.0, s + out + step);
    if (doubted) found = {std::min(found.first, s), next};
    if (next >= 1) return found;
    s = next;
  }
  return {0, 1};
}

bool PairTable::cell_free(int level, int x, int y, Poller& poller) const {
  const int count = kCoarse << level;
  x &= count - 1;
  y &= count - 1;
  std::atomic<char>& state =
      states_[level][static_cast<std::size_t>(x) * (joints_ == 1 ? 1 : count) + y];
  char known = state.load(std::memory_order_relaxed);
  if (known == unknown) {
    if (poller.stopped()) return false;
    known = look(level, x, y, poller);
    if (known == unknown) return false;
    state.store(known, std::memory_order_relaxed);
  }
  return known == free;
}

PairTable::State PairTable::look(int level, int x, int y, Poller& poller) const {
  const int most = level + 1 < kLevels ? 8 : 24;
  const int first = pair_.from, larger = 1 << (kLevels - 1 - level);
  JointArray q{}, change{};
  for (int i = 0; i < joints_; ++i) {
    const double size = larger * width_[i];
    q[first + i] = low_[i] + ((i == 0 ? x : y) + 0.5) * size;
    change[first + i] = 0.5 * kLarger * size;
  }
  const auto count = static_cast<std::size_t>(arm_.size());
  Kinematics::Poses poses;
  Bodies bodies;
  place_bodies(arm_, std::span<const double>(q).first(count), poses, bodies);
  MotionBound bound(arm_);
  std::array<RelativeMotion, 2> motions;
  for (RelativeMotion& motion : motions) {
    bound.set(std::span<const double>(change).first(count), 1, poses);
    motion = bound.of(pair_.body, pair_.from);
    change[first] = -change[first];
  }
  const Placement &here = bodies[pair_.body], &there = bodies[pair_.from];
  std::vector<std::pair<const Shape*, const Shape*>> left{{pair_.a, pair_.b}};
  for (int tests = 0; !left.empty(); ++tests) {
    if (tests == most) return open;
    const auto [a, b] = left.back();
    left.pop_back();
    const PlacedShape other(*b, there);
    const BallGap ball = ball_gap(*a, here, *b, other);
    const double curved = 0.5 * (motions[0].far + motions[0].spread * a->far);
    double across = 0;
    for (const RelativeMotion& m : motions)
      across = std::max(across, std::abs(dot(ball.normal, cross(m.turn, ball.centre) + m.shift)));
    if (ball.gap > clearance_ + across + curved) continue;
    if (a->hull_or_exact() && b->hull_or_exact()) {
      const PlacedShape at(*a, here);
      const SweptShape one(at, motions[0].turn, motions[0].shift);
      const SweptShape two(at, motions[1].turn, motions[1].shift);
      const double round = a->round * (1 + motions[0].turning) + b->round;
      const double need = clearance_ + curved + round;
      if (gjk_apart<GjkAsked::decision>(SweptTwice{one, two}, other, ball.guess, need) >= need)
        continue;
      if (a->exact && b->exact) return open;
    }
    const bool opened = first_is_opened(*a, *b);
    if (poller.stop_after(work_of_parts(opened ? *a : *b))) return unknown;
    for (const Shape* const part : parts_of(opened ? *a : *b))
      left.emplace_back(opened ? part : a, opened ? b : part);
  }
  return free;
}

}  // namespace lasius::arm
