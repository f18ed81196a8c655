#include <array>
#include <chrono>
#include <random>
#include <stdexcept>

#include "bench/clocks.h"
#include "bench/colony_figures.h"
#include "bench/quality.h"
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

std::vector<Figure> measure_overshoot(int plans) {
  using Milliseconds = std::chrono::duration<double, std::milli>;
  struct Place {
    Course course;
    Planner planner;
    Milliseconds longest;  // time limits are spread up to this one
  };
  std::vector<Place> places;
  const auto add = [&](Course course, Milliseconds longest) {
    Planner planner(course.grid);
    places.push_back({std::move(course), std::move(planner), longest});
  };
  add(fan_course(), Milliseconds(40));
  add(blobs_courses(1, 1, 1024, 1024)[0], Milliseconds(400));
  add(blobs_courses(1, 1, 4096, 4096)[0], Milliseconds(2000));
  // The largest map least often: its deadlines take long.
  constexpr std::array<std::size_t, 10> kTurns{0, 1, 0, 1, 0, 1, 0, 1, 0, 2};
  constexpr int kLimits = 20;

  std::vector<Figure> figures;
  Workspace workspace;
  for (const char* algorithm : {"fan2004", "as"}) {
    std::vector<double> overshoot;
    for (int i = 0; i < plans; ++i) {
      const int turn = i % static_cast<int>(kTurns.size());
      const Place& place = places[kTurns[turn]];
      Params params(algorithm);
      params.ants = 64;
      params.iterations = 1'000'000;
      params.seed = static_cast<std::uint64_t>(i) + 1;
      const int limit = (i / static_cast<int>(kTurns.size()) + 3 * turn) % kLimits + 1;
      Request request{place.course.start, place.course.goal};
      request.stop.deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                                 place.longest * limit / kLimits);
      const Result result = place.planner.plan(request, params, &workspace);
      overshoot.push_back(Milliseconds(Clock::now() - request.stop.deadline).count());
      if (result.status != Status::limit) throw std::logic_error("a plan ended before its time");
    }
    const auto name = std::string(", ms, `") + algorithm + "`";
    figures.push_back({"deadline overshoot, 99th percentile" + name,
                       short_number(quantile(overshoot, 0.99)), "<= 5"});
    figures.push_back({"deadline overshoot, largest" + name, short_number(largest(overshoot)), ""});
  }
  return figures;
}

}  // namespace lasius::bench
