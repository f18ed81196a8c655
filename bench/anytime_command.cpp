// lasius_bench anytime: the certified gap of `exact` against the time that it is given.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "bench/commands.h"
#include "bench/query_set.h"
#include "bench/report.h"
#include "bench/statistics.h"
#include "lasius/plan/planner.h"

namespace lasius::bench {
namespace {

struct AnytimeOptions {
  MapOptions maps;
  std::size_t count = 20;
};

constexpr int kDeadlines[] = {3, 10, 30, 100, 300, 1000};  // milliseconds

/// What the queries of a map had when a deadline was over.
struct Outcome {
  std::vector<double> gaps;  // infinite without a path
  int proven = 0;
};

Outcome outcome_of(const Planner& planner, const QuerySet& set, int deadline,
                   Workspace& workspace) {
  Outcome outcome;
  for (const Query& query : set.queries) {
    const StopCondition stop{.deadline = deadline_in(std::chrono::milliseconds(deadline))};
    const Result result =
        planner.plan({query.start, query.goal, stop}, Params("exact"), {.workspace = &workspace});
    outcome.gaps.push_back(result.path.empty() ? std::numeric_limits<double>::infinity()
                                               : result.length / *result.lower_bound - 1);
    outcome.proven += result.optimal ? 1 : 0;
  }
  return outcome;
}

// As in "12%, 3 without, 5 proven".
std::string told(const Outcome& outcome) {
  const auto without = std::count_if(outcome.gaps.begin(), outcome.gaps.end(),
                                     [](double gap) { return std::isinf(gap); });
  std::ostringstream text;
  const double gap = median(outcome.gaps);
  text << (std::isinf(gap) ? "no path" : short_number(100 * gap) + "%");
  if (without > 0) text << ", " << without << " without";
  if (outcome.proven > 0) text << ", " << outcome.proven << " proven";
  return text.str();
}

void run_anytime(const AnytimeOptions& options) {
  const MapOptions maps = or_generated(options.maps, {1024, 8192});
  std::vector<Table::Column> columns{"map"};
  for (const int deadline : kDeadlines) columns.push_back(std::to_string(deadline) + " ms");
  Table table(std::to_string(options.count) + " queries a map, seed " + std::to_string(maps.seed) +
                  ". Median certified gap when the deadline is over; how many queries have no path "
                  "yet, and how many are proven.",
              columns);
  Workspace workspace;
  for (const QuerySource& source : sources_of(maps)) {
    const QuerySet set = load(source, options.count);
    const Planner planner(set.grid);
    std::vector<std::string> cells{set.name};
    for (const int deadline : kDeadlines)
      cells.push_back(told(outcome_of(planner, set, deadline, workspace)));
    table.row(cells);
  }
}

}  // namespace

void add_anytime_command(CLI::App& app) {
  const auto [command, options] =
      add_command(app, "anytime",
                  "The certified gap of `exact` against its deadline; on maps of 1024 and 8192 "
                  "cells a side if not told",
                  run_anytime);
  add_map_options(command, options.maps);
  add_number(command, "--queries", options.count, "Queries a map", 1);
}

}  // namespace lasius::bench
