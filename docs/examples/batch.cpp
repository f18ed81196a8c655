// Many requests on one map, answered by several threads and returned in order.
#include <lasius/lasius.h>

#include <iostream>
#include <vector>

int main() {
  using namespace lasius;
  const Planner planner(generate(MapKind::blobs, {.width = 400, .height = 200, .seed = 61}));
  std::vector<Request> requests;
  for (int x = 300; x < 380; x += 10) {
    requests.push_back({.start = {14, 14}, .goal = *planner.nearest_free({x, 179})});
  }

  for (const BatchAnswer& answer : plan_batch(planner, requests)) {
    std::cout << answer.index << ": " << to_string(answer.result.status) << ' '
              << answer.result.length << '\n';
  }

  // The same with a receiver: answers come in order while others are still planned.
  std::size_t solved = 0;
  plan_batch(planner, requests, Params(), {.threads = 2}, [&](const BatchAnswer& answer) {
    if (answer.result.optimal) ++solved;
  });
  return solved > 0 ? 0 : 1;
}
