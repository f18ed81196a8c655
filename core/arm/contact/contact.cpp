#include "core/arm/contact/contact.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/arm/contact/gjk.h"
#include "core/base/poller.h"
#include "core/base/special_values.h"

namespace lasius::arm {
namespace {

/// Bodies in the world by number, the base first.
using Bodies = std::array<Placement, Robot::kMaxJoints + 1>;

void place_bodies(const Kinematics& arm, std::span<const double> q, Kinematics::Poses& poses,
                  Bodies& bodies) {
  arm.place(q, poses);
  std::copy_n(poses.begin(), arm.size(), bodies.begin() + 1);
}

/// Metres between the balls around two shapes, or the ball of one and the other itself.
struct BallGap {
  double gap;
  Vec3 centre, normal;  // of the first one's ball; away from the second
};
BallGap ball_gap(const Shape& a, const Placement& at, const Shape& b,
                 const PlacedShape& placed) noexcept {
  const Vec3 centre = at * a.centre, off = centre - placed.nearest(centre);
  const double away = length(off);
  return {away - a.radius - b.round, centre, away > 0 ? (1 / away) * off : Vec3{}};
}

/// Metres between two shapes where that is below `enough`, else something from there on; never
/// above the distance, of covers of that of what they cover.
template <GjkAsked asked>
double shapes_apart(const Shape& a, const PlacedShape& at, Vec3 guess, const Shape& b,
                    const PlacedShape& other, double enough) noexcept {
  const double round = a.round + b.round;
  return gjk_apart<asked>(at, other, guess, enough + round) - round;
}

Vec3 off(const Shape& a, const Placement& at, const Shape& b, const Placement& other) noexcept {
  return at * a.centre - other * b.centre;
}

/// Which of two shapes is looked into, where not both are exact.
bool first_is_opened(const Shape& a, const Shape& b) noexcept {
  return !a.exact && (b.exact || a.radius >= b.radius);
}

}  // namespace

RobotShapes::RobotShapes(const Robot& robot) : arm_(robot) {
  const int links = static_cast<int>(robot.links.size());
  std::vector<const Shape*> whole(links, nullptr);          // of each link
  std::vector<std::vector<int>> of_body(robot.size() + 1);  // links with solids
  for (int l = 0; l < links; ++l) {
    std::vector<const Shape*> shapes;
    for (const Solid& solid : robot.links[l].solids) {
      if (const Shape* const shape = store_.add(solid, static_cast<int>(links_.size())))
        shapes.push_back(shape);
      links_.push_back(l);
    }
    if (shapes.empty()) continue;
    whole[l] = store_.join(shapes);
    of_body[robot.links[l].body].push_back(l);
  }
  for (const std::vector<int>& on : of_body) {
    std::vector<const Shape*> shapes;
    for (const int l : on) shapes.push_back(whole[l]);
    bodies_.push_back(shapes.empty() ? nullptr : store_.join(shapes));
  }

  std::vector<std::vector<char>> checked(links, std::vector<char>(links, 0));
  for (const auto& [a, b, check] : link_pairs(robot))
    checked[a][b] = checked[b][a] = check == LinkPair::Check::yes;
  for (int i = 1; i <= robot.size(); ++i) {
    for (int j = 0; j < i; ++j) {
      // As few pairs as cover those that are checked, and no others.
      std::vector<int> wholly, partly;
      for (const int a : of_body[i]) {
        const bool all = std::ranges::all_of(of_body[j], [&](int b) { return checked[a][b] != 0; });
        (all ? wholly : partly).push_back(a);
      }
      if (of_body[j].empty() || of_body[i].empty()) continue;
      if (partly.empty()) {
        pairs_.push_back({bodies_[i], bodies_[j], i, j});
        continue;
      }
      for (const int a : wholly) pairs_.push_back({whole[a], bodies_[j], i, j});
      for (const int a : partly) {
        for (const int b : of_body[j])
          if (checked[a][b] != 0) pairs_.push_back({whole[a], whole[b], i, j});
      }
    }
  }
}

Contact::Contact(std::shared_ptr<const RobotShapes> robot, const Scene& scene)
    : robot_(std::move(robot)) {
  std::vector<const Shape*> obstacles;
  for (int o = 0; o < static_cast<int>(scene.obstacles.size()); ++o)
    if (const Shape* const s = store_.add(scene.obstacles[o], -1 - o)) obstacles.push_back(s);
  for (int i = 1; i <= robot_->kinematics().size(); ++i) {
    if (robot_->body(i) == nullptr) continue;
    for (const Shape* const obstacle : obstacles) add({robot_->body(i), obstacle, i, 0});
  }
  for (const ShapePair& pair : robot_->pairs()) add(pair);
}

void Contact::add(const ShapePair& pair) {
  const auto known = std::ranges::find_if(relations_, [&](const Relation& r) {
    return r.body == pair.body && r.from == pair.from;
  });
  pairs_.push_back({pair.a, pair.b, static_cast<int>(known - relations_.begin())});
  if (known == relations_.end()) relations_.push_back({pair.body, pair.from});
}

NearPair Contact::told(const Pair& pair, double distance) const {
  NearPair found{.distance = std::max(0.0, distance), .link = robot_->link_of(pair.a->solid)};
  if (pair.b->solid < 0)
    found.obstacle = -1 - pair.b->solid;
  else
    found.other = robot_->link_of(pair.b->solid);
  if (pair.b->solid >= 0 && found.other < found.link) std::swap(found.link, found.other);
  return found;
}

bool Contact::posture_free(std::span<const double> q, double clearance, NearPair* touch) const {
  Kinematics::Poses poses;
  Bodies bodies;
  place_bodies(robot_->kinematics(), q, poses, bodies);
  std::vector<Pair> left;
  for (const Pair& root : pairs_) {
    left.assign(1, root);
    while (!left.empty()) {
      const Pair pair = left.back();
      left.pop_back();
      const auto& [a, b, relation] = pair;
      const auto& [body, from] = relations_[relation];
      const PlacedShape other(*b, bodies[from]);
      if (ball_gap(*a, bodies[body], *b, other).gap >= 2 * clearance) continue;
      const PlacedShape at(*a, bodies[body]);
      if (a->hull_or_exact() && b->hull_or_exact()) {
        const Vec3 guess = off(*a, bodies[body], *b, bodies[from]);
        const double apart =
            shapes_apart<GjkAsked::decision>(*a, at, guess, *b, other, 2 * clearance);
        if (apart >= 2 * clearance) continue;
        if (a->exact && b->exact) {
          if (touch != nullptr) {
            *touch = told(pair, shapes_apart<GjkAsked::distance>(*a, at, guess, *b, other,
                                                                 2 * clearance));
          }
          return false;
        }
      }
      const bool first = first_is_opened(*a, *b);
      for (const Shape* const part : parts_of(first ? *a : *b))
        left.push_back(first ? Pair{part, b, relation} : Pair{a, part, relation});
    }
  }
  return true;
}

NearPair Contact::nearest(std::span<const double> q) const {
  Kinematics::Poses poses;
  Bodies bodies;
  place_bodies(robot_->kinematics(), q, poses, bodies);
  NearPair found{.distance = kInfinity};
  std::vector<Pair> left;
  const auto gap = [&](const Pair& pair) {
    const auto& [body, from] = relations_[pair.relation];
    return ball_gap(*pair.a, bodies[body], *pair.b, PlacedShape(*pair.b, bodies[from])).gap;
  };
  for (const Pair& root : pairs_) {
    left.assign(1, root);
    while (!left.empty()) {
      const Pair pair = left.back();
      left.pop_back();
      const auto& [a, b, relation] = pair;
      const auto& [body, from] = relations_[relation];
      if (gap(pair) >= found.distance) continue;
      if (a->hull_or_exact() && b->hull_or_exact()) {
        const double apart = shapes_apart<GjkAsked::distance>(
            *a, PlacedShape(*a, bodies[body]), off(*a, bodies[body], *b, bodies[from]), *b,
            PlacedShape(*b, bodies[from]), found.distance);
        if (apart >= found.distance) continue;
        if (a->exact && b->exact) {
          found = told(pair, apart);
          continue;
        }
      }
      const bool first = first_is_opened(*a, *b);
      std::array<Pair, 2> parts;
      for (int i = 0; i < 2; ++i) {
        const Shape* const part = parts_of(first ? *a : *b)[i];
        parts[i] = first ? Pair{part, b, relation} : Pair{a, part, relation};
      }
      if (gap(parts[0]) < gap(parts[1])) std::swap(parts[0], parts[1]);
      left.insert(left.end(), parts.begin(), parts.end());  // the nearer one is looked at first
    }
  }
  return found;
}

/// One motion: intervals of it, breadth first, and what is not shown to be apart in each.
class Contact::Search {
 public:
  Search(const Contact& contact, std::span<const double> from, std::span<const double> to,
         double clearance, const StopCondition& stop)
      : contact_(contact),
        arm_(contact.robot_->kinematics()),
        from_(from),
        clearance_(clearance),
        bound_(arm_),
        poller_(stop, 64),
        relative_(contact.relations_.size()) {
    for (int j = 0; j < arm_.size(); ++j) change_[j] = to[j] - from[j];
  }

