// The classic update families side by side, on the maps of the other studies.
#include "study/claims.h"
#include "study/study.h"

namespace lasius::study {

Study families() {
  Experiment grids{
      .name = "grids",
      .title = "Small grids, eight moves",
      .text = "All with 30 ants and 100 iterations, 8 moves, no corner cut, without polish.",
      .truth = {Truth::Kind::moves, 8, Corners::forbid},
      .contenders = {},
      .questions = {{"fan400x200", "fan400x200.map", {14, 14}, {380, 179}}}};
  const Settings common{
      {"ants", "30"}, {"iterations", "100"}, {"neighbours", "8"}, {"polish", "none"}};
  for (const auto* name : {"as", "eas", "ras", "acs", "mmas"})
    grids.contenders.push_back({name, name, name, common});
  Settings off = common;
  off.emplace_back("alpha", "0");
  off.emplace_back("alpha_first", "0");
  grids.contenders.push_back({"no-pheromone", "as, pheromone off", "as", off});

  return {.name = "families",
          .summary = "ant system, elitist, rank, ACS and MAX-MIN side by side",
          .source = "Dorigo, Stuetzle: Ant Colony Optimization. MIT Press, 2004",
          .text = "",
          .experiments = {grids},
          .claims = {}};
}

}  // namespace lasius::study
