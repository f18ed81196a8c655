// Parameters at the ends of their ranges, whatever the world.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/number_text.h"
#include "lasius/base/error.h"
#include "lasius/params/params.h"
#include "tests/core/base/counting_time.h"

namespace lasius {

/// The ends of a number's range as text; nothing for a choice.
inline std::optional<std::array<std::string, 2>> ends_of(const Parameter& parameter) {
  if (!parameter.choices.empty()) return std::nullopt;
  return {{parameter.text_of(parameter.least), parameter.text_of(parameter.most)}};
}

/// Expects the range that `parameter` tells to be the one that is kept: both ends are taken and the
/// next numbers beyond them are refused; of a choice each name is taken, and nothing else.
template <class Params>
void expect_range(const Parameter& parameter) {
  Params params;
  const auto expect_taken = [&](const std::string& value) {
    EXPECT_NO_THROW(set_parameter(params, parameter.name, value)) << value;
  };
  const auto expect_refused = [&](const std::string& value) {
    const std::string before = get_parameter(params, parameter.name);
    EXPECT_THROW(set_parameter(params, parameter.name, value), Error) << value;
    EXPECT_EQ(get_parameter(params, parameter.name), before) << "half set by " << value;
  };
  const auto ends = ends_of(parameter);
  if (!ends) {
    EXPECT_EQ(parameter.type, "choice");
    for (const std::string_view choice : parameter.choices) {
      const std::string name(choice);
      expect_taken(name);
      EXPECT_EQ(get_parameter(params, parameter.name), name);
      expect_refused(name + "x");
    }
    return;
  }
  for (const bool high : {false, true}) {
    const std::string& end = (*ends)[high ? 1 : 0];
    expect_taken(end);
    const double number = std::stod(end), infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(std::stod(get_parameter(params, parameter.name)), number);
    if (parameter.type == "integer") {
      expect_refused(std::to_string(std::stoll(end) + (high ? 1 : -1)));
    } else {
      expect_refused(number_text(std::nextafter(number, high ? infinity : -infinity)));
    }
  }
}

/// Checks the ends of every parameter of some algorithms, of seed and threads.
template <class Params>
void expect_ranges(std::span<const Algorithm> algorithms) {
  int parameters = 0;
  for (const Algorithm& algorithm : algorithms) {
    for (const Parameter& parameter : algorithm.parameters) {
      SCOPED_TRACE(std::string(algorithm.name) + ": " + std::string(parameter.name));
      expect_range<Params>(parameter);
      ++parameters;
    }
  }
  EXPECT_GT(parameters, 10);
  constexpr std::uint64_t kMostSeed = (std::uint64_t{1} << 53) - 1;
  const auto checked = [](std::uint64_t seed, int threads) {
    Params params;
    params.seed = seed;
    params.threads = threads;
    validate(params);
  };
  for (const std::uint64_t seed : {std::uint64_t{0}, kMostSeed}) EXPECT_NO_THROW(checked(seed, 0));
  EXPECT_THROW(checked(kMostSeed + 1, 0), Error);
  for (const int threads : {0, 1024}) EXPECT_NO_THROW(checked(0, threads)) << threads;
  for (const int threads : {-1, 1025}) EXPECT_THROW(checked(0, threads), Error) << threads;
}

/// Calls plan(name, value, stop) for both ends of each numeric range of `algorithm`, and expects
/// an answer or a refusal, few looks at the clock after the one at which `stop` holds.
template <class Plan>
void plan_at_both_ends(const Algorithm& algorithm, const Plan& plan) {
  constexpr int kLooks = 200, kMore = 40;
  for (const Parameter& parameter : algorithm.parameters) {
    const auto ends = ends_of(parameter);
    if (!ends) continue;
    for (const std::string& value : *ends) {
      const CountingTime time(kLooks);
      try {
        plan(parameter.name, value, time.is_up());
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::invalid_parameter) << parameter.name << " " << value;
      }
      EXPECT_LE(time.polls(), kLooks + kMore)
          << algorithm.name << " " << parameter.name << " " << value;
    }
  }
}

}  // namespace lasius
