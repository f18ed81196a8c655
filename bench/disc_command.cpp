// lasius_bench discs: what a disc's exact path costs, against a point's on the same queries.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/clocks.h"
#include "bench/commands.h"
#include "bench/query_set.h"
#include "bench/report.h"
#include "core/base/number_text.h"
#include "core/base/special_values.h"
#include "core/disc/disc_graph.h"
#include "core/disc/disc_search.h"
#include "core/disc/disc_space.h"
#include "core/exact/exact.h"

namespace lasius::bench {
namespace {

struct DiscOptions : QueryOptions {
  DiscOptions() : QueryOptions{.count = 30, .rounds = 3} {}
  std::vector<double> radii{0.5, 1.7, 4.4, 8, 12.3};
  bool prepare = false;
  std::string markdown;
};

// Microseconds of processor time that a call takes.
template <class Call>
double microseconds(const Call& call) {
  const ThreadStopwatch watch;
  call();
  return 1e6 * watch.seconds();
}

// The least of several rounds.
struct Least {
  double value = kInfinity;
  void add(double time) { value = std::min(value, time); }
};

struct Times {
  int found = 0, closed = 0;
  double point = 0, scan = 0, graph = 0;  // sums over what was found
};

// Each round asks all three, so that what else the machine does meets all of them.
Times measure_queries(const QuerySet& set, const disc::DiscSpace& space,
                      const disc::DiscGraph* graph, int rounds) {
  Times times;
  ExactSearch point;
  disc::DiscSearch search;
  for (const Query& query : set.queries) {
    const Point start = centre(query.start), goal = centre(query.goal);
    if (!space.clear(start) || !space.clear(goal)) continue;
    disc::DiscAnswer answer;
    ExactAnswer of_point;
    const auto ask = [&](const disc::DiscGraph* with) {
      return microseconds([&] { search.search(space, with, start, goal, {}, {}, answer); });
    };
    Least of_graph, of_scan, without;
    for (int round = 0; round < rounds; ++round) {
      without.add(
          microseconds([&] { point.search(set.grid, query.start, query.goal, {}, {}, of_point); }));
      if (graph != nullptr) of_graph.add(ask(graph));
      of_scan.add(ask(nullptr));
    }
    if (answer.end == ExactEnd::unreachable) {
      ++times.closed;
      continue;
    }
    ++times.found;
    times.point += without.value;
    times.scan += of_scan.value;
    times.graph += of_graph.value;
  }
  return times;
}

// The logarithms of the two ratios, summed over what had queries.
struct Ratios {
  double scan = 0, graph = 0, worst_scan = -kInfinity, worst_graph = -kInfinity;
  int maps = 0;

  void add(double of_scan, double of_graph) {
    scan += std::log(of_scan);
    graph += std::log(of_graph);
    worst_scan = std::max(worst_scan, of_scan);
    worst_graph = std::max(worst_graph, of_graph);
    ++maps;
  }
  std::string text(const std::string& what) const {
    return what + ": " + std::to_string(maps) + " maps, geometric mean of scan / point " +
           short_number(std::exp(scan / maps)) + ", worst " + short_number(worst_scan) +
           "; of graph / point " + short_number(std::exp(graph / maps)) + ", worst " +
           short_number(worst_graph) + ".\n";
  }
};

void measure_map(const QuerySet& set, double radius, const DiscOptions& options, Table& table,
                 Ratios& ratios, Ratios& all) {
  std::optional<disc::DiscSpace> space;
  Least made;
  for (int round = 0; round < options.rounds; ++round)
    made.add(microseconds([&] { space = disc::DiscSpace::make(set.grid, radius); }));
  std::shared_ptr<disc::DiscGraph> graph;
  Preparation report;
  double prepared = kNaN;
  if (options.prepare) {
    prepared = microseconds([&] { graph = disc::DiscGraph::make(*space, {.threads = 1}, report); });
  }
  const Times times = measure_queries(set, *space, graph.get(), options.rounds);
  const double cells = static_cast<double>(set.grid.width()) * set.grid.height();
  const double scan = times.scan / times.point;
  const double with_graph = graph != nullptr ? times.graph / times.point : kNaN;
  table.row(set.name + ' ' + number_text(radius),
            {1.0 * times.found, 1.0 * times.closed, times.point / times.found, scan, with_graph,
             made.value / 1000, static_cast<double>(space->bytes()) / cells, prepared / 1000,
             graph != nullptr ? static_cast<double>(graph->edge_count()) : kNaN});
  if (times.found == 0) return;
  ratios.add(scan, with_graph);
  all.add(scan, with_graph);
}

void run_discs(const DiscOptions& options) {
  Table table("Discs on " + std::to_string(options.count) +
                  " queries a map, processor time of one thread, least of " +
                  std::to_string(options.rounds) + " rounds in turn.",
              {"map, radius", "found", "closed", "point, us", "scan / point", "graph / point",
               "space, ms", "bytes a cell", "graph, ms", "edges"},
              options.markdown);
  const auto sources = sources_of(options.maps, {options.markdown});
  std::string means;
  Ratios all;
  for (const double radius : options.radii) {
    Ratios ratios;
    for (const QuerySource& source : sources)
      measure_map(load(source, options.count), radius, options, table, ratios, all);
    if (ratios.maps > 0) means += ratios.text("Radius " + number_text(radius));
  }
  means += all.text("All");
  table.close(means);
}

}  // namespace

void add_disc_command(CLI::App& app) {
  const auto [command, options] =
      add_command(app, "discs", "Exact paths of discs, against a point's", run_discs);
  add_query_options(command, options);
  command.add_option("--radii", options.radii, "Radii in cells, as 0.5,4.4")
      ->delimiter(',')
      ->check(CLI::Range(disc::kLeastRadius, disc::kLargestRadius));
  command.add_flag("--prepare", options.prepare, "Make the graph, too, and ask it");
  add_output(command, options.markdown);
}

}  // namespace lasius::bench
