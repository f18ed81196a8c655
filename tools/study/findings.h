// What the runs of a study found.
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lasius/plan/planner.h"
#include "tools/study/study.h"

namespace lasius::study {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Two lengths that differ by less than this fraction are equal.
inline constexpr double kSameLength = 1e-9;

/// One run, as its file keeps it.
struct Run {
  std::uint64_t seed = 0;
  Status status = Status::no_path;
  double length = kUnknown;
  int iterations = 0;
  double seconds = 0;             ///< processor time on one thread
  std::vector<double> best = {};  ///< as in Result
  std::vector<double> mean = {};
  // As in Convergence; empty where the planner does not tell.
  std::vector<double> raw_best = {}, cut_mean = {}, cut_best = {}, iteration_best = {},
                      steps_by = {};
  std::vector<double> band = {};  ///< by iteration: share of steps near the straight line
  std::vector<Point> path = {};   ///< on bitmaps
  double limit = kUnknown;        ///< shortest length that its own moves or values allow
  double reference = kUnknown;    ///< length of the path that it begins with, where there is one
  std::int64_t steps = 0;         ///< of all ants
  std::int64_t checks = 0;        ///< positions and motions that were tried

  bool solved() const { return std::isfinite(length); }
};

/// All runs of one contender on one question, by seed.
struct Sample {
  const Experiment* experiment = nullptr;
  const Question* question = nullptr;
  const Contender* contender = nullptr;
  int paths_an_iteration = 1;  ///< ants, or the population
  std::vector<Run> runs = {};

  /// A value of each run; those without a path have an infinite length.
  template <class Take>
  std::vector<double> each(const Take& take) const {
    std::vector<double> values;
    for (const Run& run : runs) values.push_back(take(run));
    return values;
  }
  std::vector<double> lengths() const {
    return each([](const Run& r) { return r.solved() ? r.length : kInfinity; });
  }
};

/// A contender that could not run, and why.
struct SkippedContender {
  std::string experiment, contender, reason;
};

class Findings {
 public:
  std::vector<Sample> samples;  ///< with the runs that were done
  std::vector<SkippedContender> skipped;
  bool whole = true;         ///< false after an interruption
  bool interrupted = false;  ///< by a signal to this process, or to one that shares the runs
  std::map<std::pair<const Experiment*, const Question*>, double> optima;  ///< where known

  /// Null where the contender was skipped. What is asked for question by question is looked up, not
  /// searched for: a study may have 100 000 of them.
  const Sample* find(std::string_view experiment, std::string_view question,
                     std::string_view contender) const;
  /// The samples of a contender, one a question.
  std::vector<const Sample*> of(std::string_view experiment, std::string_view contender) const;
  std::optional<double> optimum(const Experiment& experiment, const Question& question) const;

 private:
  using Names = std::array<std::string_view, 3>;  ///< of experiment, question, contender
  mutable std::map<Names, std::size_t> numbers_;  ///< of the samples, the first `numbered_` of them
  mutable std::size_t numbered_ = 0;
};

}  // namespace lasius::study
