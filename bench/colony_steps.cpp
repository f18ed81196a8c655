#include <functional>
#include <span>

#include "bench/clocks.h"
#include "bench/colony_figures.h"
#include "bench/peers/row_ceiling.h"
#include "bench/peers/textbook_ants.h"
#include "bench/report.h"
#include "bench/statistics.h"
#include "core/base/kernel_choice.h"
#include "core/colony/walk_setup.h"
#include "core/grid/move_rule.h"
#include "core/plan/workspace.h"
#include "lasius/grid/map_io.h"
#include "lasius/params/schedule.h"

namespace lasius::bench {
namespace {

constexpr int kAnts = 30;  // the default of `as`

double textbook_rate(std::uint32_t seed) {
  const Course& c = fan_course();
  peers::TextbookAnts ants(c.grid, c.start, c.goal, {.ants = kAnts, .seed = seed});
  const ProcessorStopwatch watch;
  while (watch.seconds() < 0.1) ants.iterate();
  return static_cast<double>(ants.steps()) / watch.seconds();
}

double ceiling_rate(peers::RowCeiling::Path path, int walkers) {
  static peers::RowCeiling ceiling(400, 200);
  constexpr std::int64_t kSteps = 1 << 20;
  std::int64_t steps = 0;
  std::uint64_t sum = 0;
  const ProcessorStopwatch watch;
  for (; watch.seconds() < 0.05; steps += kSteps) sum += ceiling.walk(path, walkers, kSteps);
  const double rate = static_cast<double>(steps) / watch.seconds();
  return sum == 0 ? 0 : rate;  // the sum keeps the walk from being optimised away
}

// The walks of a colony alone, tabu and tracks included, on its first rows of weights.
class WalkOnly {
 public:
  explicit WalkOnly(std::string_view algorithm, int ants = kAnts) : ants_(ants) {
    const Course& c = fan_course();
    Params params(algorithm);
    params.ants = ants;
    const kernels::Moves moves = moves_of(params.neighbours);
    const StepWeights weights = schedule(params, 0);
    field_.reset(c.grid, moves, c.goal, params, kFirstPheromone, {});
    field_.refresh(weights, 1);
    const kernels::WalkShape shape = walk_shape(params, moves, field_.mixture());
    world_ = walk_world(params, moves, c.start, c.goal);
    set_iteration(world_, params, moves, shape, weights, 0);
    field_.fill(world_);
    walkers_.reset(c.grid.width(), c.grid.height(), 1, ants, params.polish != Polish::none, {});
    kernel_ = kernels::walk_table(chosen_isa()).walk[shape.index()];
  }

  double rate(int round) {
    world_.seed = static_cast<std::uint64_t>(round);
    std::int64_t steps = 0;
    const ProcessorStopwatch watch;
    for (; watch.seconds() < 0.1; ++world_.iteration) {
      walkers_.walk(world_, kernel_, ants_, 0, {});
      for (const Ant& ant : ants_) steps += ant.steps;
    }
    return static_cast<double>(steps) / watch.seconds();
  }

 private:
  static constexpr double kFirstPheromone = 1;

