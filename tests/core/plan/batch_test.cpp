#include "lasius/plan/batch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <stdexcept>
#include <vector>

#include "lasius/base/error.h"
#include "lasius/grid/generate.h"
#include "tests/core/base/counting_time.h"
#include "tests/core/base/refusal.h"
#include "tests/core/loop/same_result.h"

namespace lasius {
namespace {

Params brief() {
  Params params("fan2004");
  params.iterations = 3;
  params.ants = 4;
  params.seed = 11;
  params.threads = 1;
  return params;
}

/// A map, and queries of every outcome on it: far and near, equal cells, blocked, outside.
struct Scene {
  Planner planner{generate(MapKind::blobs, {.width = 90, .height = 60, .density = -1, .seed = 5})};
  std::vector<Request> queries;

  Scene() {
    for (int i = 0; i < 150; ++i)
      queries.push_back({{i % 90, (7 * i) % 60}, {(13 * i + 5) % 90, (11 * i) % 60}});
    queries.push_back({{3, 3}, {3, 3}});
    queries.push_back({{-1, 3}, {3, 3}});
  }
};

TEST(Batch, AnswersInOrderWhatPlanAnswers) {
  const Scene scene;
  for (const int threads : {1, 2, 5}) {
    std::size_t next = 0;
    const auto count = plan_batch(
        scene.planner, scene.queries, brief(), {.threads = threads},
        [&](const BatchAnswer& answer) {
          ASSERT_EQ(answer.index, next++);
          expect_same(answer.result, scene.planner.plan(scene.queries[answer.index], brief()));
        });
    EXPECT_EQ(count, scene.queries.size());
    EXPECT_EQ(next, count);
  }
}

TEST(Batch, EverySeedOfARangeGivesWhatPlanGivesWithIt) {
  const Scene scene;
  const auto queries = std::span(scene.queries).first(12);
  const auto answers = plan_batch(scene.planner, queries, brief(), {.threads = 2, .seeds = 3});
  ASSERT_EQ(answers.size(), 36U);
  int differing = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    EXPECT_EQ(answers[i].index, i / 3);
    EXPECT_EQ(answers[i].seed, 11 + i % 3);
    Params params = brief();
    params.seed = answers[i].seed;
    expect_same(answers[i].result, scene.planner.plan(queries[i / 3], params));
    differing += answers[i].result.curves.mean != answers[i / 3 * 3].result.curves.mean;
  }
  EXPECT_GT(differing, 0);
}

// One thread answers one query after the other.
TEST(Batch, ElapsedIsOfEachQueryAlone) {
  const Scene scene;
  std::chrono::duration<double> sum(0);
  const auto begin = Clock::now();
  plan_batch(scene.planner, scene.queries, brief(), {.threads = 1},
             [&](const BatchAnswer& answer) { sum += answer.elapsed; });
  EXPECT_LE(sum, Clock::now() - begin);
  EXPECT_GT(sum.count(), 0);
}

// Components of 8 neighbours are made by whoever asks first, perhaps by several at a time.
TEST(Batch, ThreadsThatMeetARuleFirstFindTheSame) {
  const Grid grid = generate(MapKind::random, {300, 300, 0.6, 6});
  const Planner labelled(grid);
  ASSERT_TRUE(labelled.label(Corners::allow));
  Params params("as");
  params.corners = Corners::allow;
  params.iterations = params.ants = 1;
  std::vector<Request> queries;
  for (int i = 0; i < 40; ++i)
    queries.push_back({.start = labelled.nearest_free({7 * i, 5 * i}).value(),
                       .goal = labelled.nearest_free({7 * i + i % 5, 5 * i + 3}).value()});
  int unreachable = 0;
  for (int round = 0; round < 5; ++round) {
    const Planner planner(grid);
    plan_batch(planner, queries, params, {.threads = 4}, [&](const BatchAnswer& answer) {
      const Request& query = queries[answer.index];
      const bool joined = labelled.connected(query.start, query.goal, Corners::allow);
      EXPECT_EQ(answer.result.status == Status::unreachable, !joined) << answer.index;
      unreachable += !joined;
    });
  }
  EXPECT_GT(unreachable, 5);
  EXPECT_LT(unreachable, 195);
}

TEST(Batch, NoQueriesNoCalls) {
  const Scene scene;
  const auto count = plan_batch(scene.planner, {}, brief(), {.threads = 2},
                                [](const BatchAnswer&) { FAIL() << "called"; });
  EXPECT_EQ(count, 0U);
}

TEST(Batch, RefusesBadParametersBeforeAnyQuery) {
  const Scene scene;
  std::vector<Request> requests = scene.queries;
  const auto refused = [&](const Params& params, const BatchOptions& options) {
    EXPECT_THROW(plan_batch(scene.planner, requests, params, options,
                            [](const BatchAnswer&) { FAIL() << "called"; }),
                 Error);
  };
  Params params = brief();
  params.ants = 0;
  refused(params, {});
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  refused(brief(), {.threads = -1});
  refused(brief(), {.threads = 1025});
  for (const int seeds : {0, (1 << 20) + 1}) refused(brief(), {.seeds = seeds});
  Params last = brief();
  last.seed = (std::uint64_t{1} << 53) - 2;
  refused(last, {.seeds = 3});
  for (const double seconds : {-1.0, kNaN}) {
    refused(brief(), {.time_limit = std::chrono::duration<double>(seconds)});
  }
  const auto late = [&] {
    plan_batch(scene.planner, requests, brief(),
               {.time_limit = std::chrono::duration<double>(-1e-9)});
  };
  expect_says(refusal(late), "time_limit is -1e-09; it must be 0");
  EXPECT_THROW(plan_batch(scene.planner, requests, brief(), {}, BatchReceiver()), Error);
  requests.back().target_gap = kNaN;
  refused({}, {});
  requests.back().target_gap = 0.1;  // which a colony cannot certify
  refused(brief(), {});
}

TEST(Batch, WithoutAReceiverItReturnsItsAnswers) {
  const Scene scene;
  const auto answers = plan_batch(scene.planner, scene.queries, brief(), {.threads = 2});
  ASSERT_EQ(answers.size(), scene.queries.size());
  for (std::size_t i = 0; i < answers.size(); ++i) {
    EXPECT_EQ(answers[i].index, i);
    expect_same(answers[i].result, scene.planner.plan(scene.queries[i], brief()));
  }
}

// A request's own stop condition ends that request alone.
TEST(Batch, RequestsKeepTheirOwnStopsAndGaps) {
  const Scene scene;
  const auto reached = [&](const Request& q) {
    return scene.planner.plan(q).status == Status::solved && q.start != q.goal;
  };
  const auto query = std::find_if(scene.queries.begin(), scene.queries.end(), reached);
  ASSERT_NE(query, scene.queries.end());
  std::vector<Request> requests(4, *query);
  requests[1].stop = fired();
  requests[2].stop.deadline = Clock::now() - std::chrono::hours(1);
  const auto answers = plan_batch(scene.planner, requests, brief());
  ASSERT_EQ(answers.size(), 4u);
  EXPECT_EQ(answers[0].result.status, Status::solved);
  EXPECT_EQ(answers[1].result.status, Status::interrupted);
  EXPECT_EQ(answers[2].result.status, Status::limit);
  EXPECT_EQ(answers[3].result.status, Status::solved);
  requests.erase(requests.begin(), requests.end() - 1);
  requests[0].target_gap = 0.5;
  const auto near = plan_batch(scene.planner, requests);
  ASSERT_EQ(near.size(), 1u);
  EXPECT_EQ(near[0].result.status, Status::solved);
  EXPECT_LE(near[0].result.gap().value(), 0.5);
}

TEST(Batch, AStopEndsItAfterWhatWasBegun) {
  const Scene scene;
  for (const int threads : {1, 3}) {
    std::stop_source source;
    std::size_t seen = 0;
    const auto count = plan_batch(scene.planner, scene.queries, brief(),
                                  {.threads = threads, .token = source.get_token()},
                                  [&](const BatchAnswer& answer) {
                                    ASSERT_EQ(answer.index, seen);
                                    if (++seen == 10) source.request_stop();
                                  });
    EXPECT_EQ(count, seen);
    EXPECT_GE(count, 10U);
    // What was in flight or waited for its turn when the stop came is received too.
    EXPECT_LE(count, 10U + 64U + 9U * static_cast<std::size_t>(threads));
    EXPECT_LT(count, scene.queries.size());
  }
}

TEST(Batch, AStoppedTokenBeginsNothing) {
  const Scene scene;
  EXPECT_EQ(
      plan_batch(scene.planner, scene.queries, brief(), {.threads = 2, .token = fired().token},
                 [](const BatchAnswer&) { FAIL() << "called"; }),
      0U);
}

TEST(Batch, WhatTheReceiverThrowsComesOut) {
  const Scene scene;
  for (const int threads : {1, 4}) {
    std::size_t calls = 0;
    try {
      plan_batch(scene.planner, scene.queries, brief(), {.threads = threads},
                 [&](const BatchAnswer&) {
                   if (++calls == 4) throw std::runtime_error("enough");
                 });
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& fault) {
      EXPECT_STREQ(fault.what(), "enough");
    }
    EXPECT_EQ(calls, 4U);
  }
}

TEST(Batch, ATimeLimitHoldsForEachQuery) {
  const Scene scene;
  Params params = brief();
  params.iterations = 1000000000;
  const auto joined =
      std::find_if(scene.queries.begin(), scene.queries.end(),
                   [&](const Request& q) { return scene.planner.plan(q, brief()).length > 30; });
  ASSERT_NE(joined, scene.queries.end());
  const std::vector<Request> queries(3, *joined);
  int limited = 0;
  plan_batch(scene.planner, queries, params,
             {.threads = 2, .time_limit = std::chrono::duration<double>(0.02)},
             [&](const BatchAnswer& answer) {
               limited += answer.result.status == Status::limit ? 1 : 0;
               EXPECT_GE(answer.elapsed.count(), 0.02);
             });
  EXPECT_EQ(limited, 3);
}

}  // namespace
}  // namespace lasius
