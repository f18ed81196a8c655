// lasius_bench arm-mbm: MotionBenchMaker's problems, solved, shortened, and checked by FCL.
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <vector>

#include "bench/clocks.h"
#include "bench/commands.h"
#include "bench/mbm.h"
#include "bench/peers/joint_space.h"
#include "bench/report.h"
#include "bench/statistics.h"
#include "lasius/arm/plan.h"
#include "lasius/arm/trajectory.h"
#include "tests/oracle/arm/fcl_judge.h"

namespace lasius::bench {
namespace {

struct MbmOptions : Reported {
  std::string folder, problems, base, name = "ur5", tip = "ee_link";
  double clearance = arm::Sensor::kLeastClearance;
  std::uint64_t seed = 1;
  int each = 1, checked = 0, instants = 2000, cuts = 0;
  double peers = 0;
};

/// What came of the problems of one set, and of a peer's. Times in ms, travel in rad.
struct MbmFigures {
  int problems = 0, solved = 0, checked = 0, contacts = 0, limits = 0, cut = 0;
  double overrun = 0;  // ms of processor time past a limit, the worst
  std::vector<double> first, both, timed, found, travel, duration, stopping, questions;
};
struct PeerFigures {
  int problems = 0, solved = 0;
  std::vector<double> first, travel, ratio, questions;
};
constexpr std::array<const char*, 2> kPeers{"lasius' contact", "FCL, each 0.01 rad"};

double travel_of(const Eigen::MatrixXd& way) {
  double sum = 0;
  for (Eigen::Index i = 1; i < way.cols(); ++i) sum += (way.col(i) - way.col(i - 1)).norm();
  return sum;
}

bool breaks_limit(const arm::Robot& robot, const arm::Trajectory::State& state) {
  constexpr double kTolerance = 1e-9;
  for (int j = 0; j < robot.size(); ++j) {
    const arm::Joint& joint = robot.joints[static_cast<std::size_t>(j)];
    if (state.q[j] < joint.low - kTolerance || state.q[j] > joint.high + kTolerance ||
        std::abs(state.dq[j]) > joint.velocity * (1 + kTolerance) ||
        std::abs(state.ddq[j]) > joint.acceleration * (1 + kTolerance))
      return true;
  }
  return false;
}

/// The travel of the shortened way; 0 where none was found.
double solve(const arm::Robot& robot, const arm::SceneSensor& prepared, const MbmProblem& problem,
             const MbmOptions& options, const oracle::FclJudge* judge, MbmFigures& figures) {
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
  if (found.joints.cols() == 0) return 0;
  const Eigen::MatrixXd way = arm::shorten_way(
      robot, sensor, found.joints, {.shortcuts = parameters.shortcuts, .seed = options.seed});
  const double both = watch.seconds();
  const arm::Trajectory motion =
      arm::make_trajectory(robot, sensor, way, {.shortcut = false}).trajectory;
  figures.timed.push_back(1e3 * (watch.seconds() - both));
  figures.both.push_back(1e3 * both);
  figures.first.push_back(1e3 * first);
  figures.found.push_back(travel_of(found.joints));
  figures.travel.push_back(travel_of(way));
  figures.duration.push_back(motion.duration());
  // Without time to look at corners it rests at each.
  figures.stopping.push_back(
      arm::make_trajectory(robot, sensor, way, {.shortcut = false, .max_questions = 0})
          .trajectory.duration());
  figures.questions.push_back(static_cast<double>(found.questions.motions));
  ++figures.solved;
  if (judge == nullptr) return figures.travel.back();
  ++figures.checked;
  const int instants = options.instants * static_cast<int>(way.cols() - 1);
  for (int i = 0; i <= instants; ++i) {
    const auto state = motion.at(motion.duration() * i / instants);
    figures.contacts += judge->touches(state.q);
    figures.limits += breaks_limit(robot, state);
  }
  return figures.travel.back();
}

#ifdef LASIUS_HAVE_OMPL
void ask_peers(const arm::Robot& robot, const arm::SceneSensor& sensor,
               const oracle::FclJudge& judge, const MbmProblem& problem, const MbmOptions& options,
               double travel, std::array<PeerFigures, kPeers.size()>& figures) {
  constexpr double kApart = 0.01, kToSimplify = 1;  // rad, seconds
  const std::array<peers::JointChecks, kPeers.size()> checks{
      {{[&](const arm::JointRef& q) { return sensor.position_free(q); },
        [&](const arm::JointRef& a, const arm::JointRef& b) { return sensor.motion_free(a, b); }},
       {[&](const arm::JointRef& q) { return !judge.touches(q); },
        [&](const arm::JointRef& a, const arm::JointRef& b) {
          const int pieces = static_cast<int>(std::ceil((b - a).norm() / kApart));
          for (int i = 1; i <= pieces; ++i)
            if (judge.touches(a + static_cast<double>(i) / pieces * (b - a))) return false;
          return true;
        }}}};
  for (std::size_t p = 0; p < kPeers.size(); ++p) {
    PeerFigures& f = figures[p];
    const auto trial =
        peers::run_rrt_connect(robot, checks[p], problem.start, problem.goal, options.peers,
                               kToSimplify, static_cast<std::uint32_t>(options.seed));
    ++f.problems;
    if (!trial.solved) continue;
    ++f.solved;
    f.first.push_back(1e3 * trial.seconds);
    f.travel.push_back(trial.shortened_travel);
    f.questions.push_back(static_cast<double>(trial.motions));
    if (travel > 0 && trial.shortened_travel > 0)
      f.ratio.push_back(travel / trial.shortened_travel);
  }
}

void add_peers(Table& table, const MbmOptions& options,
               const std::array<PeerFigures, kPeers.size()>& figures) {
  table.next("OMPL's RRT-Connect, at most " + short_number(options.peers) +
                 " s, PathSimplifier for 1 s more; lasius' travel / its, of the problems that both "
                 "solved.",
             {"what is free by", "solved", "first, ms", "mean", "95 %", "motions asked",
              "travel, mean", "lasius / it, mean"});
  for (std::size_t p = 0; p < kPeers.size(); ++p) {
    const PeerFigures& f = figures[p];
    if (f.solved == 0) continue;
    table.row({kPeers[p], std::to_string(f.solved) + " of " + std::to_string(f.problems),
               short_number(median(f.first)), short_number(mean(f.first)),
               short_number(quantile(f.first, 0.95)), short_number(median(f.questions)),
               short_number(mean(f.travel)), f.ratio.empty() ? "" : short_number(mean(f.ratio))});
  }
}
#endif

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
    for (const double t : {median(*times), mean(*times), quantile(*times, 0.95), largest(*times)})
      cells.push_back(short_number(t));
  }
  for (const double t : {median(f.timed), quantile(f.timed, 0.95)})
    cells.push_back(short_number(t));
  for (const auto* figure : {&f.questions, &f.found, &f.travel, &f.duration, &f.stopping})
    cells.push_back(short_number(median(*figure)));
  cells.push_back(std::to_string(f.contacts) + ", " + std::to_string(f.limits) + " in " +
                  std::to_string(f.checked));
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
          " s. Times in ms: median, mean, 95 %, worst; travel in rad, durations in s.",
      {"set", "solved", "first", "mean", "95 %", "worst", "shortened", "mean", "95 %", "worst",
       "blends and timing", "95 %", "motions asked", "travel", "shortened", "duration",
       "resting at corners", "contacts by FCL, limits broken", "limit overrun, worst of"},
      options.markdown);
  std::map<std::string, MbmFigures> sets;
  MbmFigures all;
  std::array<PeerFigures, kPeers.size()> peers;
  int number = 0, taken = 0;
  std::mt19937_64 engine(options.seed);
  for (const MbmProblem& problem : problems) {
    if (number++ % options.each != 0) continue;
    const bool check = options.checked > 0 && taken++ % options.checked == 0;
    std::optional<oracle::FclJudge> judge;
    if (check || options.peers > 0) judge.emplace(robot, problem.scene);
    const double travel =
        solve(robot, prepared, problem, options, check ? &*judge : nullptr, sets[problem.set]);
    if (options.cuts > 0) cut(robot, prepared, problem, options, engine, sets[problem.set]);
#ifdef LASIUS_HAVE_OMPL
    if (options.peers > 0)
      ask_peers(robot, arm::SceneSensor(prepared, problem.scene), *judge, problem, options, travel,
                peers);
#endif
  }
  for (const auto& [name, f] : sets) {
    row(table, name, f);
    all.problems += f.problems;
    all.solved += f.solved;
    all.checked += f.checked;
    all.contacts += f.contacts;
    all.limits += f.limits;
    all.cut += f.cut;
    all.overrun = std::max(all.overrun, f.overrun);
    append(all.first, f.first);
    append(all.both, f.both);
    append(all.found, f.found);
    append(all.travel, f.travel);
    append(all.timed, f.timed);
    append(all.duration, f.duration);
    append(all.stopping, f.stopping);
    append(all.questions, f.questions);
  }
  row(table, "all", all);
#ifdef LASIUS_HAVE_OMPL
  if (options.peers > 0) add_peers(table, options, peers);
#endif
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
  add_number(command, "--instants", options.instants, "Of each straight, that FCL looks at", 1,
             1e6);
#ifdef LASIUS_HAVE_OMPL
  add_number(command, "--peers", options.peers, "Seconds for OMPL's RRT-Connect; 0: without it", 0,
             1e6);
#endif
}

}  // namespace lasius::bench