  Field field_;
  kernels::WalkWorld world_;
  Walkers walkers_;
  kernels::WalkFn kernel_ = nullptr;
  std::vector<Ant> ants_;
};

// Whole plans on one thread: walks, updates, straightening. Colonies of one ant send as many ants,
// one an iteration.
double plan_rate(const Planner& planner, Params params, std::uint64_t seed) {
  static Workspace workspace;
  constexpr int kIterations = 10;
  const bool alone = params.ants == 1;
  params.threads = 1;
  params.ants = alone ? 1 : kAnts;
  params.iterations = alone ? kAnts * kIterations : kIterations;
  params.seed = seed;
  std::int64_t steps = 0;
  const Course& c = fan_course();
  const ProcessorStopwatch watch;
  planner.plan({c.start, c.goal}, params,
               {.workspace = &workspace, .observer = [&](const GridProgress&) {
                  const std::span ants(WorkspaceMemory::of(workspace).colony.ants);
                  for (const Ant& ant : ants.first(params.ants)) steps += ant.steps;
                }});
  return static_cast<double>(steps) / watch.seconds();
}

// Without polish, which is the same for all.
double variant_rate(const Planner& planner, std::string_view algorithm, int batch,
                    std::uint64_t seed) {
  Params params(algorithm);
  params.polish = Polish::none;
  params.straight_deposit = StraightDeposit::none;
  if (batch > 0) params.batch = batch;
  return plan_rate(planner, params, seed);
}

}  // namespace

const Course& fan_course() {
  static const Course course{
      "fan400x200", read_map(LASIUS_MAPS_DIR "/fan400x200.map").grid, {14, 14}, {380, 179}};
  return course;
}

std::vector<Figure> measure_steps(int rounds) {
  using Path = peers::RowCeiling::Path;
  const Planner planner(fan_course().grid);
  WalkOnly walk("as");
  struct Subject {
    std::string name;
    std::function<double(int)> rate;
    std::vector<double> rates;
  };
  std::vector<Subject> subjects = {
      {"textbook ant system", [](int r) { return textbook_rate(r + 1); }, {}},
      {"walks of `as`, 8 neighbours", [&](int r) { return walk.rate(r + 1); }, {}},
      {"whole plans of `as`", [&](int r) { return plan_rate(planner, Params("as"), r + 1); }, {}},
      {"whole plans of `fan2004`, 4 neighbours",
       [&](int r) { return plan_rate(planner, Params("fan2004"), r + 1); },
       {}},
      {"ceiling, 8 walkers", [](int) { return ceiling_rate(Path::walk, 8); }, {}},
      {"ceiling, 1 walker", [](int) { return ceiling_rate(Path::walk, 1); }, {}},
      {"ceiling, 8 walkers that jump", [](int) { return ceiling_rate(Path::jump, 8); }, {}}};
  for (int round = 0; round < rounds; ++round) {
    for (Subject& s : subjects) s.rates.push_back(s.rate(round));
  }
  std::vector<Figure> figures;
  for (const Subject& s : subjects) {
    figures.push_back({"steps/s, " + s.name, short_number(median(s.rates) / 1e6) + " M", ""});
  }
  const auto ratio = [&](std::size_t a, std::size_t b) {
    std::vector<double> ratios;
    for (int i = 0; i < rounds; ++i) ratios.push_back(subjects[a].rates[i] / subjects[b].rates[i]);
    return short_number(median(ratios));
  };
  figures.push_back({"walks of `as` / textbook", ratio(1, 0), ">= 20"});
  figures.push_back({"whole plans of `as` / textbook", ratio(2, 0), ""});
  figures.push_back({"whole plans of `fan2004` / textbook", ratio(3, 0), ""});
  figures.push_back({"walks of `as` / ceiling, 8 walkers", ratio(1, 4), ">= 0.5"});
  figures.push_back({"walks of `as` / ceiling, 1 walker", ratio(1, 5), ""});
  return figures;
}

std::vector<Figure> measure_variants(int rounds) {
  const Planner planner(fan_course().grid);
  WalkOnly flagship("fan2004"), lone_flagship("fan2004", 1);
  std::vector<Figure> figures;
  for (const Algorithm& algorithm : algorithms()) {
    if (algorithm.name == "exact" || algorithm.name == "grid-ga") continue;
    // Ants that go one at a time are set against the flagship's ants, one at a time.
    const Params usual(algorithm.name);
    const bool alone = usual.batch == 1 || usual.ants == 1;
    WalkOnly walk(algorithm.name, alone ? 1 : kAnts);
    std::vector<double> walks, walk_ratios, plans, plan_ratios;
    for (int round = 1; round <= rounds; ++round) {
      const double best_walk = (alone ? lone_flagship : flagship).rate(round);
      walks.push_back(walk.rate(round));
      walk_ratios.push_back(best_walk / walks.back());
      const int batch = alone ? 1 : 0;
      const double best_plan = variant_rate(planner, "fan2004", batch, round);
      plans.push_back(variant_rate(planner, algorithm.name, batch, round));
      plan_ratios.push_back(best_plan / plans.back());
    }
    const auto add = [&](const std::string& what, const std::vector<double>& rates,
                         const std::vector<double>& ratios) {
      figures.push_back({"fan2004 / `" + std::string(algorithm.name) + "`, steps/s of " + what +
                             " (" + short_number(median(rates) / 1e6) + " M)",
                         short_number(median(ratios)), "<= 2"});
    };
    add("walks", walks, walk_ratios);
    add("plans", plans, plan_ratios);
  }
  return figures;
}

}  // namespace lasius::bench
