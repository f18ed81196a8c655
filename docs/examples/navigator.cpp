// A robot in its own loop: it tells what it sees, and asks for the next way.
#include <lasius/lasius.h>

#include <iostream>

int main() {
  using namespace lasius;
  const Cell goal{60, 20};
  Cell robot{3, 20};
  Navigator navigator(Grid(64, 40), goal);
  Grid world(64, 40);  // what is really there: a wall that the map has not
  world.fill({30, 5, 2, 30}, true);

  int plans = 0;
  while (robot != goal) {
    for (const Cell seen : {Cell{robot.x + 1, robot.y},
                            {robot.x, robot.y - 1},
                            {robot.x, robot.y + 1},
                            {robot.x + 1, robot.y - 1},
                            {robot.x + 1, robot.y + 1}})
      if (world.contains(seen)) navigator.observe({seen.x, seen.y, 1, 1}, world.blocked(seen));
    const Way& way = navigator.step(robot);
    if (way.walk.size() < 2) return 1;  // way.status and way.error say why
    plans += way.replanned;
    robot = way.walk[1];
  }
  std::cout << "arrived after " << plans << " plans\n";
  return plans > 1 ? 0 : 1;
}
