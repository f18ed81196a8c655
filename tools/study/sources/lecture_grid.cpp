// System E1: the lecture's colony on workspaces of 500 x 500.
#include "tools/study/claims.h"
#include "tools/study/study.h"

namespace lasius::study {
namespace {

/// The reading of eta that arrives on large maps: the angle between the move and the way to the
/// goal.
Settings with_goal_angle(Settings settings) {
  for (const auto& setting : Settings{
           {"heuristic", "goal-angle"}, {"visibility", "none"}, {"beta", "5"}, {"beta_first", "5"}})
    settings.push_back(setting);
  return settings;
}

Settings plus(Settings settings, const Settings& more) {
  settings.insert(settings.end(), more.begin(), more.end());
  return settings;
}

/// Of one workspace: what the lecture's tables give.
struct Workspace {
  std::string name, title;
  int ants, ant_iterations, population, generations;
  double ant_seconds, ga_seconds;
  double ant_length[3], ga_length[3];  // by pair of points
};

std::vector<Contender> contenders(const Workspace& w, const char* polish) {
  const Settings swarm{{"ants", std::to_string(w.ants)},
                       {"iterations", std::to_string(w.ant_iterations)},
                       {"polish", polish}};
  const Settings family = plus(swarm, {{"neighbours", "8"}});
  const auto genes = [&](int population, int generations) {
    return Settings{{"population", std::to_string(population)},
                    {"iterations", std::to_string(generations)},
                    {"polish", polish}};
  };
  std::vector<Contender> all{
      {"colony", "lecture-grid, angle to the goal", "lecture-grid", with_goal_angle(swarm)},
      {"text", "lecture-grid, change of heading", "lecture-grid",
       plus(swarm, {{"dead_end", "kill"}})},
      {"no-pheromone", "lecture-grid, pheromone off", "lecture-grid",
       plus(with_goal_angle(swarm), {{"alpha", "0"}, {"alpha_first", "0"}})},
      {"ga", "grid-ga", "grid-ga", genes(w.ants, w.ant_iterations)},
      {"as", "as", "as", family},
      {"acs", "acs", "acs", family},
      {"mmas", "mmas", "mmas", family}};
  all.push_back(tenfold(all[3]));
  if (w.population > 0)
    all.push_back({"ga-own", "grid-ga, the lecture's population and generations", "grid-ga",
                   genes(w.population, w.generations)});
  return all;
}

Experiment workspace(const Workspace& w) {
  constexpr Cell kStarts[] = {{5, 50}, {20, 55}, {30, 65}};
  constexpr Cell kGoals[] = {{400, 450}, {460, 455}, {465, 460}};
  Experiment e{.name = w.name,
               .title = w.title,
               .text = std::to_string(w.ants) + " ants, " + std::to_string(w.ant_iterations) +
                       " iterations; the lecture's genetic algorithm has a population of " +
                       std::to_string(w.population) + " and " + std::to_string(w.generations) +
                       " generations. The lecture gives one time a workspace.",
               .contenders = contenders(w, "straight")};
  for (int i = 0; i < 3; ++i)
    e.questions.push_back({"pair" + std::to_string(i + 1),
                           "workspace-" + w.name + ".pbm",
                           kStarts[i],
                           kGoals[i],
                           {{"colony", w.ant_length[i], double(w.ant_iterations), w.ant_seconds},
                            {"ga-own", w.ga_length[i], double(w.generations), w.ga_seconds}}});
  return e;
}

Experiment free_spaces() {
  const Workspace small{"free-space", "", 30, 50, 0, 0, kUnknown, kUnknown, {}, {}};
  Experiment e{.name = small.name,
               .title = "The small free-space maps (figures 4 to 6)",
               .text =
                   "30 ants, 50 iterations, no polish: the grid's own paths. Only figure 6 is "
                   "legible; the two easier maps are ours.",
               .truth = {Truth::Kind::moves, Neighbours::eight, Corners::forbid},
               .contenders = contenders(small, "none")};
  for (const auto* name : {"simple", "average", "complex"})
    e.questions.push_back({name, std::string("free-space-") + name + ".map", {0, 9}, {9, 0}});
  return e;
}

}  // namespace

Study lecture_grid() {
  const Experiments all{"simple", "relatively-complex", "complex"};
  return {
      .name = "lecture-grid",
      .summary = "the lecture's colony against a genetic algorithm on three workspaces",
      .source =
          "Lecture on ant algorithms for robot path planning, grid part (in Russian); its "
          "tables of lengths, times, iterations and populations",
      .text =
          "The workspaces are lost; ours are of 500 x 500 cells with the same start and goal "
          "pairs, drawn so that the optimum lies up to 3% below the lecture's lengths: lengths "
          "compare within a row of ours, not between ours and the lecture's. All algorithms "
          "move by 8 neighbours and have their paths pulled straight. With the text's reading "
          "of the heuristic (change of heading) and ants that die in dead ends no ant need "
          "arrive; the reading by the angle to the goal, beta 5, is the one compared.",
      .experiments = {workspace({"simple",
                                 "Relatively simple workspace",
                                 20,
                                 30,
                                 20,
                                 50,
                                 47.721,
                                 1522.03,
                                 {610.34, 655.72, 648.62},
                                 {618.05, 659.69, 652.08}}),
                      workspace({"relatively-complex",
                                 "Relatively complex workspace",
                                 25,
                                 45,
                                 35,
                                 80,
                                 648.69,
                                 1865.28,
                                 {919.45, 711.28, 697.80},
                                 {923.04, 719.48, 707.09}}),
                      workspace({"complex",
                                 "Complex workspace",
                                 30,
                                 50,
                                 50,
                                 100,
                                 972.65,
                                 2560.42,
                                 {913.82, 718.59, 698.51},
                                 {921.03, 722.28, 703.79}}),
                      free_spaces()},
      .claims = {
          {"The colony's paths are shorter than the genetic algorithm's on 9 of 9, with the "
           "lecture's populations.",
           shorter_everywhere(all, "colony", "ga-own"),
           "the genetic comparator of today's literature is stronger than the lecture's: it starts "
           "from greedy paths and repairs loops"},
          {"The same with equal evaluations.", shorter_everywhere(all, "colony", "ga"), "as above"},
          {"The colony is many times faster (the lecture: 2.6 to 32 times).",
           faster_everywhere(all, "colony", "ga-own", 2.6),
           "an ant's walk draws every step at random and wanders; a crossing copies cells"},
          {"It needs fewer iterations to converge.", sooner_everywhere(all, "colony", "ga-own"),
           ""},
          {"Pheromone is what finds the short paths.",
           shorter_everywhere(all, "colony", "no-pheromone"),
           "the heuristic and straightening alone reach the same routes"},
          {"With the text's heuristic as printed the colony finds these paths, too.",
           shorter_everywhere(all, "text", "ga-own"),
           "without a sense of the goal ants wander and die in dead ends"}}};
}

}  // namespace lasius::study
