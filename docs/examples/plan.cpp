// Plans one path with the exact planner and one with a colony.
#include <lasius/lasius.h>

#include <iostream>

int main() {
  using namespace lasius;
  const Planner planner(generate(MapKind::blobs, {.width = 400, .height = 200, .seed = 61}));
  const Request request{.start = {14, 14}, .goal = {380, 179}};

  const Result shortest = planner.plan(request);
  const Result colony = planner.plan(request, Params("fan2004"));
  std::cout << "exact " << shortest.length << ", fan2004 " << colony.length << '\n';
  return shortest.optimal && colony.length >= shortest.length ? 0 : 1;
}
