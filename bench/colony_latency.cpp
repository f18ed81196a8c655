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
    const Result result = planner.plan({start, goal}, defaults("fan2004"), &workspace);
    times.push_back(watch.microseconds());
    proven = proven && result.status == Status::unreachable;
  }
  const std::string map = ", noise 40%, " + std::to_string(side) + " square";
  return {{"unreachable, median microseconds" + map, short_number(median(times)), "< 1000"},
          {"unreachable, largest", short_number(largest(times)), "< 1000"},
          {"all proven unreachable", proven ? "yes" : "NO", "yes"}};
}

std::vector<Figure> measure_overshoot(int plans) {
  struct Place {
    Course course;
    Planner planner;
  };
  std::vector<Place> places;
  const auto add = [&](Course course) {
    Planner planner(course.grid);
    places.push_back({std::move(course), std::move(planner)});
  };
  add(fan_course());
  Grid blobs = generate(MapKind::blobs, {4096, 4096, -1, 1});
  for (int x = 0; x < 16; ++x) {
    for (int y = 0; y < 16; ++y) {
      blobs.set_blocked({x, y}, false);
      blobs.set_blocked({4095 - x, 4095 - y}, false);
    }
  }
  add({"blobs 4096", std::move(blobs), {8, 8}, {4087, 4087}});

  std::vector<Figure> figures;
  Workspace workspace;
  for (const char* algorithm : {"fan2004", "as"}) {
    std::vector<double> overshoot;
    for (int i = 0; i < plans; ++i) {
      const Place& place = places[static_cast<std::size_t>(i) % places.size()];
      Params params = defaults(algorithm);
      params.ants = 64;
      params.iterations = 1'000'000;
      params.seed = static_cast<std::uint64_t>(i) + 1;
      Request request{place.course.start, place.course.goal};
      request.stop.deadline = Clock::now() + std::chrono::microseconds(1000 + 997 * (i % 20));
      place.planner.plan(request, params, &workspace);
      overshoot.push_back(
          std::chrono::duration<double, std::milli>(Clock::now() - request.stop.deadline).count());
    }
    figures.push_back({std::string("deadline overshoot, 99th percentile, ms, `") + algorithm + "`",
                       short_number(quantile(overshoot, 0.99)), "<= 5"});
  }
  return figures;
}

}  // namespace lasius::bench
