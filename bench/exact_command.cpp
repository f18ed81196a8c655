// lasius_bench exact: preparation, anytime figures, memory and threads of the exact planner.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "bench/clocks.h"
#include "bench/commands.h"
#include "bench/query_set.h"
#include "bench/report.h"
#include "bench/statistics.h"
#include "core/base/special_values.h"
#include "core/exact/exact.h"
#include "lasius/plan/batch.h"

namespace lasius::bench {
namespace {

struct ExactOptions : QueryOptions {
  ExactOptions() : QueryOptions{.count = 30, .rounds = 3} {}
  std::size_t batch = 0;
};

constexpr double kGaps[] = {0.1, 0.03, 0.01, 0};

// Mean microseconds of a query up to a certified gap: medians over the rounds. `peak` becomes the
// most memory that a search held.
double mean_time(const QuerySet& set, double gap, int rounds, double& peak) {
  double sum = 0;
  for (const Query& query : set.queries) {
    ExactSearch search;  // a new one, so that its memory is the query's own
    ExactAnswer answer;
    sum += median_microseconds(rounds, [&] {
      search.search(set.grid, centre(query.start), centre(query.goal), {.target_gap = gap}, {},
                    answer);
    });
    peak = std::max(peak, static_cast<double>(search.bytes()));
  }
  return sum / static_cast<double>(set.queries.size());
}

// Corners that the searches from each end expand: from the goal over from the start, and of each
// query the fewer, which is what a choice of the end could gain at most, over from the start.
std::pair<double, double> compare_ends(const QuerySet& set) {
  double there = 0, back = 0, fewer = 0;
  ExactSearch search;
  ExactAnswer answer;
  const auto expanded = [&](Cell from, Cell to) {
    search.search(set.grid, centre(from), centre(to), {}, {}, answer);
    return static_cast<double>(search.counters().expansions);
  };
  for (const Query& query : set.queries) {
    const double one = expanded(query.start, query.goal), other = expanded(query.goal, query.start);
    there += one;
    back += other;
    fewer += std::min(one, other);
  }
  return {back / there, fewer / there};
}

// What a second thread does to a batch: wall clock with one over that with two, and processor time
// with two over that with one, which tells its overhead even where other programs take the cores.
struct Threads {
  double gain, cost;
};

Threads compare_threads(const Planner& planner, const QuerySet& set, int rounds) {
  constexpr double kSeconds = 0.2;  // a batch is made at least this long
  std::vector<lasius::Request> queries;
  for (const Query& q : set.queries) queries.push_back({q.start, q.goal});
  struct Spent {
    double wall, processor;
  };
  const auto spent = [&](int threads) -> Spent {
    const Stopwatch wall;
    const ProcessorStopwatch processor;
    plan_batch(planner, queries, {}, {.threads = threads}, [](const BatchAnswer&) {});
    return {wall.seconds(), processor.seconds()};
  };
  const auto copies = static_cast<std::size_t>(std::clamp(kSeconds / spent(1).wall, 1.0, 1000.0));
  const std::vector<lasius::Request> part = queries;
  for (std::size_t i = 1; i < copies; ++i) queries.insert(queries.end(), part.begin(), part.end());
  std::vector<double> gains, costs;
  for (int round = 0; round < rounds; ++round) {
    const Spent one = spent(1);
    const Spent two = spent(2);
    gains.push_back(one.wall / two.wall);
    costs.push_back(two.processor / one.processor);
  }
  return {median(gains), median(costs)};
}

// Seconds of processor time of a batch of so many queries, those of the set again and again, by a
// planner that may make a graph for itself and by one that may not.
std::pair<double, double> time_batch(const QuerySet& set, std::size_t count) {
  std::vector<lasius::Request> queries;
  queries.reserve(count);
  while (queries.size() < count) {
    const Query& query = set.queries[queries.size() % set.queries.size()];
    queries.push_back({query.start, query.goal});
  }
  const auto spent = [&](bool may) {
    Planner planner(set.grid);
    if (!may) planner.limit_own_graph(0);
    const ProcessorStopwatch watch;
    plan_batch(planner, queries, {}, {.threads = 1}, [](const BatchAnswer&) {});
    return watch.seconds();
  };
  return {spent(true), spent(false)};
}

void measure_map(const QuerySet& set, const ExactOptions& options, Table& table) {
  const Stopwatch watch;
  const Planner planner(set.grid);
  const double prepared = 1000 * watch.seconds();
  const auto held = planner.footprint();
  const double cells = static_cast<double>(set.grid.width()) * set.grid.height();
  const auto bytes = static_cast<double>(held.bitmap + held.components + held.visibility_graph);
  std::vector<double> figures{1e6 * prepared / cells, 8 * bytes / cells};
  double peak = 0;
  for (const double gap : kGaps) figures.push_back(mean_time(set, gap, options.rounds, peak));
  const Threads threads = compare_threads(planner, set, options.rounds);
  const auto [back, fewer] = compare_ends(set);
  figures.insert(figures.end(), {peak / 1e6, threads.gain, threads.cost, back, fewer});
  const auto [own, none] =
      options.batch > 0 ? time_batch(set, options.batch) : std::pair(kNaN, kNaN);
  figures.insert(figures.end(), {own, none});
  table.row(set.name, figures);
}

void run_exact(const ExactOptions& options) {
  Table table(
      std::to_string(options.count) + " queries a map, seed " + std::to_string(options.maps.seed) +
          ", median of " + std::to_string(options.rounds) +
          " rounds. Preparation without the copy of the map; microseconds of processor "
          "time a query, mean, to a certified gap.",
      {"map", "prepared, ms a million cells", "bits a cell", "gap 10%", "gap 3%", "gap 1%",
       "proven", "MB a query, most", "batch, time with 1 / 2 threads", "processor time, 2 / 1",
       "corners, goal / start", "fewer / start", "batch, s", "without a graph of its own, s"});
  for (const QuerySource& source : sources_of(options.maps))
    measure_map(load(source, options.count), options, table);
}

}  // namespace

void add_exact_command(CLI::App& app) {
  const auto [command, options] = add_command(
      app, "exact", "Preparation, anytime figures, memory and threads of `exact`", run_exact);
  add_query_options(command, options);
  add_number(command, "--batch", options.batch,
             "Queries of a batch with and without a graph of its own");
}

}  // namespace lasius::bench
