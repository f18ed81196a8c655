// Drives through worlds that the map does not show: planning goes on while the robot moves.
#pragma once

#include <filesystem>

#include "tools/study/runner.h"

namespace lasius::study {

/// Drives, see make_online_world() for a question's map. A contender's algorithm is one of the
/// library's or `dstar-lite`; beside its parameters it has the settings
///   replan     "kept" (default), or "anew": what was found is forgotten at each change
///   search_on  "false" (default) or "true", see NavigatorOptions
///   tick       milliseconds for planning in a tick, "0" (default) for no limit
/// Of a run `length` is the length travelled, as a share of the truth's shortest walk at the
/// beginning; `seconds` is the time for planning, `steps` are ticks, `iterations` ticks in which a
/// way was planned.
class OnlineDrives final : public Domain {
 public:
  OnlineDrives(const Study& study, std::filesystem::path maps);

  PreparedRun prepare(const Question& question, const Contender& contender) const override;

 private:
  std::filesystem::path maps_;
};

}  // namespace lasius::study
