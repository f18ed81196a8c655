#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <stdexcept>
#include <stop_token>
#include <utility>
#include <vector>

#include "lasius/base/error.h"
#include "lasius/polygon/plan.h"
#include "tests/core/base/counting_time.h"
#include "tests/core/base/refusal.h"
#include "tests/core/loop/same_result.h"
#include "tests/core/polygon/known_world.h"

namespace lasius::polygon {
namespace {

Params few(std::string_view algorithm) {
  Params params(algorithm);
  params.seed = 11;
  if (algorithm != "exact") params.iterations = 3;
  return params;
}

/// The known world, and requests of every outcome: its own, far and near, equal, blocked, outside.
struct Asked {
  Planner planner{known_world()};
  std::vector<Request> requests{{}};

  Asked() {
    for (int i = 0; i < 100; ++i)
      requests.push_back({.start = Point{1.5 + i, 7.25 * (i % 27)},
                          .goal = Point{199 - 1.75 * i, 13.5 * (i % 14)}});
    requests.push_back({.start = Point{5, 5}, .goal = Point{5, 5}});
    requests.push_back({.start = Point{60, 140}});
    requests.push_back({.goal = Point{1e300, 0}});
  }
};

void expect_same(const Result& a, const Result& b) {
  lasius::expect_same(a, b);
  lasius::expect_same(a.path, b.path);
  EXPECT_EQ(a.optimum, b.optimum);
}

TEST(PolygonBatch, AnswersInOrderWhatPlanAnswersWithEachSeed) {
  const Asked asked;
  for (const auto algorithm : {"exact", "maklink-acs", "real-ga"}) {
    const Params params = few(algorithm);
    int invalid = 0;
    for (const int threads : {1, 2, 5}) {
      std::size_t next = 0;
      const auto receive = [&](const BatchAnswer& answer) {
        ASSERT_EQ(answer.index, next / 2);
        ASSERT_EQ(answer.seed, 11 + next++ % 2);
        Params one = params;
        one.seed = answer.seed;
        expect_same(answer.result, asked.planner.plan(asked.requests[answer.index], one));
        invalid += answer.result.status == Status::invalid;
      };
      const auto count = plan_batch(asked.planner, asked.requests, params,
                                    {.threads = threads, .seeds = 2}, receive);
      EXPECT_EQ(count, 2 * asked.requests.size());
      EXPECT_EQ(next, count);
    }
    EXPECT_GE(invalid, 12);
  }
}

TEST(PolygonBatch, WithoutAReceiverItReturnsItsAnswers) {
  const Asked asked;
  const auto answers = plan_batch(asked.planner, asked.requests);
  ASSERT_EQ(answers.size(), asked.requests.size());
  EXPECT_NEAR(answers[0].result.length, 168.371941370, 5e-10);
  for (std::size_t i = 0; i < answers.size(); ++i)
    expect_same(answers[i].result, asked.planner.plan(asked.requests[i]));
}

TEST(PolygonBatch, RefusesBadParametersBeforeAnyRequest) {
  const Asked asked;
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [](const Planner& planner, const std::vector<Request>& requests,
                          const Params& params, const BatchOptions& options) {
    const auto fail = [](const BatchAnswer&) { FAIL() << "called"; };
    EXPECT_THROW(plan_batch(planner, requests, params, options, fail), Error);
  };
  Params params = few("maklink-acs");
  params.ants = 0;
  refused(asked.planner, asked.requests, params, {});
  params = few("maklink-acs");
  refused(asked.planner, asked.requests, params, {.threads = 1025});
  refused(asked.planner, asked.requests, params, {.time_limit = std::chrono::duration<double>(-1)});
  params.seed = (std::uint64_t{1} << 53) - 1;
  refused(asked.planner, asked.requests, params, {.seeds = 2});
  EXPECT_THROW(plan_batch(asked.planner, asked.requests, {}, {}, BatchReceiver()), Error);
  auto requests = asked.requests;
  requests.back().target_gap = kNaN;
  refused(asked.planner, requests, {}, {});
  requests.back() = {.start = Point{kNaN, 1}};
  refused(asked.planner, requests, {}, {});
  EXPECT_EQ(refusal([&] { (void)asked.planner.plan(requests.back()); }),
            "the start is (nan, 1); give finite coordinates");
  // The world names no goal, nor does the second request.
  const Planner open(empty_world(10, 10, Point{1, 1}, std::nullopt));
  refused(open, {{.goal = Point{2, 2}}, {}}, {}, {});
}

TEST(PolygonBatch, RequestsKeepTheirOwnStops) {
  const Asked asked;
  std::vector<Request> requests(3);
  requests[1].stop = fired();
  requests[2].stop.deadline = Clock::now() - std::chrono::hours(1);
  const auto answers = plan_batch(asked.planner, requests, few("maklink-acs"), {.threads = 2});
  ASSERT_EQ(answers.size(), 3U);
  EXPECT_EQ(answers[0].result.status, Status::solved);
  EXPECT_EQ(answers[1].result.status, Status::interrupted);
  EXPECT_EQ(answers[2].result.status, Status::limit);
  EXPECT_EQ(answers[2].result.limit, Limit::time);
}

TEST(PolygonBatch, ATimeLimitHoldsForEachRequest) {
  const Asked asked;
  const std::vector<Request> requests(3);
  using Seconds = std::chrono::duration<double>;
  for (const auto& [seconds, status] : {std::pair(0.0, Status::limit), {3600.0, Status::solved}}) {
    const auto answers = plan_batch(asked.planner, requests, few("maklink-acs"),
                                    {.threads = 2, .time_limit = Seconds(seconds)});
    ASSERT_EQ(answers.size(), 3U);
    for (const BatchAnswer& answer : answers) {
      EXPECT_EQ(answer.result.status, status);
      EXPECT_EQ(answer.result.limit, status == Status::limit ? Limit::time : Limit::none);
    }
  }
}

TEST(PolygonBatch, WhatIsInFlightAtAStopEndsInterruptedAndIsReceived) {
  const Asked asked;
  const FiringTime clock(0);
  std::vector<Request> requests(3);
  requests[1].stop = {.deadline = clock.fires().deadline, .time = &clock};
  const auto answers = plan_batch(asked.planner, requests, few("maklink-acs"),
                                  {.threads = 1, .token = clock.token()});
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(answers[0].result.status, Status::solved);
  EXPECT_EQ(answers[1].result.status, Status::interrupted);
}

TEST(PolygonBatch, AStopEndsItAfterWhatWasBegun) {
  const Asked asked;
  const std::vector<Request> requests(300);
  for (const int threads : {1, 3}) {
    std::stop_source source;
    std::size_t seen = 0;
    const auto receive = [&](const BatchAnswer& answer) {
      ASSERT_EQ(answer.index, seen);
      if (++seen == 10) source.request_stop();
    };
    const auto count = plan_batch(asked.planner, requests, few("maklink-acs"),
                                  {.threads = threads, .token = source.get_token()}, receive);
    EXPECT_EQ(count, seen);
    EXPECT_GE(count, 10U);
    EXPECT_LE(count, 10U + 64U + 9U * static_cast<std::size_t>(threads));
  }
}

TEST(PolygonBatch, WhatTheReceiverThrowsComesOut) {
  const Asked asked;
  std::size_t calls = 0;
  const auto receive = [&](const BatchAnswer&) {
    if (++calls == 4) throw std::runtime_error("enough");
  };
  EXPECT_THROW(plan_batch(asked.planner, asked.requests, {}, {.threads = 3}, receive),
               std::runtime_error);
  EXPECT_EQ(calls, 4U);
}

}  // namespace
}  // namespace lasius::polygon
