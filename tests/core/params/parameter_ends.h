// Plans with every numeric parameter at either end of its range.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "lasius/error.h"
#include "lasius/params.h"
#include "lasius/stop.h"

namespace lasius {

/// Calls plan(name, value, stop) for both ends of each numeric range of `algorithm`, and expects it
/// back after a deadline, with an answer or a refusal.
template <class Plan>
void plan_at_both_ends(const Algorithm& algorithm, const Plan& plan) {
  using namespace std::chrono_literals;
  for (const Parameter& parameter : algorithm.parameters) {
    const std::string range(parameter.range), between = " .. ";
    const std::size_t middle = range.find(between);
    if (middle == std::string::npos) continue;  // a choice
    for (const auto& value : {range.substr(0, middle), range.substr(middle + between.size())}) {
      const auto deadline = Clock::now() + 100ms;
      try {
        plan(parameter.name, value, StopCondition{.deadline = deadline});
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::invalid_parameter) << parameter.name << " " << value;
      }
      EXPECT_LT(Clock::now(), deadline + 10s) << parameter.name << " " << value;
    }
  }
}

}  // namespace lasius
