// Runs a study: every contender on every question for every seed, over threads, from where an
// earlier call stopped.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <stop_token>
#include <string>

#include "tools/options/options.h"
#include "tools/study/findings.h"

namespace lasius::study {

/// Runs of one contender on one question, made ready for any seed.
struct PreparedRun {
  std::string key;             ///< all that decides a run but its seed and the library's version
  int paths_an_iteration = 1;  ///< ants, or the population
  std::int64_t work = 1;       ///< of one run, an estimate: path cells
  /// One run on one thread, of all iterations or of `pilot_part` of them; whatever it returns is
  /// dropped when a stop was requested.
  std::function<Run(std::uint64_t seed, bool pilot, const std::stop_token&, Workspace&)> run;
};

/// What the questions of a study are about: bitmaps, polygons, arms or drives.
class Domain {
 public:
  virtual ~Domain() = default;
  /// May refer to the domain. @throws Error(invalid_parameter) where the library does not have the
  /// contender's algorithm or a setting.
  virtual PreparedRun prepare(const Question& question, const Contender& contender) const = 0;
  /// Length of the question's shortest path, or nothing where it is not known, as here.
  virtual std::optional<double> optimum(const Question& question, const Optimum& optimum,
                                        const StopCondition& stop) const;
};

/// Takes a contender's settings over `params`, its algorithm's defaults, on one
/// thread; those of its settings that are not read are left out. @throws Error(invalid_parameter)
template <class AnyParams>
AnyParams configured(AnyParams params, const Contender& contender) {
  for (const auto& [name, value] : contender.settings) set_parameter(params, name, value);
  params.threads = 1;
  if constexpr (std::same_as<AnyParams, Params>) reset_unread(params);
  validate(params);
  return params;
}

/// The prepared run but for `run` itself: `about` tells the question from others, `parameters`
/// are those of the algorithm, and a path is about `cells` long.
template <class AnyParams>
PreparedRun run_of(std::string about, const AnyParams& params,
                   std::span<const Parameter> parameters, std::int64_t cells) {
  PreparedRun prepared{.key = std::move(about), .run = {}};
  for (const Parameter& p : parameters) {
    const std::string value = get_parameter(params, p.name);
    prepared.key += ' ' + std::string(p.name) + '=' + value;
    if (p.name == "population" || p.name == "ants") prepared.paths_an_iteration = std::stoi(value);
  }
  // Runs of any number of iterations have a budget.
  const std::int64_t iterations = std::clamp(params.iterations, 1, 1'000'000);
  prepared.work = prepared.paths_an_iteration * iterations * cells;
  return prepared;
}

/// Iterations of a pilot, of so many.
inline int pilot_part(int iterations) { return (iterations + 7) / 8; }

/// Processor time of the calling thread, seconds: unlike wall time, whatever else runs.
double thread_seconds();

struct RunnerOptions {
  int seeds = 30;  ///< so many, from `first_seed`
  int threads = 1;
  std::filesystem::path folder;  ///< run files are kept in its subfolder `runs`
  std::stop_token stop = {};
  /// Called before the first run, unless null: how many there are, those kept from before left out,
  /// and about how many seconds they take, from a part of the first run of each contender.
  std::function<void(std::size_t runs, double seconds)> estimate = {};
  /// Called by one thread at a time after each run: work done and to do, runs kept from before
  /// left out, and what just ran.
  std::function<void(std::int64_t done, std::int64_t total, const std::string& note)> progress = {};
  std::uint64_t first_seed = 1;  ///< at least 1
  tool::Part part = {};          ///< of the runs: only these are done
  bool all_there = false;        ///< runs that are not kept are refused: Error(file_broken)
  bool tell_all = false;         ///< of a crew: all ranks are told the runs, not its leader alone
};

/// The findings, whole unless `stop` was requested: then runs in flight are dropped. They refer to
/// `study`. Of a part only the runs are made: the findings have no optima, and are not whole. A
/// crew shares the runs; its leader keeps them. Findings of a rank that is not told all are as a
/// part's.
/// @throws Error for an output that cannot be written.
Findings run_study(const Study& study, const Domain& domain, const RunnerOptions& options);

}  // namespace lasius::study
