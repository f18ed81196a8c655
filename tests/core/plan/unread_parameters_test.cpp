// Parameters that others leave unread: said to be, and so.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/number_text.h"
#include "lasius/base/error.h"
#include "lasius/params/params.h"
#include "lasius/plan/planner.h"
#include "tests/core/base/refusal.h"
#include "tests/core/params/parameter_ends.h"
#include "tests/worlds/planning.h"

namespace lasius {
namespace {

// Other values than the one in hand, in the range.
std::vector<std::string> other_values(const Parameter& parameter, const std::string& value) {
  std::vector<std::string> values;
  if (const auto ends = ends_of(parameter)) {
    const double least = std::stod((*ends)[0]), most = std::stod((*ends)[1]),
                 now = std::stod(value);
    for (const double other : {least, std::floor(now / 2), 0.9 * now, 2 * now + 1, most}) {
      const bool whole = other == std::floor(other);
      const bool fits = other >= least && other <= std::min(most, 1000.0) && other != now;
      if (fits && (whole || parameter.type == "number")) values.push_back(number_text(other));
    }
    return values;
  }
  for (const std::string_view choice : parameter.choices) {
    if (choice != value) values.emplace_back(choice);
  }
  return values;
}

bool same_number(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

bool same_run(const Result& a, const Result& b) {
  return a.status == b.status && a.curves.arrived == b.curves.arrived && a.path == b.path &&
         std::ranges::equal(a.curves.best, b.curves.best, same_number) &&
         std::ranges::equal(a.curves.mean, b.curves.mean, same_number);
}

// Nothing where the parameters do not go together.
std::optional<Result> run(const Planner& planner, const Request& request, const Params& params) {
  if (refusal([&] { validate(params); }) != "accepted") return {};
  return planner.plan(request, params);
}

// What is read, but may well change nothing: values of which only the ratio counts, times between
// equal shares, an end that comes only to those who agree.
bool may_change_nothing(std::string_view name) {
  return name == "agreement" || name == "critical_time" || name == "settling_time" ||
         name == "initial_pheromone" || name.find("_rule") != name.npos;
}

// What some colonies refuse to change alone.
bool goes_with_others(std::string_view name) {
  constexpr std::string_view kNames[] = {"selection", "trail", "update", "heuristic", "greedy"};
  return std::ranges::find(kNames, name) != std::end(kNames);
}

class EveryColonysParameters : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(UnreadParameters, EveryColonysParameters, testing::ValuesIn(colonies()),
                         by_algorithm);

TEST_P(EveryColonysParameters, ChangeARunUnlessTheyAreSaidToBeUnread) {
  const Planner planner(blobs(32, 20));
  const Request request = far_apart(planner);
  Params published = quick(GetParam());
  published.iterations = 20;
  const Result usual = run(planner, request, published).value();
  for (const Parameter& parameter : find_algorithm(GetParam()).parameters) {
    SCOPED_TRACE(parameter.name);
    const std::string why = why_unread(published, parameter.name);
    int runs = 0, changes = 0;
    for (const auto& value : other_values(parameter, get_parameter(published, parameter.name))) {
      Params changed = published;
      set_parameter(changed, parameter.name, value);
      const auto result = run(planner, request, changed);
      EXPECT_TRUE(result || why.empty()) << value;  // what is not read contradicts nothing
      if (!result) continue;
      ++runs;
      if (!same_run(*result, usual)) ++changes;
    }
    if (!why.empty()) {
      EXPECT_EQ(changes, 0) << why;
    } else if (!may_change_nothing(parameter.name) &&
               !(runs == 0 && goes_with_others(parameter.name))) {
      EXPECT_GT(changes, 0);
    }
  }
}

// Settings beside the presets' own, as "NAME=VALUE", of which the last is changed to another value.
struct Beside {
  const char* algorithm;
  std::vector<std::string_view> settings;
  const char* name;
  const char* value;
  bool read;
};

TEST(UnreadParameters, WithOtherSettings) {
  const Planner planner(blobs(30, 18, 5));
  const Request request = far_apart(planner);
  const std::vector<Beside> cases{
      {"cong2009", {"initial_pheromone=0", "reward_reading=affine"}, "deposit", "7", true},
      {"cong2009", {"initial_pheromone=1", "reward_reading=affine"}, "deposit", "7", false},
      {"cong2009", {"dead_end=kill", "ants=30"}, "penalty", "0.1", true},
      {"cong2009", {"dead_end=backtrack"}, "penalty", "0.1", false},
      {"acs", {"local_evaporation=0"}, "batch", "1", false},
      {"acs", {"local_evaporation=0.3", "batch=0"}, "batch", "1", true},
      {"as", {"visibility=heading-change"}, "beta", "1", true},
      {"as", {"heuristic=uniform", "visibility=inverse-step"}, "beta", "1", true},
      {"as", {"heuristic=uniform", "visibility=inverse-step", "neighbours=4"}, "beta", "1", false},
      {"as", {"critical_time=9", "visibility=inverse-step"}, "beta_first", "1", true},
      {"as", {"update=rank"}, "ranks", "2", true},
      {"fan2004", {"polish=taut"}, "straight_window", "0", false}};
  for (const Beside& c : cases) {
    SCOPED_TRACE(std::string(c.algorithm) + ": " + c.name);
    Params params = quick(c.algorithm);
    for (const std::string_view s : c.settings)
      set_parameter(params, s.substr(0, s.find('=')), s.substr(s.find('=') + 1));
    EXPECT_EQ(why_unread(params, c.name).empty(), c.read);
    const Result usual = run(planner, request, params).value();
    set_parameter(params, c.name, c.value);
    EXPECT_EQ(same_run(run(planner, request, params).value(), usual), !c.read);
  }
}

TEST(UnreadParameters, FourMovesPassNoCornerWhateverItsRule) {
  Grid grid(2, 2);
  grid.set_blocked({1, 0});
  grid.set_blocked({0, 1});
  Params params("fan2004");
  params.corners = Corners::allow;
  EXPECT_EQ(Planner(grid).plan({{0, 0}, {1, 1}}, params).status, Status::unreachable);
}

TEST(UnreadParameters, SayWhy) {
  EXPECT_EQ(why_unread(Params("as"), "elite_weight"), "it is read only with update=elitist");
  EXPECT_EQ(why_unread(Params("eas"), "elite_weight"), "");
  EXPECT_EQ(why_unread(Params("as"), "straight_deposit"),
            "it is read only with polish=straight|taut|local");
  EXPECT_EQ(why_unread(Params("as"), "penalty"),
            "it is read only with update=learning and dead_end=kill");
  EXPECT_EQ(why_unread(Params("terminal-index"), "persistence"),
            "it is read only with any update except terminal-index");
  Params steps("cong2009");
  steps.update = Update::ant_system;
  steps.heuristic = Heuristic::uniform;
  steps.visibility = Visibility::inverse_step;
  EXPECT_EQ(why_unread(steps, "beta"),
            "it is read only with a heuristic, visibility or update with it in its formula, and "
            "neighbours above 4 where that is inverse-step alone");
  EXPECT_EQ(why_unread(steps, "beta_first"),
            "it is read only with critical_time above 0 and settings that read beta");
  EXPECT_EQ(why_unread(Params("cong2009"), "deposit"),
            "it is read only with any update except terminal-index, and for learning also "
            "initial_pheromone=0 or a straight_deposit");
  EXPECT_EQ(why_unread(Params("as"), "ants"), "");
  EXPECT_EQ(why_unread(Params("exact"), "ants"), "exact does not read it");
  EXPECT_THROW(why_unread(Params("as"), "antz"), Error);
}

}  // namespace
}  // namespace lasius
