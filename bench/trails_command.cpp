// lasius_bench trails: where a trail shortens tours, family by family, each with its control.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>

#include "bench/commands.h"
#include "bench/query_set.h"
#include "bench/report.h"
#include "bench/statistics.h"
#include "bench/tour_time.h"
#include "core/tour/ants/ant_colony.h"
#include "core/tour/map_pricer.h"
#include "core/tour/order/costs.h"
#include "core/tour/order/search.h"
#include "kernels/base/random_stream.h"
#include "lasius/base/error.h"
#include "lasius/tour/tsplib.h"

namespace lasius::bench {
namespace {

struct TrailOptions {
  MapOptions maps = {};
  std::vector<std::string> files = {};
  std::vector<int> sizes = {100, 300};
  int instances = 2, seeds = 3;
  double seconds = 1;
};

// An order to find. Where a directed cost is below 0 the other stop comes before.
struct OrderProblem {
  int size = 0;
  std::vector<tour::Cost> matrix = {};
  std::vector<Point> places = {};
  std::vector<tour::Before> before = {};
  tour::Ends ends = {};
  bool symmetric = true;
  tour::Costs costs() const { return {size, matrix.data()}; }
};

// Problems that a row tells about.
struct TrailKind {
  std::string name;
  std::vector<OrderProblem> problems;
};

// An ant colony, whose control is the same with alpha 0.
struct Contender {
  std::string family;
  tour::Improvement improvement;
  std::string name() const {
    const std::string with = improvement == tour::Improvement::none     ? ""
                             : improvement == tour::Improvement::pieces ? ", pieces"
                                                                        : ", three edges";
    return family + with;
  }
};

constexpr std::uint32_t kDrawn = 0x7472616c;

OrderProblem on_plane(int size, std::uint64_t seed) {
  kernels::RandomStream random(seed, static_cast<std::uint32_t>(size), 0, kDrawn);
  OrderProblem problem{.size = size};
  for (int v = 0; v < size; ++v) {
    const double x = random.below(10'000), y = random.below(10'000);
    problem.places.push_back({x, y});
  }
  for (const Point& a : problem.places)
    for (const Point& b : problem.places)
      problem.matrix.push_back(static_cast<tour::Cost>(
          std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y)) + 0.5));
  return problem;
}

// Any costs, a path from the first stop to the last, and of all pairs a share in a given order, as
// the problems of SOPLIB are made.
OrderProblem directed(int size, int percent, std::uint64_t seed) {
  kernels::RandomStream random(seed, static_cast<std::uint32_t>(size), percent, kDrawn);
  OrderProblem problem{.size = size,
                       .matrix = std::vector<tour::Cost>(static_cast<std::size_t>(size) * size),
                       .places = std::vector<Point>(static_cast<std::size_t>(size)),
                       .ends = {true, 0, size - 1},
                       .symmetric = false};
  for (tour::Cost& cost : problem.matrix) cost = random.below(1001);
  for (int a = 1; a + 1 < size; ++a)
    for (int b = a + 1; b + 1 < size; ++b)
      if (random.below(100) < percent) problem.before.emplace_back(a, b);
  return problem;
}

// Stops of a map, closed; with pairs each second one comes behind the one before it.
OrderProblem on_map(const QuerySet& set, const Planner& planner, int size, bool pairs,
                    std::uint64_t seed) {
  kernels::RandomStream random(seed, static_cast<std::uint32_t>(size), 0, kDrawn);
  std::vector<Cell> stops{set.queries.front().start};
  while (static_cast<int>(stops.size()) < size) {
    const int x = random.below(set.grid.width()), y = random.below(set.grid.height());
    if (set.grid.free({x, y}) && planner.joined(stops.front(), {x, y})) stops.push_back({x, y});
  }
  OrderProblem problem{.size = size};
  for (const Cell stop : stops) problem.places.push_back(centre(stop));
  const auto lengths = planner.distances(stops, stops, 1);
  for (const double length : *lengths) problem.matrix.push_back(tour::grains(length));
  if (!pairs) return problem;
  problem.ends = {false, 0};
  for (int v = 1; v + 1 < size; v += 2) problem.before.emplace_back(v, v + 1);
  return problem;
}

