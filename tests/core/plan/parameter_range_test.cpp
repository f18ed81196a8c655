// Whole plans with every parameter at the ends of its range.
#include <gtest/gtest.h>

#include <string>

#include "lasius/path/path.h"
#include "tests/core/params/parameter_ends.h"
#include "tests/worlds/planning.h"

namespace lasius {
namespace {

class ParameterRange : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Colonies, ParameterRange, testing::ValuesIn(colonies()), by_algorithm);

TEST_P(ParameterRange, BothEndsOfEveryNumberEnd) {
  const Planner planner(blobs(60, 40));
  Request request = far_apart(planner);
  Workspace workspace;
  int plans = 0, paths = 0;
  const auto expect_plan = [&](const Params& params, const std::string& what) {
    const Result result = planner.plan(request, params, {.workspace = &workspace});
    if (!result.path.empty()) {
      EXPECT_EQ(path_fault(planner.grid(), result.path), std::nullopt) << what;
      ++paths;
    }
    ++plans;
  };
  Params usual = quick(GetParam());
  usual.iterations = 2;
  plan_at_both_ends(find_algorithm(GetParam()), [&](std::string_view name, const std::string& value,
                                                    const StopCondition& stop) {
    Params params = usual;
    set_parameter(params, name, value);
    request.stop = stop;
    expect_plan(params, std::string(name) + " = " + value);
  });
  EXPECT_GT(plans, 50);
  EXPECT_GT(paths, 50);
  // Pheromone that could vanish altogether.
  request.stop = {};
  usual.initial_pheromone = 0;
  usual.deposit = 1e-12;
  usual.persistence = 0;
  expect_plan(usual, "least pheromone");
}

}  // namespace
}  // namespace lasius
