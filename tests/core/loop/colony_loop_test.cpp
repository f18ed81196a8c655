// The loop's contract, told by a world that notes what it is asked for.
#include "core/loop/colony_loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/core/base/counting_time.h"

namespace lasius {
namespace {

using Cause = StopCondition::Cause;

struct Noted final : ColonyWorld {
  std::string calls;
  int cut_at = -1, stop_at = -1, settled_at = -1;  // iterations
  int now = 0;

  Cause send_ants(int q) override {
    now = q;
    calls += 's';
    return q == cut_at ? Cause::deadline : Cause::none;
  }
  void offer() override { calls += 'o'; }
  void offer_cut() override { calls += 'c'; }
  void update_trail(int) override { calls += 'u'; }
  int ants() const override { return 0; }
  double tour_length(int) const override { return kNaN; }
  double best_length() const override { return kNaN; }
  bool settled() override { return now == settled_at; }
  Cause observe(const Convergence& run) override {
    calls += std::to_string(run.iterations);
    return now == stop_at ? Cause::token : Cause::none;
  }
};

TEST(ColonyLoop, AnIterationIsWholeOrNothing) {
  struct Row {
    int cut_at, stop_at, settled_at;
    const char* calls;
    Cause cause;
  };
  for (const Row& row :
       {Row{-1, -1, -1, "sou1sou2sou3", Cause::none}, Row{1, -1, -1, "sou1sc", Cause::deadline},
        Row{2, 2, -1, "sou1sou2sc", Cause::deadline}, Row{-1, 0, -1, "sou1", Cause::token},
        Row{-1, 2, -1, "sou1sou2sou3", Cause::none}, Row{-1, 1, 1, "sou1sou2", Cause::none},
        Row{-1, -1, 1, "sou1sou2", Cause::none}}) {
    Noted world;
    world.cut_at = row.cut_at;
    world.stop_at = row.stop_at;
    world.settled_at = row.settled_at;
    Convergence run;
    EXPECT_EQ(run_colony_loop(world, 3, {}, run), row.cause) << row.calls;
    EXPECT_EQ(world.calls, row.calls);
  }
}

TEST(ColonyLoop, PartsAddUpAndWhoHasEndedKeepsItsBest) {
  using Values = IterationSums::Values;
  const auto iteration = [](double best, double tour) {
    IterationSums sums;
    sums.raw = Values::of(tour);
    sums.best = best;
    sums.steps = 10;
    sums.walked = true;
    return sums;
  };
  std::vector<IterationSums> all;
  add_part(all, std::vector{iteration(kNaN, kNaN), iteration(8, 9)});
  add_part(all, std::vector{iteration(6, 7)});
  add_part(all, {});
  add_part(all, std::vector{iteration(7, 7), iteration(7, 8), iteration(5, 5)});
  Convergence run;
  for (const IterationSums& sums : all) record(sums, run);
  EXPECT_EQ(run.iterations, 3);
  EXPECT_EQ(run.best, (std::vector<double>{6, 6, 5}));
  EXPECT_EQ(run.mean, (std::vector<double>{7, 8.5, 5}));
  EXPECT_EQ(run.raw_best, (std::vector<double>{7, 8, 5}));
  EXPECT_EQ(run.arrived, (std::vector<int>{2, 2, 1}));
  EXPECT_EQ(run.steps, (std::vector<std::int64_t>{30, 20, 10}));
}

TEST(ColonyLoop, PollsBetweenIterationsAlone) {
  // Before the first, after the first, after the second; after the last one it has ended by itself.
  for (int looks = 0; looks <= 3; ++looks) {
    const CountingTime time(looks);
    Noted world;
    Convergence run;
    EXPECT_EQ(run_colony_loop(world, 3, time.is_up(), run),
              looks < 3 ? Cause::deadline : Cause::none);
    EXPECT_EQ(run.iterations, looks);
    EXPECT_EQ(time.polls(), std::min(looks + 1, 3));
  }
}

}  // namespace
}  // namespace lasius
