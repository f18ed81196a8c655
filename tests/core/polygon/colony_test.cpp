#include <gtest/gtest.h>

#include <algorithm>
#include <stop_token>
#include <utility>

#include "lasius/base/error.h"
#include "lasius/path/path.h"
#include "tests/core/base/counting_time.h"
#include "tests/core/params/parameter_ends.h"
#include "tests/core/polygon/known_world.h"
#include "tests/worlds/random_world.h"

// Runs of the ants and of the genetic comparator: seeds, stops, parameters.
namespace lasius::polygon {
namespace {

TEST(Determinism, SeedAloneDecides) {
  const Planner planner(random_world(7, 60));
  const Request request = random_request(planner, 1);
  for (const char* algorithm : {"maklink-acs", "real-ga"}) {
    Params parameters(algorithm);
    parameters.iterations = 60;
    const Result one = planner.plan(request, parameters);
    parameters.threads = 3;
    const Result two = Planner(random_world(7, 60)).plan(request, parameters);
    EXPECT_EQ(one.path, two.path);
    EXPECT_EQ(one.curves.best, two.curves.best);
    EXPECT_EQ(one.curves.mean, two.curves.mean);
    parameters.seed = 2;
    EXPECT_NE(planner.plan(request, parameters).curves.mean, one.curves.mean);
  }
}

TEST(Stops, TokenAndDeadlineKeepTheBestPath) {
  const Planner planner(known_world());
  std::stop_source source;
  const Result cut = planner.plan({.start = {}, .goal = {}, .stop = {.token = source.get_token()}},
                                  Params("maklink-acs"), [&](const Progress& view) {
                                    if (view.iteration == 4) source.request_stop();
                                  });
  EXPECT_EQ(cut.status, Status::interrupted);
  EXPECT_EQ(cut.curves.iterations, 5);
  EXPECT_FALSE(cut.path.empty());
  for (const char* algorithm : {"maklink-acs", "real-ga"}) {
    const Result late =
        planner.plan({.start = {}, .goal = {}, .stop = {.deadline = Clock::time_point::min()}},
                     Params(algorithm));
    EXPECT_EQ(late.status, Status::limit);
    EXPECT_EQ(late.limit, Limit::time);
    EXPECT_EQ(late.path, late.dijkstra->path);
  }
}

TEST(Stops, ObserversSeeAndStopEveryAlgorithm) {
  const Planner planner(known_world());
  int calls = 0;
  const Result exact = planner.plan({}, {}, [&](const PlanProgress& view) {
    ++calls;
    EXPECT_EQ(view.best_length, view.lower_bound);
    EXPECT_DOUBLE_EQ(path_length(view.path()), view.best_length);
  });
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(exact.status, Status::solved);
  for (const char* algorithm : {"maklink-acs", "real-ga"}) {
    const Result cut = planner.plan({}, Params(algorithm), [&](const PlanProgress& view) {
      EXPECT_LE(view.lower_bound.value(), view.best_length);
      EXPECT_NEAR(path_length(view.path()), view.best_length, 1e-9 * view.best_length);
      return view.iteration == 2 ? Go::stop : Go::on;
    });
    EXPECT_EQ(cut.status, Status::interrupted);
    EXPECT_EQ(cut.curves.iterations, 3);
    EXPECT_FALSE(cut.path.empty());
  }
}

TEST(Stops, AnObserverComesTooLateInTheLastIterationOfTheLastRoute) {
  const Planner planner(known_world());
  int routes = 0;
  for (const char* algorithm : {"maklink-acs", "real-ga"}) {
    Params parameters(algorithm);
    parameters.iterations = 3;
    const Result whole = planner.plan({}, parameters);
    routes += whole.curves.iterations / parameters.iterations;
    for (int at = 0; at < whole.curves.iterations; ++at) {
      const Result result = planner.plan({}, parameters, [&](const PlanProgress& view) {
        return view.iteration == at ? Go::stop : Go::on;
      });
      const bool last = at + 1 == whole.curves.iterations;
      EXPECT_EQ(result.curves.iterations, at + 1);
      EXPECT_EQ(result.status, last ? Status::solved : Status::interrupted) << at;
      if (last) {
        EXPECT_EQ(result.path, whole.path);
      }
    }
  }
  EXPECT_GT(routes, 2);
}

TEST(Stops, ThePathThatAnObserverSeesIsTheBestOfAllRoutes) {
  const Planner planner(known_world());
  int runs = 0;
  for (const char* algorithm : {"maklink-acs", "real-ga"}) {
    Params parameters(algorithm);
    parameters.iterations = 20;
    std::vector<Point> last;
    double length = 0;
    const Result result = planner.plan({}, parameters, [&](const PlanProgress& view) {
      last = view.path();
      ASSERT_NEAR(path_length(last), view.best_length, 1e-9 * view.best_length);
      length = view.best_length;
    });
    runs += result.curves.iterations / parameters.iterations;
    EXPECT_EQ(last, result.path);
    EXPECT_NEAR(length, result.length, 1e-9 * length);
  }
  EXPECT_GT(runs, 2) << "the colony searches more than one route";
}

TEST(Stops, TheDiscreteOptimumIsCutShort) {
  const Planner planner(known_world());
  Params parameters("maklink-acs");
  parameters.iterations = 0;
  EXPECT_TRUE(planner.plan({}, parameters).discrete_optimum);
  parameters.values = 10001;
  const CountingTime time(3);
  const Result cut = planner.plan({.start = {}, .goal = {}, .stop = time.is_up()}, parameters);
  EXPECT_EQ(cut.status, Status::limit);
  EXPECT_FALSE(cut.discrete_optimum);
  EXPECT_TRUE(cut.sequence_optimum);
  EXPECT_EQ(cut.path, cut.dijkstra->path);
}

TEST(Stops, PolledWhileFurtherRoutesAreSought) {
  const Planner planner(random_world(7, 100));
  Request request = random_request(planner, 1);
  Params parameters("maklink-acs");
  parameters.iterations = 0;
  parameters.routes = 200;
  const CountingTime time(1000000);
  request.stop = time.is_up();
  EXPECT_EQ(planner.plan(request, parameters).status, Status::solved);
  const int before_each = parameters.routes + 1;  // and before the exact search
  EXPECT_GT(time.polls(), before_each + 10);
}

TEST(Stops, AnIterationIsCutShort) {
  const Planner planner(known_world());
  Params parameters("maklink-acs");
  parameters.values = 10001;
  parameters.iterations = 1;
  const CountingTime time(4);
  const Result cut = planner.plan({.start = {}, .goal = {}, .stop = time.is_up()}, parameters);
  EXPECT_EQ(cut.status, Status::limit);
  EXPECT_EQ(cut.curves.iterations, 0);
  EXPECT_EQ(cut.path, cut.dijkstra->path);
}

TEST(Scale, APowerOfTwoChangesNoBitOfAnyAnswer) {
  int planned = 0;
  for (int i = 0; i < 6; ++i) {
    World world = random_world(static_cast<std::uint64_t>(400 + i), 5 + 8 * i);
    world.margin = i % 2 == 0 ? 0 : 0.7;
    const Planner planner(world);
    Dice dice(static_cast<std::uint64_t>(i));
    const Point start = free_point(planner, dice), goal = free_point(planner, dice);
    std::vector<std::pair<double, Planner>> others;
    for (const double by : {0x1p-10, 0x1p3, 0x1p20}) others.emplace_back(by, scaled(world, by));
    for (const Algorithm& algorithm : algorithms()) {
      Params parameters(algorithm.name);
      if (algorithm.name == "real-ga") parameters.iterations = 20;
      const Result one = planner.plan({.start = start, .goal = goal}, parameters);
      planned += one.path.empty() ? 0 : 1;
      for (const auto& [by, there] : others) {
        const auto far = [scale = by](Point p) { return scaled(p, scale); };
        const Result other = there.plan({.start = far(start), .goal = far(goal)}, parameters);
        ASSERT_EQ(one.path.size(), other.path.size()) << algorithm.name << " " << by;
        for (std::size_t k = 0; k < one.path.size(); ++k)
          EXPECT_EQ(far(one.path[k]), other.path[k]) << algorithm.name << " " << by;
        EXPECT_EQ(one.crossing.values, other.crossing.values);
        EXPECT_EQ(one.curves.iterations, other.curves.iterations);
      }
    }
  }
  EXPECT_GT(planned, 12);
}

TEST(Scale, ThePublishedPheromoneTiesTheColonyToTheUnit) {
  Params parameters("maklink-acs");
  parameters.initial_pheromone = 0.0002;
  World far = scaled(known_world(), 1024);
  far.start = scaled(*far.start, 1024);
  far.goal = scaled(*far.goal, 1024);
  const Result metres = Planner(known_world()).plan({}, parameters);
  EXPECT_NE(metres.curves.mean, Planner(far).plan({}, parameters).curves.mean);
}

TEST(Iterations, GrowWithTheValuesUnlessTheyWereSet) {
  Params parameters("maklink-acs");
  for (const auto& [values, iterations] : {std::pair{2, 200}, {11, 200}, {21, 400}, {41, 800}}) {
    parameters.values = values;
    EXPECT_EQ(iterations_of(parameters), iterations);
    EXPECT_EQ(get_parameter(parameters, "iterations"), std::to_string(iterations));
  }
  parameters.iterations = 30;
  parameters.agreement = 0;
  parameters.routes = 1;
  EXPECT_EQ(iterations_of(parameters), 30);
  EXPECT_EQ(Planner(known_world()).plan({}, parameters).curves.iterations, 30);
  EXPECT_EQ(iterations_of(Params("real-ga")), 1000);
  parameters.iterations = -2;
  EXPECT_THROW(validate(parameters), Error);
}

TEST(TargetGap, EndsTheRun) {
  const Planner planner(known_world());
  const Result result =
      planner.plan({.start = {}, .goal = {}, .target_gap = 0.02}, Params("maklink-acs"));
  EXPECT_LT(result.curves.iterations, 50);
  EXPECT_LE(*result.gap(), 0.02);
}

TEST(Routes, MoreLineSequencesAreNeverWorse) {
  int searched = 0;
  for (int i = 0; i < 8; ++i) {
    const Planner planner(random_world(300 + i, 30));
    const Request request = random_request(planner, i);
    Params parameters("maklink-acs");
    parameters.routes = 1;
    const Result one = planner.plan(request, parameters);
    if (one.path.empty()) continue;
    ++searched;
    parameters.routes = 5;
    const Result many = planner.plan(request, parameters);
    EXPECT_LE(many.length, one.length);
    EXPECT_GE(many.curves.iterations, one.curves.iterations);
    EXPECT_TRUE(std::is_sorted(many.curves.best.rbegin(), many.curves.best.rend()));
  }
  EXPECT_GT(searched, 4);
}

TEST(Parameters, AtTheEndsOfTheirRanges) {
  const Planner planner(known_world());
  for (const Algorithm& algorithm : algorithms()) {
    const auto plan_with = [&](std::string_view name, const std::string& value,
                               const StopCondition& stop) {
      Params parameters(algorithm.name);
      parameters.iterations = 2;
      set_parameter(parameters, name, value);
      const Result result = planner.plan({.start = {}, .goal = {}, .stop = stop}, parameters);
      EXPECT_LE(result.length, result.dijkstra->length) << name << " " << value;
    };
    plan_at_both_ends(algorithm, plan_with);
  }
}

TEST(Parameters, NamesRangesAndDefaults) {
  EXPECT_EQ(algorithms().front().name, "exact");
  for (const Algorithm& algorithm : algorithms()) {
    Params parameters(algorithm.name);
    EXPECT_NO_THROW(validate(parameters));
    for (const Parameter& parameter : algorithm.parameters) {
      const std::string value = get_parameter(parameters, parameter.name);
      EXPECT_NO_THROW(set_parameter(parameters, parameter.name, value)) << parameter.name;
    }
  }
  EXPECT_THROW(Params("maklink"), Error);
  Params bad("maklink-acs");
  bad.values = 1;
  EXPECT_THROW(Planner(known_world()).plan({}, bad), Error);
}

TEST(Parameters, EveryRangeIsTheOneThatIsTold) { expect_ranges<Params>(algorithms()); }

}  // namespace
}  // namespace lasius::polygon
