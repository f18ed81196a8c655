// lasius::arm from outside: an arm of one joint turns out of its own way.
#include <lasius/arm.h>

int main() {
  using namespace lasius::arm;
  const Robot robot = parse_robot(R"({"format": "lasius-arm/1", "joints": [
      {"axis": [0, 0, 1], "link": [1, 0, 0], "radius": 0.05, "limits": [-3, 3]},
      {"axis": [0, 0, 1], "link": [1, 0, 0], "radius": 0.05, "limits": [-3, 3]}]})",
                                  "in the program");
  const Scene scene;
  const SceneSensor sensor(robot, scene);
  const Request request{.start = Eigen::Vector2d(0, 1), .goal = {1, 1, 0}};
  const Result found = plan(robot, sensor, request, {.iterations = 5});
  const Recheck check = recheck(robot, scene, found.trajectory, 100);
  return found.status == lasius::Status::solved && check.contacts == 0 && check.limits == 0 ? 0 : 1;
}
