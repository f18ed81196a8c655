#include "tools/study/bitmaps.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lasius/path/shortest_walk.h"
#include "tools/console/values.h"
#include "tools/study/map_source.h"

namespace lasius::study {
namespace {

constexpr std::string_view kExact = "exact";
constexpr double kPilotShare = 0.125;  ///< as pilot_part()

/// What costs are made of, beside layers.
std::string inflation_key(const Question& question) {
  if (!question.inflation) return {};
  const auto [radius, scaling, weight, inscribed] = *question.inflation;
  return " inflation " + tool::to_text(radius) + ',' + tool::to_text(scaling) + ',' +
         tool::to_text(weight);
}

std::string question_key(const Grid& grid, std::uint64_t costs, const Question& question,
                         const std::string& algorithm) {
  std::string key = "map " + std::to_string(grid.hash());
  for (const int v : {question.start.x, question.start.y, question.goal.x, question.goal.y})
    key += ' ' + std::to_string(v);
  // What `exact` may do depends on more than the grown map.
  if (question.radius > 0) key += " radius " + tool::to_text(question.radius);
  key += inflation_key(question);
  if (!question.layers.empty()) key += " costs " + std::to_string(costs);
  return key + ' ' + algorithm;
}

std::string costs_key(const Question& question) {
  const auto [ground, radius] = question.ground();
  return ground + " radius " + tool::to_text(radius) + inflation_key(question);
}

/// What a walk by eight moves costs at least, if there is one.
std::optional<double> cheapest_walk(const CostPlanner& planner, const Question& question,
                                    Corners corners, const StopCondition& stop) {
  // Over the cells that a disc's centre may walk on, as those of a point.
  const CostResult walk = planner.plan({question.start, question.goal, stop},
                                       {.eight_moves = true, .corners = corners});
  return walk.path.empty() ? std::nullopt : std::optional(walk.cost);
}

/// Of a budget, where there is one: nothing is said of none.
std::string budget_key(const Budget& budget) {
  std::string key;
  if (std::isfinite(budget.steps)) key += " steps<=" + tool::to_text(budget.steps);
  if (std::isfinite(budget.seconds)) key += " seconds<=" + tool::to_text(budget.seconds);
  return key;
}

/// Ends a run when its budget is spent.
class BudgetWatch {
 public:
  BudgetWatch(const Budget& budget, double share, double begin)
      : steps_(budget.steps * share), seconds_(budget.seconds * share), begin_(begin) {}

  /// An algorithm without iterations is stopped by the clock on the wall.
  StopCondition stop(const std::stop_token& token, const Params& params) const {
    StopCondition condition{.token = token};
    if (find_algorithm(params.algorithm()).kind == Algorithm::Kind::exact)
      condition.deadline = deadline_in(std::chrono::duration<double>(seconds_));
    return condition;
  }
  Observer observer() {
    if (!std::isfinite(steps_) && !std::isfinite(seconds_)) return {};
    return [this](const GridProgress& progress) {
      if (progress.curves == nullptr) return Go::on;
      const auto& steps = progress.curves->steps;
      for (; seen_ < steps.size(); ++seen_) spent_ += static_cast<double>(steps[seen_]);
      fired_ = spent_ >= steps_ || thread_seconds() - begin_ >= seconds_;
      return fired_ ? Go::stop : Go::on;
    };
  }
  bool fired() const { return fired_; }

