// What the factors of a sweep do.
#pragma once

#include <string>
#include <vector>

#include "tools/study/table.h"

namespace lasius::study {

/// Parameters that a sweep has set, in their order.
std::vector<std::string> factor_names(const Findings& findings);

/// Empty where the contender has no such factor.
std::string factor_value(const Contender& contender, const std::string& name);

/// A row a value of a factor, or a third of its range where it has many. Values are compared with
/// the first of their factor by Mann and Whitney's test over the questions, by the gaps of all runs
/// that had them.
Table factor_table(const Findings& findings, const Experiment& experiment);

}  // namespace lasius::study
