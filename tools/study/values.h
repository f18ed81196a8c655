// Numbers that are taken of runs, and what a run has spent.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/study/findings.h"

namespace lasius::study {

/// The names of values and of budgets.
std::vector<std::string_view> value_names();
std::vector<std::string_view> budget_names();

/// In words, for tables. @throws std::invalid_argument for an unknown name or budget.
std::string value_text(const Value& value);

/// "within 1.0% of the optimum", "at the optimum".
std::string target_text(double target, bool own_limit = false);

/// What a run spent in its first `iterations`, in the unit of `value.at`; unknown where the planner
/// does not tell. Time is shared out evenly over a run's iterations.
double spent(const Sample& sample, const Run& run, const std::string& at, std::size_t iterations);

/// The budget at which two contenders are compared: that of the value, else what the longest run of
/// the more frugal one spends. A run that ended earlier, by its own rule, keeps what it had.
double common_budget(const Value& value, const Sample& a, const Sample& b);

/// Infinite where a run does not get there (a length without a path, an effort without success);
/// unknown where it was not recorded.
double value_of(const Sample& sample, const Run& run, const Value& value, double budget,
                std::optional<double> optimum);

/// What an optimum is called: "true optimum", or "optimum of 8 moves".
std::string optimum_text(const Optimum& optimum);

}  // namespace lasius::study
