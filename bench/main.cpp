// lasius_bench: micro benchmarks (Google Benchmark) and comparisons of planners.
#include <benchmark/benchmark.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <string_view>

#include "bench/commands.h"
#include "lasius/version.h"

namespace {

int run_benchmarks(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}

}  // namespace

void lasius::bench::add_commands(CLI::App& app) {
  add_queries_command(app);
  add_anytime_command(app);
  add_exact_command(app);
  add_costs_command(app);
  add_disc_command(app);
  add_labels_command(app);
  add_edits_command(app);
  add_competition_command(app);
  add_colony_command(app);
  add_hunt_command(app);
  add_overshoot_command(app);
  add_quality_command(app);
  add_validity_command(app);
  add_drive_command(app);
  add_drive_costs_command(app);
  add_survive_command(app);
  add_tours_command(app);
  add_trails_command(app);
  add_cover_command(app);
  add_vehicles_command(app);
#ifdef LASIUS_HAVE_IO
  add_nav2_command(app);
#endif
#ifdef LASIUS_HAVE_POLYGON
  add_polygons_command(app);
#endif
#ifdef LASIUS_HAVE_OMPL
  add_sampling_command(app);
#endif
#ifdef LASIUS_HAVE_ARM
  add_arm_command(app);
  add_arm_mbm_command(app);
#endif
#if defined(LASIUS_HAVE_ARM) && defined(LASIUS_HAVE_OMPL)
  add_arm_peers_command(app);
#endif
}

int main(int argc, char** argv) {
  // Google Benchmark has the command line to itself unless a subcommand comes first.
  if (argc < 2 || std::string_view(argv[1]).starts_with("--benchmark_")) {
    return run_benchmarks(argc, argv);
  }
  CLI::App app("Benchmarks of lasius. Without a subcommand: micro benchmarks, --benchmark_...");
  app.set_version_flag("--version", LASIUS_VERSION);
  app.require_subcommand(1);
  lasius::bench::add_commands(app);
  lasius::bench::add_smoke_command(app);
  try {
    app.parse(argc, argv);
    return 0;
  } catch (const CLI::RuntimeError& e) {
    return e.get_exit_code();
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  } catch (const std::exception& e) {
    std::cerr << "lasius_bench: " << e.what() << '\n';
    return 1;
  }
}
