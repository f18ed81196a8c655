#include <array>
#include <atomic>
#include <cstdint>
#include <fstream>
#include <optional>
#include <random>
#include <string>
#include <thread>

#include "bench/clocks.h"
#include "bench/colony_figures.h"
#include "bench/report.h"
#include "bench/statistics.h"
#include "lasius/base/error.h"
#include "lasius/grid/generate.h"

namespace lasius::bench {
namespace {

// A value of /proc/self/status in bytes, or nothing.
std::optional<double> status_bytes(const std::string& key) {
  std::ifstream in("/proc/self/status");
  for (std::string line; std::getline(in, line);) {
    if (line.rfind(key, 0) == 0) return 1024 * std::stod(line.substr(key.size() + 1));
  }
  return {};
}

// Starts VmHWM, the peak of resident memory, anew.
void forget_peak() { std::ofstream("/proc/self/clear_refs") << 5; }

bool same_run(const Result& a, const Result& b) {
  return a.path == b.path && alike(a.curves.best, b.curves.best) &&
         alike(a.curves.mean, b.curves.mean) && a.curves.arrived == b.curves.arrived;
}

// Seconds of the plan's iterations, the first left out: it makes the tiles.
std::vector<double> iteration_times(const Planner& planner, const Course& course,
                                    const Params& params, Workspace& workspace) {
  std::vector<double> times;
  Stopwatch watch;
  double last = 0;
  planner.plan({course.start, course.goal}, params,
               {.workspace = &workspace, .observer = [&](const GridProgress& p) {
                  const double now = watch.seconds();
                  if (p.iteration > 0) times.push_back(now - last);
                  last = now;
                }});
  return times;
}

// The fan course in the middle of a blocked square.
Course pasted(int side) {
  const Course& small = fan_course();
  Course large{"pasted", Grid(side, side), {}, {}};
  large.grid.fill(true);
  const int x0 = side / 2 - 217, y0 = side / 2 - 91;
  large.grid.paste({x0, y0, small.grid.width(), small.grid.height()},
                   small.grid.bytes(Nonzero::blocked), Nonzero::blocked);
  large.start = {x0 + small.start.x, y0 + small.start.y};
  large.goal = {x0 + small.goal.x, y0 + small.goal.y};
  return large;
}

// Seconds of one plan on each of two threads that share the map alone: what the machine allows.
double apart(const Planner& planner, const Request& request, const Params& params,
             std::array<Workspace, 2>& workspaces) {
  const Stopwatch watch;
  std::thread other([&] { planner.plan(request, params, {.workspace = &workspaces[1]}); });
  planner.plan(request, params, {.workspace = &workspaces[0]});
  other.join();
  return watch.seconds();
}

// Nanoseconds for a word to another thread and back: how far apart the machine put the cores.
double round_trip() {
  constexpr int kTrips = 20000;
  std::atomic<int> ball{0};
  std::thread other([&] {
    for (int i = 1; i < 2 * kTrips; i += 2) {
      while (ball.load() != i) {
      }
      ball.store(i + 1);
    }
  });
  const Stopwatch watch;
  for (int i = 0; i < 2 * kTrips; i += 2) {
    ball.store(i + 1);
    while (ball.load() != i + 2) {
    }
  }
  const double seconds = watch.seconds();
  other.join();
  return 1e9 * seconds / kTrips;
}

}  // namespace

std::vector<Figure> measure_threads(int rounds) {
  const Course& c = fan_course();
  const Planner planner(c.grid);
  const Request request{c.start, c.goal};
  Params params("fan2004");
  params.ants = 64;
  params.iterations = 40;
  std::vector<double> ratios, ceilings, trips;
  bool identical = true;
  std::array<Workspace, 2> workspaces;
  for (int round = 0; round < rounds; ++round) {
    params.seed = static_cast<std::uint64_t>(round) + 1;
    params.threads = 1;
    const Stopwatch first;
    const Result a = planner.plan(request, params, {.workspace = &workspaces[0]});
    const double single = first.seconds();
    ceilings.push_back(2 * single / apart(planner, request, params, workspaces));
    trips.push_back(round_trip());
    params.threads = 2;
    const Stopwatch second;
    const Result b = planner.plan(request, params, {.workspace = &workspaces[1]});
    ratios.push_back(single / second.seconds());
    identical = identical && same_run(a, b);
  }
  return {{"1 thread / 2 threads, 64 ants", short_number(median(ratios)), ">= 1.8"},
          {"two plans apart: the machine's ratio", short_number(median(ceilings)), ""},
          {"a word to the other thread and back, ns", short_number(median(trips)), ""},
          {"identical with 1 and 2 threads", identical ? "yes" : "NO", "yes"}};
}

std::vector<Figure> measure_area(int rounds, int side) {
  const Course& small = fan_course();
  const Planner small_planner(small.grid);
  Params params("fan2004");
  params.threads = 1;
  params.iterations = 30;
  Workspace small_workspace, large_workspace;
  iteration_times(small_planner, small, params, small_workspace);

  forget_peak();
  const double before = status_bytes("VmRSS:").value_or(0);
  Course large = pasted(side);
  const Planner large_planner(std::move(large.grid));
  iteration_times(large_planner, large, params, large_workspace);
  const double peak = status_bytes("VmHWM:").value_or(0) - before;

  std::vector<double> ratios;
  for (int round = 0; round < rounds; ++round) {
    params.seed = static_cast<std::uint64_t>(round) + 1;
    const auto a = iteration_times(small_planner, small, params, small_workspace);
    const auto b = iteration_times(large_planner, large, params, large_workspace);
    ratios.push_back(median(b) / median(a));
  }
  const auto footprint = large_planner.footprint();
  const double cells = static_cast<double>(side) * side;
  const double held =
      static_cast<double>(footprint.bitmap + footprint.components + footprint.visibility_graph);
  return {{"iteration, pasted into " + std::to_string(side) + " square / alone",
           short_number(median(ratios)), "<= 1.5"},
          {"map held, bits a cell", short_number(8 * held / cells), ""},
          {"peak memory, bits a cell", short_number(8 * peak / cells), "<= 2.25 + ants'"},
          {"peak memory beyond the map, MB", short_number((peak - held) / 1e6), ""}};
}

std::vector<Figure> measure_unreachable(int queries, int side) {
  const Planner planner(generate(MapKind::random, {side, side, 0.4, 1}));
  const Grid& grid = planner.grid();
  Workspace workspace;
  std::mt19937_64 random(1);
  const auto cell = [&] {
    for (;;) {  // most cells are free
      const Cell c{static_cast<int>(random() % static_cast<std::uint64_t>(side)),
                   static_cast<int>(random() % static_cast<std::uint64_t>(side))};
      if (grid.free(c)) return c;
    }
  };
  std::vector<double> times;
  bool proven = true;
  for (std::int64_t joined = 0; static_cast<int>(times.size()) < queries;) {
    const Cell start = cell(), goal = cell();
    if (planner.connected(start, goal)) {
      if (++joined == 10'000'000)
        throw Error(ErrorCode::invalid_parameter, "all free cells of a map are joined",
                    "use another map");
      continue;
    }
    const Stopwatch watch;
    const Result result = planner.plan({start, goal}, Params("fan2004"), {.workspace = &workspace});
    times.push_back(watch.microseconds());
    proven = proven && result.status == Status::unreachable;
  }
  const std::string map = ", noise 40%, " + std::to_string(side) + " square";
  return {{"unreachable, median microseconds" + map, short_number(median(times)), "< 1000"},
          {"unreachable, largest", short_number(largest(times)), "< 1000"},
          {"all proven unreachable", proven ? "yes" : "NO", "yes"}};
}

}  // namespace lasius::bench
