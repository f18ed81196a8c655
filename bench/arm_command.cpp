// lasius_bench arm: speed, threads, validity and optima of arms among unknown obstacles.
#include <array>
#include <cmath>
#include <mutex>
#include <vector>

#include "bench/clocks.h"
#include "bench/commands.h"
#include "bench/report.h"
#include "bench/statistics.h"
#include "lasius/arm/generate.h"
#include "lasius/arm/plan.h"
#include "lasius/arm/trajectory.h"
#include "tests/oracle/arm/fcl_judge.h"

namespace lasius::bench {
namespace {

struct ArmOptions : Reported {
  int rounds = 5, scenes = 60, seeds = 60, goals = 60;
};

arm::Robot shipped(const std::string& name) {
  return arm::read_robot(LASIUS_MAPS_DIR "/arms/" + name + ".json");
}

/// A question, and a lattice of `side` points a side that reaches beyond start and goal.
struct ArmCase {
  arm::Robot robot;
  arm::Scene scene;
  arm::Request request;
  arm::Params parameters;
};

double widest(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

ArmCase make_case(const arm::Robot& robot, const arm::GenerateOptions& options, int side) {
  arm::Query query = arm::generate_query(robot, options);
  ArmCase c{robot,
            std::move(query.scene),
            {.start = std::move(query.start), .goals = {query.goal}, .motion = false},
            arm::Params("goritov2020")};
  c.parameters.seed = options.seed;
  c.parameters.threads = 1;
  c.parameters.side = side;
  c.parameters.pitch = widest(arm::tip_position(robot, c.request.start), query.goal) / (0.6 * side);
  return c;
}

/// Keeps the questions that a search asks.
class Recorder final : public arm::Sensor {
 public:
  explicit Recorder(const arm::Sensor& sensor) : sensor_(sensor) {}
  bool position_free(const arm::JointRef& q) const override {
    const std::scoped_lock lock(mutex_);
    positions.emplace_back(q);
    return sensor_.position_free(q);
  }
  bool motion_free(const arm::JointRef& from, const arm::JointRef& to) const override {
    const std::scoped_lock lock(mutex_);
    motions.push_back({from, to});
    return sensor_.motion_free(from, to);
  }
  double clearance() const override { return sensor_.clearance(); }

  mutable std::vector<arm::JointVector> positions;
  mutable std::vector<std::array<arm::JointVector, 2>> motions;

 private:
  const arm::Sensor& sensor_;
  mutable std::mutex mutex_;
};

/// The base set on the 6-axis arm among 20 obstacles, 40 x 40 x 40 points.
std::vector<Figure> measure_speed(int rounds) {
  const arm::Robot robot = shipped("industrial6");
  std::vector<double> steps, ratios, per_position, per_motion, questions, planning;
  bool identical = true;
  for (std::uint64_t seed = 1; static_cast<int>(ratios.size()) < rounds; ++seed) {
    ArmCase c = make_case(robot, {.seed = seed, .obstacles = 20}, 40);
    const arm::SceneSensor sensor(c.robot, c.scene);
    const auto timed = [&](int threads, double& seconds) {
      c.parameters.threads = threads;
      const Stopwatch watch;
      arm::Result result = arm::plan(c.robot, sensor, c.request, c.parameters);
      seconds = watch.seconds();
      return result;
    };
    double one = 0, two = 0;
    const arm::Result a = timed(1, one);
    if (a.status != Status::solved) continue;
    const arm::Result b = timed(2, two);
    identical = identical && a.joints == b.joints && alike(a.curves.best, b.curves.best) &&
                alike(a.curves.mean, b.curves.mean) && a.questions == b.questions;
    ratios.push_back(one / two);
    planning.push_back(one);
    steps.push_back(static_cast<double>(a.steps) / one);

    const Recorder recorder(sensor);
    arm::plan(c.robot, recorder, c.request, c.parameters);
    questions.push_back(static_cast<double>(recorder.positions.size() + recorder.motions.size()));
    const ProcessorStopwatch positions;
    for (const auto& q : recorder.positions) sensor.position_free(q);
    per_position.push_back(static_cast<double>(recorder.positions.size()) / positions.seconds());
    const ProcessorStopwatch motions;
    for (const auto& [from, to] : recorder.motions) sensor.motion_free(from, to);
    per_motion.push_back(static_cast<double>(recorder.motions.size()) / motions.seconds());
  }
  return {{"ant steps a second, whole plan, 1 thread", short_number(median(steps)), ""},
          {"seconds a plan, 1 thread", short_number(median(planning)), ""},
          {"questions a plan, each asked once", short_number(median(questions)), ""},
          {"positions checked a second, 1 thread", short_number(median(per_position)), ""},
          {"motions checked a second, 1 thread", short_number(median(per_motion)), ""},
          {"1 thread / 2 threads", short_number(median(ratios)), ">= 1.6"},
          {"identical with 1 and 2 threads", identical ? "yes" : "NO", "yes"}};
}

/// Half of the scenes have a wall between start and goal.
arm::GenerateOptions random_scene(std::uint64_t seed) {
  return {.seed = seed, .obstacles = 15, .wall = seed % 2 == 0 ? 0.8 : 0};
}

const std::array<arm::Robot, 3>& shipped_robots() {
  static const std::array kRobots{shipped("planar3"), shipped("industrial6"),
                                  shipped("redundant7")};
  return kRobots;
}

/// Empty scenes, goals where the tip is at drawn joint values: so each can be reached.
std::vector<Figure> measure_reach(int goals) {
  int solved = 0, given_up = 0;
  for (const arm::Robot& robot : shipped_robots()) {
    for (int i = 0; i < goals; ++i) {
      const arm::Query query =
          arm::generate_query(robot, {.seed = 1 + static_cast<std::uint64_t>(i), .obstacles = 0});
      const arm::SceneSensor sensor(robot, query.scene);
      const Status status =
          arm::plan(robot, sensor, {.start = query.start, .goals = {query.goal}, .motion = false})
              .status;
      solved += status == Status::solved;
      given_up += status == Status::invalid || status == Status::unreachable;
    }
  }
  const std::string all = std::to_string(goals * std::ssize(shipped_robots()));
  return {{"empty scenes, postures: goals reached", std::to_string(solved) + " of " + all, all},
          {"the same: called out of reach or blocked", std::to_string(given_up), "0"}};
}

/// Trajectories on random scenes, each checked at 1000 times by KDL and FCL.
std::vector<Figure> measure_validity(int scenes) {
  int moved = 0, contacts = 0, limits = 0, stops = 0;
  double nearest = 1e300;
  for (std::uint64_t seed = 1; moved < scenes; ++seed) {
    const arm::Robot& robot = shipped_robots()[seed % shipped_robots().size()];
    const ArmCase c = make_case(robot, random_scene(seed), 12);
    const arm::SceneSensor sensor(c.robot, c.scene);
    const arm::Result found = arm::plan(c.robot, sensor, c.request, c.parameters);
    if (found.joints.cols() == 0) continue;
    ++moved;
    const auto made = arm::make_trajectory(
        c.robot, sensor, found.joints, {.shortcut = seed % 4 != 0, .timing = c.parameters.timing});
    stops += made.stops;
    const oracle::FclJudge judge(c.robot, c.scene);
    constexpr int kInstants = 1000;
    for (int i = 0; i < kInstants; ++i) {
      const double t = made.trajectory.duration() * i / (kInstants - 1);
      const double apart = judge.distance(made.trajectory.at(t).q);
      contacts += apart <= 0;
      nearest = std::min(nearest, apart);
    }
    limits += arm::recheck(c.robot, c.scene, made.trajectory, kInstants).limits;
  }
  return {{"trajectories checked by FCL at 1000 times", std::to_string(moved), ""},
          {"contacts", std::to_string(contacts), "0"},
          {"limits broken", std::to_string(limits), "0"},
          {"least distance, mm (clearance 2)", short_number(1000 * nearest), ">= 2"},
          {"that rest at each waypoint", std::to_string(stops), ""}};
}

/// Runs within 5% of the optimum of the fully known lattice.
std::vector<Figure> measure_optimum(int seeds, int side, double elite_weight) {
  const arm::Robot robot = shipped("industrial6");
  int solved = 0, near = 0, optimal = 0;
  std::vector<double> gaps;
  for (std::uint64_t seed = 1; solved < seeds; ++seed) {
    ArmCase c = make_case(robot, random_scene(seed), side);
    c.parameters.elite_weight = elite_weight;
    c.parameters.threads = 0;
    const arm::SceneSensor sensor(c.robot, c.scene);
    const arm::Result best = arm::shortest_lattice_way(c.robot, sensor, c.request, c.parameters);
    if (best.status != Status::solved || best.length <= 0) continue;
    ++solved;
    const arm::Result found = arm::plan(c.robot, sensor, c.request, c.parameters);
    const double ratio = found.joints.cols() == 0 ? 1e9 : found.length / best.length;
    near += ratio <= 1.05;
    optimal += ratio <= 1 + 1e-9;
    gaps.push_back(ratio - 1);
  }
  const std::string what = std::to_string(side) + "^3, e = " + short_number(elite_weight) + ": ";
  const auto share = [&](int count) {
    return short_number(100.0 * count / solved) + "% of " + std::to_string(solved);
  };
  return {{what + "within 5% of the optimum", share(near),
           side <= 12 && elite_weight == 16 ? ">= 95%" : ""},
          {what + "optimal", share(optimal), ""},
          {what + "worst gap, %", short_number(100 * largest(gaps)), ""}};
}

void run_arm(const ArmOptions& options) {
  Table table = Table::of_figures("maps/arms/industrial6.json, base set unless said otherwise.",
                                  options.markdown);
  table.add(measure_speed(options.rounds));
  table.add(measure_validity(options.scenes));
  table.add(measure_reach(options.goals));
  for (const double elite : {16.0, 0.0}) table.add(measure_optimum(options.seeds, 12, elite));
  for (const int side : {20, 30})
    table.add(measure_optimum(std::max(options.seeds / 4, 1), side, 16));
}

}  // namespace

void add_arm_command(CLI::App& app) {
  const auto [command, options] =
      add_command(app, "arm", "Speed, validity and optima of goritov2020", run_arm);
  add_number(command, "--rounds", options.rounds, "Questions timed", 1, 1000);
  add_number(command, "--scenes", options.scenes, "Trajectories checked by FCL", 1, 100000);
  add_number(command, "--goals", options.goals, "Goals in empty scenes, of each of three arms", 1,
             100000);
  add_number(command, "--seeds", options.seeds, "Runs compared with the optimum", 1, 100000);
}

}  // namespace lasius::bench
