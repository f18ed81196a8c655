// The study of `maklink-acs`: a world of ours in the lecture's size, its tables repeated.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "lasius/polygon_plan.h"
#include "tools/study/runner.h"
#include "tools/study/table.h"

namespace lasius::study {

/// The world of the study's only question. A run's limit is the optimum of its lines and values,
/// for ants; of its lines, for genes. Its time is that of all iterations.
class MaklinkWorld final : public Domain {
 public:
  MaklinkWorld(const Study& study, const std::filesystem::path& maps);

  Task task(const Question& question, const Contender& contender) const override;

  /// Of the world itself.
  struct Figures {
    int lines = 0;    ///< of the graph
    int crossed = 0;  ///< lines on Dijkstra's path
    double dijkstra = 0;
    double sequence_optimum = 0;
    double optimum = 0;  ///< of the world
  };
  const Figures& figures() const { return figures_; }
  const std::string& file() const { return file_; }

 private:
  std::string file_;
  polygon::Planner planner_;
  Figures figures_;
};

/// The report's page; `pictures` are shown at its end.
std::string maklink_page(const Study& study, const Findings& findings, const MaklinkWorld& world,
                         const std::vector<std::pair<std::string, std::string>>& pictures);

/// A row a run.
Table maklink_runs(const Findings& findings);

/// Standard deviation of the best length over the trials, by iteration.
std::vector<double> deviation(const Sample& sample);

}  // namespace lasius::study
