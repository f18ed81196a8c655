// Islands: what they find depends on their number and the schedule of their exchange alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <climits>
#include <cmath>
#include <list>
#include <stop_token>
#include <string>
#include <vector>

#include "core/colony/grid_colony.h"
#include "lasius/base/error.h"
#include "lasius/drive/navigator.h"
#include "lasius/params/own_rules.h"
#include "tests/core/base/counting_time.h"
#include "tests/core/colony/archipelago.h"
#include "tests/core/loop/same_result.h"
#include "tests/worlds/planning.h"

namespace lasius {
namespace {

class Archipelago : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Islands, Archipelago, testing::ValuesIn(colonies()), by_algorithm);

TEST_P(Archipelago, ThreadsAndWhatAWorkspaceHasSeenChangeNothing) {
  FarApart far;
  Params params = split(GetParam(), 3);
  params.exchange_every = 2;
  const Result once = far.plan(params);
  EXPECT_EQ(once.status, Status::solved);
  EXPECT_TRUE(std::ranges::is_sorted(once.curves.best, std::ranges::greater{}));
  Workspace workspace;
  for (const int threads : {1, 2, 5}) {
    params.threads = threads;
    expect_same(far.plan(params, {.workspace = &workspace}), once);
    (void)far.plan(split(GetParam(), threads + 1), {.workspace = &workspace});
  }
}

TEST_P(Archipelago, AllRanksFindWhatOneProcessFinds) {
  Params params = split(GetParam(), 3);
  params.exchange_every = 2;
  const Result alone = FarApart().plan(params);
  for (const int ranks : {1, 2, 3, 5}) {  // of five, two have no island
    params.threads = ranks % 2 + 1;
    for (const Result& one : plan_on_ranks(ranks, params)) expect_same(one, alone);
  }
}

TEST(Islands, ARankThatIsToldToStopEndsAllOfThem) {
  std::stop_source stop;
  stop.request_stop();
  Params params;
  for (const auto& [islands, ranks, told] : {std::array{3, 5, 4}, {4, 3, 1}}) {  // 4 has no island
    params = split("acs", islands);
    params.iterations = 1000;
    const int of = told;
    for (const Result& one : plan_on_ranks(ranks, params, [&, of](int rank, Request&request) {
           if (rank == of) request.stop.token = stop.get_token();
         }))
      EXPECT_EQ(one.status, Status::interrupted);
  }
  // An observer, of a rank that has islands, is heard in the next iteration.
  std::atomic<int> seen = 0;
  for (const Result& one : plan_on_ranks(
           2, params, {}, [&](const GridProgress&) { return ++seen == 5 ? Go::stop : Go::on; })) {
    EXPECT_EQ(one.status, Status::interrupted);
    EXPECT_LE(one.curves.iterations, 5);
    EXPECT_FALSE(one.path.empty());
  }
}

TEST(Islands, TheDeadlineOfARankWithoutAnIslandEndsAllOfThem) {
  Params params = split("acs", 3);
  params.iterations = 1000;
  for (const Result& one : plan_on_ranks(5, params, [&](int rank, Request&request) {
         if (rank == 3) request.stop.deadline = Clock::time_point::min();
       }))
    EXPECT_EQ(one.status, Status::limit);
}

TEST(Islands, ARankThatHasEndedIsAsADeadline) {
  Params params = split("acs", 4);
  params.iterations = 1000;
  for (const int ranks : {2, 5}) {  // of five, the last has no island
    const auto results = plan_on_ranks(ranks, params, [&](int rank, Request& request) {
      if (rank == ranks - 1) request.goal = request.start;  // an answer without a search
    });
    for (int r = 0; r < ranks; ++r)
      EXPECT_EQ(results[static_cast<std::size_t>(r)].status,
                r == ranks - 1 ? Status::solved : Status::limit);
  }
}

TEST(Islands, RanksThatCannotBeAreRefused) {
  const Params params = split("acs", 2);
  const auto alone = [](std::string own) { return std::vector{std::move(own)}; };
  EXPECT_EQ(remedy_of(params, {0, 1, alone}), "");
  EXPECT_EQ(remedy_of(params, {0, 0, alone}), "it must be 1 or more");
  EXPECT_EQ(remedy_of(params, {-1, 2, alone}), "it must be from 0 to 1");
  EXPECT_EQ(remedy_of(params, {2, 2, alone}), "it must be from 0 to 1");
  EXPECT_EQ(remedy_of(params, {0, 1}), "give it a function");
  const std::string one_each = "it must give one for each, empty where a rank has ended";
  EXPECT_EQ(remedy_of(params, {0, 2, alone}), one_each);
  int calls = 0;  // of the last, too
  EXPECT_EQ(remedy_of(params, {0, 1,
                               [&](const std::string& own) {
                                 return std::vector(++calls > params.iterations ? 2 : 1, own);
                               }}),
            one_each);
}

TEST(Islands, RanksThatAreAskedForOtherThingsAreRefused) {
  struct Heard {};
  const auto news_of_second = [](int ants, int islands) {
    Params params = split("acs", islands);
    params.ants = ants;
    std::string news;
    const auto hear = [&](const std::string& own) -> std::vector<std::string> {
      news = own;
      throw Heard{};
    };
    EXPECT_THROW(remedy_of(params, {1, 2, hear}), Heard);
    return news;
  };
  const auto told_first = [](const std::string& second, int later) {
    Params params = split("acs", 4);
    params.ants = 8;
    int calls = 0;
    return remedy_of(params, {0, 2, [&](const std::string& own) {
                                return std::vector{own, ++calls > later ? "path" : second};
                              }});
  };
  const std::string same = "give all ranks the same request and parameters";
  EXPECT_EQ(told_first(news_of_second(12, 4), 1), same);  // more ants of an island
  EXPECT_EQ(told_first(news_of_second(12, 6), 1), same);  // more islands
  EXPECT_EQ(told_first(news_of_second(4, 2), 1), same);   // fewer
  EXPECT_EQ(told_first(news_of_second(8, 4), 1), same);   // it ends sooner
  EXPECT_EQ(told_first(news_of_second(8, 4), split("acs", 4).iterations), same);  // a broken path
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
  EXPECT_TRUE(std::equal(apart.curves.steps.begin(), apart.curves.steps.begin() + 3,
                         joined.curves.steps.begin()));
  EXPECT_NE(apart.curves.steps, joined.curves.steps);
}

TEST_P(Archipelago, EachLearnsByTheOneBeforeIt) {
  FarApart far;
  Params params = split(GetParam(), 3);
  params.exchange_every = 2;
  const auto steps = steps_by_hand(far, params, [](std::list<GridColony>& colonies) {
    const GridColony* before = &colonies.back();
    for (GridColony& colony : colonies) {
      colony.welcome(before->best_tour());
      before = &colony;
    }
  });
  EXPECT_EQ(far.plan(params).curves.steps, steps);
}

TEST(Islands, TheEntropyIsOfThoseWhereAnAntHasArrived) {
  Planner planner{blobs(40, 30)};
  Params params = split("as", 7);
  params.dead_end = DeadEnd::kill;
  bool one_alone = false;
  for (params.seed = 1; params.seed <= 40; ++params.seed) {
    const Result found = planner.plan(far_apart(planner), params);
    int arrived = 0;
    for (std::size_t q = 0; q < found.curves.arrived.size(); ++q) {
      arrived += found.curves.arrived[q];
      EXPECT_EQ(std::isnan(found.curves.trail_entropy[q]), arrived == 0) << params.seed << " " << q;
      one_alone = one_alone || arrived == 1;
    }
  }
  EXPECT_TRUE(one_alone);
}

TEST(Islands, AnAntHasTheNumbersThatItHasInOneColony) {
  FarApart far;
  const Result whole = far.plan(split("fan2004", 1));
  for (const int islands : {2, 3, 7}) {
    const Result parts = far.plan(split("fan2004", islands));
    // The trail is blank for all.
    EXPECT_EQ(parts.curves.steps[0], whole.curves.steps[0]) << islands;
    EXPECT_EQ(parts.curves.raw_best[0], whole.curves.raw_best[0]) << islands;
    EXPECT_EQ(parts.curves.arrived[0], whole.curves.arrived[0]) << islands;
    EXPECT_EQ(parts.curves.iteration_best[0], whole.curves.iteration_best[0]) << islands;
    EXPECT_NE(parts.curves.steps, whole.curves.steps) << islands;
  }
}

TEST(Islands, AnObserverSeesTheLeaderAndEndsAllOfThem) {
  FarApart far;
  const Params params = split("mmas", 4);
  const Result whole = far.plan(params);
  int seen = 0;
  const Result cut = far.plan(
      params, {.observer = [&](const GridProgress& now) {
        EXPECT_EQ(now.best_length, whole.curves.best[static_cast<std::size_t>(now.iteration)]);
        EXPECT_GE(now.ants(), 1);
        return ++seen == 3 ? Go::stop : Go::on;
      }});
  EXPECT_EQ(cut.status, Status::interrupted);
  EXPECT_EQ(cut.curves.iterations, 3);
  EXPECT_EQ(cut.length, whole.curves.best[2]);
}

TEST(Islands, WhatACutIterationFoundIsOffered) {
  const Planner planner{blobs(40, 30)};
  Request request = far_apart(planner);
  Params params = split("as", 2);
  params.iterations = 1;
  const CountingTime never(INT_MAX);
  request.stop = never.is_up();
  ASSERT_EQ(planner.plan(request, params).curves.iterations, 1);

  // Of the second island alone, which walks after the first.
  const CountingTime of_second(INT_MAX);
  Params share = params;
  share.islands = 1;
  share.ants = 3;
  ColonyMemory memory;
  GridColony second(planner.grid(), share, memory, no_own_rules(), GridColony::After::nothing,
                    nullptr, nullptr, 4);
  const Observer none;
  request.stop = of_second.is_up();
  second.begin(request);
  second.set_out(request, none);
  const int before = of_second.polls();
  ASSERT_EQ(second.send_ants(0), StopCondition::Cause::none);

  int cut = 0;  // how often there is a path nevertheless
  for (int polls = 1; polls < never.polls(); ++polls) {
    const CountingTime time(polls);
    request.stop = time.is_up();
    const Result found = planner.plan(request, params);
    cut += found.curves.iterations == 0 && !found.path.empty();
  }
  EXPECT_GT(cut, of_second.polls() - before + 2);
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
  EXPECT_THROW(far.plan(split("as", 2), {.own_rules = own}), Error);
  NavigatorOptions options;
  options.params = split("as", 2);
  EXPECT_THROW(Navigator(far.planner.grid(), far.request.goal, options), Error);
  options.params = split("as", 1);
  EXPECT_NO_THROW(Navigator(far.planner.grid(), far.request.goal, options));
}

}  // namespace
}  // namespace lasius
