// System A: the bitmap of 400 x 200 pixels.
#include "tools/study/claims.h"
#include "tools/study/study.h"

namespace lasius::study {

Study fan2004() {
  const Contender colony{"colony", "fan2004", "fan2004"};
  const Contender no_pheromone{
      "no-pheromone", "fan2004, pheromone off", "fan2004", {{"alpha", "0"}, {"alpha_first", "0"}}};
  const Contender distance_only{
      "distance-only",
      "fan2004, distance rule alone",
      "fan2004",
      {{"pheromone_rule", "0"}, {"combined_rule", "0"}, {"distance_rule", "1"}}};
  const Contender ga{"ga",
                     "grid-ga",
                     "grid-ga",
                     {{"population", "10"}, {"neighbours", "4"}, {"iterations", "120"}}};

  Experiment bitmap{
      .name = "bitmap",
      .title = "The bitmap of 400 x 200 pixels (figures 2 to 5)",
      .text =
          "10 ants, critical time 10, persistence 0.7, 120 iterations, as in section 4 of the "
          "source. The source's bitmap is not published; maps/fan400x200.map has its size, its "
          "many irregular obstacles, and its start and goal corners. The source prints no "
          "length. With the pheromone off every step draws among the same rules with all "
          "pheromone equal; the second control takes every step by the distance rule alone.",
      .contenders = {colony, no_pheromone, distance_only, ga, tenfold(no_pheromone),
                     tenfold(distance_only), tenfold(ga)},
      .questions = {{"fan400x200",
                     "fan400x200.map",
                     {14, 14},
                     {380, 179},
                     {{.contender = "colony", .iterations = 70}}}},
      .portrait = true};

  Experiment others{
      .name = "other-bitmaps",
      .title = "Other bitmaps of the same kind",
      .text =
          "maps/fan400x200.map was picked for an optimum that turns little, where this "
          "algorithm does well: no fair sample. These are the first eight seeds of the same "
          "generator that are free at both ends and join them.",
      .contenders = {colony, no_pheromone, distance_only, ga, tenfold(ga)},
      .questions = {}};
  for (const char* seed : {"2", "4", "8", "9", "10", "12", "14", "16"})
    others.questions.push_back({std::string("blobs") + seed,
                                std::string("blobs 400x200 0.33 ") + seed,
                                {14, 14},
                                {380, 179}});

  return {
      .name = "fan2004",
      .summary = "the flagship on a bitmap of 400 x 200 with irregular obstacles",
      .source =
          "Fan Xiaoping, Luo Xiong, Yi Sheng, Zhang Hang: Path planning for robots based on "
          "ant colony optimization algorithm under complex environment. Control and "
          "Decision 19 (2), 2004, 166-170",
      .text = "Lengths are of the straightened paths, optima the exact any-angle ones.",
      .experiments = {bitmap, others},
      .claims = {{"No better path is found from iteration 70 to 120 (figure 5: one run).",
                  converged_by({"bitmap"}, "colony", 70),
                  "one run of the source against many of ours: straightened paths keep improving "
                  "by fractions of a percent"},
                 {"After the critical time pheromone leads the ants to shorter paths.",
                  shorter_everywhere({"bitmap", "other-bitmaps"}, "colony", "no-pheromone"),
                  "straightening does most of the work on each ant's path, and pheromone narrows "
                  "the choice of paths to straighten"},
                 {"The same against the distance rule alone.",
                  shorter_everywhere({"bitmap", "other-bitmaps"}, "colony", "distance-only"),
                  "as above"}}};
}

}  // namespace lasius::study
