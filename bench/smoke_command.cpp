// lasius_bench smoke: every command once, on little input, in a few seconds.
#include <iostream>

#include "bench/commands.h"

namespace lasius::bench {
namespace {

constexpr const char* kLines[] = {
    "queries --generated 96 --queries 4 --rounds 1",
    "anytime --generated 96 --queries 2",
    "exact --noise 96 --queries 4 --rounds 1",
    "costs --generated 96 --kinds blobs --queries 1 --rounds 1",
    "edits --generated 96 --kinds blobs --queries 4 --rounds 1 --edits 20",
    "edits --unprepared --generated 96 --kinds blobs --edits 20",
    "drive --generated 96 --kinds blobs,maze --queries 1 --rounds 1",
    "survive --worlds 2 --train 20 --budget 2e4",
    "colony --rounds 1 --side 1024 --plans 4",
    "tours --generated 96 --kinds blobs --stops 20 --seeds 1 --seconds 0.05",
    "cover --generated 96 --kinds rooms --generations 0",
    "vehicles --generated 96 --size 4 2 --optimum",
    "hunt --answers 2000",
    "overshoot --generated 96 --cuts 2 --limit 2",
    "quality --seeds 1 --blobs 1 --no-fan",
    "validity --random 20 --side 96",
#ifdef LASIUS_HAVE_POLYGON
    "polygons --rounds 1 --worlds 4 --scaled 1",
#endif
#ifdef LASIUS_HAVE_OMPL
    "sampling --generated 96 --queries 1 --seeds 1 --cap 0.02",
#endif
#ifdef LASIUS_HAVE_ARM
    "arm --rounds 1 --scenes 1 --seeds 1 --goals 1",
#endif
#if defined(LASIUS_HAVE_ARM) && defined(LASIUS_HAVE_OMPL)
    "arm-peers --queries 1 --obstacles 2 --cap 0.05",
#endif
};

void run_smoke() {
  for (const char* line : kLines) {
    std::cout << "\nlasius_bench " << line << "\n\n";
    CLI::App app;
    add_commands(app);
    app.parse(line);
  }
}

}  // namespace

void add_smoke_command(CLI::App& app) {
  app.add_subcommand("smoke", "Every command once, in a few seconds")->callback(run_smoke);
}

}  // namespace lasius::bench
