// System E1.1: how many moves an ant should have.
#include "tools/study/claims.h"
#include "tools/study/study.h"

namespace lasius::study {
namespace {

/// The same colony with every neighbourhood; eight, the usual one, first.
std::vector<Contender> contenders(const char* polish) {
  std::vector<Contender> all;
  for (const std::string moves : {"8", "4", "16", "16k", "24", "32"})
    all.push_back({"moves" + moves,
                   moves + " neighbours",
                   "lecture-grid",
                   {{"neighbours", moves},
                    {"heuristic", "goal-angle"},
                    {"visibility", "none"},
                    {"beta", "5"},
                    {"beta_first", "5"},
                    {"polish", polish}}});
  all.push_back(all.front());
  all.back().name = "no-pheromone";
  all.back().label = "8 neighbours, pheromone off";
  all.back().settings.emplace_back("alpha", "0");
  all.back().settings.emplace_back("alpha_first", "0");
  return all;
}

std::vector<Question> questions() {
  return {
      {"workspace-simple", "workspace-simple.pbm", {20, 55}, {460, 455}},
      {"workspace-relatively-complex", "workspace-relatively-complex.pbm", {20, 55}, {460, 455}},
      {"workspace-complex", "workspace-complex.pbm", {20, 55}, {460, 455}},
      {"fan400x200", "fan400x200.map", {14, 14}, {380, 179}},
      {"grid30b", "grid30b.map", {0, 29}, {29, 0}}};
}

}  // namespace

Study neighbourhoods() {
  Experiment raw{.name = "raw",
                 .title = "Paths as the ants walk them",
                 .text =
                     "lecture-grid by the angle to the goal, 30 ants, 50 iterations, no polish. "
                     "The optimum is the any-angle one: no neighbourhood need reach it.",
                 .contenders = contenders("none"),
                 .questions = questions()};
  Experiment straight{.name = "straight",
                      .title = "Paths pulled straight",
                      .text = "The same with each path pulled straight.",
                      .contenders = contenders("straight"),
                      .questions = questions()};
  return {.name = "neighbourhoods",
          .summary = "4, 8, 16, 16k, 24 and 32 moves: length against time",
          .source =
              "Lecture on ant algorithms for robot path planning, grid part (in Russian): "
              "4, 8, 16, 24 and 32 possible moves",
          .text =
              "16k, the 8 moves and the knight's, is not the lecture's: its 16 moves only "
              "lengthen strides.",
          .experiments = {raw, straight},
          .claims = {{"More possible moves give shorter paths: 24 against 8.",
                      shorter_everywhere({"raw"}, "moves24", "moves8"),
                      "more moves spread the ants' draws over more cells"},
                     {"The same for 32 against 8.",
                      shorter_everywhere({"raw"}, "moves32", "moves8"), "as above"},
                     {"16 moves, which bring no new direction, against 8.",
                      shorter_everywhere({"raw"}, "moves16", "moves8"),
                      "no path of 16 moves is shorter than the best one of 8"},
                     {"The knight's moves against 8.",
                      shorter_everywhere({"raw"}, "moves16k", "moves8"), ""},
                     {"More moves cost time: 8 is faster than 24.",
                      faster_everywhere({"raw"}, "moves8", "moves24", 1),
                      "longer strides mean fewer steps a path"},
                     {"After straightening 24 moves are still shorter than 8.",
                      shorter_everywhere({"straight"}, "moves24", "moves8"),
                      "straightening takes out what the directions of the grid cost"}}};
}

}  // namespace lasius::study
