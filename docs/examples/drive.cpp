// A drive, simulated: a wall that the map has not, one that comes later, an obstacle that moves.
#include <lasius/lasius.h>

#include <iostream>

int main() {
  using namespace lasius;
  const Grid map(64, 40);  // what the robot knows
  Grid truth(64, 40);      // what is there
  truth.fill({30, 5, 2, 30}, true);

  Changes changes;
  changes.cells.push_back({.tick = 15, .part = {40, 0, 2, 20}, .blocked = true});
  changes.obstacles.push_back(
      {.width = 3, .height = 3, .speed = 0.5, .track = {{50, 5}, {50, 30}}});

  const auto watch = [](const DriveTick& tick) {
    if (tick.replanned && tick.way != nullptr)
      std::cout << "tick " << tick.tick << ": " << tick.way->length << " cells to go\n";
  };
  const DriveResult result =
      drive(map, truth, {3, 20}, {60, 20}, changes, {.sense = 8, .observer = watch});
  std::cout << to_string(result.status) << " after " << result.ticks << " ticks, " << result.length
            << " cells\n";
  return result.status == Status::solved && result.replans.size() > 1 ? 0 : 1;
}
