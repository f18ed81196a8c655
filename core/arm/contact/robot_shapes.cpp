#include "core/arm/contact/robot_shapes.h"

#include <algorithm>
#include <functional>

namespace lasius::arm {

RobotShapes::RobotShapes(const Robot& robot, double clearance)
    : clearance_(clearance), arm_(robot) {
  const int links = static_cast<int>(robot.links.size());
  LinkShapes whole(links, nullptr);
  std::vector<std::vector<InnerBall>> inner(robot.size() + 1);  // of each body
  std::vector<std::vector<int>> of_body(robot.size() + 1);      // links with solids
  for (int l = 0; l < links; ++l) {
    std::vector<const Shape*> shapes;
    for (const Solid& solid : robot.links[l].solids) {
      if (const Shape* const shape = store_.add(solid, static_cast<int>(links_.size())))
        shapes.push_back(shape);
      links_.push_back(l);
      const std::vector<InnerBall> balls = inner_balls(solid);
      auto& of_all = inner[robot.links[l].body];
      of_all.insert(of_all.end(), balls.begin(), balls.end());
    }
    if (shapes.empty()) continue;
    whole[l] = store_.join(shapes);
    of_body[robot.links[l].body].push_back(l);
  }
  for (const std::vector<int>& on : of_body) {
    std::vector<const Shape*> shapes;
    shapes.reserve(on.size());
    for (const int l : on) shapes.push_back(whole[l]);
    bodies_.push_back(shapes.empty() ? nullptr : store_.join(shapes));
  }

  // Here, not in the first motion, which may have to end soon.
  for (std::vector<InnerBall>& balls : inner)
    std::ranges::stable_sort(balls, std::greater<>(), &InnerBall::radius);
  lanes_.emplace(robot, bodies_, inner);
  add_pairs(robot, whole, of_body);
  for (const ShapePair& pair : pairs_) {
    tables_.push_back(
        pair.body <= pair.from + 2 ? std::make_unique<PairTable>(arm_, pair, clearance) : nullptr);
  }
}

// As few pairs as cover those that are checked, and no others.
void RobotShapes::add_pairs(const Robot& robot, const LinkShapes& whole,
                            const std::vector<std::vector<int>>& of_body) {
  const std::size_t links = whole.size();
  std::vector<std::vector<char>> checked(links, std::vector<char>(links, 0));
  for (const auto& [a, b, check] : link_pairs(robot))
    checked[a][b] = checked[b][a] = check == LinkPair::Check::yes;
  for (int i = 1; i <= robot.size(); ++i) {
    for (int j = 0; j < i; ++j) {
      if (of_body[j].empty() || of_body[i].empty()) continue;
      std::vector<int> wholly, partly;
      for (const int a : of_body[i]) {
        const bool all = std::ranges::all_of(of_body[j], [&](int b) { return checked[a][b] != 0; });
        (all ? wholly : partly).push_back(a);
      }
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

}  // namespace lasius::arm
