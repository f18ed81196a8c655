// Questions and sensors for tests of planning.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/arm/robot/vec3.h"
#include "lasius/arm/generate.h"
#include "lasius/arm/plan.h"
#include "tests/core/arm/robot/arms.h"

namespace lasius::arm {

/// A sensor that knows no obstacle; others below and in tests say where they differ.
class Nothing : public Sensor {
 public:
  bool position_free(const JointRef&) const override { return true; }
  bool motion_free(const JointRef&, const JointRef&) const override { return true; }
  double clearance() const override { return 0.001; }
};

/// Blocks every position with the tip at `x` or, against x, no further than `thickness` beyond it.
class Wall final : public Nothing {
 public:
  Wall(const Robot& robot, double x, double thickness = std::numeric_limits<double>::infinity())
      : robot_(robot), x_(x), end_(x - thickness) {}
  bool position_free(const JointRef& q) const override {
    const double x = tip_position(robot_, q).x();
    return x > x_ || x < end_;
  }

 private:
  const Robot& robot_;
  double x_, end_;
};

/// The two links, bent, move their tip by 0.2 against x.
inline Request across(const Robot& robot) {
  Eigen::Vector3d goal = tip_position(robot, joints({0.6, 1.2}));
  goal.x() -= 0.2;
  return {.start = joints({0.6, 1.2}), .goals = {goal}};
}

/// Two trees without the straight line.
inline Params by_trees() {
  Params p;
  p.direct = false;
  return p;
}

inline JointVector last(const Result& result) {
  return result.joints.col(result.joints.cols() - 1);
}

/// A question with a lattice of `side` points, most of them between start and goal.
inline Params lattice_of(const Robot& robot, const Request& request, int side) {
  const Vec3 from = tip_position(robot, request.start),
             to = request.goals[0].target.translation().eval();
  const auto span = [](double a, double b) { return a < b ? b - a : a - b; };
  Params parameters("goritov2020");
  parameters.side = side;
  parameters.pitch =
      std::max({span(from.x, to.x), span(from.y, to.y), span(from.z, to.z)}) / (0.6 * side);
  return parameters;
}

struct Case {
  Robot robot;
  Scene scene;
  Request request;
  Params parameters;
};

/// A generated question to a robot that is shipped, answered by one thread.
inline Case make_case(const char* robot, std::uint64_t seed, int obstacles, double wall, int side) {
  Case c{shipped(robot), {}, {}, {}};
  Query query = generate_query(c.robot, {.seed = seed, .obstacles = obstacles, .wall = wall});
  c.scene = std::move(query.scene);
  c.request.start = std::move(query.start);
  c.request.goals = {query.goal};
  c.parameters = lattice_of(c.robot, c.request, side);
  c.parameters.threads = 1;
  return c;
}

}  // namespace lasius::arm
