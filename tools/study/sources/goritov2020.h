// System D: what one parameter after another does to arms among unknown obstacles.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "lasius/arm/generate.h"
#include "lasius/arm/plan.h"
#include "tools/study/runner.h"

namespace lasius::study {

/// What was measured of a question itself.
struct ArmGround {
  double optimum = 0;    ///< metres
  double detour = 1;     ///< optimum / Manhattan distance
  bool straight = true;  ///< the straight way is open
};

/// The arm maps/arms/industrial6.json in generated scenes: a question's map is "scene SEED WALL",
/// see arm::GenerateOptions. The study's ten: the straight way is open in five, closed in five; two
/// of those need a detour of at least 1.5 times the Manhattan distance. The first seeds of each
/// kind. Lengths are shares of the optimum of the fully known lattice.
class ArmScenes final : public Domain {
 public:
  ArmScenes(const Study& study, const std::filesystem::path& maps);
  ~ArmScenes() override;

  PreparedRun prepare(const Question& question, const Contender& contender) const override;
  std::optional<double> optimum(const Question& question, const Optimum& optimum,
                                const StopCondition& stop) const override;
  const ArmGround& ground(const Question& question) const;

 private:
  struct Case;

  arm::Robot robot_;
  std::map<std::string, std::unique_ptr<const Case>> cases_;  // by the question's map
};

}  // namespace lasius::study
