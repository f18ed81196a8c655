#include <random>

#include "bench/clocks.h"
#include "bench/colony_figures.h"
#include "bench/report.h"
#include "bench/statistics.h"
#include "lasius/generate.h"

namespace lasius::bench {

std::vector<Figure> measure_unreachable(int queries, int side) {
  const Planner planner(generate(MapKind::random, {side, side, 0.4, 1}));
  const Grid& grid = planner.grid();
  Workspace workspace;
  std::mt19937_64 random(1);
  const auto cell = [&] {
    for (;;) {
      const Cell c{static_cast<int>(random() % static_cast<std::uint64_t>(side)),
                   static_cast<int>(random() % static_cast<std::uint64_t>(side))};
      if (grid.free(c)) return c;
    }
  };
  std::vector<double> times;
  bool proven = true;
  while (static_cast<int>(times.size()) < queries) {
    const Cell start = cell(), goal = cell();
    if (planner.connected(start, goal)) continue;
    const Stopwatch watch;
    const Result result = planner.plan({start, goal}, Params("fan2004"), &workspace);
    times.push_back(watch.microseconds());
    proven = proven && result.status == Status::unreachable;
  }
  const std::string map = ", noise 40%, " + std::to_string(side) + " square";
  return {{"unreachable, median microseconds" + map, short_number(median(times)), "< 1000"},
          {"unreachable, largest", short_number(largest(times)), "< 1000"},
          {"all proven unreachable", proven ? "yes" : "NO", "yes"}};
}

}  // namespace lasius::bench
