// What is measured of the runs of a setting.
#pragma once

#include <string>
#include <vector>

#include "tools/study/findings.h"
#include "tools/study/statistics.h"

namespace lasius::study {

/// All runs of a setting: by question.
using Runs = std::vector<const Sample*>;

/// The last best length of a run; unknown without an iteration.
double final_best(const Run& run);

/// Steps of a run, and the iteration that found its best path: means over all runs.
double mean_steps(const Runs& runs);
double mean_reached(const Runs& runs);

/// Mean over all runs, by iteration, of the best length so far or of the mean tour.
std::vector<double> mean_curve(const Runs& runs, std::vector<double> Run::*curve);

/// A share in percent, with one decimal and without the sign.
std::string percent(double share);

/// How much longer the best paths of `second` are than those of `first`, paired by question and
/// seed, in shares of the optimum.
struct Contrast {
  double mean = 0;
  Interval interval;

  Contrast(const Runs& first, const Runs& second);
  bool first_shorter() const { return interval.low > 0; }
  bool second_shorter() const { return interval.high < 0; }
  /// "+2.0% [1.5, 2.5]".
  std::string text() const;
};

/// How many runs' mean tours stop changing for good before the last tenth, and when.
struct Freezing {
  int frozen = 0, all = 0;
  double median = kUnknown;  ///< iteration

  explicit Freezing(const Runs& runs);
  double share() const { return all > 0 ? static_cast<double>(frozen) / all : 0; }
  std::string text() const;
};

}  // namespace lasius::study
