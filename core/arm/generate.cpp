#include "lasius/arm/generate.h"

#include <cmath>
#include <optional>

#include "core/arm/robot/kinematics.h"
#include "core/arm/robot/vec3.h"
#include "core/base/invalid_parameter.h"
#include "kernels/base/random_stream.h"
#include "lasius/arm/sensor.h"

namespace lasius::arm {
namespace {

/// Numbers of one attempt.
class Draw {
 public:
  Draw(std::uint64_t seed, int attempt) : words_(seed, static_cast<std::uint32_t>(attempt), 0) {}
  double between(double low, double high) noexcept {
    return low + (high - low) * ((words_.next() + 0.5) * 0x1p-32);
  }
  int below(int count) noexcept { return static_cast<int>(between(0, count)); }
  Vec3 in_cube(double half) noexcept {
    const double x = between(-half, half), y = between(-half, half);
    return {x, y, between(-half, half)};
  }

 private:
  kernels::RandomStream words_;
};

Obstacle draw_obstacle(Draw& draw, const Kinematics& arm) {
  const double reach = arm.reach();
  Obstacle o;
  o.shape = static_cast<Obstacle::Shape>(draw.below(3));
  const Vec3 position = arm.shoulder() + draw.in_cube(reach);
  o.pose = to_eigen({roll_pitch_yaw(draw.in_cube(3.14)), position});
  const auto size = [&] { return reach * draw.between(0.04, 0.2); };
  o.size = Vec3{size(), size(), size()};
  o.radius = 0.5 * size();
  o.length = 2 * size();
  return o;
}

/// Joint values, and where the tip is then.
struct ArmPosition {
  JointVector q;
  Vec3 tip;
};

ArmPosition draw_position(Draw& draw, const Robot& robot) {
  ArmPosition drawn{JointVector(robot.size()), {}};
  for (int j = 0; j < robot.size(); ++j) {
    // A middle part of its range: the ends are full of self-contact.
    const Joint& joint = robot.joints[j];
    const double middle = 0.5 * (joint.low + joint.high);
    const double half = joint.continuous ? 3.14 : 0.35 * (joint.high - joint.low);
    drawn.q[j] = draw.between(middle - half, middle + half);
  }
  drawn.tip = tip_position(robot, drawn.q);
  return drawn;
}

/// A plate across the way from one tip to the other.
Obstacle wall_between(Vec3 from, Vec3 to, double share) {
  const Vec3 way = to - from;
  const double far = length(way);
  const double level = std::sqrt(way.x * way.x + way.y * way.y);
  Obstacle o;
  o.name = "wall";
  o.size = Vec3(0.04 * far, share * far, share * far);
  Placement at{.position = 0.5 * (from + to)};
  if (level > 1e-9) {
    // Its thin side along the way as seen from above.
    at.rotation = {way.x / level, -way.y / level, 0, way.y / level, way.x / level, 0, 0, 0, 1};
  }
  o.pose = to_eigen(at);
  return o;
}

std::optional<Query> attempt(const Robot& robot, const GenerateOptions& options, int number) {
  const Kinematics arm(robot);
  Draw draw(options.seed, number);
  Query query;
  for (int i = 0; i < options.obstacles; ++i)
    query.scene.obstacles.push_back(draw_obstacle(draw, arm));
  const ArmPosition start = draw_position(draw, robot), goal = draw_position(draw, robot);
  if (distance(start.tip, goal.tip) < options.least_distance * arm.reach()) return std::nullopt;
  if (options.wall > 0)
    query.scene.obstacles.push_back(wall_between(start.tip, goal.tip, options.wall));
  const SceneSensor sensor(robot, query.scene);
  if (!sensor.position_free(start.q) || !sensor.position_free(goal.q)) return std::nullopt;
  query.start = start.q;
  query.goal = goal.tip;
  query.goal_joints = goal.q;
  return query;
}

}  // namespace

Query generate_query(const Robot& robot, const GenerateOptions& options) {
  constexpr int kAttempts = 10000;
  validate(robot);
  const int obstacles = options.obstacles;
  const double wall = options.wall, distance = options.least_distance;
  require_parameter(obstacles >= 0 && obstacles <= 1000, "obstacles", obstacles,
                    "it must be 0 .. 1000");
  require_parameter(wall >= 0 && wall <= 100, "wall", wall, "it must be 0 .. 100");
  require_parameter(distance >= 0 && distance <= 1, "least_distance", distance,
                    "it must be 0 .. 1");
  for (int i = 0; i < kAttempts; ++i)
    if (auto query = attempt(robot, options, i)) return *std::move(query);
  refuse(std::to_string(obstacles) + " obstacles leave this arm no room",
         "ask for fewer, or for a shorter distance");
}

}  // namespace lasius::arm
