// Islands that do not wait for one another.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <list>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "core/colony/grid_colony.h"
#include "lasius/path/path.h"
#include "tests/core/colony/archipelago.h"
#include "tests/core/loop/same_result.h"
#include "tests/worlds/planning.h"

namespace lasius {
namespace {

Params apart(std::string_view algorithm, int islands) {
  Params params = split(algorithm, islands);
  params.exchange = Exchange::asynchronous;
  params.agreement = 0;
  return params;
}

class Asynchronous : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Islands, Asynchronous,
                         testing::Values("fan2004", "mmas", "acs", "terminal-index"), by_algorithm);

void expect_near(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::isnan(a[i]) && std::isnan(b[i])) continue;
    EXPECT_NEAR(a[i], b[i], 1e-9 * a[i]) << i;
  }
}

/// The same, though sums are made in another order.
void expect_alike(const Result& a, const Result& b) {
  Result same = a;
  for (const auto curve :
       {&Convergence::mean, &Convergence::cut_mean, &Convergence::trail_entropy}) {
    expect_near(a.curves.*curve, b.curves.*curve);
    same.curves.*curve = b.curves.*curve;
  }
  expect_same(same, b);
}

TEST_P(Asynchronous, BeforeTheFirstExchangeTheyAreAsScheduled) {
  Params params = apart(GetParam(), 3);
  params.exchange_every = params.iterations;
  Params scheduled = params;
  scheduled.exchange = Exchange::scheduled;
  const Result alone = FarApart().plan(scheduled);
  for (const int threads : {1, 2, 5}) {
    params.threads = threads;
    expect_alike(FarApart().plan(params), alone);
  }
  for (const int ranks : {2, 5}) {  // of five, two have no island
    params.threads = 3 - ranks / 2;
    for (const Result& one : plan_on_ranks(ranks, params)) expect_alike(one, alone);
  }
}

TEST_P(Asynchronous, AThreadAloneTellsAllTheBestThatThereIs) {
  FarApart far;
  Params params = apart(GetParam(), 3);
  params.exchange_every = 2;
  const auto steps = steps_by_hand(far, params, [](std::list<GridColony>& colonies) {
    const GridColony* best = nullptr;
    const auto length = [](const GridColony& one) { return one.best_tour().length; };
    for (const GridColony& one : colonies)
      if (length(one) > 0 && (best == nullptr || length(one) < length(*best))) best = &one;
    for (GridColony& one : colonies)
      if (best != nullptr && !(length(one) <= length(*best))) one.welcome(best->best_tour());
  });
  EXPECT_EQ(far.plan(params).curves.steps, steps);
}

TEST_P(Asynchronous, ThreadsAndRanksFindAWholeAnswer) {
  const FarApart far;
  Params params = apart(GetParam(), 4);
  params.exchange_every = 2;
  for (const int ranks : {1, 3}) {
    params.threads = 2;
    for (const Result& one : plan_on_ranks(ranks, params)) {
      EXPECT_EQ(one.status, Status::solved);
      EXPECT_FALSE(path_fault(far.planner.grid(), one.path, params.corners));
      EXPECT_NEAR(one.curves.best.back(), one.length, 1e-9 * one.length);
      EXPECT_TRUE(std::ranges::is_sorted(one.curves.best, std::ranges::greater{}));
      EXPECT_EQ(one.curves.iterations, params.iterations);
    }
  }
}

/// A rank whose texts are the test's.
struct Told {
  std::vector<std::string> passed;  ///< by it
  std::vector<std::string> heard;   ///< at once
  std::vector<std::string> others;  ///< handed in by the second rank, call by call; then the same

  Ranks rank() {
    return {0, 2,
            [this](const std::string& own) {
              const std::string other = gathers_ < others.size() ? others[gathers_] : own;
              ++gathers_;
              return std::vector{own, other};
            },
            [this](const std::string& own) {
              if (!own.empty()) passed.push_back(own);
              return std::exchange(heard, {});
            }};
  }
  Result plan(const Params& params) {
    FarApart far;
    const Ranks ranks = rank();
    far.request.ranks = &ranks;
    return far.plan(params);
  }

