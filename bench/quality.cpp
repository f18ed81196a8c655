#include "bench/quality.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <thread>

#include "bench/statistics.h"
#include "core/exact/exact.h"
#include "core/grid/cell_distance.h"
#include "lasius/generate.h"

namespace lasius::bench {
namespace {

template <class Value>
std::vector<double> collect(const std::vector<QualityRun>& runs, Value QualityRun::*value) {
  std::vector<double> values;
  for (const QualityRun& run : runs) values.push_back(run.*value);
  return values;
}

QualityRun run_once(const Planner& planner, const Course& course, const Params& params,
                    double optimum, Workspace& workspace) {
  QualityRun run;
  double shortest = std::numeric_limits<double>::infinity();
  const Result result = planner.plan({course.start, course.goal}, params, &workspace,
                                     [&](const GridProgress& progress) {
                                       for (int ant = 0; ant < progress.ants(); ++ant) {
                                         const auto tour = progress.tour(ant);
                                         const double length = length_of(tour);
                                         if (tour.empty() || length >= shortest) continue;
                                         shortest = length;
                                         run.last_as_walked = progress.iteration + 1;
                                       }
                                     });
  run.gap = result.path.empty() ? std::numeric_limits<double>::infinity()
                                : (result.length - optimum) / optimum;
  for (std::size_t q = 0; q < result.best.size(); ++q) {
    // Not a number before the first path, which makes the first comparison false.
    const bool same = q > 0 && result.best[q] >= result.best[q - 1];
    if (!std::isnan(result.best[q]) && !same) run.last_improvement = static_cast<int>(q) + 1;
  }
  const int arrived = std::accumulate(result.arrived.begin(), result.arrived.end(), 0);
  run.arrived =
      static_cast<double>(arrived) / (static_cast<double>(params.ants) * result.iterations);
  return run;
}

// The free cell nearest to a corner of the map, along its diagonal.
Cell first_free(const Grid& grid, Cell from, int step) {
  while (grid.blocked(from)) from = {from.x + step, from.y + step};
  return from;
}

}  // namespace

double Quality::median_gap() const { return median(collect(runs, &QualityRun::gap)); }
double Quality::worst_gap() const { return largest(collect(runs, &QualityRun::gap)); }
double Quality::median_last_improvement() const {
  return median(collect(runs, &QualityRun::last_improvement));
}
double Quality::median_last_as_walked() const {
  return median(collect(runs, &QualityRun::last_as_walked));
}
double Quality::least_arrived() const { return quantile(collect(runs, &QualityRun::arrived), 0); }

Quality measure_quality(const Course& course, const Params& params, int seeds) {
  ExactSearch exact;
  ExactAnswer answer;
  exact.search(course.grid, course.start, course.goal, {}, {}, answer);
  Quality quality{course.name, answer.length, {}};
  quality.runs.resize(static_cast<std::size_t>(seeds));
  const Planner planner(course.grid);
  std::atomic<int> next{0};
  const auto work = [&] {
    Workspace workspace;
    Params seeded = params;
    seeded.threads = 1;
    for (int i = next++; i < seeds; i = next++) {
      seeded.seed = static_cast<std::uint64_t>(i) + 1;
      quality.runs[i] = run_once(planner, course, seeded, answer.length, workspace);
    }
  };
  {
    std::vector<std::jthread> team(std::max(1u, std::thread::hardware_concurrency()));
    for (auto& member : team) member = std::jthread(work);
  }
  return quality;
}

Params without_pheromone(Params params) {
  params.pheromone_rule_first = params.pheromone_rule = 0;
  params.combined_rule_first = params.combined_rule = 0;
  params.distance_rule_first = params.distance_rule = 1;
  return params;
}

std::vector<Course> blobs_courses(int count, std::uint64_t seed, int width, int height) {
  std::vector<Course> courses;
  for (std::uint64_t s = seed; static_cast<int>(courses.size()) < count; ++s) {
    Grid grid = generate(MapKind::blobs, {width, height, -1, s});
    const Cell start = first_free(grid, {10, 10}, 1);
    const Cell goal = first_free(grid, {width - 11, height - 11}, -1);
    if (!Planner(grid).connected(start, goal)) continue;
    courses.push_back({"blobs, seed " + std::to_string(s), std::move(grid), start, goal});
  }
  return courses;
}

}  // namespace lasius::bench
