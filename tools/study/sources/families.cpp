// The classic update families side by side, on the maps of the other studies.
#include "tools/study/claims.h"
#include "tools/study/study.h"

namespace lasius::study {
namespace {

/// Equal numbers of paths for all; 10 ants for acs as in its source, 30 for the others.
std::vector<Contender> contenders(const char* polish) {
  constexpr int kPaths = 3000;
  const auto settings = [&](int ants, const char* paths_name) {
    return Settings{{paths_name, std::to_string(ants)},
                    {"iterations", std::to_string(kPaths / ants)},
                    {"neighbours", "8"},
                    {"polish", polish}};
  };
  std::vector<Contender> all{{"as", "as", "as", settings(30, "ants")},
                             {"eas", "eas", "eas", settings(30, "ants")},
                             {"ras", "ras", "ras", settings(30, "ants")},
                             {"acs", "acs", "acs", settings(10, "ants")},
                             {"mmas", "mmas", "mmas", settings(30, "ants")},
                             {"no-pheromone", "as, pheromone off", "as", settings(30, "ants")},
                             {"ga", "grid-ga", "grid-ga", settings(30, "population")}};
  for (const char* exponent : {"alpha", "alpha_first"}) all[5].settings.emplace_back(exponent, "0");
  return all;
}

}  // namespace

Study families() {
  Experiment grids{.name = "grids",
                   .title = "Small grids",
                   .text =
                       "3000 paths each, 8 moves, no corner cut, no polish; beta 5 and the "
                       "families' own evaporation.",
                   .truth = {Truth::Kind::moves, Neighbours::eight, Corners::forbid},
                   .contenders = contenders("none"),
                   .questions = {{"grid20a", "grid20a.map", {0, 19}, {19, 0}},
                                 {"grid20b", "grid20b.map", {0, 19}, {19, 0}},
                                 {"grid30a", "grid30a.map", {0, 29}, {29, 0}},
                                 {"grid30b", "grid30b.map", {0, 29}, {29, 0}},
                                 {"maze6-20x20", "maze6-20x20.map", {0, 19}, {19, 0}}}};
  Experiment large{
      .name = "large",
      .title = "Large maps",
      .text =
          "The same, every path pulled straight; ten times the budget for the genetic "
          "comparator only.",
      .contenders = contenders("straight"),
      .questions = {{"fan400x200", "fan400x200.map", {14, 14}, {380, 179}},
                    {"workspace-complex", "workspace-complex.pbm", {20, 55}, {460, 455}}}};
  return {
      .name = "families",
      .summary = "ant system, elitist, rank, ACS and MAX-MIN side by side",
      .source =
          "Dorigo, Stuetzle: Ant Colony Optimization. MIT Press, 2004, chapter 3; table I "
          "of the lecture on ant algorithms for robot path planning",
      .text =
          "The sources compare the families on the travelling salesman problem, where each "
          "later one is better than the ant system; no figures exist for grids.",
      .experiments = {grids, large},
      .claims = {{"The elitist ant system finds shorter paths than the ant system.",
                  shorter_everywhere({"grids", "large"}, "eas", "as"),
                  "small grids leave nothing to gain: both find the optimum"},
                 {"So does the rank-based one.",
                  shorter_everywhere({"grids", "large"}, "ras", "as"), "as above"},
                 {"So does ACS.", shorter_everywhere({"grids", "large"}, "acs", "as"),
                  "greedy steps repeat the first path found; as above on small grids"},
                 {"So does MAX-MIN.", shorter_everywhere({"grids", "large"}, "mmas", "as"),
                  "evaporation 0.02 needs more iterations than these 100"},
                 {"Pheromone helps the ant system at all.",
                  shorter_everywhere({"grids", "large"}, "as", "no-pheromone"),
                  "straightening and the distance to the goal do most of the work on large maps"}}};
}

}  // namespace lasius::study
