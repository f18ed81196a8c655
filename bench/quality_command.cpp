// lasius_bench quality: gap to the optimum over many seeds, with and without pheromone.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "bench/colony_figures.h"
#include "bench/commands.h"
#include "bench/report.h"
#include "bench/statistics.h"
#include "core/base/number_text.h"
#include "core/base/text_lines.h"
#include "core/exact/exact.h"
#include "core/grid/cell_distance.h"
#include "lasius/base/error.h"
#include "lasius/grid/generate.h"
#include "lasius/grid/map_io.h"

namespace lasius::bench {
namespace {

struct QualityOptions : Reported {
  std::string algorithm = "fan2004";
  int seeds = 30;
  int blobs = 20;
  std::uint64_t first_blobs = 1001;
  bool fan = true;
  std::vector<std::string> courses;  // FILE,X,Y,X,Y
};

/// One plan.
struct QualityRun {
  double gap = 0;            ///< (length - optimum) / optimum; infinite without a path
  int last_improvement = 0;  ///< iteration, from 1, that found the answer; 0 without one
  int last_as_walked = 0;    ///< that found the shortest of all tours, before any polish
  double arrived = 0;        ///< share of all ants of all iterations
};

/// One course under one set of parameters, a run a seed.
struct Quality {
  std::string course;
  double optimum = 0;
  std::vector<QualityRun> runs;

  double median_gap() const { return median(collect(&QualityRun::gap)); }
  double worst_gap() const { return largest(collect(&QualityRun::gap)); }
  double median_last_improvement() const { return median(collect(&QualityRun::last_improvement)); }
  double median_last_as_walked() const { return median(collect(&QualityRun::last_as_walked)); }
  double least_arrived() const { return quantile(collect(&QualityRun::arrived), 0); }

