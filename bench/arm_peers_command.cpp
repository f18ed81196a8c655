// lasius_bench arm-peers: arms beside OMPL's RRT-Connect.
#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/clocks.h"
#include "bench/commands.h"
#include "bench/peers/joint_space.h"
#include "bench/report.h"
#include "bench/statistics.h"
#include "lasius/arm/generate.h"
#include "lasius/arm/plan.h"
#include "lasius/base/error.h"

namespace lasius::bench {
namespace {

struct ArmPeersOptions : Reported {
  std::vector<std::string> robots;
  std::vector<int> obstacles{0, 5, 15};
  int queries = 20;
  double cap = 2;
  std::uint64_t seed = 1;
};

/// A robot's name and itself; FILE, or FILE:BASE:TIP.
struct NamedRobot {
  std::string name;
  arm::Robot robot;
};

NamedRobot read(const std::string& text) {
  const auto first = text.find(':');
  const auto second = first == std::string::npos ? first : text.find(':', first + 1);
  const std::string file = text.substr(0, first);
  arm::Chain chain;
  if (second != std::string::npos)
    chain = {.base = text.substr(first + 1, second - first - 1), .tip = text.substr(second + 1)};
  const auto slash = file.find_last_of('/') + 1;
  return {file.substr(slash, file.find_last_of('.') - slash), arm::read_robot(file, chain)};
}

/// All joints at the value nearest to 0 that their limits allow.
arm::JointVector home(const arm::Robot& robot) {
  arm::JointVector q(robot.size());
  for (int i = 0; i < robot.size(); ++i)
    q[i] = std::clamp(0.0, robot.joints[i].low, robot.joints[i].high);
  return q;
}

/// Among obstacles every second question has a plate between start and goal, where that leaves any.
arm::Query query_of(const arm::Robot& robot, int obstacles, std::uint64_t number) {
  arm::GenerateOptions options{.seed = number, .obstacles = obstacles};
  if (obstacles > 0 && number % 2 == 1) {
    options.wall = 0.8;
    try {
      return arm::generate_query(robot, options);
    } catch (const Error&) {
      options.wall = 0;
    }
  }
  return arm::generate_query(robot, options);
}

/// The goal is where the tip is at joint values that are free; every fourth question starts from
/// home, where that is free.
struct PeersCase {
  arm::Query query;
  arm::SceneSensor sensor;
  std::uint32_t seed;

