// lasius arm.
#include <algorithm>
#include <initializer_list>
#include <memory>

#include "tools/arm/arm_command.h"
#include "tools/arm/arm_kind.h"
#include "tools/command_line/search_options.h"

namespace lasius::tool {
namespace {

constexpr std::array<std::string_view, 7> kArmEndings{".json", ".csv", ".yaml", ".yml",
                                                      ".svg",  ".png", ".html"};

/// "A=B" or "A,B": what is before and after the first `between`. @throws UsageError
std::pair<std::string, std::string> halves(const std::string& option, const std::string& text,
                                           char between, const char* form) {
  const auto at = text.find(between);
  if (at == std::string::npos || at == 0 || at + 1 == text.size())
    throw UsageError(option + " " + text + ": not of the form " + form);
  return {text.substr(0, at), text.substr(at + 1)};
}

/// Not a name: a number, or several.
bool is_numeric(const std::string& text) {
  return text.find(',') != std::string::npos || parse_real(text).has_value();
}

ArmGoal arm_goal(const std::string& option, const std::string& text) {
  if (option == "--goal-pose") return {ArmGoal::Kind::pose, reals_value(option, text, 6, 6), {}};
  if (option == "--goal-joints")
    return {ArmGoal::Kind::joints, reals_value(option, text, 1, 16), {}};
  if (option == "--goal-state") return {ArmGoal::Kind::joints, {}, text};
  return {ArmGoal::Kind::position, reals_value(option, text, 3, 3), {}};
}

/// What the program is to know of an arm.
void add_robot_options(OptionTable& table, ArmCommand& to) {
  const auto once = [](const char* option, const std::string& name, bool first) {
    if (!first) throw UsageError(std::string(option) + " " + name + " is given twice");
  };
  table.text("--base", to.base_link, "Link that a URDF's chain begins with (default the root)",
             "LINK");
  table.text("--tip", to.tip_link, "Link that it ends with (default the only leaf)", "LINK");
  table.file("--srdf", to.srdf, "SRDF of the robot: pairs of links not to check, named states",
             {".srdf"});
  table.file("--joint-limits", to.joint_limits,
             "MoveIt's joint_limits.yaml: velocities and accelerations", {".yaml", ".yml"});
  table.repeatable("--allow-contact", "Do not check this pair of links (repeatable)", "LINK,LINK",
                   [&to](const auto& text) {
                     to.contacts.push_back(halves("--allow-contact", text, ',', "LINK,LINK"));
                   });
  table.repeatable(
      "--set-joint",
      "Value of a joint beside the chain (repeatable; default 0, or the middle of its limits)",
      "NAME=VALUE", [&to, once](const auto& text) {
        const auto [name, value] = halves("--set-joint", text, '=', "NAME=VALUE");
        const double number = real_value("--set-joint " + name, value, -kNoLimit, kNoLimit);
        once("--set-joint", name, to.joint_values.emplace(name, number).second);
      });
  table.repeatable("--package", "Folder of a package, for package://NAME/... (repeatable)",
                   "NAME=DIR", [&to, once](const auto& text) {
                     const auto [name, folder] = halves("--package", text, '=', "NAME=DIR");
                     once("--package", name, to.packages.emplace(name, folder).second);
                   });
  table.flag("--use-visual", to.visual,
             "Links without collision geometry have the body that is seen of them");
  table.flag("--bodiless", to.bodiless,
             "Plan for the tip alone: no link has a body, nothing is checked");
}

/// Goals are read in their order, once all are typed.
void add_goal_options(OptionTable& table, ArmCommand& to) {
  const auto goal = [&](const char* option, const char* help, const char* type) {
    table.repeatable(option, help, type, [](const std::string&) {});
  };
  goal("--goal",
       "Where the tip goes, metres; orientation free. Goals may be several, of any kind: one of "
       "them is reached",
       "X,Y,Z");
  goal("--goal-pose", "Position and orientation of the tip, radians as in URDF",
       "X,Y,Z,ROLL,PITCH,YAW");
  goal("--goal-joints", "Joint values", "Q1,Q2,...");
  goal("--goal-state", "Joint values by the name of a state (--srdf)", "NAME");
  const auto tolerance = [&](const char* option, double& value, const char* unit) {
    table.real(option, value, ArmCommand::kLeastTolerance, ArmCommand::kMostTolerance,
               "Of --goal-pose (default 1e-7)", unit);
  };
  tolerance("--position-tolerance", to.position_tolerance, "METRES");
  tolerance("--angle-tolerance", to.angle_tolerance, "RADIANS");
}

/// What the tip holds, straight motions, and questions without a motion.
void add_tip_options(OptionTable& table, ArmCommand& to) {
  table.file("--held", to.held, "What the tip holds: bodies as in a scene, placed in its frame",
             {".json"});
  table.repeatable("--held-touches", "Link that it may touch (repeatable)", "LINK",
                   [&to](const auto& link) { to.held_touches.push_back(link); });
  table.flag("--straight", to.straight, "The tip goes straight to --goal-pose, turning evenly");
  table.real("--straight-tolerance", to.straight_tolerance, ArmCommand::kLeastOff,
             ArmCommand::kMostTolerance, "How far off that line (default 0.001)", "METRES");
  table.real("--straight-angle", to.straight_angle, ArmCommand::kLeastOff,
             ArmCommand::kMostTolerance,
             "How far off that turn (default 0.01; pi or more: turned as it likes)", "RADIANS");
  table.integer("--inverse", to.inverse, 1, ArmCommand::kMostInverse,
                "No motion: at most N joint values that reach the goal, nearest to the start first",
                "N");
  table.flag("--nearest", to.nearest,
             "Tell which two things are nearest to each other at start and end; without a goal, at "
             "the start");
}

/// What the motion keeps to, and how it is told.
void add_motion_options(OptionTable& table, ArmCommand& to, bool& plain) {
  add_parameter(table, "--objective", to,
                "What is made short: moves of the lattice times pitch, joint travel, or time at "
                "full speed (default length)",
                "length|joint|duration");
  add_parameter(table, "--max-questions", to,
                "Ask the sensor at most so often (default 0, as often as needed)", "N");
  add_parameter(table, "--pitch", to,
                "Distance of lattice points (default a twentieth of the reach)", "METRES");
  add_parameter(table, "--side", to, "Lattice points a side (default all in reach)", "N");
  table.real("--clearance", to.clearance, ArmCommand::kLeastClearance, ArmCommand::kMostClearance,
             "Distance that is kept from everything (default 0.002)", "METRES");
  table.flag("--no-shortcut", plain, "Keep every lattice point of the path");
  table.real("--duration", to.duration, ArmCommand::kLeastDuration, ArmCommand::kMostDuration,
             "Time that the motion is to take; more where the joints' limits ask for it (default "
             "as little as they allow)",
             "SECONDS");
  table.real("--rate", to.rate, ArmCommand::kLeastRate, ArmCommand::kMostRate,
             "Samples of the trajectory a second (default 100)", "HZ");
  table.integer("--recheck", to.recheck, 1, ArmCommand::kMostRecheck,
                "Look at the trajectory again at N instants and between, and say what is found",
                "N");
}

/// Notes options that say nothing to what is asked in place of a plan.
void note_idle(const OptionTable& table, ArmCommand& to) {
  const std::string asked = to.straight        ? "with --straight"
                            : to.inverse > 0   ? "with --inverse"
                            : to.goals.empty() ? "without a goal"
                                               : "";
  const auto idle = [&](std::initializer_list<const char*> options) {
    for (const char* const option : options)
      if (table.given(option)) to.notes.push_back(option + (" has no effect " + asked));
  };
  if (asked.empty()) return;
  idle({"--algorithm", "--set", "--ants", "--iterations", "--objective", "--max-questions",
        "--pitch", "--side", "--target-gap", "--no-shortcut"});
  if (to.straight) idle({"--position-tolerance", "--angle-tolerance"});
  if (to.inverse == 0) idle({"--seed"});
  if (!to.straight) idle({"--duration", "--rate"});
  if (to.inverse > 0) idle({"--recheck"});
}

void finish_tip_options(const OptionTable& table, ArmCommand& to) {
  if (to.straight && to.inverse > 0)
    throw UsageError("--inverse makes no motion; leave it or --straight out");
  const auto of_pose = [](const ArmGoal& goal) { return goal.kind == ArmGoal::Kind::pose; };
  if (to.straight && !std::ranges::all_of(to.goals, of_pose))
    throw UsageError("--straight goes to poses; give goals by --goal-pose");
  if (to.straight && table.given("--objective"))
    throw UsageError("--straight: the line is the way; leave --objective out");
  const auto is_json = [](const std::string& file) { return file.ends_with(".json"); };
  if (to.inverse > 0 && !std::ranges::all_of(to.outputs, is_json))
    throw UsageError("--inverse makes no motion; -o takes .json with it");
  const auto idle = [&](const char* option, const char* other, bool has_other) {
    if (table.given(option) && !has_other)
      to.notes.push_back(std::string(option) + " has no effect without " + other);
  };
  idle("--straight-tolerance", "--straight", to.straight);
  idle("--straight-angle", "--straight", to.straight);
  idle("--held-touches", "--held", !to.held.empty());
  note_idle(table, to);
}

void finish_goals(const OptionTable& table, ArmCommand& to) {
  for (const auto& [option, value] : table.in_order("--goal"))
    to.goals.push_back(arm_goal(option, value));
  if (to.goals.empty() && (!to.nearest || to.straight || to.inverse > 0))
    throw UsageError("a goal is required: --goal, --goal-pose, --goal-joints or --goal-state");
  if (table.given("--goal-pose")) return;
  for (const char* option : {"--position-tolerance", "--angle-tolerance"})
    if (table.given(option))
      to.notes.push_back(std::string(option) + " has no effect without --goal-pose");
}

}  // namespace

Subcommand add_arm(CLI::App& app) {
  auto to = std::make_shared<ArmCommand>();
  OptionTable table(app, "arm", "Plan an arm's motion among obstacles that it learns");
  table.file("ROBOT", to->robot, "Robot: URDF, or JSON as in maps/arms", {".urdf", ".json"})
      ->required();
  table.file("--scene", to->scene, "Obstacles: JSON as in maps/arms", {".json"})->required();
  const auto start = [to](const std::string& text) {
    if (is_numeric(text))
      to->start = reals_value("--start", text, 1, 16);
    else
      to->start_state = text;
  };
  table
      .add("--start", "Joint values, radians or metres, or the name of a state (--srdf)",
           "Q1,Q2,...|NAME", start)
      ->required();
  add_goal_options(table, *to);
  add_robot_options(table, *to);
  add_tip_options(table, *to);
  add_search_options(
      table, *to,
      {.seed = "Seed, from 0 to 2^53-1 (default 1)",
       .time_limit = "Stop after this time",
       .target_gap = "Stop at this gap to the bound from what was learned (1 means 1%)",
       .json = "Print one JSON object; its length is that of --objective",
       .outputs = "Write a file, by its ending (repeatable):\n"
                  ".json  what --json prints\n"
                  ".csv  the trajectory: time, joints, their velocities, accelerations, tip\n"
                  ".yaml, .yml  the trajectory as ROS trajectory_msgs/JointTrajectory\n"
                  ".svg, .png  arm, obstacles, tip's path in three views, joints, convergence, "
                  "questions\n"
                  ".html  one page with the arm moving in space, to be turned",
       .endings = kArmEndings});
  auto plain = std::make_shared<bool>(false);
  add_motion_options(table, *to, *plain);
  return table.command(
      {.examples = {{"lasius arm maps/arms/industrial6.json --scene maps/arms/cell.json "
                     "--start -0.9,0.3,0.4,0,0.4,0 --goal 0.45,0.4,0.5 -o motion.csv",
                     "a motion, and its trajectory as a table"},
                    {"lasius arm maps/arms/industrial6.json --scene maps/arms/cell.json "
                     "--start -0.9,0.3,0.4,0,0.4,0 --goal 0.45,0.4,0.5 --inverse 3",
                     "joint values that reach it, and what is nearest there"}},
       .exits =
           {{kFound, "a motion was returned"},
            {kBadFile, "robot, scene or another file is missing or broken"},
            {kInvalidQuery, "start or goal outside, blocked, or proven out of reach"},
            {kNoPath,
             "none found, or a limit is spent: that a goal in reach has no way is never proven"},
            kOutput,
            {kInterrupted, "interrupted, best so far written"}},
       .json = "program/JSON of an arm's motion"},
      [=](const Call& call) {
        to->called = call.line;
        finish_search(*to);
        if (to->ranged)
          table.refuse({"--seed"}, ": arm takes one seed; several are for plan and batch");
        if (*plain) to->named.insert(to->named.end(), {{"shortcut", "off"}, {"shortcuts", "0"}});
        to->inputs = {to->robot, to->scene, to->srdf, to->joint_limits, to->held};
        finish_goals(table, *to);
        finish_tip_options(table, *to);
        return run_command(*to);
      });
}

}  // namespace lasius::tool
