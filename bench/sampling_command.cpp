// lasius_bench sampling: how long OMPL's planners take to come near the optimum.
#include <algorithm>
#include <iostream>
#include <string_view>

#include "bench/clocks.h"
#include "bench/commands.h"
#include "bench/contenders.h"
#include "bench/peers/sampling.h"
#include "bench/report.h"
#include "bench/statistics.h"
#include "core/base/number_text.h"

namespace lasius::bench {
namespace {

using peers::kGaps;
using peers::SamplingTrial;

struct SamplingOptions : Reported {
  MapOptions maps;
  std::size_t count = 3;
  int seeds = 3;
  double cap = 2;
};

// All trials of one planner on one map.
struct Row {
  std::string map, planner;
  std::vector<SamplingTrial> trials;
};

// Median milliseconds of all trials, longer where they never got there, and how many got there.
std::string cell(const std::vector<SamplingTrial>& trials, std::size_t gap) {
  std::vector<double> times;
  for (const SamplingTrial& t : trials) times.push_back(1000 * t.seconds[gap]);
  const auto reached = std::count_if(times.begin(), times.end(), [](double t) { return t < 1e18; });
  return short_number(median(times)) + " (" + std::to_string(reached) + "/" +
         std::to_string(times.size()) + ")";
}

// A row for each planner with its trials on every map.
std::vector<Row> over_all_maps(const std::vector<Row>& rows) {
  std::vector<Row> all;
  for (const Row& row : rows) {
    auto same = std::find_if(all.begin(), all.end(),
                             [&](const Row& sum) { return sum.planner == row.planner; });
    if (same == all.end()) same = all.insert(all.end(), {"**all**", row.planner, {}});
    same->trials.insert(same->trials.end(), row.trials.begin(), row.trials.end());
  }
  return all;
}

void write_rows(Table& table, const std::vector<Row>& rows) {
  for (const Row& row : rows) {
    std::vector<double> first;
    for (const SamplingTrial& t : row.trials) first.push_back(1000 * t.first_seconds);
    std::vector<std::string> cells{row.map, row.planner, short_number(median(first))};
    for (std::size_t g = 0; g < kGaps.size(); ++g) cells.push_back(cell(row.trials, g));
    table.row(cells);
  }
}

// Our exact search as a row of that table: its only path is the optimum, put into `length`.
SamplingTrial time_exact(peers::QueryPlanner& exact, const Query& query, double& length) {
  std::vector<Point> path;
  const Stopwatch watch;
  length = exact.plan(query.start, query.goal, path);
  const double seconds = watch.seconds();
  return {seconds, {seconds, seconds, seconds}};
}

void run_map(const QuerySet& set, const SamplingOptions& options, std::vector<Row>& rows) {
  const auto all = all_contenders();
  const auto exact =
      std::ranges::find(all, std::string_view("exact"), &peers::Peer::name)->make(set.grid);
  Row ours{set.name, "lasius exact", {}};
  std::vector<double> optima;
  for (const Query& query : set.queries)
    ours.trials.push_back(time_exact(*exact, query, optima.emplace_back()));
  rows.push_back(ours);
  for (std::size_t s = 0; s < peers::sampler_names().size(); ++s) {
    Row row{set.name, std::string(peers::sampler_names()[s]), {}};
    for (std::size_t q = 0; q < set.queries.size(); ++q) {
      for (int seed = 0; seed < options.seeds; ++seed) {
        row.trials.push_back(peers::run_sampler(
            static_cast<peers::Sampler>(s), set.grid, set.queries[q].start, set.queries[q].goal,
            optima[q], options.cap, static_cast<std::uint32_t>(options.maps.seed) + seed));
      }
    }
    rows.push_back(row);
  }
}

void run_sampling(const SamplingOptions& options) {
  std::vector<Row> rows;
  for (const QuerySource& source : sources_of(options.maps, {options.markdown})) {
    std::cerr << source.name << std::endl;
    run_map(load(source, options.count), options, rows);
  }
  constexpr auto kText = Table::Align::left;
  Table table(peers::ompl_version() + ". " + std::to_string(options.count) + " queries a map, " +
                  std::to_string(options.seeds) + " seeds, at most " + number_text(options.cap) +
                  " s each; median milliseconds to within a gap of the optimum (trials that got "
                  "there).",
              {"map", {"planner", kText}, "any path", "5%", "1%", "0.1%"}, options.markdown);
  write_rows(table, rows);
  write_rows(table, over_all_maps(rows));
}

}  // namespace

void add_sampling_command(CLI::App& app) {
  const auto [command, options] =
      add_command(app, "sampling", "OMPL's planners: time to 5, 1 and 0.1%", run_sampling);
  add_map_options(command, options.maps);
  add_number(command, "--queries", options.count, "Queries a map");
  add_number(command, "--seeds", options.seeds, "Runs of each query");
  add_number(command, "--cap", options.cap, "Seconds a run");
}

}  // namespace lasius::bench
