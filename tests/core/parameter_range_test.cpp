// Whole plans with every parameter at the ends of its range.
#include <gtest/gtest.h>

#include <string>

#include "lasius/error.h"
#include "lasius/path.h"
#include "presets.h"
#include "tests/core/counting_time.h"
#include "tests/core/planning.h"

namespace lasius {
namespace {

// Both ends of "least .. most".
std::vector<std::string> ends(std::string_view range) {
  const auto dots = range.find(" .. ");
  return {std::string(range.substr(0, dots)), std::string(range.substr(dots + 4))};
}

class ParameterRange : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Colonies, ParameterRange, testing::ValuesIn(kColonies));

TEST_P(ParameterRange, BothEndsOfEveryNumberEnd) {
  const Planner planner(blobs(60, 40));
  Request request = far_apart(planner);
  Workspace workspace;
  int plans = 0;
  const auto expect_plan = [&](const Params& params, const std::string& what) {
    const CountingTime time(2000);
    request.stop = time.is_up();
    try {
      const Result result = planner.plan(request, params, &workspace);
      if (!result.path.empty()) {
        EXPECT_EQ(path_fault(planner.grid(), result.path), std::nullopt) << what;
      }
      ++plans;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::invalid_parameter) << what << ": " << error.what();
    }
  };
  const Params usual = quick(GetParam());
  for (const Parameter& parameter : find_algorithm(GetParam()).parameters) {
    if (parameter.type == "choice" || parameter.name == "ants") continue;
    for (const std::string& value : ends(parameter.range)) {
      Params params = usual;
      if (parameter.name != "iterations") params.iterations = 2;
      set_parameter(params, parameter.name, value);
      expect_plan(params, std::string(parameter.name) + " = " + value);
    }
  }
  EXPECT_GT(plans, 30);
  // Pheromone that could vanish altogether.
  Params params = usual;
  params.iterations = 2;
  params.initial_pheromone = 0;
  params.deposit = 1e-12;
  params.persistence = 0;
  expect_plan(params, "least pheromone");
}

}  // namespace
}  // namespace lasius
