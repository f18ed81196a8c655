// An arm learns of obstacles by trying positions, and moves smoothly among them.
#include <lasius/arm.h>

#include <Eigen/Core>
#include <iostream>

int main() {
  using namespace lasius::arm;
  const Robot robot = parse_robot(R"({"format": "lasius-arm/1", "joints": [
      {"axis": [0, 0, 1], "link": [0.5, 0, 0], "radius": 0.04, "limits": [-3, 3]},
      {"axis": [0, 0, 1], "link": [0.4, 0, 0], "radius": 0.04, "limits": [-3, 3]}]})",
                                  "in the program");
  const Scene scene = parse_scene(R"({"format": "lasius-scene/1", "obstacles": [
      {"shape": "sphere", "position": [0.75, 0.45, 0], "radius": 0.1}]})",
                                  "in the program");
  const SceneSensor sensor(robot, scene);  // your own Sensor asks a simulator or the robot

  Params params;
  params.iterations = 20;
  const Request request{.start = Eigen::Vector2d(0, 0.6), .goals = {Eigen::Vector3d(0.3, 0.6, 0)}};
  const Result result = plan(robot, sensor, request, params);
  const Trajectory& motion = result.trajectory;
  std::cout << to_string(result.status) << ", " << result.questions.positions
            << " positions asked, " << motion.duration() << " s\n";
  std::cout << "halfway at " << motion.at(motion.duration() / 2).q.transpose() << '\n';
  const Recheck check = recheck(robot, scene, motion);  // looked at once more
  return check.contacts == 0 && check.limits == 0 ? 0 : 1;
}
