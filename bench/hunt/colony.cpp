// Colonies: what they answer is a path, no shorter than the shortest, whatever the threads.
#include <optional>

#include "bench/hunt/drawing.h"
#include "lasius/base/error.h"
#include "lasius/plan/planner.h"
#include "tests/oracle/visibility_graph.h"

namespace lasius::bench {
namespace {

Params draw_colony(HuntDraw& draw) {
  const auto all = algorithms();
  const auto last = static_cast<int>(all.size()) - 1;
  const Algorithm* algorithm = nullptr;
  while (algorithm == nullptr || algorithm->kind == Algorithm::Kind::exact)
    algorithm = &all[static_cast<std::size_t>(draw.between(0, last))];
  Params params(algorithm->name);
  params.seed = draw.any() >> 12;
  params.iterations = draw.between(0, 6);
  if (algorithm->has("ants")) params.ants = draw.between(1, 9);
  if (algorithm->has("population")) params.population = draw.between(2, 12);
  // What is drawn is there for every algorithm, so that a problem cut down draws the same.
  const int neighbours = draw.between(0, 5), corners = draw.between(0, 1);
  const int polish = draw.between(0, 3), cut = draw.between(0, 2);
  const int islands = draw.between(1, 5), every = draw.between(1, 3);
  if (algorithm->has("neighbours") && neighbours < 2)
    params.neighbours = neighbours == 0 ? Neighbours::four : Neighbours::eight;
  if (algorithm->has("corners"))
    params.corners = corners == 0 ? Corners::forbid : Corners::one_side;
  if (algorithm->has("polish") && polish < 3) params.polish = static_cast<Polish>(polish);
  if (algorithm->has("walk_cut")) params.walk_cut = static_cast<WalkCut>(cut);
  if (algorithm->has("islands") && islands <= params.ants && islands > 1) {
    params.islands = islands;
    params.exchange_every = every;
  }
  return params;
}

}  // namespace

void judge_colony(const HuntCase& problem, HuntDraw& draw, HuntVerdict& verdict) {
  Params params = draw_colony(draw);
  const int threads = draw.between(2, 5);
  const Planner planner(Grid(problem.grid));
  const oracle::VisibilityGraph oracle(problem.grid);
  const Cell from = problem.places[0], to = problem.places[1];
  const auto best = oracle.shortest(from, to);
  const auto text = [&](const std::string& what) {
    return sentence(params.algorithm(), " with seed ", params.seed, ": ", what);
  };
  const auto run = [&](int count) -> std::optional<Result> {
    params.threads = count;
    try {
      return planner.plan({.start = from, .goal = to}, params);
    } catch (const Error& error) {
      if (error.code() != ErrorCode::invalid_parameter) throw;
      return {};  // these do not go together
    }
  };
  const auto one = run(1);
  if (!one) return;
  if (!best) {
    verdict.expect(one->status == Status::unreachable && one->path.empty(),
                   [&] { return text("a path where there is none"); });
    return;
  }
  verdict.expect(one->status == Status::solved || one->status == Status::no_path,
                 [&] { return text(std::string(to_string(one->status))); });
  if (!one->path.empty()) {
    const std::string fault =
        path_fault(problem.grid, one->path, centre(from), centre(to), one->length);
    verdict.expect(fault.empty() && one->length >= best->length - 1e-9, [&] {
      return text(sentence(fault, " length ", one->length, ", the shortest is ", best->length));
    });
  }
  const auto more = run(threads);
  verdict.expect(more->path == one->path && more->curves.steps == one->curves.steps,
                 [&] { return text("another answer with more threads"); });
}

}  // namespace lasius::bench