OrderProblem from_file(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw Error(ErrorCode::file_missing, {file}, "cannot be opened", "name a file .tsp");
  Tsplib read = read_tsplib(in, file);
  OrderProblem problem{.size = read.size, .matrix = std::move(read.matrix), .places = read.places};
  problem.places.resize(static_cast<std::size_t>(read.size));
  if (!read.ordered) return problem;
  problem.ends = {true, 0, read.size - 1};
  problem.symmetric = false;
  for (int a = 0; a < read.size; ++a)
    for (int b = 0; b < read.size; ++b)
      if (a != b && problem.costs()(a, b) < 0) problem.before.emplace_back(b, a);
  return problem;
}

Marks run_order(const OrderProblem& problem, const tour::PartialOrder& given,
                const tour::AntParams& params, std::uint64_t seed, double seconds) {
  Marks marks{};
  const TourTime time(seconds);
  tour::OrderOptions options;
  options.seed = seed;
  options.given = &given;
  options.stop = time.stop();
  options.observer = [&](std::span<const int>, std::int64_t cost) {
    time.tell(cost, marks);
    return true;
  };
  Convergence run;
  if (params.algorithm() == "exact")
    (void)tour::find_order(problem.costs(), problem.ends, problem.places, options);
  else
    (void)tour::find_order_by_ants(problem.costs(), problem.ends, problem.symmetric, params, 1,
                                   options, run);
  return marks;
}

tour::AntParams params_of(const Contender& contender, double alpha) {
  tour::AntParams params(contender.family);
  params.iterations = 1'000'000'000;
  params.alpha = alpha;
  params.local_search = contender.improvement;
  if (contender.improvement != tour::Improvement::none && params.ants == 0) params.ants = 10;
  if (contender.improvement != tour::Improvement::none && contender.family == "mmas")
    params.persistence = 0.8;  // the book's, where tours are improved
  return params;
}

// Means of what was told at each mark, and nothing where a run had no tour.
std::vector<double> means(const std::vector<std::vector<double>>& runs) {
  std::vector<double> sums(kShares.size(), 0);
  for (const auto& run : runs)
    for (std::size_t i = 0; i < sums.size(); ++i)
      sums[i] += run[i] / static_cast<double>(runs.size());
  return sums;
}

// The mean of differences with its interval of 95%, by percentiles of 2000 resamplings.
std::string interval(const std::vector<double>& differences) {
  kernels::RandomStream random(1, 0, 0, kDrawn);
  const int n = static_cast<int>(differences.size());
  std::vector<double> drawn;
  for (int i = 0; i < 2000; ++i) {
    double sum = 0;
    for (int k = 0; k < n; ++k) sum += differences[random.below(n)];
    drawn.push_back(sum / n);
  }
  const double mean = std::accumulate(differences.begin(), differences.end(), 0.0) / n;
  return short_number(mean) + " [" + short_number(quantile(drawn, 0.025)) + ", " +
         short_number(quantile(drawn, 0.975)) + "]";
}

std::vector<Contender> contenders_of(const TrailKind& kind) {
  using tour::Improvement;
  const bool given = !kind.problems.front().before.empty();
  std::vector<Contender> contenders;
  for (const char* family : {"as", "eas", "ras", "mmas", "acs"}) {
    contenders.push_back({family, Improvement::none});
    contenders.push_back({family, given ? Improvement::pieces : Improvement::three_edges});
  }
  contenders.push_back({"has-sop", Improvement::pieces});
  contenders.push_back({"eacs", Improvement::pieces});
  return contenders;
}

