// lasius::polygon from outside: around one block.
#include <lasius/polygon.h>

int main() {
  using namespace lasius::polygon;
  const World world = parse_wkt(
      "POLYGON ((0 0, 9 0, 9 4, 0 4, 0 0)) POLYGON ((3 0, 6 0, 6 3, 3 3, 3 0)) POINT (0 0) "
      "POINT (9 0)",
      "in the program");
  const Planner planner(world);
  const Result exact = planner.plan();
  const Result ants = planner.plan({}, Params("maklink-acs"));
  return exact.optimal && exact.path.size() == 4 && ants.length >= exact.length ? 0 : 1;
}
