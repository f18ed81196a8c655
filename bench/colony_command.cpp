// lasius_bench colony: speed, threads, area, latency of the colony.
#include <memory>

#include "bench/colony_figures.h"
#include "bench/commands.h"
#include "bench/figure_table.h"

namespace lasius::bench {
namespace {

struct Options {
  int rounds = 9;
  int side = 16384;
  int plans = 200;
  std::string markdown;
};

void run(const Options& options) {
  FigureTable table("maps/fan400x200.map; medians of " + std::to_string(options.rounds) +
                        " rounds in turns; steps in processor time, one thread.",
                    options.markdown);
  table.add(measure_steps(options.rounds));
  table.add(measure_variants(options.rounds));
  table.add(measure_threads(options.rounds));
  table.add(measure_area(options.rounds, options.side));
  table.add(measure_unreachable(options.plans, options.side / 4));
  table.add(measure_overshoot(options.plans));
}

}  // namespace

void add_colony_command(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("colony", "Speed, threads, area, latency of the colony");
  command->add_option("--rounds", options->rounds, "Rounds of each measurement")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  command->add_option("--side", options->side, "Side of the large map")
      ->capture_default_str()
      ->check(CLI::Range(1024, Grid::kMaxSide));
  command->add_option("--plans", options->plans, "Plans for latencies")
      ->capture_default_str()
      ->check(CLI::Range(1, 100000));
  command->add_option("-o,--output", options->markdown, "Write the Markdown here, too");
  command->callback([options] { run(*options); });
}

}  // namespace lasius::bench
