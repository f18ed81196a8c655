// Studies on maps of free and blocked cells.
#pragma once

#include <cstdint>
#include <map>

#include "lasius/cost/planner.h"
#include "tools/study/runner.h"

namespace lasius::study {

/// The contender's parameters on one thread. @throws Error(invalid_parameter) where the library
/// does not have its algorithm or a setting.
Params params_of(const Contender& contender);

/// The question's optimum, or nothing where it is not known: the any-angle one is asked of the
/// library's algorithm `exact`.
std::optional<double> true_optimum(const Planner& planner, const Question& question,
                                   const Optimum& optimum, const StopCondition& stop);

class Bitmaps final : public Domain {
 public:
  /// Reads or makes the maps of the study's questions. @throws Error as `load_map`.
  Bitmaps(const Study& study, const std::filesystem::path& maps);

  PreparedRun prepare(const Question& question, const Contender& contender) const override;
  std::optional<double> optimum(const Question& question, const Optimum& optimum,
                                const StopCondition& stop) const override;

 private:
  struct OverCosts {
    CostPlanner planner;
    std::uint64_t hash;  ///< of its weights
  };

  double shortest(const Question& question, const Params& params) const;

  std::map<std::pair<std::string, double>, Planner> planners_;  ///< by Question::ground()
  std::map<std::string, OverCosts> over_costs_;                 ///< by costs_key()
};

}  // namespace lasius::study