  Answer run() {
    const int joints = arm_.size();
    double way = 0;
    for (int j = 0; j < joints; ++j) way += std::abs(change_[j]);
    int pieces = 1;
    constexpr int kMostPieces = 64;
    constexpr double kPiece = 0.8;  // radians and metres, all joints together
    while (pieces < kMostPieces && way > kPiece * pieces) pieces *= 2;
    left_ = contact_.pairs_;
    // Far apart ones first: what is blocked at all is found sooner.
    for (int i = 0; i < pieces; ++i) {
      int place = 0;
      for (int bit = 1; bit < pieces; bit *= 2) place = 2 * place + ((i & bit) != 0);
      intervals_.push_back({(place + 0.5) / pieces, 0.5 / pieces, 0, left_.size()});
    }
    constexpr int kMostHalvings = 48;
    for (int depth = 0; !intervals_.empty(); ++depth) {
      if (depth == kMostHalvings) return Answer::blocked;
      std::vector<Pair> next;
      std::vector<Interval> halves;
      for (const Interval& interval : intervals_) {
        const std::size_t first = next.size();
        if (!look(interval, next))
          return poller_.stopped() ? Answer::stopped : Answer::blocked;
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
    JointArray q;
    const int joints = arm_.size();
    for (int j = 0; j < joints; ++j) q[j] = from_[j] + interval.middle * change_[j];
    const std::span<const double> change(change_.data(), static_cast<std::size_t>(joints));
    place_bodies(arm_, std::span<const double>(q).first(change.size()), poses_, bodies_);
    bound_.set(change, interval.half, poses_);
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
        const auto& [a, b, relation] = pair;
        const bool first = first_is_opened(*a, *b);
        for (const Shape* const part : parts_of(first ? *a : *b))
          stack_.push_back(first ? Pair{part, b, relation} : Pair{a, part, relation});
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
    if (shapes_apart<GjkAsked::decision>(*a, at, guess, *b, other, 2 * clearance_) >= 2 * clearance_)
      return Verdict::apart;
    return a->exact && b->exact ? Verdict::touched : Verdict::opened;
  }

  const Contact& contact_;
  const Kinematics& arm_;
  std::span<const double> from_;
  double clearance_;
  JointArray change_{};
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
  return Search(*this, from, to, clearance, stop).run();
}

}  // namespace lasius::arm
