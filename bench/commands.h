// The modes of lasius_bench beside Google Benchmark's own.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace lasius::bench {

/// Each adds a subcommand, whose callback runs it and throws CLI::RuntimeError(1) for a fault
/// found.
void add_queries_command(CLI::App& app);
void add_exact_command(CLI::App& app);
void add_colony_command(CLI::App& app);
void add_quality_command(CLI::App& app);
void add_validity_command(CLI::App& app);
void add_polygons_command(CLI::App& app);  ///< only with GEOS
void add_sampling_command(CLI::App& app);  ///< only with OMPL
void add_arm_command(CLI::App& app);       ///< only with lasius::arm
void add_smoke_command(CLI::App& app);

/// The options that say which maps: --maps, --generated, --noise.
void add_map_options(CLI::App& command, std::vector<std::string>& maps, std::vector<int>& sides,
                     std::vector<int>& noise);

/// All of them that were built, but for smoke.
void add_commands(CLI::App& app);

}  // namespace lasius::bench
