// Among polygons: the exact path, and a colony over the lines of the MAKLINK graph.
#include <lasius/polygon.h>

#include <iostream>
#include <vector>

int main() {
  using namespace lasius::polygon;
  const World world = parse_wkt(
      "POLYGON ((0 0, 90 0, 90 40, 0 40, 0 0)) POLYGON ((30 0, 60 0, 60 30, 30 30, 30 0)) "
      "POINT (5 5) POINT (85 5)",
      "in the program");
  const Planner planner(world);
  const Result exact = planner.plan();
  const Result ants = planner.plan({}, Params("maklink-acs"));
  std::cout << exact.length << ", ants " << ants.length << " across " << ants.crossing.lines.size()
            << " lines\n";

  // Many at once; a request that names no start or goal has the world's.
  const std::vector<Request> requests{{}, {.goal = lasius::Point{80, 35}}};
  for (const BatchAnswer& answer : plan_batch(planner, requests))
    std::cout << answer.index << ": " << answer.result.length << '\n';
  return exact.optimal && ants.length > exact.length - 1e-9 ? 0 : 1;
}
