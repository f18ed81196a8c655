// Parameters that others leave unread: said to be, and so.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "lasius/error.h"
#include "lasius/params.h"
#include "lasius/planner.h"
#include "tests/core/params/parameter_ends.h"
#include "tests/core/plan/planning.h"
#include "tests/core/plan/same_result.h"

namespace lasius {
namespace {

std::vector<std::string> some_values(const Parameter& parameter) {
  if (const auto ends = ends_of(parameter)) return {ends->begin(), ends->end()};
  std::vector<std::string> names;
  std::istringstream range{std::string(parameter.range)};
  for (std::string name; std::getline(range, name, '|');) names.push_back(name);
  return names;
}

bool is_valid(const Params& params) {
  try {
    validate(params);
  } catch (const Error&) {
    return false;
  }
  return true;
}

bool same_number(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

TEST(UnreadParameters, ChangeNothingAndOthersDo) {
  const Planner planner(blobs(50, 30));
  const Request request = far_apart(planner);
  std::set<std::string_view> unread, changing, conditional;
  for (const char* name : colonies()) {
    Params published = quick(name);
    published.iterations = 25;
    published.dead_end = Params(name).dead_end;
    const Result usual = planner.plan(request, published);
    for (const Parameter& parameter : find_algorithm(name).parameters) {
      if (parameter.only_with.empty()) {
        EXPECT_EQ(why_unread(published, parameter.name), "");
        continue;
      }
      SCOPED_TRACE(std::string(name) + ": " + std::string(parameter.name));
      conditional.insert(parameter.name);
      const bool is_read = why_unread(published, parameter.name).empty();
      for (const std::string& value : some_values(parameter)) {
        Params changed = published;
        set_parameter(changed, parameter.name, value);
        if (!is_valid(changed)) continue;
        const Result result = planner.plan(request, changed);
        if (!is_read) {
          unread.insert(parameter.name);
          expect_same(result, usual);
        } else if (result.arrived != usual.arrived || result.best != usual.best ||
                   !std::ranges::equal(result.mean, usual.mean, same_number)) {
          changing.insert(parameter.name);
        }
      }
    }
  }
  EXPECT_GE(conditional.size(), 15u);
  EXPECT_EQ(unread, conditional);
  EXPECT_EQ(changing, conditional);
}

TEST(UnreadParameters, SayWhy) {
  EXPECT_EQ(why_unread(Params("as"), "elite_weight"), "update is ant-system, not elitist");
  EXPECT_EQ(why_unread(Params("eas"), "elite_weight"), "");
  EXPECT_EQ(why_unread(Params("as"), "straight_deposit"),
            "polish is none, not straight|taut|local");
  EXPECT_EQ(why_unread(Params("as"), "ants"), "");
  EXPECT_THROW(why_unread(Params("as"), "antz"), Error);
}

}  // namespace
}  // namespace lasius
