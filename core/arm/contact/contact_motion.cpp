// Motions: a quick look for what reaches far inside, then bounds, interval by interval.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory_resource>
#include <utility>

#include "core/arm/contact/contact.h"
#include "core/arm/contact/motion_bound.h"
#include "core/arm/contact/pair_tests.h"

namespace lasius::arm {
namespace {

/// The i-th of `count`, a power of two, such that those so far are always well spread.
int mirrored(int i, int count) noexcept {
  int place = 0;
  for (int bit = 1; bit < count; bit *= 2) place = 2 * place + ((i & bit) != 0);
  return place;
}

constexpr int kMostParts = 64;
constexpr std::int64_t kPairs = 64;  // looked at between two polls

/// In so many parts of a motion none is longer than `most`, radians and metres of all joints
/// together: 1 to 64, a power of two.
int parts_of(double way, double most) noexcept {
  int count = 1;
  while (count < kMostParts && way > most * count) count *= 2;
  return count;
}
int lanes_of(double way) noexcept {
  constexpr double kPart = 0.3;
  return std::max(kernels::kLanes, parts_of(way, kPart));
}

}  // namespace

bool Contact::lanes_hold(std::span<const double> from, std::span<const double> to) const noexcept {
  constexpr double kMost = 1000, kLongest = 100;
  const Kinematics& arm = robot_->kinematics();
  double way = 0;
  for (int j = 0; j < arm.size(); ++j) {
    const auto [least, most] = std::minmax(from[j], to[j]);
    const bool within = arm.slides(j) ? least >= arm.low(j) && most <= arm.high(j)
                                      : least >= -kMost && most <= kMost;
    if (!within) return false;
    way += most - least;
  }
  return way <= kLongest;
}

template <class Look>
bool Contact::glance(Poller& poller, const Look& look) const {
  constexpr std::size_t kSome = 512, kOfUnit = 16;  // as long takes one pair in the search
  const std::span<const kernels::LaneObstacle> all = lane_obstacles_;
  for (std::size_t first = 0; first < all.size(); first += kSome) {
    const auto some = all.subspan(first, std::min(kSome, all.size() - first));
    if (!look(some, static_cast<int>(first)) ||
        poller.stop_after(static_cast<std::int64_t>(some.size() / kOfUnit)))
      return false;
  }
  return true;
}

bool Contact::touches(const Straight& motion, Poller& poller) const {
  const int lanes = lanes_of(motion.curve.way());
  bool touched = false;
  for (int part = 0; part < lanes && !touched && !poller.stopped(); part += kernels::kLanes) {
    const kernels::LaneMotion parts{motion.from.data(), motion.to.data(), lanes, part, 0};
    glance(poller, [&](std::span<const kernels::LaneObstacle> obstacles, int) {
      return !(touched = glance_.touches(robot_->lanes().robot, obstacles, parts));
    });
  }
  return touched;
}

/// One motion: intervals of it, breadth first, and what is not shown to be apart in each.
class Contact::Search {
 public:
  /// `straight`: the same motion, where it is one; else null.
  Search(const Contact& contact, const JointCurve& curve, const Straight* straight, Poller& poller)
      : contact_(contact),
        arm_(contact.robot_->kinematics()),
        curve_(curve),
        straight_(straight),
        clearance_(contact.robot_->clearance()),
        bound_(arm_),
        poller_(poller),
        relative_(contact.relations_.size(), &memory_),
        known_(relative_.size(), 0, &memory_) {}

  Answer run() {
    begin();
    if (poller_.stopped()) return Answer::stopped;
    constexpr int kMostHalvings = 48;
    for (int depth = 0; !intervals_.empty(); ++depth) {
      if (depth == kMostHalvings) return Answer::blocked;
      std::pmr::vector<Pair> next(&memory_);
      std::pmr::vector<Interval> halves(&memory_);
      for (const Interval& interval : intervals_) {
        const std::size_t first = next.size();
        if (!look(interval, next)) return poller_.stopped() ? Answer::stopped : Answer::blocked;
        if (next.size() == first) continue;
        const double half = 0.5 * interval.half;
        halves.push_back({interval.middle - half, half, first, next.size()});
        halves.push_back({interval.middle + half, half, first, next.size()});
      }
      left_.swap(next);
      intervals_.swap(halves);
    }
    return Answer::free;
  }

