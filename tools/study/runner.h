// Runs a study: every contender on every question for every seed, over threads, from where an
// earlier call stopped.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>

#include "tools/study/findings.h"

namespace lasius::study {

/// The contender's parameters on one thread. @throws Error(invalid_parameter) where the library
/// does not have its algorithm or a setting.
Params params_of(const Contender& contender);

struct RunnerOptions {
  int seeds = 30;  ///< seeds 1 .. seeds
  int threads = 1;
  std::filesystem::path folder;  ///< run files are kept in its subfolder `runs`
  std::filesystem::path maps;
  std::stop_token stop = {};
  /// Called by one thread at a time after each run: work done and to do, runs kept from before
  /// left out, and what just ran.
  std::function<void(std::int64_t done, std::int64_t total, const std::string& note)> progress = {};
};

/// The findings, complete unless `stop` was requested: then runs in flight are dropped, and nothing
/// is returned. The findings refer to `study`. @throws Error for a missing map or an output that
/// cannot be written.
std::optional<Findings> run_study(const Study& study, const RunnerOptions& options);

}  // namespace lasius::study
