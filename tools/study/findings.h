// What the runs of a study found.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lasius/planner.h"
#include "tools/study/study.h"

namespace lasius::study {

/// One run, as its file keeps it.
struct Run {
  std::uint64_t seed = 0;
  Status status = Status::no_path;
  double length = kUnknown;
  int iterations = 0;
  double seconds = 0;        ///< processor time on one thread
  std::vector<double> best;  ///< as in Result
  std::vector<double> mean = {};
  std::vector<Point> path = {};  ///< on bitmaps
  double limit = kUnknown;       ///< shortest length that its own discretisation allows
  std::int64_t steps = 0;        ///< of all ants
  std::int64_t checks = 0;       ///< positions and motions that were tried

  bool solved() const { return !path.empty(); }
  /// Iterations done when the final length was first reached; 0 for algorithms without iterations.
  int converged() const;
};

/// All runs of one contender on one question, by seed.
struct Sample {
  const Experiment* experiment = nullptr;
  const Question* question = nullptr;
  const Contender* contender = nullptr;
  int paths_an_iteration = 1;  ///< ants, or the population
  std::vector<Run> runs = {};

  /// Of the solved runs, in the order of the seeds.
  std::vector<double> lengths() const;
  std::vector<double> iterations_to_converge() const;
  std::vector<double> seconds() const;  ///< of all runs
  int solved() const;
};

/// A contender that could not run, and why.
struct Absent {
  std::string experiment, contender, reason;
};

class Findings {
 public:
  std::vector<Sample> samples;
  std::vector<Absent> absent;
  struct Optimum {
    const Question* question;
    const Experiment* experiment;
    double length;
  };
  std::vector<Optimum> optima;  ///< where known

  /// Null where the contender is absent.
  const Sample* find(std::string_view experiment, std::string_view question,
                     std::string_view contender) const;
  /// The samples of a contender, one a question.
  std::vector<const Sample*> of(std::string_view experiment, std::string_view contender) const;
  std::optional<double> optimum(const Experiment& experiment, const Question& question) const;
};

}  // namespace lasius::study
