// lasius_bench tours: how far above the best a tour is by time, against textbooks.
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numeric>

#include "bench/commands.h"
#include "bench/peers/textbook_tours.h"
#include "bench/query_set.h"
#include "bench/report.h"
#include "bench/tour_time.h"
#include "core/tour/map_pricer.h"
#include "core/tour/order/bound.h"
#include "core/tour/order/search.h"
#include "kernels/base/random_stream.h"
#include "lasius/base/error.h"
#include "lasius/tour/tour.h"
#include "lasius/tour/tsplib.h"

namespace lasius::bench {
namespace {

struct TourBenchOptions {
  MapOptions maps = {};
  std::vector<std::string> files = {};
  int stops = 200, seeds = 3, groups = 0, spread = 0;
  double seconds = 1;
  bool bounds = false, whole = false;
};

struct TourInstance {
  std::string name;
  std::vector<tour::Cost> matrix;
  std::vector<Point> places;
  std::int64_t known = 0;  // an optimum from elsewhere; 0: none
  int size() const { return static_cast<int>(places.size()); }
};

Marks searched(const tour::Costs& costs, const TourInstance& instance, std::uint64_t seed,
               const TourTime& time) {
  Marks marks{};
  tour::OrderOptions options;
  options.seed = seed;
  options.stop = time.stop();
  options.target = instance.known;
  options.observer = [&](std::span<const int>, std::int64_t cost) {
    time.tell(cost, marks);
    return true;
  };
  (void)tour::find_order(costs, {}, instance.places, options);
  return marks;
}

Marks textbook(const TourInstance& instance, peers::TourMethod method, std::uint64_t seed,
               const TourBenchOptions& options) {
  Marks marks{};
  const TourTime time(options.seconds);
  const auto watch = [&](std::int64_t cost) {
    time.tell(cost, marks);
    return cost > instance.known;
  };
  (void)peers::textbook_tour(instance.size(), instance.matrix, method, seed, watch,
                             [&] { return time.used() > options.seconds; });
  return marks;
}

// What the best tour is above the bound, which is given so many seconds of processor time.
double above_bound(const TourInstance& instance, std::int64_t best, double seconds) {
  constexpr int kRounds = 1000;
  const TourTime time(seconds);
  const StopCondition stop = time.stop();
  Poller poller(stop, 1 << 14);
  const std::int64_t bound = tour::tour_bound({instance.size(), instance.matrix.data()}, {},
                                              instance.places, best, kRounds, poller);
  return bound > 0 ? 100.0 * static_cast<double>(best - bound) / static_cast<double>(bound)
                   : kUnknown;
}

void write_bound(const TourInstance& instance, std::int64_t best, const TourBenchOptions& options,
                 Table& table) {
  std::vector<double> figures;
  for (const double share : kShares)
    figures.push_back(above_bound(instance, best, share * options.seconds));
  figures.push_back(kUnknown);
  table.row(instance.name + ", the best above the bound", figures);
}

// Rows of one instance: contenders, each the means over the seeds of what it is above the best.
void write_rows(const TourInstance& instance,
                const std::vector<std::pair<std::string, std::vector<Marks>>>& runs,
                const TourBenchOptions& options, Table& table) {
  std::int64_t best = instance.known;
  for (const auto& [name, marks] : runs)
    for (const Marks& one : marks)
      if (best == 0 || (one.back() > 0 && one.back() < best)) best = one.back();
  for (const auto& [name, marks] : runs) {
    std::vector<double> figures;
    for (std::size_t i = 0; i < kShares.size(); ++i) {
      std::vector<double> above;
      for (const Marks& one : marks) above.push_back(percent_above(one[i], best));
      figures.push_back(std::accumulate(above.begin(), above.end(), 0.0) /
                        static_cast<double>(above.size()));
      if (i + 1 == kShares.size()) figures.push_back(*std::max_element(above.begin(), above.end()));
    }
    table.row(instance.name + ", " + name, figures);
  }
  write_bound(instance, best, options, table);
}

std::vector<std::pair<std::string, std::vector<Marks>>> matrix_runs(
    const TourInstance& instance, const TourBenchOptions& options) {
  std::vector<std::pair<std::string, std::vector<Marks>>> runs{
      {"lasius", {}}, {"2-opt", {}}, {"2-opt and Or-opt, kicked", {}}, {"the same, restarted", {}}};
  for (int seed = 1; seed <= options.seeds; ++seed) {
    const auto number = static_cast<std::uint64_t>(seed);
    const TourTime time(options.seconds);
    runs[0].second.push_back(
        searched({instance.size(), instance.matrix.data()}, instance, number, time));
    runs[1].second.push_back(textbook(instance, peers::TourMethod::two_opt, number, options));
    runs[2].second.push_back(textbook(instance, peers::TourMethod::ils, number, options));
    runs[3].second.push_back(textbook(instance, peers::TourMethod::restarts, number, options));
  }
  return runs;
}

// A problem of TSPLIB, and its optimum where an optima.txt beside it tells: "name : length".
TourInstance tsplib_instance(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw Error(ErrorCode::file_missing, {file}, "cannot be opened", "name a file .tsp");
  Tsplib problem = read_tsplib(in, file);
  const std::filesystem::path path(file);
  TourInstance instance{path.stem().string(), std::move(problem.matrix), std::move(problem.places)};
  instance.places.resize(static_cast<std::size_t>(problem.size));
  std::ifstream optima(path.parent_path() / "optima.txt");
  std::string name, colon;
  for (std::int64_t length = 0; optima >> name >> colon >> length;)
    if (name == instance.name) instance.known = length;
  return instance;
}

// The whole of plan_tour, on a map that nothing is known of.
Marks from_nothing(const Grid& grid, const std::vector<Cell>& stops, std::uint64_t seed,
                   const TourBenchOptions& options) {
  Marks marks{};
  TourRequest request;
  request.stops = stops;
  request.seed = seed;
  request.threads = 1;
  request.generations = std::numeric_limits<int>::max();
  const TourTime time(options.seconds);
  request.stop = {.deadline = deadline_in(std::chrono::duration<double>(2 * options.seconds), {}),
                  .time = &time};  // of which a part is the bound's
  (void)plan_tour(Planner(grid), request, [&](std::span<const int>, double length) {
    time.tell(std::llround(length * tour::kGrains), marks);
  });
  return marks;
}

// The bound with costs at hand, of the best tour that a search of `seconds` finds, or the optimum
// where it is known.
constexpr std::array<double, 3> kBoundSeconds{0.3, 1, 2};
void measure_bounds(const TourInstance& instance, const TourBenchOptions& options, Table& table) {
  const TourTime time(options.seconds);
  const std::int64_t best =
      instance.known > 0
          ? instance.known
          : searched({instance.size(), instance.matrix.data()}, instance, 1, time).back();
  std::vector<double> figures;
  for (const double seconds : kBoundSeconds)
    figures.push_back(above_bound(instance, best, seconds));
  table.row(instance.name, figures);
}

// The start of a map's first query, and random cells that are joined to it.
std::vector<Cell> random_stops(const QuerySet& set, const Planner& planner,
                               const TourBenchOptions& options) {
  kernels::RandomStream random(options.maps.seed, 0, 0, 0x73746f70);
  std::vector<Cell> stops{set.queries.front().start};
  while (static_cast<int>(stops.size()) < options.stops) {
    const int x = random.below(set.grid.width()), y = random.below(set.grid.height());
    if (set.grid.free({x, y}) && planner.joined(stops.front(), {x, y})) stops.push_back({x, y});
  }
  return stops;
}

// Random stops of a map: lengths from a matrix that is ready, and priced as the search asks.
void measure_stops(const QuerySource& source, const TourBenchOptions& options, Table& table,
                   std::string& notes) {
  const QuerySet set = load(source, 1);
  const Stopwatch preparing;
  const Planner planner = Planner(set.grid).prepared({.threads = 1});
  const double prepared = preparing.seconds();
  const std::vector<Cell> stops = random_stops(set, planner, options);
  TourInstance instance{set.name, {}, {}};
  for (const Cell cell : stops) instance.places.push_back(centre(cell));
  const ThreadStopwatch pricing;
  const auto lengths = planner.distances(stops, stops, 1);
  const double priced = pricing.seconds();
  for (const double length : *lengths) instance.matrix.push_back(tour::grains(length));
  if (options.bounds) return measure_bounds(instance, options, table);
  auto runs = matrix_runs(instance, options);
  runs.emplace_back("lasius, from nothing", std::vector<Marks>{});
  for (int seed = 1; seed <= options.seeds; ++seed)
    runs.back().second.push_back(
        from_nothing(set.grid, stops, static_cast<std::uint64_t>(seed), options));
  runs.emplace_back("lasius, legs priced when asked for", std::vector<Marks>{});
  std::int64_t legs = 0;
  for (int seed = 1; seed <= options.seeds; ++seed) {
    const TourTime time(options.seconds);  // prices count
    tour::MapPricer pricer(planner, instance.places, time.stop());
    runs.back().second.push_back(
        searched({instance.size(), pricer}, instance, static_cast<std::uint64_t>(seed), time));
    legs = pricer.priced();
  }
  write_rows(instance, runs, options, table);
  const double all = 0.5 * options.stops * (options.stops - 1);
  notes += set.name + ": prepared in " + short_number(prepared) + " s; the matrix takes " +
           short_number(priced) + " s; of all legs " +
           short_number(100 * static_cast<double>(legs) / all) + "% were priced when asked for.\n";
}

// Groups of three stops, each anywhere or near the first of its group, by the whole call.
void measure_groups(const QuerySource& source, const TourBenchOptions& options, Table& table) {
  const QuerySet set = load(source, 1);
  const Planner planner(set.grid);
  kernels::RandomStream random(options.maps.seed, 0, 0, 0x67726f75);
  TourRequest request;
  request.threads = 1;
  const auto drawn = [&](Cell near, int spread) {
    const auto along = [&](int at, int size) {
      return spread == 0 ? random.below(size) : at - spread + random.below(2 * spread + 1);
    };
    for (;;) {
      const int x = along(near.x, set.grid.width()), y = along(near.y, set.grid.height());
      if (set.grid.free({x, y}) && planner.joined(set.queries.front().start, {x, y}))
        return Cell{x, y};
    }
  };
  for (int group = 0; group < options.groups; ++group)
    for (int i = 0; i < 3; ++i) {
      const Cell near = i == 0 ? Cell{0, 0} : request.stops[request.stops.size() - i];
      request.stops.push_back(drawn(near, i == 0 ? 0 : options.spread));
      request.group.push_back(group);
    }
  const ThreadStopwatch watch;
  const TourResult tour = plan_tour(planner, request);
  table.row(set.name, {tour.length, 100 * tour.gap().value_or(kUnknown), watch.seconds()});
}

void run_groups(const TourBenchOptions& options) {
  Table table(std::to_string(options.groups) + " groups of three stops, " +
                  (options.spread == 0 ? "anywhere"
                                       : "within " + std::to_string(options.spread) +
                                             " cells of the first of their group along each axis"),
              {"map", "length", "gap, %", "CPU s"});
  for (const QuerySource& source : sources_of(options.maps)) measure_groups(source, options, table);
}

// The whole of plan_tour within a time limit: its own gap, and the memory of all until then.
void measure_whole(const QuerySource& source, const TourBenchOptions& options, Table& table) {
  const QuerySet set = load(source, 1);
  const Planner planner(set.grid);
  TourRequest request;
  request.stops = random_stops(set, planner, options);
  request.threads = 1;
  request.generations = std::numeric_limits<int>::max();
  const TourTime time(options.seconds);
  request.stop = time.stop();
  const TourResult tour = plan_tour(planner, request);
  const double used = time.used();
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  table.row(set.name, {tour.length, 100 * tour.gap().value_or(kUnknown), used,
                       static_cast<double>(usage.ru_maxrss) / 1024});
}

Table table_of(const TourBenchOptions& options) {
  const std::string stops = std::to_string(options.stops), limit = short_number(options.seconds);
  if (options.whole)
    return {"Closed tours of " + stops + " stops from nothing, time limit " + limit +
                " s of processor time of one thread",
            {"map", "length", "gap, %", "CPU s", "peak of memory, MiB"}};
  std::vector<Table::Column> columns{"closed tours"};
  if (options.bounds) {
    for (const double seconds : kBoundSeconds) columns.emplace_back(short_number(seconds) + " s");
    return {"Per cent that the best tour (of TSPLIB the optimum, else of a search of " + limit +
                " s over " + stops +
                " stops) is above the bound, by its processor time of one thread, costs at hand",
            columns};
  }
  for (const double share : kShares)
    columns.emplace_back(short_number(share * options.seconds) + " s");
  columns.emplace_back("worst");
  return {
      "Per cent above the best known (of TSPLIB its optimum, else the best of these runs), "
      "mean of " +
          std::to_string(options.seeds) +
          " seeds, by processor time of one thread. Matrices are ready before; what they took "
          "stands below.",
      columns};
}

void run_tours(const TourBenchOptions& options) {
  if (options.groups > 0) return run_groups(options);
  Table table = table_of(options);
  for (const std::string& file : options.files) {
    const TourInstance instance = tsplib_instance(file);
    if (options.bounds)
      measure_bounds(instance, options, table);
    else
      write_rows(instance, matrix_runs(instance, options), options, table);
  }
  std::string notes;
  for (const QuerySource& source :
       sources_of(options.files.empty() ? or_generated(options.maps, {512}) : options.maps)) {
    if (options.whole)
      measure_whole(source, options, table);
    else
      measure_stops(source, options, table, notes);
  }
  if (!notes.empty()) table.close(notes);
}

}  // namespace

void add_tours_command(CLI::App& app) {
  const auto [command, options] = add_command(
      app, "tours", "Tours of many stops by time, against textbook searches", run_tours);
  add_map_options(command, options.maps);
  command.add_option("--files", options.files,
                     "Problems of TSPLIB, .tsp; an optima.txt beside them is read");
  add_number(command, "--stops", options.stops, "Random stops of a map", 13, 5000);
  add_number(command, "--groups", options.groups,
             "Instead: so many groups of three stops a map, of which one is visited", 0, 600);
  add_number(command, "--spread", options.spread,
             "Cells around the first stop of a group that its others are in; 0: anywhere", 0, 1000);
  command.add_flag("--bounds", options.bounds,
                   "Instead: the bound by its time, of the best tour of one search");
  command.add_flag("--whole", options.whole,
                   "Instead, on maps: plan_tour until --seconds, its gap and the memory it took");
  add_number(command, "--seeds", options.seeds, "Runs of each", 1, 1000);
  add_number(command, "--seconds", options.seconds, "Processor time of a run", 0.01, 1000);
}

}  // namespace lasius::bench
