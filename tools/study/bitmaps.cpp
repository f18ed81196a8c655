#include "tools/study/bitmaps.h"

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
  return configured(Params(contender.algorithm), contender);
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
  task.run = [&planner, &question, params](std::uint64_t seed, const std::stop_token& stop,
                                           Workspace& workspace) {
    Params seeded = params;
    seeded.seed = seed;
    const double begin = thread_seconds();
    Result result =
        planner.plan({question.start, question.goal, {.token = stop}}, seeded, &workspace);
    return Run{.status = result.status,
               .length = result.length,
               .iterations = result.iterations,
               .seconds = thread_seconds() - begin,
               .best = std::move(result.best),
               .path = std::move(result.path)};
  };
  return task;
}

std::optional<double> Bitmaps::optimum(const Question& question, const Truth& truth,
                                       const StopCondition& stop) const {
  return true_optimum(planners_.at(question.map), question, truth, stop);
}

}  // namespace lasius::study
