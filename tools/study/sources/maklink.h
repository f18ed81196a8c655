// The study of `maklink-acs`: a world of ours in the lecture's size.
#pragma once

#include <filesystem>

#include "lasius/polygon/plan.h"
#include "tools/study/runner.h"

namespace lasius::study {

/// The world of the study's only question. A run's limit is the optimum of its lines and values,
/// for ants; of its lines, for genes; its reference is Dijkstra's path through midpoints. Its time
/// is that of all iterations.
class MaklinkWorld final : public Domain {
 public:
  MaklinkWorld(const Study& study, const std::filesystem::path& maps);

  PreparedRun prepare(const Question& question, const Contender& contender) const override;
  /// Of the whole world, whichever is asked for.
  std::optional<double> optimum(const Question& question, const Optimum& optimum,
                                const StopCondition& stop) const override;

 private:
  polygon::Planner planner_;
};

}  // namespace lasius::study
