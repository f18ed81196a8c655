// Runs a tuning: the race, and the judgement of its winner.
#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "tools/study/findings.h"
#include "tools/study/runner.h"
#include "tools/study/tune/tune_file.h"

namespace lasius::study {

struct TuneOptions {
  int threads = 1;
  std::filesystem::path folder;  ///< run files are kept in its subfolder `runs`
  std::filesystem::path maps;
  std::stop_token stop = {};
  /// Called before the first run: the seconds that all takes at most, were no candidate to leave.
  std::function<void(double seconds)> estimate = {};
  /// Called after each block, and after each run that judges.
  std::function<void(std::int64_t done, std::int64_t total, const std::string& note)> progress = {};
};

/// Questions of one kind of generated maps, or of one file.
struct Family {
  std::string name;              ///< empty: all of them
  std::vector<Pair> pairs = {};  ///< values of the judged and of the default, by question
  RankTest test = {};
  Interval effect = {};  ///< of the test's effect, 95%
  double ratio = 0;      ///< of medians, NaN where there is none
  Interval ratios = {};  ///< 95%
  double p = 1;          ///< two-sided, by Holm's method over the families; of all by itself
};

struct Tuned {
  Race race;
  bool whole = false;  ///< false after an interruption
  /// The race's values, a row a run: block, question, map, seed, candidate, value.
  std::vector<std::vector<std::string>> rows = {};
  std::size_t judged = 0;  ///< which candidate was: the winner, or the rival of a default that won
  std::vector<Family> families = {};  ///< of it and the default, all first; none: not judged yet
};

/// The race, then the winner's judgement. Equal tunings and maps give equal results, whatever the
/// threads, and wherever an earlier call was stopped: runs are kept. Draws the tuning's questions.
/// @throws as draw_questions(), run_study().
Tuned tune(Tuning& tuning, const TuneOptions& options);

/// A candidate against the default by family. Equal values give equal families.
std::vector<Family> judge(const Findings& findings, const Tuning& tuning,
                          const std::string& candidate);

}  // namespace lasius::study
