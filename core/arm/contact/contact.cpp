#include "core/arm/contact/contact.h"

#include <algorithm>
#include <utility>

#include "core/arm/contact/pair_tests.h"
#include "core/base/kernel_choice.h"
#include "core/base/special_values.h"

namespace lasius::arm {

Contact::Contact(std::shared_ptr<const RobotShapes> robot, const Scene& scene)
    : robot_(std::move(robot)),
      glance_(kernels::lane_contact(chosen_isa())),
      to_world_(robot_->kinematics().size() + 1, -1) {
  for (int o = 0; o < static_cast<int>(scene.obstacles.size()); ++o)
    if (const Shape* const s = store_.add(scene.obstacles[o], -1 - o)) obstacles_.push_back(s);
  for (const Shape* const obstacle : obstacles_)
    lane_obstacles_.push_back(robot_->lanes().obstacle(*obstacle));
  for (int i = 1; i <= robot_->kinematics().size(); ++i) {
    if (robot_->body(i) == nullptr) continue;
    for (const Shape* const obstacle : obstacles_) add({robot_->body(i), obstacle, i, 0});
    if (!obstacles_.empty()) to_world_[i] = pairs_.back().relation;
  }
  own_ = pairs_.size();
  for (const ShapePair& pair : robot_->pairs()) add(pair);
}

void Contact::add(const ShapePair& pair) {
  const auto known = std::ranges::find_if(
      relations_, [&](const Relation& r) { return r.body == pair.body && r.from == pair.from; });
  pairs_.push_back({pair.a, pair.b, static_cast<int>(known - relations_.begin())});
  if (known == relations_.end()) relations_.push_back({pair.body, pair.from});
}

std::array<Contact::Pair, 2> Contact::opened(const Pair& pair) {
  const auto& [a, b, relation] = pair;
  const bool first = first_is_opened(*a, *b);
  const Shape::Parts& parts = parts_of(first ? *a : *b);
  if (first) return {{{parts[0], b, relation}, {parts[1], b, relation}}};
  return {{{a, parts[0], relation}, {a, parts[1], relation}}};
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

bool Contact::posture_free(std::span<const double> q) const {
  const double least = 2 * robot_->clearance();
  Kinematics::Poses poses;
  Bodies bodies;
  place_bodies(robot_->kinematics(), q, poses, bodies);
  std::vector<Pair> left(pairs_.rbegin(), pairs_.rend());
  while (!left.empty()) {
    const Pair pair = left.back();
    left.pop_back();
    const auto& [a, b, relation] = pair;
    const auto& [body, from] = relations_[relation];
    const PlacedShape other(*b, bodies[from]);
    const BallGap ball = ball_gap(*a, bodies[body], *b, other);
    if (ball.gap >= least) continue;
    const PlacedShape at(*a, bodies[body]);
    if (a->hull_or_exact() && b->hull_or_exact()) {
      if (shapes_apart<GjkAsked::decision>(*a, at, ball.guess, *b, other, least) >= least) continue;
      if (a->exact && b->exact) return false;
    }
    const auto parts = opened(pair);
    left.insert(left.end(), parts.begin(), parts.end());
  }
  return true;
}

NearPair Contact::nearest(std::span<const double> q) const {
  Kinematics::Poses poses;
  Bodies bodies;
  place_bodies(robot_->kinematics(), q, poses, bodies);
  NearPair found{.distance = kInfinity};
  std::vector<Pair> left(pairs_.rbegin(), pairs_.rend());
  const auto gap = [&](const Pair& pair) {
    const auto& [body, from] = relations_[pair.relation];
    return ball_gap(*pair.a, bodies[body], *pair.b, PlacedShape(*pair.b, bodies[from])).gap;
  };
  while (!left.empty()) {
    const Pair pair = left.back();
    left.pop_back();
    if (gap(pair) >= found.distance) continue;
    const auto& [a, b, relation] = pair;
    const auto& [body, from] = relations_[relation];
    if (a->hull_or_exact() && b->hull_or_exact()) {
      const PlacedShape at(*a, bodies[body]), other(*b, bodies[from]);
      const double apart = shapes_apart<GjkAsked::distance>(*a, at, at.centre() - other.centre(),
                                                            *b, other, found.distance);
      if (apart >= found.distance) continue;
      if (a->exact && b->exact) {
        found = told(pair, apart);
        continue;
      }
    }
    auto parts = opened(pair);
    if (gap(parts[0]) < gap(parts[1])) std::swap(parts[0], parts[1]);
    left.insert(left.end(), parts.begin(), parts.end());  // the nearer one is looked at first
  }
  return found;
}

}  // namespace lasius::arm