 private:
  template <class Value>
  std::vector<double> collect(Value QualityRun::*value) const {
    std::vector<double> values;
    for (const QualityRun& run : runs) values.push_back(run.*value);
    return values;
  }
};

QualityRun run_once(const Planner& planner, const Course& course, const Params& params,
                    double optimum, Workspace& workspace) {
  QualityRun run;
  double shortest = std::numeric_limits<double>::infinity();
  const Result result =
      planner.plan({course.start, course.goal}, params,
                   {.workspace = &workspace, .observer = [&](const GridProgress& progress) {
                      for (int ant = 0; ant < progress.ants(); ++ant) {
                        const auto tour = progress.tour(ant);
                        const double length = length_of(tour);
                        if (tour.empty() || length >= shortest) continue;
                        shortest = length;
                        run.last_as_walked = progress.iteration + 1;
                      }
                    }});
  run.gap = result.path.empty() ? std::numeric_limits<double>::infinity()
                                : (result.length - optimum) / optimum;
  for (std::size_t q = 0; q < result.curves.best.size(); ++q) {
    // Not a number before the first path, which makes the first comparison false.
    const bool same = q > 0 && result.curves.best[q] >= result.curves.best[q - 1];
    if (!std::isnan(result.curves.best[q]) && !same) run.last_improvement = static_cast<int>(q) + 1;
  }
  const int arrived =
      std::accumulate(result.curves.arrived.begin(), result.curves.arrived.end(), 0);
  run.arrived =
      static_cast<double>(arrived) / (static_cast<double>(params.ants) * result.curves.iterations);
  return run;
}

// The free cell nearest to a corner of the map, along its diagonal; nothing where there is none.
std::optional<Cell> first_free(const Grid& grid, Cell from, int step) {
  for (; grid.contains(from); from = {from.x + step, from.y + step})
    if (grid.free(from)) return from;
  return std::nullopt;
}

/// Plans the course with seeds 1 .. `seeds`, one thread a plan and as many plans at a time as there
/// are cores. The optimum is that of the exact search.
Quality measure_quality(const Course& course, const Params& params, int seeds) {
  ExactSearch exact;
  ExactAnswer answer;
  exact.search(course.grid, centre(course.start), centre(course.goal), {}, {}, answer);
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

/// Parameters with pheromone switched off: the rule that reads distances only, as in the
/// first iteration. What is left is random walks that know the way, and straightening.
Params without_pheromone(Params params) {
  params.pheromone_rule_first = params.pheromone_rule = 0;
  params.combined_rule_first = params.combined_rule = 0;
  params.distance_rule_first = params.distance_rule = 1;
  return params;
}

/// `count` generated blobs maps with a query from corner to corner, seeds from `seed`.
std::vector<Course> blobs_courses(int count, std::uint64_t seed) {
  constexpr int kWidth = 400, kHeight = 200;
  std::vector<Course> courses;
  for (std::uint64_t s = seed; static_cast<int>(courses.size()) < count; ++s) {
    Grid grid = generate(MapKind::blobs, {kWidth, kHeight, -1, s});
    const auto start = first_free(grid, {10, 10}, 1);
    const auto goal = first_free(grid, {kWidth - 11, kHeight - 11}, -1);
    if (!start || !goal || !Planner(grid).connected(*start, *goal)) continue;
    courses.push_back({"blobs, seed " + std::to_string(s), std::move(grid), *start, *goal});
  }
  return courses;
}

Course parse_course(const std::string& text) {
  const auto parts = words_of(text, ",");
  std::array<int, 4> cells{};
  bool good = parts.size() == 1 + cells.size() && std::ranges::count(text, ',') == 4;
  for (std::size_t i = 0; good && i < cells.size(); ++i) {
    const auto number = number_of<int>(parts[i + 1]);
    good = number.has_value();
    cells[i] = number.value_or(0);
  }
  if (!good)
    throw Error(ErrorCode::invalid_parameter, "course " + text + " is not FILE,X,Y,X,Y",
                "give a map, and two cells in whole numbers");
  const std::string file(parts[0]);
  return {file.substr(file.find_last_of('/') + 1),
          read_map(file).grid,
          {cells[0], cells[1]},
          {cells[2], cells[3]}};
}

std::string percent(double share) { return short_number(100 * share); }

std::vector<std::string> quality_row(const Quality& with, const Quality& without) {
  std::vector<std::string> cells{with.course, short_number(with.optimum)};
  for (const Quality* q : {&with, &without}) {
    cells.insert(cells.end(), {percent(q->median_gap()), percent(q->worst_gap()),
                               short_number(q->median_last_improvement()),
                               short_number(q->median_last_as_walked())});
  }
  cells.push_back(percent(with.least_arrived()));
  return cells;
}

void run_quality(const QualityOptions& options) {
  std::vector<Course> courses;
  if (options.fan) courses.push_back(fan_course());
  for (const std::string& text : options.courses) courses.push_back(parse_course(text));
  auto blobs = blobs_courses(options.blobs, options.first_blobs);
  for (Course& course : blobs) courses.push_back(std::move(course));

  const Params params(options.algorithm);
  Table table("`" + options.algorithm + "`, its defaults, seeds 1 to " +
                  std::to_string(options.seeds) +
                  "; gap to the exact optimum in per cent, iteration of the last improvement and "
                  "of that of the shortest tour as walked, both in the median, least share of ants "
                  "that arrived in a run; then these with pheromone switched off.",
              {"map", "optimum", "median gap", "worst gap", "last improvement", "as walked",
               "no pheromone: median", "worst", "last improvement", "as walked", "arrived, %"},
              options.markdown);
  Quality all, all_without;
  for (const Course& course : courses) {
    const Quality with = measure_quality(course, params, options.seeds);
    const Quality without = measure_quality(course, without_pheromone(params), options.seeds);
    table.row(quality_row(with, without));
    if (!course.name.starts_with("blobs")) continue;
    all.runs.insert(all.runs.end(), with.runs.begin(), with.runs.end());
    all_without.runs.insert(all_without.runs.end(), without.runs.begin(), without.runs.end());
  }
  if (!all.runs.empty()) {
    all.course = "**all blobs**";
    all.optimum = std::numeric_limits<double>::quiet_NaN();
    table.row(quality_row(all, all_without));
  }
}

}  // namespace

void add_quality_command(CLI::App& app) {
  const auto [command, options] =
      add_command(app, "quality", "Gap to the optimum over many seeds", run_quality);
  command.add_option("--algorithm", options.algorithm, "Of the colony")->capture_default_str();
  add_number(command, "--seeds", options.seeds, "Runs of each course", 1, 100000);
  add_number(command, "--blobs", options.blobs, "Generated blobs maps of 400 x 200", 0, 10000);
  add_number(command, "--first-blobs", options.first_blobs, "Seed of the first of them");
  command.add_flag("!--no-fan", options.fan, "Leave out maps/fan400x200.map");
  command.add_option("--course", options.courses, "More courses: FILE,X,Y,X,Y");
}

}  // namespace lasius::bench
