// System C: one ant at a time on mazes and random maps.
#include "tools/study/claims.h"
#include "tools/study/study.h"

namespace lasius::study {
namespace {

constexpr int kRuns = 10;  // of which the source reports the best

std::vector<Contender> contenders(int ants) {
  const std::string number = std::to_string(ants);
  const Settings one{{"iterations", number}};
  const auto with = [&](Settings more) {
    more.insert(more.begin(), one.begin(), one.end());
    return more;
  };
  const int generations = ants / 10;
  return {{"colony", "cong2009", "cong2009", one},
          {"affine", "cong2009, other reading of eq. 3", "cong2009",
           with({{"reward_reading", "affine"}})},
          {"no-pheromone", "cong2009, pheromone off", "cong2009",
           with({{"alpha", "0"}, {"alpha_first", "0"}})},
          {"blind", "cong2009, pheromone and learning off", "cong2009",
           with({{"alpha", "0"}, {"alpha_first", "0"}, {"beta", "0"}, {"beta_first", "0"}})},
          {"ga",
           "grid-ga",
           "grid-ga",
           {{"population", "10"},
            {"iterations", std::to_string(generations)},
            {"neighbours", "4"},
            {"polish", "none"}}}};
}

void add_tenfold(std::vector<Contender>& all) {
  const std::size_t count = all.size();
  for (std::size_t i = 2; i < count; ++i) all.push_back(tenfold(all[i]));
}

Experiment experiment(std::string name, std::string title, std::string text, int ants,
                      std::vector<Question> questions) {
  Experiment e{.name = std::move(name),
               .title = std::move(title),
               .text = std::move(text),
               .truth = {Truth::Kind::moves, Neighbours::four, Corners::forbid},
               .contenders = contenders(ants),
               .questions = std::move(questions)};
  add_tenfold(e.contenders);
  return e;
}

/// From the bottom left corner to the top right one.
Question corner_to_corner(std::string name, std::string map, int side) {
  return {std::move(name), std::move(map), {0, side - 1}, {side - 1, 0}};
}

/// Random maps with a quarter of the cells blocked; the first seeds that join the corners.
Experiment random_maps(int side, int ants, const std::vector<int>& seeds) {
  const std::string size = std::to_string(side) + "x" + std::to_string(side);
  std::vector<Question> questions;
  for (const int seed : seeds)
    questions.push_back(corner_to_corner("random" + size + "-" + std::to_string(seed),
                                         "random " + size + " 0.25 " + std::to_string(seed), side));
  return experiment("random" + std::to_string(side), "Random maps of " + size,
                    std::to_string(ants) + " ants, one at a time; a quarter of the cells blocked.",
                    ants, std::move(questions));
}

}  // namespace

Study cong2009() {
  Experiment mazes = experiment(
      "mazes", "Eight mazes of 10 x 10 to 32 x 32 (figures 5 to 8)",
      "1000 ants, one at a time. Each maze has at least three loops and a second route at most 10% "
      "longer than the best one.",
      1000, {});
  mazes.by_ant = true;
  const std::pair<const char*, int> files[] = {
      {"maze1-10x10", 10}, {"maze2-10x10", 10}, {"maze3-12x12", 12}, {"maze4-16x16", 16},
      {"maze5-16x16", 16}, {"maze6-20x20", 20}, {"maze7-24x24", 24}, {"maze8-32x32", 32}};
  for (const auto& [name, side] : files)
    mazes.questions.push_back(corner_to_corner(name, std::string(name) + ".map", side));

  return {
      .name = "cong2009",
      .summary = "one ant at a time with a learned heuristic, on mazes and random maps",
      .source =
          "Cong, Ponnambalam: Mobile robot path planning using ant colony optimization. "
          "IEEE/ASME Int. Conf. on Advanced Intelligent Mechatronics, 2009",
      .text =
          "The source's maps SPSet01 to 08 and its table of lengths are lost, so no published "
          "length stands beside ours. 4 moves; the optimum is that of 4 moves.",
      .experiments = {mazes, random_maps(10, 100, {1, 3, 7, 9, 12, 13, 16, 19, 20}),
                      random_maps(16, 1000, {5, 8, 12, 15, 17, 18, 20, 21, 22}),
                      random_maps(20, 1000, {4, 6, 10, 11, 13, 15, 19, 20, 24}),
                      random_maps(32, 1000, {4, 6, 8})},
      .claims = {
          {"The best of 10 runs is never longer than that of a genetic algorithm, on the mazes.",
           best_never_longer({"mazes"}, "colony", "ga", kRuns),
           "ants that die in dead ends reach the far corner of the large mazes seldom or never"},
          {"The same on the random maps.",
           best_never_longer({"random10", "random16", "random20", "random32"}, "colony", "ga",
                             kRuns),
           "the genetic comparator walks greedily to the goal and so starts near the optimum"},
          {"The tours settle at the optimum: best of 10 runs on 10 x 10 with 100 ants.",
           best_is_optimal({"random10"}, "colony", kRuns, 9), ""},
          {"The same on 16 x 16 with 1000 ants, at least 7 of 9.",
           best_is_optimal({"random16"}, "colony", kRuns, 7), ""},
          {"The same on 20 x 20 with 1000 ants, at least 4 of 9.",
           best_is_optimal({"random20"}, "colony", kRuns, 4),
           "rewards multiply on the first path that arrives, and later ants repeat it"},
          {"The other reading of equation 3 on 16 x 16, at least 7 of 9.",
           best_is_optimal({"random16"}, "affine", kRuns, 7), ""},
          {"The other reading on 20 x 20, at least 4 of 9.",
           best_is_optimal({"random20"}, "affine", kRuns, 4), ""},
          {"On the mazes, all of them.", best_is_optimal({"mazes"}, "colony", kRuns, 8),
           "a rewarded detour outweighs what later ants find"},
          {"Pheromone and learning help: shorter than blind ants.",
           shorter_everywhere({"mazes", "random10", "random16", "random20", "random32"}, "colony",
                              "blind"),
           "where blind ants find a path at all, many of them can find a shorter one by chance"}}};
}

}  // namespace lasius::study
