#include <CLI/CLI.hpp>
#include <map>
#include <memory>

#include "tools/command_line/option_kinds.h"
#include "tools/command_line/run_text.h"
#include "tools/command_line/subcommands.h"

namespace lasius::tool {
namespace {

/// What the program is to know of an arm.
void add_robot_options(CLI::App& app, ArmText& text) {
  const AddOption option = option_adder(app);
  option("--base", text.taken.base_link, "Link that a URDF's chain begins with (default the root)",
         "LINK");
  option("--tip", text.taken.tip_link, "Link that it ends with (default the only leaf)", "LINK");
  option("--srdf", text.taken.srdf, "SRDF of the robot: pairs of links not to check, named states",
         "FILE");
  option("--joint-limits", text.taken.joint_limits,
         "MoveIt's joint_limits.yaml: velocities and accelerations", "FILE");
  add_repeatable(app, "--allow-contact", text.contacts,
                 "Do not check this pair of links (repeatable)", "LINK,LINK");
  add_repeatable(app, "--set-joint", text.joint_values,
                 "Value of a joint beside the chain (repeatable; default 0, or the middle of its "
                 "limits)",
                 "NAME=VALUE");
  add_repeatable(app, "--package", text.packages,
                 "Folder of a package, for package://NAME/... (repeatable)", "NAME=DIR");
  add_switch(app, "--use-visual", text.taken.visual,
             "Links without collision geometry have the body that is seen of them");
  add_switch(app, "--bodiless", text.taken.bodiless,
             "Plan for the tip alone: no link has a body, nothing is checked");
}

struct ArmGoals {
  std::vector<std::string> positions, poses, joints, states;
};

void add_goal_options(CLI::App& app, ArmText& text, ArmGoals& goals) {
  add_repeatable(app, "--goal", goals.positions,
                 "Where the tip goes, metres; orientation free. Goals may be several, of any kind: "
                 "one of them is reached",
                 "X,Y,Z");
  add_repeatable(app, "--goal-pose", goals.poses,
                 "Position and orientation of the tip, radians as in URDF", "X,Y,Z,ROLL,PITCH,YAW");
  add_repeatable(app, "--goal-joints", goals.joints, "Joint values", "Q1,Q2,...");
  add_repeatable(app, "--goal-state", goals.states, "Joint values by the name of a state (--srdf)",
                 "NAME");
  const AddOption option = option_adder(app);
  option("--position-tolerance", text.position_tolerance, "Of --goal-pose (default 1e-7)",
         "METRES");
  option("--angle-tolerance", text.angle_tolerance, "Of --goal-pose (default 1e-7)", "RADIANS");
}

/// The goals in the order of the command line.
std::vector<std::pair<std::string, std::string>> in_order(const CLI::App& app) {
  std::map<const CLI::Option*, std::size_t> used;
  std::vector<std::pair<std::string, std::string>> goals;
  for (const CLI::Option* option : app.parse_order()) {
    const std::string name = option->get_name();
    if (name.starts_with("--goal")) goals.emplace_back(name, option->results()[used[option]++]);
  }
  return goals;
}

}  // namespace

Subcommand add_arm(CLI::App& app) {
  struct Raw : ArmText {
    ArmGoals goal_texts;
  };
  auto raw = std::make_shared<Raw>();
  auto* arm = app.add_subcommand("arm", "Plan an arm's motion among obstacles that it learns");
  const AddOption option = option_adder(*arm);
  option("ROBOT", raw->taken.robot, "Robot: URDF, or JSON as in maps/arms", "FILE")->required();
  option("--scene", raw->taken.scene, "Obstacles: JSON as in maps/arms", "FILE")->required();
  option("--start", raw->start, "Joint values, radians or metres, or the name of a state (--srdf)",
         "Q1,Q2,...|NAME")
      ->required();
  add_goal_options(*arm, *raw, raw->goal_texts);
  add_robot_options(*arm, *raw);
  add_search_options(
      *arm, *raw,
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
                  ".html  one page with the arm moving in space, to be turned"});
  option("--objective", raw->value_of("objective"),
         "What is made short: moves of the lattice times pitch, joint travel, or time at "
         "full speed (default length)",
         "length|joint|duration");
  option("--max-questions", raw->value_of("max_questions"),
         "Ask the sensor at most so often (default 0, as often as needed)", "N");
  option("--pitch", raw->value_of("pitch"),
         "Distance of lattice points (default a twentieth of the reach)", "METRES");
  option("--side", raw->value_of("side"), "Lattice points a side (default all in reach)", "N");
  option("--clearance", raw->clearance, "Distance that is kept from everything (default 0.002)",
         "METRES");
  add_switch(*arm, "--no-shortcut", raw->plain, "Keep every lattice point of the path");
  option("--duration", raw->duration,
         "Time that the motion is to take; more where the joints' limits ask for it (default as "
         "little as they allow)",
         "SECONDS");
  option("--rate", raw->rate, "Samples of the trajectory a second (default 100)", "HZ");
  option("--recheck", raw->recheck,
         "Check the trajectory at N instants by KDL and FCL and say what they find", "N");
  return {arm, [raw, arm]() -> Command {
            raw->goals = in_order(*arm);
            return make_arm(*raw);
          }};
}

}  // namespace lasius::tool
