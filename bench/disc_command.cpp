// lasius_bench discs: what a disc's exact path costs, against a point's on the same queries.
#include <algorithm>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "bench/clocks.h"
#include "bench/commands.h"
#include "bench/query_set.h"
#include "bench/report.h"
#include "bench/statistics.h"
#include "core/base/number_text.h"
#include "core/base/special_values.h"
#include "core/disc/disc_graph.h"
#include "core/disc/disc_search.h"
#include "core/disc/disc_space.h"
#include "core/exact/exact.h"
#include "lasius/plan/planner.h"

namespace lasius::bench {
namespace {

struct DiscOptions : QueryOptions, Reported {
  DiscOptions() : QueryOptions{.count = 30, .rounds = 3} {}
  std::vector<double> radii{0.5, 1.7, 4.4, 8, 12.3};
  bool prepare = false;
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
      without.add(microseconds([&] { point.search(set.grid, start, goal, {}, {}, of_point); }));
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

// Of 10 x 10 cells that are blocked or freed, microseconds, the median of some places: in place,
// and as another Planner.
struct EditTimes {
  double space, planner;
};

EditTimes measure_edits(const Grid& map, const disc::DiscSpace& made, int rounds) {
  constexpr int kPlaces = 15, kSide = 10;
  std::mt19937 random(1);
  const auto below = [&](int end) {
    return static_cast<int>(random() % static_cast<unsigned>(end));
  };
  const Planner planner(map, Disc{made.asked_radius()});
  disc::DiscSpace space = made;
  std::vector<double> in_place, copied;
  for (int place = 0; place < kPlaces; ++place) {
    const int width = std::min(kSide, map.width()), height = std::min(kSide, map.height());
    const Cell at{below(map.width() - width + 1), below(map.height() - height + 1)};
    Grid edited = map;
    edited.fill({at.x, at.y, width, height}, map.free(at));
    std::vector<Cell> cells;
    std::vector<Planner::Edit> edits;
    for (int y = at.y; y < at.y + height; ++y) {
      for (int x = at.x; x < at.x + width; ++x) {
        cells.push_back({x, y});
        edits.push_back({{x, y}, map.free(at)});
      }
    }
    Least here, anew;
    for (int round = 0; round < rounds; ++round) {
      here.add(microseconds([&] { space.update(edited, cells); }));
      space.update(map, cells);
      anew.add(microseconds([&] { (void)planner.edited(edits); }));
    }
    in_place.push_back(here.value);
    copied.push_back(anew.value);
  }
  return {median(in_place), median(copied)};
}

// What spaces cost, the first two of a cell.
struct Costs {
  GeometricMean nanoseconds, bytes, edit, planner;

  std::string text() const {
    const auto mean = [](const GeometricMean& of) { return short_number(of.value()); };
    return "; of " + std::to_string(bytes.count()) + " spaces " + mean(nanoseconds) + " ns and " +
           mean(bytes) + " bytes a cell, an edit of 10 x 10 cells " + mean(edit) +
           " us, as another Planner " + mean(planner) + " us.\n";
  }
};

// The two ratios, of what had queries.
struct Ratios {
  GeometricMean scan, graph;
  double worst_scan = -kInfinity, worst_graph = -kInfinity;

  void add(double of_scan, double of_graph) {
    scan.add(of_scan);
    graph.add(of_graph);
    worst_scan = std::max(worst_scan, of_scan);
    worst_graph = std::max(worst_graph, of_graph);
  }
  std::string text(const std::string& what) const {
    return what + ": " + std::to_string(scan.count()) + " maps, geometric mean of scan / point " +
           short_number(scan.value()) + ", worst " + short_number(worst_scan) +
           "; of graph / point " + short_number(graph.value()) + ", worst " +
           short_number(worst_graph);
  }
};

void measure_map(const QuerySet& set, double radius, const DiscOptions& options, Table& table,
                 Ratios& ratios, Ratios& all, Costs& costs) {
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
  const double bytes = static_cast<double>(space->bytes()) / cells;
  const EditTimes edit = measure_edits(set.grid, *space, options.rounds);
  table.row(set.name + ' ' + number_text(radius),
            {1.0 * times.found, 1.0 * times.closed, times.point / times.found, scan, with_graph,
             made.value / 1000, bytes, edit.space, edit.planner, prepared / 1000,
             graph != nullptr ? static_cast<double>(graph->edge_count()) : kNaN});
  costs.nanoseconds.add(1000 * made.value / cells);
  costs.bytes.add(bytes);
  costs.edit.add(edit.space);
  costs.planner.add(edit.planner);
  if (times.found == 0) return;
  ratios.add(scan, with_graph);
  all.add(scan, with_graph);
}

void run_discs(const DiscOptions& options) {
  Table table("Discs on " + std::to_string(options.count) +
                  " queries a map, processor time of one thread, least of " +
                  std::to_string(options.rounds) + " rounds in turn.",
              {"map, radius", "found", "closed", "point, us", "scan / point", "graph / point",
               "space, ms", "bytes a cell", "edit, us", "edited, us", "graph, ms", "edges"},
              options.markdown);
  const auto sources = sources_of(options.maps, {options.markdown});
  std::string means;
  Ratios all;
  for (const double radius : options.radii) {
    Ratios ratios;
    Costs costs;
    for (const QuerySource& source : sources)
      measure_map(load(source, options.count), radius, options, table, ratios, all, costs);
    means += ratios.text("Radius " + number_text(radius)) + costs.text();
  }
  means += all.text("All") + ".\n";
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
}

}  // namespace lasius::bench