 private:
  struct Interval {
    double middle, half;
    std::size_t first, last;  // of left_
  };

  /// Makes intervals of what a glance leaves open.
  void begin() {
    const bool glances = straight_ != nullptr && straight_->lanes_hold;
    if (glances && !glance()) return;
    constexpr double kPiece = 3.2;
    const int pieces = parts_of(curve_.way(), kPiece);
    std::vector<std::pair<PairTable::Doubt, std::size_t>> doubts;
    std::size_t first = left_.size();
    const auto& pairs = contact_.pairs_;
    for (std::size_t i = glances ? contact_.own_ : 0; i < pairs.size(); ++i) {
      const PairTable* const table = straight_ == nullptr || i < contact_.own_
                                         ? nullptr
                                         : contact_.robot_->table(i - contact_.own_);
      if (table == nullptr) {
        left_.push_back(pairs[i]);
        continue;
      }
      const PairTable::Doubt doubt = table->doubt(straight_->from, straight_->to, poller_);
      if (doubt.first <= doubt.last) doubts.emplace_back(doubt, i);
    }
    for (int i = 0; i < pieces && left_.size() > first; ++i)
      intervals_.push_back(
          {(mirrored(i, pieces) + 0.5) / pieces, 0.5 / pieces, first, left_.size()});
    for (const auto& [doubt, i] : doubts) {
      first = left_.size();
      left_.push_back(pairs[i]);
      const double half = 0.5 * (doubt.last - doubt.first);
      intervals_.push_back({doubt.first + half, half, first, first + 1});
    }
  }

  /// Of the lanes. False when stopped.
  bool glance() {
    const int lanes = lanes_of(curve_.way());
    std::vector<kernels::LaneMiss> misses;
    std::array<std::size_t, kMostParts / kernels::kLanes + 1> until{};
    for (int b = 0; b < lanes / kernels::kLanes; ++b) {
      const kernels::LaneMotion parts{straight_->from.data(), straight_->to.data(), lanes,
                                      b * kernels::kLanes, clearance_};
      const auto sweep = [&](std::span<const kernels::LaneObstacle> obstacles, int first) {
        std::size_t m = misses.size();
        contact_.glance_.sweep(contact_.robot_->lanes().robot, obstacles, parts, misses);
        for (; m < misses.size(); ++m) misses[m].obstacle += first;
        return true;
      };
      if (!contact_.glance(poller_, sweep) && poller_.stopped()) return false;
      until[b + 1] = misses.size();
    }
    // Far apart ones first: what is blocked at all is found sooner.
    for (int i = 0; i < lanes && !misses.empty(); ++i) {
      const int place = mirrored(i, lanes), batch = place / kernels::kLanes;
      const std::size_t first = left_.size();
      for (std::size_t m = until[batch]; m < until[batch + 1]; ++m) {
        if ((misses[m].parts >> (place % kernels::kLanes) & 1) == 0) continue;
        const auto& [body, ball, obstacle, bits] = misses[m];
        left_.push_back({contact_.robot_->lanes().nodes[body][ball], contact_.obstacles_[obstacle],
                         contact_.to_world_[body + 1]});
      }
      if (left_.size() > first)
        intervals_.push_back({(place + 0.5) / lanes, 0.5 / lanes, first, left_.size()});
    }
    return true;
  }

  /// False where something is touched, or told to stop. Adds to `next` what may still touch within
  /// the interval, and is apart in its middle.
  bool look(const Interval& interval, std::pmr::vector<Pair>& next) {
    JointArray q, change, bend;
    const CurvePiece& piece = curve_.piece(interval.middle);
    for (std::size_t j = 0; j < curve_.size(); ++j) {
      q[j] = piece.at(j, interval.middle);
      change[j] = piece.rate(j, interval.middle);
    }
    curve_.bends(interval.middle, interval.half, bend);
    place_bodies(arm_, std::span<const double>(q).first(curve_.size()), poses_, bodies_);
    bound_.set(change, bend, interval.half, poses_);
    known_.assign(relative_.size(), 0);
    for (std::size_t i = interval.first; i < interval.last; ++i) {
      stack_.assign(1, left_[i]);
      while (!stack_.empty()) {
        const Pair pair = stack_.back();
        stack_.pop_back();
        if (poller_.stop_after(1)) return false;
        const Verdict verdict = judge(pair, interval.half);
        if (verdict == Verdict::touched) return false;
        if (verdict == Verdict::apart) next.push_back(pair);
        if (verdict != Verdict::opened) continue;
        poller_.stop_after(work_of_parts(first_is_opened(*pair.a, *pair.b) ? *pair.a : *pair.b));
        const auto parts = opened(pair);
        stack_.insert(stack_.end(), parts.begin(), parts.end());
      }
    }
    return true;
  }

