#include "lasius/io/json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "lasius/base/error.h"
#include "lasius/plan/planner.h"
#include "tests/core/base/refusal.h"
#include "tests/core/loop/same_result.h"

namespace lasius {
namespace {

/// What is said about a text that `read` refuses.
std::string refusal_of(const std::string& text, const auto& read, ErrorCode code) {
  const Error error = error_of([&] { return read(text); }, text);
  EXPECT_EQ(error.code(), code) << error.what();
  EXPECT_FALSE(error.remedy().empty());
  return error.what();
}
std::string params_refusal(const std::string& text, ErrorCode code = ErrorCode::file_broken) {
  return refusal_of(text, params_from_json, code);
}
std::string result_refusal(const std::string& text) {
  return refusal_of(text, result_from_json, ErrorCode::file_broken);
}

/// An answer is read from its text as it was.
void expect_kept(const Result& result) {
  const Result read = result_from_json(result_to_json(result));
  expect_same(result, read);
  EXPECT_EQ(result.own_rules, read.own_rules);
  EXPECT_EQ(result.limit, read.limit);
  EXPECT_EQ(result.alternatives, read.alternatives);
}

TEST(Json, KeepsTheParametersOfEveryAlgorithm) {
  for (const Algorithm& algorithm : algorithms()) {
    Params params(algorithm.name);
    params.seed = (std::uint64_t{1} << 53) - 1;
    params.threads = 3;
    if (algorithm.has("alpha")) params.alpha = 0.1 + 0.2;
    const Params read = params_from_json(params_to_json(params));
    EXPECT_EQ(read.algorithm(), params.algorithm());
    EXPECT_EQ(read.seed, params.seed);
    EXPECT_EQ(read.threads, 3);
    for (const Parameter& parameter : algorithm.parameters)
      EXPECT_EQ(get_parameter(read, parameter.name), get_parameter(params, parameter.name))
          << algorithm.name << " " << parameter.name;
  }
}

TEST(Json, KeepsTheAnswerOfEveryAlgorithm) {
  Grid grid(9, 7);
  for (int y = 1; y < 7; ++y) grid.set_blocked({4, y}, true);
  const Planner planner(std::move(grid));
  for (const Algorithm& algorithm : algorithms()) {
    Params params(algorithm.name);
    if (algorithm.has("iterations")) params.iterations = 3;
    for (const Cell goal : {Cell{8, 6}, Cell{0, 6}, Cell{4, 5}, Cell{20, 3}}) {
      const Result result = planner.plan({{0, 6}, goal}, params);
      expect_kept(result);
    }
  }
}

TEST(Json, KeepsNumbersBitForBitAndWritesNullForWhatIsNone) {
  Result result;
  result.status = Status::limit;
  result.limit = Limit::time;
  result.length = 0.1 + 0.2;
  result.path = {{-0.0, 5e-324}, {1e308, 1.0 / 3}};
  result.curves.iterations = 2;
  result.curves.best = {NAN, 2.2250738585072014e-308};
  result.curves.mean = {1e17 + 2, NAN};
  result.curves.arrived = {0, 7};
  result.lower_bound = 0.3;
  result.own_rules = true;
  result.way_out = Point{1.0 / 3, 4};
  result.alternatives = {{{{0.1, 2}, {1.0 / 3, 4}}, 0.1 + 0.7}, {{{5, 6}}, 1e300}};
  result.error = "a \"quote\", \\ and \n";
  result.fault = Fault::trapped;  // the last of them
  const std::string text = result_to_json(result);
  expect_says(text, "\"best\":[null,");
  EXPECT_EQ(text.find('\n'), text.size() - 1);
  expect_kept(result);
  expect_says(result_to_json(Result()), "\"length\":null,\"path\":null");
  expect_kept(Result());
}

TEST(Json, ReadsWhatTheProgramPrints) {
  const std::string saved =
      R"({"format": "lasius-plan/1", "algorithm": "fan2004", "seed": 7, "threads": 2,
          "parameters": {"ants": 5, "polish": "taut", "target_gap": 0.5, "radius": 2,
                         "alternatives": 2, "time_limit": null, "unknown": "free", "goal_tolerance": 2, "frame": "cell"},
          "goal_reached": [2.0, 0.5], "way_out": [0.75, 0.5],
          "status": "solved", "error": null, "length": 1.5, "path": [[0.5, 0.5], [2, 0.5]],
          "iterations": 0, "best": [], "mean": [], "arrived": [], "lower_bound": null,
          "gap": null, "optimal": false, "elapsed_ms": 1})";
  const Params params = params_from_json(saved);
  EXPECT_EQ(params.seed, 7);
  EXPECT_EQ(params.ants, 5);
  EXPECT_EQ(params.polish, Polish::taut);
  EXPECT_EQ(params.iterations, Params("fan2004").iterations);
  const Result result = result_from_json(saved);
  EXPECT_EQ(result.path.size(), 2);
  EXPECT_EQ(result.goal_reached, (Cell{2, 0})) << "where a disc ends at a point";
  EXPECT_EQ(result.way_out, (Point{0.75, 0.5}));
}

