// lasius_bench arm-mbm: MotionBenchMaker's problems, solved, shortened, and checked by FCL.
#include <map>
#include <random>
#include <vector>

#include "bench/clocks.h"
#include "bench/commands.h"
#include "bench/mbm.h"
#include "bench/report.h"
#include "bench/statistics.h"
#include "lasius/arm_plan.h"
#include "lasius/arm_trajectory.h"

namespace lasius::bench {
namespace {

struct MbmOptions {
  std::string folder, problems, base, name = "ur5", tip = "ee_link", markdown;
  double clearance = arm::Sensor::kLeastClearance;
  std::uint64_t seed = 1;
  int each = 1, checked = 0, instants = 2001, cuts = 0;
};

/// What came of the problems of one set.
struct MbmFigures {
  int problems = 0, solved = 0, checked = 0, contacts = 0, unproven = 0, cut = 0;
  double overrun = 0;  // ms of processor time past a limit, the worst
  double nearest = 1e300;
  std::vector<double> first, both, found, travel, questions;  // ms, ms, rad, rad
};

double travel_of(const Eigen::MatrixXd& way) {
  double sum = 0;
  for (Eigen::Index i = 1; i < way.cols(); ++i) sum += (way.col(i) - way.col(i - 1)).norm();
  return sum;
}

/// Straight from waypoint to waypoint, each a second.
arm::Trajectory straight(const Eigen::MatrixXd& way) {
  std::vector<arm::Trajectory::Knot> knots;
  for (Eigen::Index i = 0; i < way.cols(); ++i)
    knots.push_back({static_cast<double>(i), way.col(i), arm::JointVector::Zero(way.rows())});
  return arm::Trajectory(std::move(knots));
}

void solve(const arm::Robot& robot, const arm::SceneSensor& prepared, const MbmProblem& problem,
           const MbmOptions& options, bool check, MbmFigures& figures) {
  arm::Params parameters;
  parameters.seed = options.seed;
  parameters.threads = 1;
  const ThreadStopwatch watch;
  const arm::SceneSensor sensor(prepared, problem.scene);
  const arm::Result found = arm::plan(
      robot, sensor,
      {.start = problem.start, .goals = {arm::Goal::joints(problem.goal)}, .motion = false},
      parameters);
  const double first = watch.seconds();
  ++figures.problems;
  if (found.joints.cols() == 0) return;
  const Eigen::MatrixXd way = arm::shorten_way(
      robot, sensor, found.joints, {.shortcuts = parameters.shortcuts, .seed = options.seed});
  figures.both.push_back(1e3 * watch.seconds());
  figures.first.push_back(1e3 * first);
  figures.found.push_back(travel_of(found.joints));
  figures.travel.push_back(travel_of(way));
  figures.questions.push_back(static_cast<double>(found.questions.motions));
  ++figures.solved;
  if (!check) return;
  ++figures.checked;
  const int samples = (options.instants - 1) * static_cast<int>(way.cols() - 1) + 1;
  const arm::Recheck seen = arm::recheck(robot, problem.scene, straight(way), samples);
  figures.contacts += seen.contacts;
  figures.unproven += seen.unproven;
  figures.nearest = std::min(figures.nearest, seen.nearest);
}

/// Plans, motion and all, with limits that end somewhere on the way, in processor time.
void cut(const arm::Robot& robot, const arm::SceneSensor& prepared, const MbmProblem& problem,
         const MbmOptions& options, std::mt19937_64& engine, MbmFigures& figures) {
  arm::Params parameters;
  parameters.seed = options.seed;
  parameters.threads = 1;
  const arm::SceneSensor sensor(prepared, problem.scene);
  double whole = 1e9;
  for (int i = 0; i <= options.cuts; ++i) {
    const double limit = i == 0 ? 1e9 : whole * std::generate_canonical<double, 53>(engine);
    const ThreadTime time;
    const arm::Result found =
        arm::plan(robot, sensor,
                  {.start = problem.start,
                   .goals = {arm::Goal::joints(problem.goal)},
                   .stop = {.deadline = deadline_in(std::chrono::duration<double>(limit), {}),
                            .time = &time}},
                  parameters);
    const double used = time.used();
    if (i == 0) whole = used;
    if (found.status != Status::limit) continue;
    ++figures.cut;
    figures.overrun = std::max(figures.overrun, 1e3 * (used - limit));
  }
}

void append(std::vector<double>& all, const std::vector<double>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

void row(Table& table, const std::string& name, const MbmFigures& f) {
  std::vector<std::string> cells{name,
                                 std::to_string(f.solved) + " of " + std::to_string(f.problems)};
  if (f.solved == 0) {
    table.row(cells);
    return;
  }
  for (const auto* times : {&f.first, &f.both}) {
    double sum = 0;
    for (const double t : *times) sum += t;
    for (const double t : {median(*times), sum / f.solved, quantile(*times, 0.95), largest(*times)})
      cells.push_back(short_number(t));
  }
  for (const auto* figure : {&f.questions, &f.found, &f.travel})
    cells.push_back(short_number(median(*figure)));
  cells.push_back(std::to_string(f.contacts) + " in " + std::to_string(f.checked));
  cells.push_back(short_number(f.overrun) + " of " + std::to_string(f.cut));
  table.row(cells);
}

void run_arm_mbm(const MbmOptions& options) {
  const ThreadStopwatch preparing;
  const std::string folder = options.folder + "/" + options.name;
  const arm::Robot robot = read_mbm_robot(folder, options.name, options.base, options.tip);
  const double read = preparing.seconds();
  const arm::SceneSensor prepared(robot, {}, options.clearance);
  const double ready = preparing.seconds() - read;
  const auto problems =
      read_mbm_problems(options.problems.empty() ? folder + "/problems" : options.problems, robot);
  Table table(
      "MotionBenchMaker, " + options.name + ", meshes as they are, clearance " +
          short_number(1e3 * options.clearance) + " mm, one thread, processor time; read in " +
          short_number(read) + " s, prepared in " + short_number(ready) +
          " s. Times in ms: median, mean, 95 %, worst; travel in rad.",
      {"set", "solved", "first", "mean", "95 %", "worst", "shortened", "mean", "95 %", "worst",
       "motions asked", "travel", "shortened", "contacts, by FCL", "limit overrun, worst of"},
      options.markdown);
  std::map<std::string, MbmFigures> sets;
  MbmFigures all;
  int number = 0, taken = 0;
  std::mt19937_64 engine(options.seed);
  for (const MbmProblem& problem : problems) {
    if (number++ % options.each != 0) continue;
    const bool check = options.checked > 0 && taken++ % options.checked == 0;
    solve(robot, prepared, problem, options, check, sets[problem.set]);
    if (options.cuts > 0) cut(robot, prepared, problem, options, engine, sets[problem.set]);
  }
  for (const auto& [name, f] : sets) {
    row(table, name, f);
    all.problems += f.problems;
    all.solved += f.solved;
    all.checked += f.checked;
    all.contacts += f.contacts;
    all.cut += f.cut;
    all.overrun = std::max(all.overrun, f.overrun);
    append(all.first, f.first);
    append(all.both, f.both);
    append(all.found, f.found);
    append(all.travel, f.travel);
    append(all.questions, f.questions);
  }
  row(table, "all", all);
}

}  // namespace

void add_arm_mbm_command(CLI::App& app) {
  const auto [command, options] =
      add_command(app, "arm-mbm", "MotionBenchMaker's problems for an arm", run_arm_mbm);
  command.add_option("DIR", options.folder, "Folder of NAME/NAME.urdf, .srdf and meshes")
      ->required();
  command.add_option("--problems", options.problems, "Their folder; default: DIR/NAME/problems");
  command.add_option("--name", options.name, "The robot")->capture_default_str();
  command.add_option("--base", options.base, "First link of the chain; default: the root");
  command.add_option("--tip", options.tip, "Last link of the chain")->capture_default_str();
  add_number(command, "--clearance", options.clearance, "Metres", 1e-6, 1);
  add_number(command, "--seed", options.seed, "Of the trees");
  add_number(command, "--each", options.each, "Only each so many-th problem", 1, 1e6);
  add_number(command, "--checked", options.checked, "Each so many-th by FCL; 0: none", 0, 1e6);
  add_number(command, "--cuts", options.cuts, "Limits at random, each problem", 0, 1e6);
  add_number(command, "--instants", options.instants, "Of a motion, that FCL looks at", 2, 1e6);
  add_output(command, options.markdown);
}

}  // namespace lasius::bench
