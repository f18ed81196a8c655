// lasius_bench validity: every path of the colonies is checked, over many maps.
#include <cmath>
#include <iostream>
#include <map>
#include <memory>

#include "bench/clocks.h"
#include "bench/commands.h"
#include "bench/query_set.h"
#include "bench/report.h"
#include "bench/statistics.h"
#include "lasius/path.h"
#include "lasius/planner.h"

namespace lasius::bench {
namespace {

struct Options {
  std::vector<std::string> maps;
  std::vector<std::string> algorithms = {"fan2004", "as"};
  int random = 1000;
  int side = 256;
  int iterations = 3;
  int ants = 4;
  std::uint64_t seed = 1;
};

std::string fault_of(const Grid& grid, const Query& query, const Result& result) {
  if (result.path.empty()) return {};
  if (result.path.front() != centre(query.start) || result.path.back() != centre(query.goal)) {
    return "the path does not join start and goal";
  }
  if (std::abs(result.length - path_length(result.path)) > 1e-9 * std::max(1.0, result.length)) {
    return "the length is not the path's";
  }
  if (!std::isnan(query.optimum) && result.length < query.optimum - 1e-6 * query.optimum) {
    return "shorter than the optimum";
  }
  return path_fault(grid, result.path).value_or("");
}

struct Tally {
  int paths = 0, faults = 0;
  std::map<std::string, int> unsolved;  // by status
  std::vector<double> gaps;             // of the others, to the any-angle optimum
  double seconds = 0;
};
using Tallies = std::map<std::string, Tally>;  // by algorithm

void check(const QuerySet& set, const Options& options, Tallies& tallies) {
  const Planner planner(set.grid);
  Workspace workspace;
  std::vector<double> optima;
  for (const Query& query : set.queries) {
    optima.push_back(planner.plan({query.start, query.goal}, {}, &workspace).length);
  }
  for (const std::string& algorithm : options.algorithms) {
    Tally& tally = tallies[algorithm];
    Params params = defaults(algorithm);
    params.iterations = options.iterations;
    params.ants = options.ants;
    params.threads = 1;
    const Stopwatch watch;
    for (std::size_t q = 0; q < set.queries.size(); ++q) {
      params.seed = options.seed + q;
      const Query& query = set.queries[q];
      const Result result = planner.plan({query.start, query.goal}, params, &workspace);
      ++tally.paths;
      if (result.status != Status::solved) {
        ++tally.unsolved[std::string(to_string(result.status))];
      } else if (optima[q] > 0) {
        tally.gaps.push_back(result.length / optima[q] - 1);
      }
      const std::string fault = fault_of(set.grid, query, result);
      if (fault.empty()) continue;
      ++tally.faults;
      std::cout << set.name << ", query " << q << ", " << algorithm << ": " << fault << '\n';
    }
    tally.seconds += watch.seconds();
  }
}

int unsolved(const Tally& tally) {
  int sum = 0;
  for (const auto& [status, count] : tally.unsolved) sum += count;
  return sum;
}

/// A row of the table, paths and median gap by algorithm; adds the map to the sums.
void report(const std::string& map, const Options& options, const Tallies& here, Tallies& sums) {
  std::cout << "| " << map;
  for (const std::string& algorithm : options.algorithms) {
    const Tally& tally = here.at(algorithm);
    std::cout << " | " << tally.paths - unsolved(tally) << " of " << tally.paths;
    if (!tally.gaps.empty()) std::cout << ", " << short_number(100 * median(tally.gaps)) << '%';
    Tally& sum = sums[algorithm];
    sum.paths += tally.paths;
    sum.faults += tally.faults;
    sum.seconds += tally.seconds;
    for (const auto& [status, count] : tally.unsolved) sum.unsolved[status] += count;
  }
  std::cout << " |" << std::endl;
}

void run(Options options) {
  if (options.algorithms == std::vector<std::string>{"all"}) {
    options.algorithms.clear();
    for (const Algorithm& a : algorithms()) options.algorithms.emplace_back(a.name);
  }
  std::cout << "Paths found and median gap to the any-angle optimum; " << options.iterations
            << " iterations of " << options.ants << " ants.\n\n| map";
  for (const std::string& algorithm : options.algorithms) std::cout << " | " << algorithm;
  std::cout << " |\n|---";
  for (std::size_t i = 0; i < options.algorithms.size(); ++i) std::cout << "|---";
  std::cout << "|\n";

  Tallies tallies;
  for (const QuerySource& source : find_sources(options.maps)) {
    Tallies here;
    const QuerySet set = load(source, 0);
    check(set, options, here);
    report(set.name, options, here, tallies);
  }
  Tallies random;
  // Ten queries a map, the kinds in turn, a new seed each time around.
  for (int done = 0; done < options.random;) {
    const auto seed = options.seed + static_cast<std::uint64_t>(done);
    for (const QuerySource& source : generated_sources({options.side}, seed)) {
      if (done >= options.random) break;
      const auto count = std::min(10, options.random - done);
      check(load(source, static_cast<std::size_t>(count)), options, random);
      done += count;
    }
  }
  if (!random.empty()) report("generated", options, random, tallies);
  std::cout << '\n';
  int faults = 0;
  for (const auto& [algorithm, tally] : tallies) {
    std::cout << algorithm << ": " << tally.paths << " queries, " << tally.faults << " faults";
    for (const auto& [status, count] : tally.unsolved) std::cout << ", " << count << ' ' << status;
    std::cout << ", " << tally.seconds << " s\n";
    faults += tally.faults;
  }
  if (faults != 0) throw CLI::RuntimeError(1);
}

}  // namespace

void add_validity_command(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("validity", "Checks every path of the colonies");
  command->add_option("--maps", options->maps,
                      "Folders or files, as for queries; all their queries");
  command->add_option("--algorithms", options->algorithms, "Which; all")
      ->delimiter(',')
      ->capture_default_str();
  command->add_option("--random", options->random, "Queries on generated maps of all kinds")
      ->capture_default_str();
  command->add_option("--side", options->side, "Of generated maps")->capture_default_str();
  command->add_option("--iterations", options->iterations, "Of each plan")->capture_default_str();
  command->add_option("--ants", options->ants, "Of each iteration")->capture_default_str();
  command->add_option("--seed", options->seed, "The first one")->capture_default_str();
  command->callback([options] { run(*options); });
}

}  // namespace lasius::bench
