// lasius_bench colony: speed, threads, area, proofs of the colony.

#include "bench/colony_figures.h"
#include "bench/commands.h"
#include "bench/report.h"

namespace lasius::bench {
namespace {

struct ColonyOptions : Reported {
  int rounds = 9, side = 16384, plans = 200;
};

void run_colony(const ColonyOptions& options) {
  Table table =
      Table::of_figures("maps/fan400x200.map; medians of " + std::to_string(options.rounds) +
                            " rounds in turns; steps in processor time, one thread.",
                        options.markdown);
  table.add(measure_steps(options.rounds));
  table.add(measure_variants(options.rounds));
  table.add(measure_threads(options.rounds));
  table.add(measure_area(options.rounds, options.side));
  table.add(measure_unreachable(options.plans, options.side / 4));
}

}  // namespace

void add_colony_command(CLI::App& app) {
  const auto [command, options] =
      add_command(app, "colony", "Speed, threads, area, proofs of the colony", run_colony);
  add_number(command, "--rounds", options.rounds, "Rounds of each measurement", 1, 1000);
  add_number(command, "--side", options.side, "Side of the large map", 1024, Grid::kMaxSide);
  add_number(command, "--plans", options.plans, "Plans for latencies", 1, 100000);
}

}  // namespace lasius::bench