 private:
  double steps_, seconds_, begin_, spent_ = 0;
  std::size_t seen_ = 0;
  bool fired_ = false;
};

}  // namespace

Params params_of(const Contender& contender) {
  return configured(Params(contender.algorithm, contender.preset), contender);
}

std::optional<double> true_optimum(const Planner& planner, const Question& question,
                                   const Optimum& optimum, const StopCondition& stop) {
  if (optimum.kind == Optimum::Kind::moves)
    return shortest_walk(planner.passable(), question.start, question.goal, optimum.neighbours,
                         optimum.corners, stop);
  const Result result = planner.plan({question.start, question.goal, stop}, Params(kExact));
  if (!result.optimal) return std::nullopt;
  return result.length;
}

Bitmaps::Bitmaps(const Study& study, const std::filesystem::path& maps) {
  for (const Experiment& experiment : study.experiments)
    for (const Question& question : experiment.questions) {
      const bool known = planners_.contains(question.ground());
      if (known && (!question.has_costs() || over_costs_.contains(costs_key(question)))) continue;
      auto [map, costs] = load_weighted_map(question, maps);
      if (question.inflation) costs.add(map.grid, *question.inflation);
      if (!known)
        planners_.emplace(question.ground(), Planner(std::move(map.grid), Disc{question.radius}));
      if (question.has_costs())
        over_costs_.emplace(costs_key(question),
                            OverCosts{{planners_.at(question.ground()), costs}, costs.hash()});
    }
}

PreparedRun Bitmaps::prepare(const Question& question, const Contender& contender) const {
  const Params params = params_of(contender);
  const Planner& planner = planners_.at(question.ground());
  const OverCosts* const over =
      question.has_costs() ? &over_costs_.at(costs_key(question)) : nullptr;
  const CostPlanner* const costs = over != nullptr ? &over->planner : nullptr;
  const Grid& grid = planner.passable();
  PreparedRun prepared =
      run_of(question_key(grid, over != nullptr ? over->hash : 0, question, params.algorithm()) +
                 budget_key(contender.budget),
             params, find_algorithm(params.algorithm()).parameters, grid.width() + grid.height());
  if (std::isfinite(contender.budget.steps))
    prepared.work = std::min(prepared.work, static_cast<std::int64_t>(contender.budget.steps));
  prepared.run = [&planner, costs, &question, params, limit = shortest(question, params),
                  budget = contender.budget](std::uint64_t seed, bool pilot,
                                             const std::stop_token& stop, Workspace& workspace) {
    Params seeded = params;
    seeded.seed = seed;
    if (pilot && find_algorithm(params.algorithm()).has("iterations"))
      seeded.iterations = pilot_part(params.iterations);
    Run run{.limit = limit};
    const double begin = thread_seconds();
    BudgetWatch watch(budget, pilot ? kPilotShare : 1, begin);
    const Request request{question.start, question.goal, watch.stop(stop, params)};
    double cost = kUnknown;
    const auto plan = [&]() -> Result {
      if (costs == nullptr)
        return planner.plan(request, seeded,
                            {.workspace = &workspace, .observer = watch.observer()});
      CostResult found = costs->plan(
          request, {.params = seeded, .workspace = &workspace, .observer = watch.observer()});
      cost = found.cost;
      return found;
    };
    Result result = plan();
    run.seconds = thread_seconds() - begin;
    run.status =
        watch.fired() && result.status == Status::interrupted ? Status::limit : result.status;
    run.length = costs != nullptr ? cost : result.length;
    run.iterations = result.curves.iterations;
    run.best = std::move(result.curves.best);
    run.mean = std::move(result.curves.mean);
    run.raw_best = std::move(result.curves.raw_best);
    run.cut_mean = std::move(result.curves.cut_mean);
    run.cut_best = std::move(result.curves.cut_best);
    run.band = std::move(result.curves.band);
    run.iteration_best = std::move(result.curves.iteration_best);
    run.steps_by.assign(result.curves.steps.begin(), result.curves.steps.end());
    run.steps =
        std::accumulate(result.curves.steps.begin(), result.curves.steps.end(), std::int64_t{0});
    run.path = std::move(result.path);
    return run;
  };
  return prepared;
}

/// The shortest walk of the contender's own moves; over costs the cheapest, of a point's eight.
double Bitmaps::shortest(const Question& question, const Params& params) const {
  if (question.has_costs()) {
    if (params.neighbours != Neighbours::eight || question.radius > 0) return kUnknown;
    return cheapest_walk(over_costs_.at(costs_key(question)).planner, question, params.corners, {})
        .value_or(kUnknown);
  }
  return shortest_walk(planners_.at(question.ground()).grid(), question.start, question.goal,
                       params.neighbours, params.corners)
      .value_or(kUnknown);
}

std::optional<double> Bitmaps::optimum(const Question& question, const Optimum& optimum,
                                       const StopCondition& stop) const {
  if (!question.has_costs())
    return true_optimum(planners_.at(question.ground()), question, optimum, stop);
  const CostPlanner& costs = over_costs_.at(costs_key(question)).planner;
  if (optimum.kind == Optimum::Kind::any_angle) {
    const CostResult least = costs.plan({question.start, question.goal, stop});
    return least.status == Status::solved ? std::optional(least.cost) : std::nullopt;
  }
  if (optimum.neighbours != Neighbours::eight || question.radius > 0) return std::nullopt;
  return cheapest_walk(costs, question, optimum.corners, stop);
}

}  // namespace lasius::study