  enum class Verdict { free, apart, opened, touched };

  const RelativeMotion& relative(int relation) {
    if (known_[relation] == 0) {
      const auto& [body, from] = contact_.relations_[relation];
      relative_[relation] = bound_.of(body, from);
      known_[relation] = 1;
    }
    return relative_[relation];
  }

  Verdict judge(const Pair& pair, double h) {
    const auto& [a, b, relation] = pair;
    const auto& [body, from] = contact_.relations_[relation];
    const RelativeMotion& motion = relative(relation);
    const Placement &here = bodies_[body], &there = bodies_[from];
    const PlacedShape other(*b, there);
    const BallGap ball = ball_gap(*a, here, *b, other);
    const Vec3 velocity = cross(motion.turn, ball.centre) + motion.shift;
    const double curved = 0.5 * h * h * (motion.far + motion.spread * a->far);
    // The plane through the nearest point keeps the ball off: only what goes across it counts.
    if (ball.gap > clearance_ + h * std::abs(dot(ball.normal, velocity)) + curved)
      return Verdict::free;
    const bool hulls = a->hull_or_exact() && b->hull_or_exact();
    if (!hulls) return ball.gap >= 2 * clearance_ ? Verdict::apart : Verdict::opened;
    const PlacedShape at(*a, here);
    if (curved + clearance_ < std::max(ball.gap, 0.0) + 0.5 * a->radius) {
      const SweptShape swept(at, h * motion.turn, h * motion.shift);
      const double round = a->round * (1 + h * motion.turning) + b->round;
      const double need = clearance_ + curved + round;
      if (gjk_apart<GjkAsked::decision>(swept, other, ball.guess, need) >= need)
        return Verdict::free;
    }
    if (ball.gap >= 2 * clearance_) return Verdict::apart;
    if (shapes_apart<GjkAsked::decision>(*a, at, ball.guess, *b, other, 2 * clearance_) >=
        2 * clearance_)
      return Verdict::apart;
    return a->exact && b->exact ? Verdict::touched : Verdict::opened;
  }

  const Contact& contact_;
  const Kinematics& arm_;
  const JointCurve& curve_;
  const Straight* straight_;
  double clearance_;
  MotionBound bound_;
  Poller& poller_;
  Kinematics::Poses poses_;
  Bodies bodies_;
  std::array<std::byte, 1 << 15> buffer_;
  std::pmr::monotonic_buffer_resource memory_{buffer_.data(), buffer_.size()};
  std::pmr::vector<RelativeMotion> relative_;
  std::pmr::vector<char> known_;  // of relative_
  std::pmr::vector<Pair> left_{&memory_}, stack_{&memory_};
  std::pmr::vector<Interval> intervals_{&memory_};
};

Contact::Answer Contact::motion(std::span<const double> from, std::span<const double> to,
                                const StopCondition& stop) const {
  if (std::ranges::equal(from, to)) return posture_free(from) ? Answer::free : Answer::blocked;
  if (stop.poll() != StopCondition::Cause::none) return Answer::stopped;
  const CurvePiece piece(from, to);
  const Straight motion{from, to, JointCurve(from.size(), {&piece, 1}), lanes_hold(from, to)};
  Poller poller(stop, kPairs);
  if (motion.lanes_hold && touches(motion, poller)) return Answer::blocked;
  return poller.stopped() ? Answer::stopped : Search(*this, motion.curve, &motion, poller).run();
}

Contact::Answer Contact::motion(const JointCurve& curve, const StopCondition& stop) const {
  if (stop.poll() != StopCondition::Cause::none) return Answer::stopped;
  Poller poller(stop, kPairs);
  return Search(*this, curve, nullptr, poller).run();
}

}  // namespace lasius::arm
