// lasius_bench discs: what a disc's exact path costs, against a point's on the same queries.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <random>
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
#include "lasius/planner.h"

namespace lasius::bench {
namespace {

struct DiscOptions : QueryOptions {
  DiscOptions() : QueryOptions{.count = 30, .rounds = 3} {}
  std::vector<double> radii{0.5, 1.7, 4.4, 8, 12.3};
  bool prepare = false;
  std::string markdown;
};

// The least time of so many calls, microseconds of processor time.
template <class Call>
double least_microseconds(int rounds, const Call& call) {
  double least = kInfinity;
  for (int round = 0; round < rounds; ++round) {
    const ThreadStopwatch watch;
    call();
    least = std::min(least, 1e6 * watch.seconds());
  }
  return least;
}

struct Times {
  int found = 0, closed = 0;
  double point = 0, scan = 0, graph = 0;  // sums over what was found
};

Times measure_queries(const QuerySet& set, const disc::DiscSpace& space,
                      const disc::DiscGraph* graph, int rounds) {
  Times times;
  ExactSearch point;
  disc::DiscSearch search;
  for (const Query& query : set.queries) {
    const Point start = centre(query.start), goal = centre(query.goal);
    if (!space.clear(start) || !space.clear(goal)) continue;
    disc::DiscAnswer answer;
    const auto ask = [&](const disc::DiscGraph* with) {
      return least_microseconds(rounds,
                                [&] { search.search(space, with, start, goal, {}, {}, answer); });
    };
    const double scan = ask(nullptr);
    if (answer.end == ExactEnd::unreachable) {
      ++times.closed;
      continue;
    }
    ++times.found;
    times.scan += scan;
    if (graph != nullptr) times.graph += ask(graph);
    ExactAnswer of_point;
    times.point += least_microseconds(
        rounds, [&] { point.search(set.grid, query.start, query.goal, {}, {}, of_point); });
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
    in_place.push_back(kInfinity);
    for (int round = 0; round < rounds; ++round) {
      const ThreadStopwatch watch;
      space.update(edited, cells);
      in_place.back() = std::min(in_place.back(), 1e6 * watch.seconds());
      space.update(map, cells);
    }
    copied.push_back(least_microseconds(rounds, [&] { (void)planner.edited(edits); }));
  }
  std::ranges::sort(in_place);
  std::ranges::sort(copied);
  return {in_place[kPlaces / 2], copied[kPlaces / 2]};
}

// Sums over the maps of a radius: logarithms of the two ratios where there were queries, and what
// their spaces cost.
struct Sums {
  double scan = 0, graph = 0;
  int maps = 0;
  double nanoseconds = 0, bytes = 0, edit = 0, planner = 0;  // logarithms, the first two of a cell
  int spaces = 0;
};

void measure_map(const QuerySet& set, double radius, const DiscOptions& options, Table& table,
                 Sums& sums) {
  std::optional<disc::DiscSpace> space;
  const double made =
      least_microseconds(options.rounds, [&] { space = disc::DiscSpace::make(set.grid, radius); });
  std::shared_ptr<disc::DiscGraph> graph;
  Preparation report;
  double prepared = kNaN;
  if (options.prepare) {
    prepared = least_microseconds(
        1, [&] { graph = disc::DiscGraph::make(*space, {.threads = 1}, report); });
  }
  const Times times = measure_queries(set, *space, graph.get(), options.rounds);
  const double cells = static_cast<double>(set.grid.width()) * set.grid.height();
  const double scan = times.scan / times.point;
  const double with_graph = graph != nullptr ? times.graph / times.point : kNaN;
  const double bytes = static_cast<double>(space->bytes()) / cells;
  const EditTimes edit = measure_edits(set.grid, *space, options.rounds);
  table.row(set.name + ' ' + number_text(radius),
            {1.0 * times.found, 1.0 * times.closed, times.point / times.found, scan, with_graph,
             made / 1000, bytes, edit.space, edit.planner, prepared / 1000,
             graph != nullptr ? static_cast<double>(graph->edge_count()) : kNaN});
  ++sums.spaces;
  sums.nanoseconds += std::log(1000 * made / cells);
  sums.bytes += std::log(bytes);
  sums.edit += std::log(edit.space);
  sums.planner += std::log(edit.planner);
  if (times.found == 0) return;
  sums.scan += std::log(scan);
  sums.graph += std::log(with_graph);
  ++sums.maps;
}

void run_discs(const DiscOptions& options) {
  Table table("Discs on " + std::to_string(options.count) +
                  " queries a map, processor time of one thread, least of " +
                  std::to_string(options.rounds) + " rounds.",
              {"map, radius", "found", "closed", "point, us", "scan / point", "graph / point",
               "space, ms", "bytes a cell", "edit, us", "edited, us", "graph, ms", "edges"},
              options.markdown);
  const auto sources = sources_of(options.maps, {options.markdown});
  std::string means;
  for (const double radius : options.radii) {
    Sums sums;
    const auto mean = [](double logarithms, int count) {
      return short_number(std::exp(logarithms / count));
    };
    for (const QuerySource& source : sources)
      measure_map(load(source, options.count), radius, options, table, sums);
    means += "Radius " + number_text(radius) + ": geometric mean over " +
             std::to_string(sums.maps) + " maps " + mean(sums.scan, sums.maps) +
             ", with the graph " + mean(sums.graph, sums.maps) + "; of all " +
             std::to_string(sums.spaces) + ": a space in " + mean(sums.nanoseconds, sums.spaces) +
             " ns and " + mean(sums.bytes, sums.spaces) +
             " bytes a cell; an edit of 10 x 10 cells in " + mean(sums.edit, sums.spaces) +
             " us, as another Planner in " + mean(sums.planner, sums.spaces) + " us.\n";
  }
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