  PeersCase(const arm::Robot& robot, int obstacles, std::uint64_t number)
      : query(query_of(robot, obstacles, number)),
        sensor(robot, query.scene),
        seed(static_cast<std::uint32_t>(number)) {
    const arm::JointVector q = home(robot);
    if (number % 4 == 0 && sensor.position_free(q)) query.start = q;
  }
  arm::Request request() const { return {.start = query.start, .goals = {query.goal}}; }
};

arm::Params rival(std::string_view algorithm) {
  arm::Params parameters(algorithm);
  parameters.threads = 1;
  return parameters;
}

/// Length in joint space of a motion in time.
double travel(const arm::Trajectory& trajectory) {
  constexpr int kPieces = 1000;
  double sum = 0;
  for (int i = 0; i < kPieces; ++i)
    sum += (trajectory.at(trajectory.duration() * (i + 1) / kPieces).q -
            trajectory.at(trajectory.duration() * i / kPieces).q)
               .norm();
  return sum;
}

/// What one planner did with all questions of a robot.
struct PeersRow {
  std::string planner;
  int solved = 0, unreachable = 0, outside = 0, contradicted = 0;
  std::vector<double> seconds = {}, questions = {}, travel_ratios = {};
};

std::string median_text(const std::vector<double>& values) {
  return values.empty() ? "" : short_number(median(values));
}

std::vector<std::string> cells(const PeersRow& row) {
  return {row.planner,
          std::to_string(row.solved),
          std::to_string(row.unreachable),
          std::to_string(row.outside),
          std::to_string(row.contradicted),
          median_text(row.seconds),
          median_text(row.questions),
          median_text(row.travel_ratios)};
}

void ask(const arm::Robot& robot, const PeersCase& c, double cap, std::vector<PeersRow>& rows) {
  std::optional<peers::JointTrial> peer;
  const auto run_peer = [&](double seconds) {
    return peers::run_rrt_connect(robot, c.sensor, c.query.start, c.query.goal, cap, seconds,
                                  c.seed);
  };
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    arm::Params parameters = rival(rows[i].planner);
    parameters.seed = c.seed;
    arm::Request request = c.request();
    request.stop.deadline = deadline_in(std::chrono::duration<double>(cap));
    const Stopwatch watch;
    const arm::Result found = arm::plan(robot, c.sensor, request, parameters);
    const double seconds = watch.seconds();
    peer = run_peer(seconds);
    PeersRow& row = rows[i];
    const bool solved = found.joints.cols() > 0;
    const bool outside = found.status == Status::invalid;
    row.solved += solved;
    row.unreachable += found.status == Status::unreachable;
    row.outside += outside;
    row.contradicted += peer->solved && (outside || found.status == Status::unreachable);
    row.seconds.push_back(seconds);
    if (!solved) continue;
    row.questions.push_back(static_cast<double>(
        found.questions.positions + found.questions.motions + found.questions.trajectory));
    if (peer->solved && peer->shortened_travel > 0 && !found.trajectory.empty())
      row.travel_ratios.push_back(travel(found.trajectory) / peer->shortened_travel);
  }
  PeersRow& row = rows.back();
  row.solved += peer->solved;
  row.seconds.push_back(peer->seconds);
  if (peer->solved) row.questions.push_back(static_cast<double>(peer->positions + peer->motions));
}

void compare(const NamedRobot& named, int obstacles, const ArmPeersOptions& options, Table& table) {
  std::vector<PeersRow> rows;
  for (const Algorithm& algorithm : arm::algorithms())
    rows.push_back({.planner = std::string(algorithm.name)});
  rows.push_back({.planner = "RRT-Connect"});
  for (int i = 0; i < options.queries; ++i)
    ask(named.robot, PeersCase(named.robot, obstacles, options.seed + i), options.cap, rows);
  for (const PeersRow& row : rows) {
    std::vector<std::string> line{named.name, std::to_string(obstacles)};
    std::ranges::move(cells(row), std::back_inserter(line));
    table.row(line);
  }
}

void run_arm_peers(const ArmPeersOptions& options) {
  std::vector<NamedRobot> robots;
  for (const auto& robot : options.robots) robots.push_back(read(robot));
  if (robots.empty())
    for (const char* name : {"planar3", "industrial6", "redundant7"})
      robots.push_back(read(std::string(LASIUS_MAPS_DIR "/arms/") + name + ".json"));
  constexpr auto kText = Table::Align::left;
  Table table(std::to_string(options.queries) + " questions each from seed " +
                  std::to_string(options.seed) + ", at most " + short_number(options.cap) +
                  " s, one thread; seconds, questions and joint travel are medians; joint travel "
                  "is that of the motion / of RRT-Connect's path, shortcut for as long as the "
                  "motion took to plan.",
              {"robot",
               "obstacles",
               {"planner", kText},
               "solved",
               "told unreachable",
               "told invalid",
               "of both solved by RRT-Connect",
               "seconds",
               "questions",
               "joint travel"},
              options.markdown);
  for (const NamedRobot& named : robots)
    for (const int obstacles : options.obstacles) compare(named, obstacles, options, table);
}

}  // namespace

void add_arm_peers_command(CLI::App& app) {
  const auto [command, options] =
      add_command(app, "arm-peers", "Arms beside OMPL's RRT-Connect", run_arm_peers);
  command
      .add_option("--robot", options.robots,
                  "A robot's file, or FILE:BASE:TIP (repeatable; default the shipped ones)")
      ->allow_extra_args(false);
  command.add_option("--obstacles", options.obstacles, "Numbers of obstacles")->delimiter(',');
  add_number(command, "--queries", options.queries, "Questions a robot and number", 1, 100000);
  add_number(command, "--cap", options.cap, "Seconds a question");
  add_number(command, "--seed", options.seed, "Of the first question");
}

}  // namespace lasius::bench