TEST(Json, KeepsParametersThatAreNotRead) {
  Params idle("as", Preset::book);
  idle.ranks = 9;
  EXPECT_EQ(params_from_json(params_to_json(idle)), idle);
  EXPECT_THROW(params_from_json(R"({"algorithm":"exact","parameters":{"ants":5}})"), Error);
}

// Numbers that a type does not hold are named, not cut.
TEST(Json, RefusesNumbersThatDoNotFit) {
  expect_says(params_refusal(R"({"algorithm": "exact", "threads": 4294967297})"), "threads");
  const std::string whole =
      R"({"status": "solved", "iterations": 1, "best": [1], "mean": [1], "arrived": [1],
          "lower_bound": null, "optimal": false, "path": [[1, 2]], "nearest_free": [1, 2]})";
  EXPECT_NO_THROW((void)result_from_json(whole));
  for (const auto& [from, to] : {std::pair{"\"arrived\": [1]", "\"arrived\": [1.7]"},
                                 {"\"iterations\": 1", "\"iterations\": 4294967297"},
                                 {"\"nearest_free\": [1, 2]", "\"nearest_free\": [1.5, 2]"},
                                 {"\"nearest_free\": [1, 2]", "\"nearest_free\": [1, 2, 3]"},
                                 {"\"nearest_free\": [1, 2]", "\"way_out\": [1, 1e300]"},
                                 {"\"path\": [[1, 2]]", "\"path\": [[1, 2, 3]]"}}) {
    std::string text = whole;
    text.replace(text.find(from), std::string_view(from).size(), to);
    EXPECT_FALSE(result_refusal(text).empty()) << text;
  }
}

TEST(Json, RefusesOtherTexts) {
  expect_says(params_refusal("{"), "line 1, byte 1: this is not JSON");
  expect_says(params_refusal("{\"seed\": 1,\n\"seed\": 2}"), "line 2, byte 17: \"seed\" is given");
  expect_says(params_refusal("[1]"), "not an object");
  expect_says(params_refusal(std::string(100, '[')), "nests too deep");
  expect_says(params_refusal("{}"), "lacks \"algorithm\"");
  expect_says(params_refusal(R"({"algorithm": 3})"), "\"algorithm\": 3");
  expect_says(params_refusal(R"({"algorithm": "exact", "seed": 1.5})"), "\"seed\": 1.5");
  constexpr auto kValue = ErrorCode::invalid_parameter;
  expect_says(params_refusal(R"({"algorithm": "fan204"})", kValue), "fan2004");
  expect_says(params_refusal(R"({"algorithm": "fan2004", "parameters": {"atns": 3}})", kValue),
              "\"ants\"");
  expect_says(params_refusal(R"({"algorithm": "fan2004", "parameters": {"ants": 0}})", kValue),
              "ants");
  expect_says(result_refusal(R"({"status": "solvde"})"), "solvde");
  expect_says(result_refusal(R"({"status": "solved"})"), "\"iterations\"");
}

}  // namespace
}  // namespace lasius
