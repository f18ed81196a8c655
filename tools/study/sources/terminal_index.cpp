// System B: the terminal index on small grids.
#include "tools/study/claims.h"
#include "tools/study/study.h"

namespace lasius::study {
namespace {

Experiment grids(std::string name, std::string title, std::vector<Question> questions) {
  const Contender index{"index", "terminal-index", "terminal-index"};
  const Contender dying{
      "index-kill", "terminal-index, ants die", "terminal-index", {{"dead_end", "kill"}}};
  const Contender off{"no-index",
                      "terminal-index, index off",
                      "terminal-index",
                      {{"alpha", "0"}, {"alpha_first", "0"}}};
  const Contender classic{"as", "as, pheromone on arcs", "as"};
  const Contender on_cells{
      "as-cells",
      "as, pheromone on cells",
      "as",
      {{"trail", "cells"}, {"beta", "2"}, {"beta_first", "2"}, {"persistence", "0.9"}}};
  const Contender ga{"ga", "grid-ga", "grid-ga", {{"population", "30"}, {"polish", "none"}}};
  return {.name = std::move(name),
          .title = std::move(title),
          .text =
              "8 moves, no corner cut, 30 ants, 100 iterations. The source gives no parameters "
              "of its classic ant system: one with pheromone on arcs (beta 5, evaporation 0.3) "
              "and a weaker one on cells (beta 2, evaporation 0.1) stand for it. With the "
              "index off a step draws by distance alone; the generation's answer still follows "
              "the index.",
          .truth = {Truth::Kind::moves, Neighbours::eight, Corners::forbid},
          .contenders = {index, dying, off, classic, on_cells, ga, tenfold(classic),
                         tenfold(on_cells), tenfold(ga)},
          .questions = std::move(questions)};
}

}  // namespace

Study terminal_index() {
  const std::vector<Published> on20{
      {"index", 30.97, 3}, {"index-kill", 30.97, 3}, {"as", 30.97, 43}, {"as-cells", 30.97, 43}};
  Experiment small = grids("grid20", "Grids of 20 x 20 (figures 8 to 10)",
                           {{"grid20a", "grid20a.map", {0, 19}, {19, 0}, on20},
                            {"grid20b", "grid20b.map", {0, 19}, {19, 0}}});
  Experiment large = grids(
      "grid30", "Grids of 30 x 30 (figures 11 to 13, tables 1 and 2)",
      {{"grid30a", "grid30a.map", {0, 29}, {29, 0}}, {"grid30b", "grid30b.map", {0, 29}, {29, 0}}});
  return {
      .name = "terminal-index",
      .summary = "terminal index against the classic ant system on 20 x 20 and 30 x 30",
      .source =
          "Li Dongdong, Wang Lei, Ma Kangkang: an ant colony algorithm with a terminal index "
          "(Anhui Polytechnic University)",
      .text =
          "The source's grids are known as pictures only. Ours have their size and kind; "
          "grid20a has the optimum of the source's worked example, 30.97.",
      .experiments = {small, large},
      .claims = {
          {"The optimum of the 20 x 20 grid is found at generation 3.",
           optimum_by({"grid20"}, "index", 3, 5),
           "an index near the start needs ants that pass it"},
          {"The same with ants that die when they are stuck, as the source has it.",
           optimum_by({"grid20"}, "index-kill", 3, 5),
           "most ants of a generation die before they reach the goal, so the index spreads slowly"},
          {"It converges sooner than the classic ant system.",
           sooner_everywhere({"grid20", "grid30"}, "index", "as"), ""},
          {"On 30 x 30 it finds shorter paths than the classic ant system.",
           shorter_everywhere({"grid30"}, "index", "as"),
           "with pheromone on arcs and beta 5 the classic system finds the optimum as well"},
          {"The same against the classic system with pheromone on cells.",
           shorter_everywhere({"grid30"}, "index", "as-cells"), ""},
          {"30 runs on 30 x 30 all find the same path, about as soon.",
           optimum_by({"grid30"}, "index", 10, 20), ""},
          {"Drawing by the index is what helps: sooner than with the index off.",
           sooner_everywhere({"grid20", "grid30"}, "index", "no-index"),
           "the answer of a generation joins the best known ways whether or not ants draw by them"},
          {"The best length never rises again.", never_rises({"grid20", "grid30"}, "index"), ""}}};
}

}  // namespace lasius::study
