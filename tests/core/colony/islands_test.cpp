// Islands: what they find depends on their number and the schedule of their exchange alone.
#include <gtest/gtest.h>

#include <algorithm>

#include "lasius/error.h"
#include "lasius/navigator.h"
#include "lasius/own_rules.h"
#include "tests/core/loop/same_result.h"
#include "tests/worlds/planning.h"

namespace lasius {
namespace {

Params split(std::string_view algorithm, int islands) {
  Params params = quick(algorithm);
  params.ants = 7;
  params.iterations = 7;
  params.islands = islands;
  return params;
}

class Archipelago : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Islands, Archipelago, testing::ValuesIn(colonies()), by_algorithm);

TEST_P(Archipelago, ThreadsAndWhatAWorkspaceHasSeenChangeNothing) {
  FarApart far;
  Params params = split(GetParam(), 3);
  params.exchange_every = 2;
  const Result once = far.plan(params);
  EXPECT_EQ(once.status, Status::solved);
  EXPECT_TRUE(std::ranges::is_sorted(once.best, std::ranges::greater{}));
  Workspace workspace;
  for (const int threads : {1, 2, 5}) {
    params.threads = threads;
    expect_same(far.plan(params, &workspace), once);
    (void)far.plan(split(GetParam(), threads + 1), &workspace);
  }
}

TEST_P(Archipelago, ATourIsLearnedByInTheIterationThatIsDue) {
  FarApart far;
  Params params = split(GetParam(), 3);
  params.agreement = 0;
  const auto until = [&](int every) {
    params.exchange_every = every;
    return far.plan(params);
  };
  const Result apart = until(1000), joined = until(2);
  // Ants of iteration 2 have walked when the trail learns.
  EXPECT_TRUE(std::equal(apart.steps.begin(), apart.steps.begin() + 3, joined.steps.begin()));
  EXPECT_NE(apart.steps, joined.steps);
}

TEST(Islands, AnAntHasTheNumbersThatItHasInOneColony) {
  FarApart far;
  const Result whole = far.plan(split("fan2004", 1));
  for (const int islands : {2, 3, 7}) {
    const Result parts = far.plan(split("fan2004", islands));
    // The trail is blank for all.
    EXPECT_EQ(parts.steps[0], whole.steps[0]) << islands;
    EXPECT_EQ(parts.raw_best[0], whole.raw_best[0]) << islands;
    EXPECT_EQ(parts.arrived[0], whole.arrived[0]) << islands;
    EXPECT_EQ(parts.iteration_best[0], whole.iteration_best[0]) << islands;
    EXPECT_NE(parts.steps, whole.steps) << islands;
  }
}

TEST(Islands, AnObserverSeesTheLeaderAndEndsAllOfThem) {
  FarApart far;
  const Params params = split("mmas", 4);
  const Result whole = far.plan(params);
  int seen = 0;
  const Result cut = far.plan(params, nullptr, [&](const GridProgress& now) {
    EXPECT_EQ(now.best_length, whole.best[static_cast<std::size_t>(now.iteration)]);
    EXPECT_GE(now.ants(), 1);
    if (++seen == 3) now.stop();
  });
  EXPECT_EQ(cut.status, Status::interrupted);
  EXPECT_EQ(cut.iterations, 3);
  EXPECT_EQ(cut.length, whole.best[2]);
}

TEST(Islands, MoreThanThereAreAntsAreRefused) {
  FarApart far;
  EXPECT_THROW(far.plan(split("fan2004", 8)), Error);
  EXPECT_NO_THROW(far.plan(split("fan2004", 7)));
  EXPECT_THROW(far.plan(split("fan2004", 0)), Error);
}

TEST(Islands, OwnRulesAndMapsThatChangeHaveOneColony) {
  FarApart far;
  const OwnRules own{.schedule = [](int) { return StepWeights{}; }};
  EXPECT_THROW(far.plan(split("as", 2), own), Error);
  NavigatorOptions options;
  options.params = split("as", 2);
  EXPECT_THROW(Navigator(far.planner.grid(), far.request.goal, options), Error);
  options.params = split("as", 1);
  EXPECT_NO_THROW(Navigator(far.planner.grid(), far.request.goal, options));
}

}  // namespace
}  // namespace lasius
