#include <gtest/gtest.h>

#include <limits>

#include "lasius/path/path.h"
#include "lasius/plan/planner.h"
#include "tests/worlds/planning.h"

namespace lasius {
namespace {

// One observer for every algorithm, `exact` included, and it can stop the run.
TEST(Observer, SeesEveryAlgorithm) {
  const Planner planner(blobs());
  const Planner prepared(blobs(), PrepareOptions{});
  const Request request = far_apart(planner);
  for (const Algorithm& algorithm : algorithms()) {
    const bool exact = algorithm.kind == Algorithm::Kind::exact;
    const Params params = exact ? Params() : quick(algorithm.name);
    for (const Planner* const p : {&planner, &prepared}) {
      const Result whole = p->plan(request, params);
      int calls = 0;
      double last = std::numeric_limits<double>::infinity();
      const Result watched =
          p->plan(request, params, {.observer = [&](const GridProgress& seen) {
                    EXPECT_EQ(seen.iteration, calls++);
                    if (seen.path().empty()) return;
                    EXPECT_LE(seen.best_length, last);
                    last = seen.best_length;
                    EXPECT_NEAR(path_length(seen.path()), seen.best_length, 1e-9);
                    if (exact) {
                      EXPECT_LE(seen.lower_bound.value(), whole.length * (1 + 1e-9));
                    }
                  }});
      EXPECT_EQ(watched.path, whole.path) << algorithm.name;
      EXPECT_EQ(watched.status, whole.status) << algorithm.name;
      EXPECT_GT(calls, 0) << algorithm.name;
      if (exact) {
        EXPECT_EQ(last, whole.length);
      } else {
        EXPECT_EQ(calls, whole.curves.iterations);
      }
    }
  }
}

TEST(Observer, StopsEveryAlgorithm) {
  const Planner planner(blobs(300, 200, 9));
  const Request request = far_apart(planner);
  for (const Algorithm& algorithm : algorithms()) {
    if (algorithm.kind == Algorithm::Kind::exact) continue;
    const Params params = quick(algorithm.name);
    int calls = 0;
    const Result result = planner.plan(request, params, {.observer = [&](const GridProgress&) {
                                         return ++calls == 3 ? Go::stop : Go::on;
                                       }});
    EXPECT_EQ(calls, 3) << algorithm.name;
    EXPECT_EQ(result.curves.iterations, 3) << algorithm.name;
    EXPECT_EQ(result.status, Status::interrupted) << algorithm.name;
  }
}

// An exact search that is stopped at its first path keeps it, with a bound.
TEST(Observer, StopsExact) {
  int stopped = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Planner planner(
        generate(MapKind::random, {.width = 250, .height = 250, .density = 0.1, .seed = seed}));
    const Request request = far_apart(planner);
    const Result whole = planner.plan(request);
    int calls = 0;
    const Result result = planner.plan(request, {}, {.observer = [&](const GridProgress&) {
                                         ++calls;
                                         return Go::stop;
                                       }});
    EXPECT_EQ(calls, 1);
    ASSERT_FALSE(result.path.empty());
    EXPECT_GE(result.length, whole.length * (1 - 1e-12));
    ASSERT_TRUE(result.lower_bound.has_value());
    EXPECT_LE(*result.lower_bound, whole.length * (1 + 1e-12));
    if (result.status != Status::interrupted) continue;
    ++stopped;
    EXPECT_FALSE(result.optimal);
  }
  EXPECT_GT(stopped, 0);
}

TEST(Observer, SeesToursAndPheromone) {
  const FarApart far;
  int calls = 0;
  Params params = quick("fan2004");
  params.walk_cut = WalkCut::none;  // deposits on all of a tour
  (void)far.plan(params, {.observer = [&](const GridProgress& p) {
                   EXPECT_EQ(p.iteration, calls++);
                   EXPECT_EQ(p.ants(), 10);
                   EXPECT_EQ(p.arrived, 10);
                   for (int a = 0; a < p.ants(); ++a) {
                     const auto tour = p.tour(a);
                     ASSERT_GE(tour.size(), 2u);
                     EXPECT_EQ(tour.front(), far.request.start);
                     EXPECT_EQ(tour.back(), far.request.goal);
                     EXPECT_GT(p.pheromone(tour[tour.size() / 2]), p.pheromone({0, 79}));
                   }
                 }});
  EXPECT_EQ(calls, 15);
}

}  // namespace
}  // namespace lasius
