#include "tools/study/bitmaps.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lasius/shortest_walk.h"
#include "tools/study/map_source.h"

namespace lasius::study {
namespace {

constexpr std::string_view kExact = "exact";

std::string question_key(const Grid& grid, const Question& question, const std::string& algorithm) {
  std::string key = "map " + std::to_string(grid.hash());
  for (const int v : {question.start.x, question.start.y, question.goal.x, question.goal.y})
    key += ' ' + std::to_string(v);
  return key + ' ' + algorithm;
}

}  // namespace

Params params_of(const Contender& contender) {
  return configured(Params(contender.algorithm, contender.preset), contender);
}

std::optional<double> true_optimum(const Planner& planner, const Question& question,
                                   const Truth& truth, const StopCondition& stop) {
  if (truth.kind == Truth::Kind::moves)
    return shortest_walk(planner.grid(), question.start, question.goal, truth.neighbours,
                         truth.corners, stop);
  const Result result = planner.plan({question.start, question.goal, stop}, Params(kExact));
  if (!result.optimal) return std::nullopt;
  return result.length;
}

Bitmaps::Bitmaps(const Study& study, const std::filesystem::path& maps) {
  for (const Experiment& experiment : study.experiments)
    for (const Question& question : experiment.questions)
      if (!planners_.contains(question.map))
        planners_.emplace(question.map, Planner(load_map(question.map, maps)));
}

Task Bitmaps::task(const Question& question, const Contender& contender) const {
  const Params params = params_of(contender);
  const Planner& planner = planners_.at(question.map);
  const Grid& grid = planner.grid();
  Task task =
      task_of(question_key(grid, question, params.algorithm()), params,
              parameters_of(algorithms(), params.algorithm()), grid.width() + grid.height());
  task.run = [&planner, &question, params, limit = shortest(question, params)](
                 std::uint64_t seed, bool pilot, const std::stop_token& stop,
                 Workspace& workspace) {
    Params seeded = params;
    seeded.seed = seed;
    if (pilot) seeded.iterations = pilot_part(params.iterations);
    Run run{.limit = limit};
    const double begin = thread_seconds();
    Result result =
        planner.plan({question.start, question.goal, {.token = stop}}, seeded, &workspace);
    run.seconds = thread_seconds() - begin;
    run.status = result.status;
    run.length = result.length;
    run.iterations = result.iterations;
    run.best = std::move(result.best);
    run.mean = std::move(result.mean);
    run.raw_best = std::move(result.raw_best);
    run.cut_mean = std::move(result.cut_mean);
    run.cut_best = std::move(result.cut_best);
    run.band = std::move(result.band);
    run.iteration_best = std::move(result.iteration_best);
    run.steps_by.assign(result.steps.begin(), result.steps.end());
    run.steps = std::accumulate(result.steps.begin(), result.steps.end(), std::int64_t{0});
    run.path = std::move(result.path);
    return run;
  };
  return task;
}

/// The shortest walk of the contender's own moves.
double Bitmaps::shortest(const Question& question, const Params& params) const {
  return shortest_walk(planners_.at(question.map).grid(), question.start, question.goal,
                       params.neighbours, params.corners)
      .value_or(kUnknown);
}

std::optional<double> Bitmaps::optimum(const Question& question, const Truth& truth,
                                       const StopCondition& stop) const {
  return true_optimum(planners_.at(question.map), question, truth, stop);
}

}  // namespace lasius::study
