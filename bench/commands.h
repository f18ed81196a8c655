// The commands of lasius_bench.
#pragma once

#include <CLI/CLI.hpp>
#include <concepts>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bench/query_set.h"

namespace lasius::bench {

/// Each adds a subcommand, whose callback runs it and throws CLI::RuntimeError(1) for a fault.
void add_queries_command(CLI::App& app);
void add_anytime_command(CLI::App& app);
void add_exact_command(CLI::App& app);
void add_costs_command(CLI::App& app);
void add_disc_command(CLI::App& app);
void add_labels_command(CLI::App& app);
void add_edits_command(CLI::App& app);
void add_competition_command(CLI::App& app);
void add_colony_command(CLI::App& app);
void add_hunt_command(CLI::App& app);
void add_overshoot_command(CLI::App& app);
void add_quality_command(CLI::App& app);
void add_validity_command(CLI::App& app);
void add_drive_command(CLI::App& app);
void add_drive_costs_command(CLI::App& app);
void add_survive_command(CLI::App& app);
void add_cover_command(CLI::App& app);
void add_tours_command(CLI::App& app);
void add_trails_command(CLI::App& app);
void add_vehicles_command(CLI::App& app);
void add_nav2_command(CLI::App& app);       ///< only with lasius::io
void add_polygons_command(CLI::App& app);   ///< only with GEOS
void add_sampling_command(CLI::App& app);   ///< only with OMPL
void add_arm_command(CLI::App& app);        ///< only with lasius::arm
void add_arm_mbm_command(CLI::App& app);    ///< likewise
void add_arm_peers_command(CLI::App& app);  ///< only with lasius::arm and OMPL
void add_smoke_command(CLI::App& app);

/// Options of a command whose table goes to a file beside standard output.
struct Reported {
  std::string markdown;
};

/// A subcommand that runs `run` with options of its own.
template <class Options>
std::pair<CLI::App&, Options&> add_command(CLI::App& app, const std::string& name,
                                           const std::string& summary,
                                           void (*run)(const Options&)) {
  auto options = std::make_shared<Options>();
  CLI::App& command = *app.add_subcommand(name, summary);
  if constexpr (std::derived_from<Options, Reported>)
    command.add_option("-o,--output", options->markdown, "Write the Markdown here, too");
  command.callback([options, run] { run(*options); });
  return {command, *options};
}

/// A number from `least` to `most` whose default the help shows.
template <class Number>
void add_number(CLI::App& command, const std::string& name, Number& value, const std::string& text,
                double least = 0, double most = 1e9) {
  command.add_option(name, value, text)->capture_default_str()->check(CLI::Range(least, most));
}

/// Which maps a command runs on.
struct MapOptions {
  std::vector<std::string> maps;
  std::vector<int> sides, noise;
  std::vector<std::string> kinds;
  std::uint64_t seed = 1;
};
void add_map_options(CLI::App& command, MapOptions& options);
/// These, or generated ones where none is told.
MapOptions or_generated(MapOptions options, std::vector<int> sides,
                        std::vector<std::string> kinds = {});
/// Queries on each of them, time and again.
struct QueryOptions {
  MapOptions maps = {};
  std::size_t count;  ///< queries a map; 0: all of its table, 30 where it has none
  int rounds;
};
void add_query_options(CLI::App& command, QueryOptions& options);

/// @throws Error where one of `outputs`, but for empty names, cannot be written or is one of the
/// maps.
std::vector<QuerySource> sources_of(const MapOptions& options,
                                    std::vector<std::string> outputs = {});

/// All of them that were built, but for smoke.
void add_commands(CLI::App& app);

}  // namespace lasius::bench