void write_kind(const TrailKind& kind, const TrailOptions& options, Table& table) {
  const std::vector<Contender> contenders = contenders_of(kind);
  // By contender, with its trail and without, run by run; the last is the usual search.
  std::vector<std::array<std::vector<std::vector<double>>, 2>> above(contenders.size() + 1);
  for (const OrderProblem& problem : kind.problems) {
    const tour::PartialOrder order(problem.size, problem.before);
    for (int seed = 1; seed <= options.seeds; ++seed) {
      const auto number = static_cast<std::uint64_t>(seed);
      std::vector<std::array<Marks, 2>> marks(above.size());
      for (std::size_t i = 0; i < contenders.size(); ++i)
        for (const int off : {0, 1})
          marks[i][off] =
              run_order(problem, order, params_of(contenders[i], 1 - off), number, options.seconds);
      marks.back()[0] =
          run_order(problem, order, tour::AntParams("exact"), number, options.seconds);
      marks.back()[1] = marks.back()[0];
      std::int64_t best = marks.back()[0].back();
      for (const auto& pair : marks)
        for (const Marks& one : pair)
          if (one.back() > 0) best = std::min(best, one.back());
      for (std::size_t i = 0; i < above.size(); ++i)
        for (const int off : {0, 1}) {
          std::vector<double> figures;
          for (const std::int64_t mark : marks[i][off])
            figures.push_back(percent_above(mark, best));
          above[i][off].push_back(std::move(figures));
        }
    }
  }
  for (std::size_t i = 0; i < above.size(); ++i) {
    const bool usual = i == contenders.size();
    std::vector<std::string> cells{kind.name, usual ? "the usual search" : contenders[i].name()};
    const std::vector<double> with = means(above[i][0]), without = means(above[i][1]);
    for (std::size_t mark = 1; mark < kShares.size(); ++mark)
      cells.push_back(short_number(with[mark]) +
                      (usual ? "" : " / " + short_number(without[mark])));
    std::vector<double> differences;
    int better = 0, worse = 0;
    for (std::size_t run = 0; run < above[i][0].size(); ++run) {
      const double more = above[i][0][run].back() - above[i][1][run].back();
      differences.push_back(more);
      better += more < 0;
      worse += more > 0;
    }
    cells.push_back(usual ? "-" : interval(differences));
    cells.push_back(
        usual ? "-"
              : std::to_string(better) + "/" +
                    std::to_string(static_cast<int>(differences.size()) - better - worse) + "/" +
                    std::to_string(worse));
    table.row(cells);
  }
}

std::vector<TrailKind> kinds_of(const TrailOptions& options) {
  std::vector<TrailKind> kinds;
  const auto add = [&](const std::string& name, const auto& make) {
    TrailKind kind{name, {}};
    for (int i = 1; i <= options.instances; ++i)
      kind.problems.push_back(make(options.maps.seed + static_cast<std::uint64_t>(i)));
    kinds.push_back(std::move(kind));
  };
  for (const std::string& file : options.files) kinds.push_back({file, {from_file(file)}});
  for (const int size : options.sizes) {
    const std::string stops = " " + std::to_string(size);
    add("plane" + stops, [&](std::uint64_t seed) { return on_plane(size, seed); });
    for (const int percent : {1, 15})
      add("directed" + stops + ", " + std::to_string(percent) + "% in order",
          [&](std::uint64_t seed) { return directed(size, percent, seed); });
  }
  if (options.maps.maps.empty()) return kinds;
  for (const QuerySource& source : sources_of(options.maps)) {
    const QuerySet set = load(source, 1);
    const Planner planner = Planner(set.grid).prepared({.threads = 1});
    for (const int size : options.sizes)
      for (const bool pairs : {false, true})
        add(set.name + " " + std::to_string(size) + (pairs ? ", in pairs" : ""),
            [&](std::uint64_t seed) { return on_map(set, planner, size, pairs, seed); });
  }
  return kinds;
}

void run_trails(const TrailOptions& options) {
  std::vector<Table::Column> columns{"problems, stops", {"colony", Table::Align::left}};
  for (std::size_t i = 1; i < kShares.size(); ++i)
    columns.emplace_back(short_number(kShares[i] * options.seconds) + " s");
  columns.emplace_back("trail less control [95%]");
  columns.emplace_back("better/equal/worse");
  Table table(
      "Per cent above the best of all runs of a problem and seed, mean of " +
          std::to_string(options.instances) + " problems (of a file one) and " +
          std::to_string(options.seeds) +
          " seeds, by processor time of one thread: with the trail / without (alpha = 0), and at "
          "the end how much more that is with it, run by run.",
      columns);
  for (const TrailKind& kind : kinds_of(options)) write_kind(kind, options, table);
}

}  // namespace

void add_trails_command(CLI::App& app) {
  const auto [command, options] =
      add_command(app, "trails", "Colonies over stops by time, each against itself without a trail",
                  run_trails);
  add_map_options(command, options.maps);
  command.add_option("--files", options.files, "Problems of TSPLIB, .tsp and .sop");
  command.add_option("--stops", options.sizes, "Stops of drawn problems and of maps")
      ->capture_default_str()
      ->check(CLI::Range(13, 2000));
  add_number(command, "--instances", options.instances, "Problems of each kind", 1, 100);
  add_number(command, "--seeds", options.seeds, "Runs of each", 1, 1000);
  add_number(command, "--seconds", options.seconds, "Processor time of a run", 0.01, 1000);
}

}  // namespace lasius::bench
