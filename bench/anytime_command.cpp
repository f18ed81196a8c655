// lasius_bench anytime: the certified gap of `exact` against the time that it is given.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "bench/commands.h"
#include "bench/query_set.h"
#include "bench/report.h"
#include "bench/statistics.h"
#include "lasius/planner.h"

namespace lasius::bench {
namespace {

struct AnytimeOptions {
  std::vector<int> sides = {1024, 8192};
  std::uint64_t seed = 1;
  std::size_t count = 20;
};

constexpr double kDeadlines[] = {0.003, 0.01, 0.03, 0.1, 0.3, 1};  // seconds

/// What the queries of a map had when a deadline was over.
struct Outcome {
  std::vector<double> gaps;  // infinite without a path
  int proven = 0;
};

Outcome outcome_of(const Planner& planner, const QuerySet& set, double deadline,
                   Workspace& workspace) {
  Outcome outcome;
  for (const Query& query : set.queries) {
    const StopCondition stop{.deadline = deadline_in(std::chrono::duration<double>(deadline))};
    const Result result =
        planner.plan({query.start, query.goal, stop}, Params("exact"), &workspace);
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
  std::cout
      << machine_line() << ". " << options.count << " queries a map, seed " << options.seed
      << ". Median certified gap when the deadline is over; how many queries have no path yet, "
         "and how many are proven.\n\n| map |";
  for (const double deadline : kDeadlines) std::cout << ' ' << 1000 * deadline << " ms |";
  std::cout << "\n|---|";
  for (std::size_t i = 0; i < std::size(kDeadlines); ++i) std::cout << "--:|";
  std::cout << std::endl;
  Workspace workspace;
  for (const QuerySource& source : generated_sources(options.sides, options.seed)) {
    const QuerySet set = load(source, options.count);
    const Planner planner(set.grid);
    std::cout << "| " << set.name << " |";
    for (const double deadline : kDeadlines) {
      std::cout << ' ' << told(outcome_of(planner, set, deadline, workspace)) << " |" << std::flush;
    }
    std::cout << std::endl;
  }
}

}  // namespace

void add_anytime_command(CLI::App& app) {
  const auto [command, options] =
      add_command(app, "anytime", "The certified gap of `exact` against its deadline", run_anytime);
  command.add_option("--sides", options.sides, "Sides of the maps")->capture_default_str();
  add_number(command, "--seed", options.seed, "Seed of maps and queries");
  add_number(command, "--queries", options.count, "Queries a map", 1);
}

}  // namespace lasius::bench