 private:
  std::size_t gathers_ = 0;
};

TEST_P(Asynchronous, ATourOfAnotherRankIsLearnedByOnceItHasCome) {
  Params params = apart(GetParam(), 2);
  params.exchange_every = 2;
  Params longer = params;
  longer.iterations = 60;
  longer.seed = 5;
  Told first, second, third;
  first.plan(longer);
  ASSERT_FALSE(first.passed.empty());
  const Result none = second.plan(params);
  third.heard = {first.passed.back()};  // a good one
  const Result told = third.plan(params);
  EXPECT_TRUE(std::equal(none.curves.steps.begin(), none.curves.steps.begin() + 3,
                         told.curves.steps.begin()));
  EXPECT_NE(none.curves.steps, told.curves.steps);
  EXPECT_TRUE(std::ranges::find(third.passed, first.passed.back()) == third.passed.end());
}

TEST(Asynchronous, WhatOneIsToldEndsAllOfThem) {
  std::stop_source stop;
  stop.request_stop();
  Params params = apart("acs", 4);
  params.iterations = 1000000000;
  for (const int ranks : {2, 3}) {
    for (const Result& one : plan_on_ranks(ranks, params, [&](int rank, Request&request) {
           if (rank == ranks - 1) request.stop.token = stop.get_token();
         }))
      EXPECT_EQ(one.status, Status::interrupted);
  }
  std::atomic<int> seen = 0;
  params.threads = 2;
  for (const Result& one : plan_on_ranks(
           2, params, {}, [&](const GridProgress&) { return ++seen == 5 ? Go::stop : Go::on; }))
    EXPECT_EQ(one.status, Status::interrupted);
}

TEST(Asynchronous, AnObserverIsCalledByTheThreadThatPlans) {
  FarApart far;
  Params params = apart("mmas", 5);
  params.threads = 3;
  int seen = 0;
  far.plan(params, {.observer = [&, here = std::this_thread::get_id()](const GridProgress& now) {
             EXPECT_EQ(std::this_thread::get_id(), here);
             EXPECT_EQ(now.iteration, seen++);
           }});
  EXPECT_LE(seen, params.iterations);
}

TEST(Asynchronous, RanksThatCannotBeAreRefused) {
  const Params params = apart("acs", 2);
  const auto alone = [](std::string own) { return std::vector{std::move(own)}; };
  const auto nothing = [](const std::string&) { return std::vector<std::string>{}; };
  EXPECT_EQ(remedy_of(params, {0, 1, alone, nothing}), "");
  EXPECT_EQ(remedy_of(params, {0, 1, alone}), "give it a function, or exchange as scheduled");
  const std::string same = "give all ranks the same request and parameters";
  for (const std::string& other : {std::string("asked for other things"), std::string(40, 'x')}) {
    Told told;
    told.others = {other};
    EXPECT_EQ(remedy_of(params, told.rank()), same);
  }
  Told broken;
  broken.heard = {"no tour"};
  EXPECT_EQ(remedy_of(params, broken.rank()), same);

  std::string met;
  const Ranks rank{0, 2,
                   [&](const std::string& own) {
                     if (met.empty()) return std::vector{met = own, own};
                     return std::vector<std::string>{own, "no course"};
                   },
                   nothing};
  EXPECT_EQ(remedy_of(params, rank), same);
}

TEST(Asynchronous, ARankThatHasEndedIsAsADeadline) {
  Told before, meanwhile;
  before.others = {""};
  meanwhile.heard = {""};
  Params params = apart("acs", 4);
  params.iterations = 1000000000;
  EXPECT_EQ(before.plan(params).status, Status::limit);
  EXPECT_EQ(meanwhile.plan(params).status, Status::limit);
  EXPECT_EQ(meanwhile.passed.size(), 1U);  // others are told the cause
}

}  // namespace
}  // namespace lasius
