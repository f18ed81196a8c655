// lasius_bench queries: every planner on the same queries.
#include <algorithm>
#include <iostream>

#include "bench/commands.h"
#include "bench/contenders.h"
#include "bench/report.h"
#include "core/base/output.h"
#include "lasius/base/error.h"

namespace lasius::bench {
namespace {

constexpr const char* kQueriesHelp = "Queries a map; 0: all of its table, 30 where it has none";

struct QueriesOptions : Reported {
  MapOptions maps;
  std::vector<std::string> planners;
  std::string subject;
  std::size_t count = 30;
  ComparisonOptions comparison;
};

std::vector<peers::Peer> chosen(const std::vector<std::string>& names) {
  const auto all = all_contenders();
  if (names.empty()) return all;
  std::vector<peers::Peer> found;
  for (const std::string& name : names) {
    for (const auto& planner : all) {
      if (planner.name == name) found.push_back(planner);
    }
  }
  return found;
}

void run_queries(const QueriesOptions& options) {
  const auto planners = chosen(options.planners);
  std::size_t subject = 0;
  for (std::size_t p = 0; p < planners.size(); ++p) {
    if (planners[p].name == options.subject) subject = p;
  }
  const auto sources = sources_of(options.maps, {options.markdown});
  std::vector<MapComparison> results;
  for (const QuerySource& source : sources) {
    std::cerr << source.name << std::endl;
    results.push_back(compare(load(source, options.count), planners, options.comparison));
  }
  const std::string seeds =
      "seed " + std::to_string(options.maps.seed) + " for generated maps and queries";
  std::ostringstream text;
  write_markdown(text, results, planners, subject, options.comparison, seeds);
  Output(options.markdown).write(text.str());
  if (count_faults(results) != 0) throw CLI::RuntimeError(1);
}

}  // namespace

void add_map_options(CLI::App& command, MapOptions& options) {
  command.add_option("--maps", options.maps,
                     "Folders, .map, .tsv or .scen files; a map without a table gets random "
                     "queries");
  command.add_option("--generated", options.sides, "Sides of generated maps, as 512,1024,4096")
      ->delimiter(',')
      ->check(CLI::Range(16, Grid::kMaxSide));
  command
      .add_option("--kinds", options.kinds, "Of the generated maps only these, as blobs,random20")
      ->delimiter(',');
  command
      .add_option("--noise", options.noise, "Sides of maps of isolated blocked cells, 0.5 to 40%")
      ->delimiter(',')
      ->check(CLI::Range(16, Grid::kMaxSide));
  command.add_option("--seed", options.seed, "Of generated maps and random queries")
      ->capture_default_str();
}

void add_query_options(CLI::App& command, QueryOptions& options) {
  add_map_options(command, options.maps);
  add_number(command, "--queries", options.count, kQueriesHelp);
  add_number(command, "--rounds", options.rounds, "Rounds of each query", 1, 1000);
}

MapOptions or_generated(MapOptions options, std::vector<int> sides,
                        std::vector<std::string> kinds) {
  if (options.maps.empty() && options.sides.empty() && options.noise.empty()) {
    options.sides = std::move(sides);
    if (options.kinds.empty()) options.kinds = std::move(kinds);
  }
  return options;
}

std::vector<QuerySource> sources_of(const MapOptions& options, std::vector<std::string> outputs) {
  auto sources = find_sources(options.maps);
  for (const QuerySource& made : generated_sources(options.sides, options.seed)) {
    const bool wanted =
        std::any_of(options.kinds.begin(), options.kinds.end(),
                    [&](const std::string& kind) { return made.name.rfind(kind + "-", 0) == 0; });
    if (wanted || options.kinds.empty()) sources.push_back(made);
  }
  for (QuerySource& made : noise_sources(options.noise, options.seed)) {
    sources.push_back(std::move(made));
  }
  std::vector<std::string> inputs;
  for (const QuerySource& source : sources) {
    inputs.push_back(source.map);
    inputs.push_back(source.table);
  }
  std::erase(outputs, "");
  check_outputs(outputs, inputs);
  return sources;
}

void add_queries_command(CLI::App& app) {
  const auto [command, options] =
      add_command(app, "queries", "All planners on the same queries", run_queries);
  add_map_options(command, options.maps);
  std::vector<std::string> names;
  for (const auto& planner : all_contenders()) names.emplace_back(planner.name);
  command.add_option("--planners", options.planners, "Only these, by name")
      ->delimiter(',')
      ->check(CLI::IsMember(names));
  command.add_option("--subject", options.subject, "The planner that ratios are against")
      ->check(CLI::IsMember(names));
  add_number(command, "--queries", options.count, kQueriesHelp);
  add_number(command, "--rounds", options.comparison.rounds, "Rounds over the queries of a map", 1,
             1000);
  add_number(command, "--seconds", options.comparison.seconds,
             "A planner that spent this on a map starts no further round there");
}

}  // namespace lasius::bench
