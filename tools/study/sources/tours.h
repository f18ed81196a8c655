// Colonies over stops, on TSPLIB's instances and drawn ones.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "lasius/tour/tsplib.h"
#include "tools/study/runner.h"

namespace lasius::study {

/// A question's map is a file of TSPLIB, or "drawn N SEED": N places in a square of side 10000. A
/// contender is one of tour::algorithms(); a run's length is by the instance's own rounding.
class StopTours final : public Domain {
 public:
  StopTours(const Study& study, const std::filesystem::path& maps);

  PreparedRun prepare(const Question& question, const Contender& contender) const override;

 private:
  std::map<std::string, Tsplib> instances_;  // by the question's map
};

/// Takes out of a study of tours the questions whose file is not among the maps, the experiments
/// that have none then, and says that claims that have none are not repeated. Returns the files.
std::vector<std::string> leave_out_absent(Study& study, const std::filesystem::path& maps);

}  // namespace lasius::study
