// The study of `maklink-acs`: a world of ours in the lecture's size, its tables repeated.
#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "lasius/polygon_plan.h"
#include "tools/study/table.h"

namespace lasius::study {

/// One way to search, with its settings.
struct CrossingContender {
  std::string name;   ///< of columns
  std::string label;  ///< in tables and legends
  std::string algorithm;
  std::vector<std::pair<std::string, std::string>> settings;
  int paths = 0;  ///< of an iteration
};

/// One run: what it found, and when.
struct CrossingTrial {
  std::uint64_t seed = 1;
  double length = 0;
  double limit = 0;    ///< the optimum of its lines and values, for ants; of its lines, for genes
  int iterations = 0;  ///< done
  int converged = 0;   ///< iteration from which on the best path stayed the same, from 1
  double seconds = 0;  ///< of all iterations
  std::vector<double> best;
};

struct CrossingSample {
  CrossingContender contender;
  std::vector<CrossingTrial> trials;
};

struct MaklinkStudy {
  std::string world;  ///< file
  int trials = 0;
  int crossed = 0;  ///< lines on Dijkstra's path
  int lines = 0;    ///< of the graph
  double dijkstra = 0;
  double optimum = 0;  ///< of the world
  double sequence_optimum = 0;
  std::vector<CrossingSample> samples;
};

/// Runs everything; empty when stopped. `progress` is told runs done and in all.
std::optional<MaklinkStudy> run_maklink(const std::filesystem::path& maps, int trials,
                                        const std::stop_token& stop,
                                        const std::function<void(int, int)>& progress);

/// The report's page; `pictures` are shown at its end.
std::string maklink_page(const MaklinkStudy& study,
                         const std::vector<std::pair<std::string, std::string>>& pictures);

/// A row a run.
Table maklink_runs(const MaklinkStudy& study);

/// Standard deviation of the best length over the trials, by iteration.
std::vector<double> deviation(const CrossingSample& sample);

}  // namespace lasius::study
