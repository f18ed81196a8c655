// Motions: a quick look for what reaches far inside, then bounds, interval by interval.
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/arm/contact/contact.h"
#include "core/arm/contact/motion_bound.h"
#include "core/arm/contact/pair_tests.h"
#include "core/base/poller.h"

namespace lasius::arm {
namespace {

/// The square of the distance from a point to an obstacle that is no mesh, 0 inside.
double squared_gap(const Shape& shape, Vec3 p) noexcept {
  if (shape.kind == Shape::Kind::segment) {
    const Vec3 way = shape.corner[1] - shape.corner[0], off = p - shape.corner[0];
    const double whole = dot(way, way);
    const double share = whole > 0 ? std::clamp(dot(off, way) / whole, 0.0, 1.0) : 0;
    const double away = std::max(0.0, length(off - share * way) - shape.round);
    return away * away;
  }
  const Vec3 local = rotate_back(shape.at.rotation, p - shape.at.position);
  const auto outside = [](double v, double half) { return std::max(0.0, std::abs(v) - half); };
  const double z = outside(local.z, shape.half.z);
  if (shape.kind == Shape::Kind::cylinder) {
    const double across = std::sqrt(local.x * local.x + local.y * local.y);
    const double out = std::max(0.0, across - shape.half.x);
    return out * out + z * z;
  }
  const double x = outside(local.x, shape.half.x), y = outside(local.y, shape.half.y);
  return x * x + y * y + z * z;
}

/// The i-th of `count`, a power of two, such that those so far are always well spread.
int mirrored(int i, int count) noexcept {
  int place = 0;
  for (int bit = 1; bit < count; bit *= 2) place = 2 * place + ((i & bit) != 0);
  return place;
}

}  // namespace

bool Contact::reaches_inside(const JointCurve& curve) const {
  const Kinematics& arm = robot_->kinematics();
  const int instants = curve.way() > 2 ? 16 : 8;
  Kinematics::Poses poses;
  JointArray q;
  std::vector<Vec3> placed;
  for (int i = 0; i < instants; ++i) {
    const double s = (mirrored(i, instants) + 0.5) / instants;
    const CurvePiece& piece = curve.piece(s);
    for (std::size_t j = 0; j < curve.size(); ++j) q[j] = piece.at(j, s);
    arm.place(std::span<const double>(q).first(curve.size()), poses);
    for (int body = arm.size(); body > 0; --body) {
      const std::vector<InnerBall>& balls = robot_->inner(body);
      if (balls.empty()) continue;
      const Placement& at = poses[body - 1];
      const Shape& all = *robot_->body(body);
      const Vec3 middle = at * all.centre;
      placed.clear();
      for (const Shape* const obstacle : obstacles_) {
        const bool solid = obstacle->exact && obstacle->kind != Shape::Kind::triangle;
        if (!solid || squared_gap(*obstacle, middle) > all.radius * all.radius) continue;
        if (placed.empty())
          for (const InnerBall& ball : balls) placed.push_back(at * ball.centre);
        // What is smaller than the body may be all inside of a mesh, which is free.
        const Vec3 off = middle - obstacle->centre;
        const bool sticks_out =
            dot(off, off) + obstacle->radius * obstacle->radius > all.radius * all.radius;
        for (std::size_t b = 0; b < balls.size(); ++b) {
          if ((sticks_out || !balls[b].hollow) &&
              squared_gap(*obstacle, placed[b]) < balls[b].radius * balls[b].radius)
            return true;
        }
      }
    }
  }
  return false;
}

/// One motion: intervals of it, breadth first, and what is not shown to be apart in each.
class Contact::Search {
 public:
  Search(const Contact& contact, const JointCurve& curve, double clearance,
         const StopCondition& stop)
      : contact_(contact),
        arm_(contact.robot_->kinematics()),
        curve_(curve),
        clearance_(clearance),
        bound_(arm_),
        poller_(stop, 64),
        relative_(contact.relations_.size()) {}

  Answer run() {
    int pieces = 1;
    constexpr int kMostPieces = 64;
    constexpr double kPiece = 0.8;  // radians and metres, all joints together
    while (pieces < kMostPieces && curve_.way() > kPiece * pieces) pieces *= 2;
    left_ = contact_.pairs_;
    // Far apart ones first: what is blocked at all is found sooner.
    for (int i = 0; i < pieces; ++i) {
      const int place = mirrored(i, pieces);
      intervals_.push_back({(place + 0.5) / pieces, 0.5 / pieces, 0, left_.size()});
    }
    constexpr int kMostHalvings = 48;
    for (int depth = 0; !intervals_.empty(); ++depth) {
      if (depth == kMostHalvings) return Answer::blocked;
      std::vector<Pair> next;
      std::vector<Interval> halves;
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

  /// False where something is touched, or told to stop. Adds to `next` what may still touch within
  /// the interval, and is apart in its middle.
  bool look(const Interval& interval, std::vector<Pair>& next) {
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
    const Vec3 guess = off(*a, here, *b, there);
    if (curved + clearance_ < std::max(ball.gap, 0.0) + 0.5 * a->radius) {
      const SweptShape swept(at, h * motion.turn, h * motion.shift);
      const double round = a->round * (1 + h * motion.turning) + b->round;
      const double need = clearance_ + curved + round;
      if (gjk_apart<GjkAsked::decision>(swept, other, guess, need) >= need) return Verdict::free;
    }
    if (ball.gap >= 2 * clearance_) return Verdict::apart;
    if (shapes_apart<GjkAsked::decision>(*a, at, guess, *b, other, 2 * clearance_) >=
        2 * clearance_)
      return Verdict::apart;
    return a->exact && b->exact ? Verdict::touched : Verdict::opened;
  }

  const Contact& contact_;
  const Kinematics& arm_;
  const JointCurve& curve_;
  double clearance_;
  MotionBound bound_;
  Poller poller_;
  Kinematics::Poses poses_;
  Bodies bodies_;
  std::vector<RelativeMotion> relative_;
  std::vector<char> known_;  // of relative_
  std::vector<Pair> left_, stack_;
  std::vector<Interval> intervals_;
};

Contact::Answer Contact::motion(std::span<const double> from, std::span<const double> to,
                                double clearance, const StopCondition& stop) const {
  if (std::ranges::equal(from, to))
    return posture_free(from, clearance) ? Answer::free : Answer::blocked;
  const CurvePiece straight(from, to);
  return motion(JointCurve(from.size(), {&straight, 1}), clearance, stop);
}

Contact::Answer Contact::motion(const JointCurve& curve, double clearance,
                                const StopCondition& stop) const {
  if (stop.poll() != StopCondition::Cause::none) return Answer::stopped;
  if (reaches_inside(curve)) return Answer::blocked;
  return Search(*this, curve, clearance, stop).run();
}

}  // namespace lasius::arm
