#include "lasius/params/params.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "lasius/base/error.h"
#include "tests/core/base/refusal.h"
#include "tests/core/params/parameter_ends.h"

namespace lasius {
namespace {

TEST(Params, EveryAlgorithmsDefaultsAreValidAndRoundTrip) {
  for (const Algorithm& algorithm : algorithms()) {
    const Params published(algorithm.name);
    EXPECT_EQ(published.algorithm(), algorithm.name);
    EXPECT_NO_THROW(validate(published)) << algorithm.name;
    EXPECT_FALSE(algorithm.source.empty());
    for (const Parameter& parameter : algorithm.parameters) {
      Params copy = published;
      const std::string value = get_parameter(published, parameter.name);
      set_parameter(copy, parameter.name, value);
      EXPECT_EQ(get_parameter(copy, parameter.name), value) << parameter.name;
    }
  }
}

TEST(Params, NumbersRoundTrip) {
  Params p;
  set_parameter(p, "persistence", "0.1");
  EXPECT_EQ(p.persistence, 0.1);
  EXPECT_EQ(get_parameter(p, "persistence"), "0.1");
  set_parameter(p, "mu", "1e-3");
  EXPECT_EQ(p.mu, 1e-3);
}

TEST(Params, MistypedNamesAreAnsweredWithTheNearest) {
  Params p;
  EXPECT_EQ(refusal([&] { set_parameter(p, "alhpa", "1"); }),
            "unknown parameter \"alhpa\"; did you mean \"alpha\"?");
  EXPECT_EQ(refusal([&] { set_parameter(p, "q0", "1"); }),  // as sources have it
            "unknown parameter \"q0\"; did you mean \"greedy\"?");
  EXPECT_EQ(refusal([&] { set_parameter(p, "q", "1"); }),
            "unknown parameter \"q\"; did you mean \"index_spread\"?");
  EXPECT_EQ(refusal([&] { set_parameter(p, "mc", "1"); }),
            "unknown parameter \"mc\"; did you mean \"critical_time\"?");
  EXPECT_EQ(refusal([&] { Params("fan2044"); }),
            "unknown algorithm \"fan2044\"; did you mean \"fan2004\"?");
  EXPECT_EQ(refusal([&] { set_parameter(p, "polish", "strait"); }),
            "polish is \"strait\"; did you mean \"straight\"? It must be none|straight|taut|local");
}

TEST(Params, EveryRangeIsTheOneThatIsTold) { expect_ranges<Params>(algorithms()); }

TEST(Params, ValuesOutOfRangeNameTheRange) {
  Params p;
  for (const auto& [name, value] : {std::pair{"ants", "0"},
                                    {"ants", "1.5"},
                                    {"ants", ""},
                                    {"ants", "99999999999999"},
                                    {"persistence", "1.1"},
                                    {"persistence", "nan"},
                                    {"alpha", "inf"},
                                    {"alpha", "4x"},
                                    {"mu", "0"}}) {
    const std::string message = refusal([&, n = name, v = value] { set_parameter(p, n, v); });
    EXPECT_EQ(message.find(std::string(name) + " is " + value + "; it must be "), 0u) << message;
  }
  EXPECT_EQ(get_parameter(p, "ants"), "1");  // nothing half-set
}

TEST(Params, ValidateNamesTheField) {
  const auto message = [](auto change) {
    Params p("fan2004");
    change(p);
    return refusal([&] { validate(p); });
  };
  EXPECT_EQ(message([](Params& p) { p.ants = -3; }), "ants is -3; it must be 1 .. 1000000");

  EXPECT_EQ(message([](Params& p) { p.alpha = -1; }), "alpha is -1; it must be 0 .. 20");
  EXPECT_EQ(message([](Params& p) { p.seed = std::uint64_t{1} << 53; }),
            "seed is 9007199254740992; it must be at most 2^53 - 1");
  for (const int threads : {-1, 1025}) {
    EXPECT_EQ(message([&](Params& p) { p.threads = threads; }),
              "threads is " + std::to_string(threads) + "; it must be 0 (all cores) to 1024");
  }
  expect_says(message([](Params& p) { p.trail = Trail::arcs; }), "straight_deposit");
  expect_says(message([](Params& p) { p.distance_rule_first = 0; }), "shares");
  expect_says(message([](Params& p) { p.polish = static_cast<Polish>(7); }), "polish");
  expect_says(message([](Params& p) { p.settling_time = 10; }), "settling_time is 10, not after");
  expect_says(message([](Params& p) {
                p.pheromone_rule = p.combined_rule = p.distance_rule_last = 0;
                p.distance_rule = 1;
              }),
              "shares");
  EXPECT_EQ(message([](Params& p) { p.deposit = 1e-320; }).find("deposit is positive, but"), 0u);
}

TEST(Params, ANameComesWithItsNumbers) {
  const Params acs("acs", Preset::book);
  EXPECT_EQ(acs.algorithm(), "acs");
  EXPECT_EQ(acs.update, Update::colony_system);
  EXPECT_EQ(acs.greedy, 0.9);
  EXPECT_NE(acs, Params("acs"));
  EXPECT_EQ(Params().algorithm(), "exact");
  expect_says(refusal([] { Params misspelt("ass"); }), "\"as\"");
}

TEST(Params, NoPresetIsRefused) { EXPECT_THROW(Params("acs", static_cast<Preset>(9)), Error); }

TEST(Params, ABookIsASecondPresetOfItsOwn) {
  int books = 0;
  for (const Algorithm& algorithm : algorithms()) {
    if (has_preset(algorithm.name, Preset::book)) {
      ++books;
      const Params book(algorithm.name, Preset::book);
      validate(book);
      EXPECT_NE(book, Params(algorithm.name)) << algorithm.name;
    } else {
      EXPECT_THROW(Params(algorithm.name, Preset::book), Error) << algorithm.name;
    }
  }
  EXPECT_GT(books, 0);
}

// In full, as JSON has them, but for the largest and the least.
TEST(Params, RangesAsTold) {
  const auto range = [](std::string_view name) {
    return std::ranges::find(find_algorithm("as").parameters, name, &Parameter::name)->range();
  };
  EXPECT_EQ(range("iterations"), "0 .. 1000000000");
  EXPECT_EQ(range("mu"), "0.000001 .. 1000000");
  EXPECT_EQ(range("greedy"), "0 .. 1");
  EXPECT_EQ(range("deposit"), "0 .. 1e9");
  EXPECT_EQ(range("best_probability"), "1e-9 .. 1");
  EXPECT_EQ(range("walk_cut"), "none|own-cells|entered-cells");
}

// Whatever the other parameters.
TEST(Params, RowsOfRulesNameWhatTheirFormulasRead) {
  EXPECT_TRUE(rule_of(Visibility::inverse_step, kVisibilities).reads("beta"));
  EXPECT_TRUE(rule_of(Update::learning, kUpdates).reads("deposit"));
}

TEST(Params, EvaporationIsTheOtherWordForPersistence) {
  Params params("as");
  set_parameter(params, "evaporation", "0.25");
  EXPECT_EQ(params.persistence, 0.75);
  EXPECT_THROW(set_parameter(params, "evaporation", "1.5"), Error);
  const std::string rho = refusal([&] { set_parameter(params, "rho", "0.1"); });
  expect_says(rho, "evaporation");
  expect_says(rho, "persistence");
}

TEST(Params, FormulasAreThoseOfTheRulesInForce) {
  EXPECT_TRUE(formulas(Params("exact")).empty());
  Params params("as", Preset::book);
  EXPECT_EQ(formulas(params).front(),
            "weight of the move from i to j: tau^alpha * (1 / d(j, E))^beta");
  params.heuristic = Heuristic::rescaled_distance;
  params.visibility = Visibility::inverse_step;
  EXPECT_EQ(
      formulas(params).front(),
      "weight of the move from i to j: tau^alpha * ((Dmax - d(j, E)) omega + mu)^lambda * (1 / "
      "s)^beta; Dmax the largest d around i; s the length of the move");
  EXPECT_EQ(formulas(params).back(),
            "update: tau <- persistence tau + sum over the arrived ants of deposit / L");
  EXPECT_EQ(formulas(Params("acs")).back(),
            "update: on the best tour so far tau <- persistence tau + (1 - persistence) deposit / "
            "L; after an ant has passed tau <- (1 - local_evaporation) tau + local_evaporation "
            "tau0; tau0 the pheromone at first");
  EXPECT_EQ(formulas(Params("fan2004")).back(),
            "and deposit / S on the cells under straightened paths of length S");
  EXPECT_EQ(formulas(Params("fan2004"))[3],
            "or, drawn by shares: the weight tau^alpha * (1 / s)^beta, or that of the heuristic "
            "alone");
  const auto tells_of_eta = [](const char* name) {
    return formulas(Params(name))[0].find("eta what ants have learned") != std::string::npos;
  };
  EXPECT_TRUE(tells_of_eta("cong2009"));
  EXPECT_FALSE(tells_of_eta("fan2004"));
  for (const Algorithm& algorithm : algorithms()) {
    if (algorithm.kind != Algorithm::Kind::colony) continue;
    EXPECT_GE(formulas(Params(algorithm.name)).size(), 3u) << algorithm.name;
  }
}

// A value that the caller changed and that the algorithm never looks at is a mistake.
TEST(Params, WhatAnAlgorithmDoesNotReadMustStay) {
  Params exact;
  exact.corners = Corners::allow;
  EXPECT_EQ(refusal([&] { validate(exact); }),
            "corners is allow, but exact does not read it; leave it at forbid, or choose an "
            "algorithm that does");
  Params genetic("grid-ga");
  genetic.ants = 11;
  EXPECT_THROW(validate(genetic), Error);
  Params colony("as");
  colony.population = 51;
  EXPECT_THROW(validate(colony), Error);
  reset_unread(colony);  // of the algorithm's own parameters only
  EXPECT_THROW(validate(colony), Error);
  // Without straight paths there is nothing that could be laid: no contradiction.
  Params raw("fan2004");
  raw.polish = Polish::none;
  EXPECT_NO_THROW(validate(raw));
  raw.trail = Trail::arcs;
  EXPECT_NO_THROW(validate(raw));
  raw.polish = Polish::straight;
  EXPECT_THROW(validate(raw), Error);
}

TEST(Params, WhatWaitsForAnothersValueIsSetBack) {
  Params params("as"), read = params;
  params.ranks = 9;
  params.beta_first = 2;
  params.ants = read.ants = 7;
  EXPECT_NO_THROW(validate(params));
  reset_unread(params);
  EXPECT_EQ(params, read);
  for (Params* each : {&params, &read}) {
    each->ranks = 9;
    each->update = Update::rank;
    each->critical_time = 5;
    each->heuristic = Heuristic::inverse_distance;
  }
  reset_unread(read);
  EXPECT_EQ(read, params);
  Params index("terminal-index");  // what is not read contradicts nothing
  index.initial_pheromone = 1e-20;
  index.pheromone_rule_first = 1;
  EXPECT_NO_THROW(validate(index));
  index.critical_time = 5;
  expect_says(refusal([&] { validate(index); }), "the inverse roulette knows one rule");
}

TEST(Params, KindsAreTold) {
  EXPECT_EQ(find_algorithm("exact").kind, Algorithm::Kind::exact);
  EXPECT_EQ(find_algorithm("grid-ga").kind, Algorithm::Kind::genetic);
  EXPECT_EQ(find_algorithm("mmas").kind, Algorithm::Kind::colony);
  EXPECT_EQ(to_string(Algorithm::Kind::genetic), "genetic");
  EXPECT_TRUE(find_algorithm("mmas").has("ants"));
  EXPECT_FALSE(find_algorithm("exact").has("ants"));
}

}  // namespace
}  // namespace lasius
