// What of a URDF is the robot's body, and which pairs of links are checked.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "lasius/arm/generate.h"
#include "lasius/arm/sensor.h"
#include "lasius/base/error.h"
#include "tests/core/arm/robot/arms.h"
#include "tests/core/arm/robot/refusals.h"
#include "tests/core/base/made_files.h"

namespace lasius::arm {
namespace {

const std::string kRobots = LASIUS_MAPS_DIR "/../tests/core/arm/robots";

std::string test_robot(const std::string& name) { return kRobots + "/" + name + ".urdf"; }

bool holds(const std::vector<std::string>& notes, const std::string& words) {
  return std::ranges::any_of(notes, [&](const auto& note) { return note == words; });
}

TEST(Body, AGripperBesideTheTipIsSeen) {
  const JointVector q = joints({0, -1, 1, 0, 0.5, 0});
  const Robot bare = read_robot(test_robot("ur5"));
  const Robot robot = read_robot(test_robot("ur5_gripper"), {.tip = "tool0"});
  EXPECT_EQ(robot.size(), 6);
  EXPECT_EQ(robot.links.size(), bare.links.size() + 3);
  const Pose tip = tip_pose(robot, q);
  EXPECT_TRUE(tip.isApprox(tip_pose(bare, q)));
  // In front of the flange, where the gripper is.
  const Scene scene{"", {ball(tip * Eigen::Vector3d(0, 0, 0.05), 0.01)}};
  EXPECT_EQ(SceneSensor(bare, scene).contact(q), "");
  EXPECT_EQ(SceneSensor(robot, scene).contact(q), "link \"gripper_base\" and obstacle 1");
  const Scene finger{"", {ball(tip * Eigen::Vector3d(0.016, 0, 0.1), 0.005)}};
  EXPECT_EQ(SceneSensor(robot, finger).contact(q), "link \"left_finger\" and obstacle 1");
  EXPECT_TRUE(holds(robot.notes, "joint \"left_finger_joint\" stands at 0"));
  // Open: the other finger follows.
  const Robot open = read_robot(test_robot("ur5_gripper"),
                                {.tip = "tool0", .set_joints = {{"left_finger_joint", 0.03}}});
  EXPECT_EQ(SceneSensor(open, finger).contact(q), "");
  for (const double x : {-0.046, 0.046}) {
    const Scene beside{"", {ball(tip * Eigen::Vector3d(x, 0, 0.1), 0.005)}};
    EXPECT_EQ(SceneSensor(robot, beside).contact(q), "");
    EXPECT_NE(SceneSensor(open, beside).contact(q), "");
  }
  EXPECT_TRUE(holds(open.notes, "joint \"right_finger_joint\" stands at 0.03"));
}

/// Three links end to end, of which the last two are turned against each other by `zero` at 0.
std::string drawn_with_zero(double zero) {
  const std::string bar =
      "<collision><origin xyz=\"0.25 0 0\"/><geometry><box size=\"0.46 0.05 "
      "0.05\"/></geometry></collision>";
  std::string text = "<robot name=\"r\"><link name=\"l0\">" + bar + "</link>";
  for (int i = 1; i <= 3; ++i) {
    const std::string to = std::to_string(i), from = std::to_string(i - 1);
    text += "<link name=\"l" + to + "\">" + bar + "</link><joint name=\"j" + to +
            "\" type=\"continuous\"><parent link=\"l" + from + "\"/><child link=\"l" + to +
            "\"/><origin xyz=\"0.5 0 0\" rpy=\"0 0 " + std::to_string(i == 3 ? zero : 0) +
            "\"/><axis xyz=\"0 0 1\"/></joint>";
  }
  return text + "</robot>";
}

TEST(Body, WhereAJointsZeroIsDrawnChangesNothing) {
  const Robot straight = parse_robot(drawn_with_zero(0), "r.urdf");
  const Robot folded = parse_robot(drawn_with_zero(2.5), "r.urdf");
  for (const double a : {0.0, 2.2, 2.5}) {
    for (double b = -2.6; b < 2.6; b += 0.2) {
      EXPECT_EQ(SceneSensor(straight, {}).contact(joints({0, a, b})),
                SceneSensor(folded, {}).contact(joints({0, a, b - 2.5})))
          << a << " " << b;
    }
  }
  EXPECT_EQ(SceneSensor(folded, {}).contact(joints({0, 2.5, 0})), "link \"l1\" and link \"l3\"");
}

TEST(Body, LinksThatSweepPastEachOtherAreSeen) {
  const Robot robot = read_robot(test_robot("ur5"));
  const SceneSensor sensor(robot, {}, 0.002), half(robot, {}, 0.001);
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> value(-2.9, 2.9);
  const auto draw = [&] {
    JointVector q(robot.size());
    for (double& v : q) v = value(engine);
    return q;
  };
  int free = 0, crossed = 0;  // free at both ends, but not between them
  for (int i = 0; i < 1000; ++i) {
    const JointVector from = draw(), to = draw();
    if (!sensor.position_free(from) || !sensor.position_free(to)) continue;
    const bool is_free = sensor.motion_free(from, to);
    (is_free ? free : crossed)++;
    for (int k = 0; is_free && k <= 500; ++k) {
      ASSERT_TRUE(half.position_free(from + 0.002 * k * (to - from))) << i << " at " << k;
    }
  }
  EXPECT_GT(free, 100);
  EXPECT_GT(crossed, 20);
}

TEST(Body, ABranchStandsWhereItIsSet) {
  const std::map<std::string, std::string> parts{{"parts", kRobots}};
  const auto robot = [&](std::map<std::string, double> set) {
    return read_robot(test_robot("branch"),
                      {.tip = "tool", .set_joints = std::move(set), .packages = parts});
  };
  const Robot usual = robot({});
  EXPECT_EQ(usual.size(), 4);
  EXPECT_TRUE(holds(usual.notes, "joint \"flag_turn\" stands at 1.5"));
  EXPECT_EQ(usual.files, (std::vector<std::string>{kRobots + "/wedge.stl", kRobots + "/tool.obj"}));
  // The flag stands on the base, where it is in the way or not.
  const JointVector q = joints({2.05, 0.3, 0, 0});
  EXPECT_EQ(SceneSensor(usual, {}).contact(q), "link \"boom\" and link \"flag\"");
  EXPECT_EQ(SceneSensor(robot({{"flag_turn", 2.5}}), {}).contact(q), "");
  const auto refused = [&](std::map<std::string, double> set, const char* words) {
    expect_says(error_of([&] { return robot(std::move(set)); }, words), words);
  };
  refused({{"flag_trun", 1}}, "did you mean \"flag_turn\"?");
  refused({{"flag_turn", 3}}, "its limits are 0.5 .. 2.5");
  refused({{"lift", 1}}, "is one of the chain");
  refused({{"mast_fixed", 1}}, "does not move");
}

TEST(Body, PairsAreToldWithTheReason) {
  const Robot robot =
      read_robot(test_robot("ur5_gripper"),
                 {.tip = "tool0", .allow_contact = {{"wrist_1_link", "wrist_3_link"}}});
  std::map<std::pair<std::string, std::string>, LinkPair::Check> checks;
  for (const LinkPair& pair : link_pairs(robot)) {
    checks[{robot.links[pair.first].name, robot.links[pair.second].name}] = pair.check;
  }
  EXPECT_EQ(checks.size(), 45u);
  using Check = LinkPair::Check;
  EXPECT_EQ((checks.at({"base_link", "shoulder_link"})), Check::neighbours);
  EXPECT_EQ((checks.at({"base_link", "upper_arm_link"})), Check::yes);
  EXPECT_EQ((checks.at({"wrist_1_link", "wrist_3_link"})), Check::allowed);
  EXPECT_EQ((checks.at({"wrist_3_link", "gripper_base"})), Check::rigid);
  EXPECT_EQ((checks.at({"wrist_2_link", "gripper_base"})), Check::yes)
      << "it hangs on the link before";
  EXPECT_EQ(to_string(Check::neighbours), "neighbours");
}

TEST(Body, LinksWithoutGeometryAreCollapsed) {
  const auto chain = [](const std::string& between) {
    const std::string ball = "<collision><geometry><sphere radius=\"0.3\"/></geometry></collision>";
    const std::string joint = "type=\"continuous\"><axis xyz=\"0 0 1\"/><origin xyz=\"0.1 0 0\"/>";
    return parse_robot("<robot name=\"r\"><link name=\"a\">" + ball + "</link><link name=\"b\">" +
                           between + "</link><link name=\"c\">" + ball +
                           "</link><joint name=\"j\" " + joint +
                           "<parent link=\"a\"/><child link=\"b\"/></joint><joint name=\"k\" " +
                           joint + "<parent link=\"b\"/><child link=\"c\"/></joint></robot>",
                       "r.urdf");
  };
  EXPECT_TRUE(SceneSensor(chain(""), {}).position_free(joints({0, 0})));
  const Robot whole =
      chain("<collision><geometry><sphere radius=\"0.01\"/></geometry></collision>");
  EXPECT_EQ(SceneSensor(whole, {}).contact(joints({0, 0})), "link \"a\" and link \"c\"");
}

TEST(Body, WhatIsAboveTheBaseStandsWhereItsJointsPutIt) {
  const std::string text = R"(<robot name="r"><link name="rail"><collision>
    <geometry><sphere radius="0.1"/></geometry></collision></link><link name="a"/><link name="b"/>
    <joint name="turret" type="revolute"><parent link="rail"/><child link="a"/>
      <origin xyz="1 0 0.2"/><axis xyz="0 0 1"/><limit lower="0" upper="1" velocity="1" effort="1"/>
    </joint>
    <joint name="j" type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/>
      <limit lower="0" upper="1" velocity="1" effort="1"/></joint></robot>)";
  const Robot robot = parse_robot(text, "r.urdf", {.base = "a", .set_joints = {{"turret", 0.5}}});
  ASSERT_EQ(robot.links.size(), 1u);
  EXPECT_EQ(robot.links[0].body, 0);
  const Eigen::Vector3d at = robot.links[0].solids[0].pose.translation();
  EXPECT_TRUE(at.isApprox(Eigen::Vector3d(-std::cos(0.5), std::sin(0.5), -0.2))) << at.transpose();
}

TEST(Body, ARobotWithoutCollisionGeometryIsRefused) {
  std::string text = kUrdf;
  for (auto at = text.find("collision"); at != text.npos; at = text.find("collision", at)) {
    text.replace(at, 9, "visual");
  }
  expect_error(text, ErrorCode::file_broken, "no link has collision geometry");
  Chain chain;
  chain.use_visual = true;
  EXPECT_EQ(parse_robot(text, "r.urdf", chain).links.size(), 2u);
  chain.use_visual = false;
  chain.bodiless = true;
  EXPECT_TRUE(parse_robot(text, "r.urdf", chain).links.empty());
  EXPECT_TRUE(parse_robot(kUrdf, "r.urdf", chain).links.empty());
}

TEST(Body, JointsThatFollowTheChainAreRefused) {
  const std::string end = "</joint>\n</robot>";
  const std::string text = with(kUrdf, end, "<mimic joint=\"j1\"/>" + end);
  expect_error(text, ErrorCode::file_unsupported, "joint \"j2\" of the chain follows \"j1\"");
  Chain chain{.tip = "c"};
  expect_says(error_of([&] { return parse_robot(text, "r.urdf", chain); }), "--set-joint j2=VALUE");
  chain.set_joints["j2"] = 0.1;
  EXPECT_EQ(parse_robot(text, "r.urdf", chain).size(), 1);
}

TEST(Body, JointsThatStandTooFarAreRefused) {
  const std::string text =
      with(kUrdf, "lower=\"-0.2\" upper=\"0.3\"", "lower=\"2e20\" upper=\"4e20\"");
  expect_says(error_of([&] { return parse_robot(text, "r.urdf", {.tip = "c"}); }),
              "joint \"j2\" stands at 3e+20, farther than 1000000");
}

using FilesOfRobot = Files;

TEST_F(FilesOfRobot, Srdf) {
  const auto read = [&](const std::string& text) {
    return parse_robot(kUrdf, "r.urdf", {.srdf = file(text, "r.srdf")});
  };
  const Robot robot = read(R"(<?xml version="1.0"?><robot name="r">
    <group_state name="home" group="arm"><joint name="j1" value="0.5"/>
      <joint name="j2" value="-0.1"/></group_state>
    <group_state name="half" group="arm"><joint name="j1" value="0.5"/></group_state>
    <disable_collisions link1="c" link2="b" reason="Never"/>
    <disable_collisions link1="a" link2="b" reason="Never"/></robot>)");
  EXPECT_EQ(robot.may_touch, (std::vector{std::pair{0, 1}})) << "a has no body";
  EXPECT_EQ(robot.states.size(), 1u);
  EXPECT_EQ(robot.states.at("home"), joints({0.5, -0.1}));
  EXPECT_TRUE(holds(robot.notes, "state \"half\" is left out: it does not say j2"));
  const auto refused = [&](const std::string& element, std::int64_t line, const char* words) {
    expect_refused_at(read, "<robot name=\"r\">\n" + element + "</robot>", line, words);
  };
  refused("<disable_collisions link1=\"a\"/>", 2, "has no link2");
  refused("<group_state name=\"x\">\n<joint name=\"j1\" value=\"one\"/></group_state>", 3, "one");
  refused("<group_state name=\"x\">", 2, "no XML");
  refused("</robot>\n<robot name=\"r\">", 3, "a second document follows the first");
  refused("<xacro:arm prefix=\"\"/>", 2, "make it first: xacro ");
  refused("<disable_collisions link1=\"${p}a\" link2=\"b\"/>", 2, "xacro");
  refused("<group name=\"g\">\n<link name=\"$(arg p)a\"/></group>", 3, "xacro");
  refused("<link name=\"a\"/>", 2, "this is a robot in URDF");
  EXPECT_THROW(read(kUrdf), Error);
  EXPECT_NO_THROW(read("<robot name=\"r\" xmlns:xacro=\"http://x\"/>")) << "one that was made";
  const std::string all = "<robot name=\"r\"><disable_default_collisions link=\"b\"/>";
  EXPECT_EQ(read(all + "</robot>").may_touch, (std::vector{std::pair{0, 1}}));
  EXPECT_TRUE(read(all + "<enable_collisions link1=\"c\" link2=\"b\"/></robot>").may_touch.empty());
  // As MoveIt does; a pair whose name is wrong stays checked.
  const Robot other = read(R"(<robot name="r"><disable_collisions link1="c" link2="hand"/>
    <group_state name="home" group="arm"><joint name="j1" value="0.5"/>
      <joint name="j2" value="-0.1"/><joint name="j3" value="1"/></group_state></robot>)");
  EXPECT_TRUE(other.may_touch.empty());
  EXPECT_EQ(other.states.at("home"), joints({0.5, -0.1}));
  EXPECT_TRUE(holds(other.notes, "the SRDF names what the robot has not: hand, j3"));
}

TEST_F(FilesOfRobot, JointLimits) {
  const auto read = [&](const std::string& text) {
    return parse_robot(kUrdf, "r.urdf", {.joint_limits = file(text, "limits.yaml")});
  };
  const Robot robot = read(R"(default_velocity_scaling_factor: 0.5
joint_limits:
  j1: {has_velocity_limits: true, max_velocity: 3, has_acceleration_limits: false}
  j2:
    has_acceleration_limits: true
    max_acceleration: 7
    has_jerk_limits: true
    max_jerk: 30
    has_position_limits: true
    min_position: -0.1
    max_position: 5
)");
  EXPECT_DOUBLE_EQ(robot.joints[0].velocity, 1.5);
  EXPECT_DOUBLE_EQ(robot.joints[0].acceleration, 6);
  EXPECT_DOUBLE_EQ(robot.joints[1].acceleration, 7);
  EXPECT_EQ(robot.joints[0].jerk, 0);
  EXPECT_DOUBLE_EQ(robot.joints[1].jerk, 30);
  EXPECT_DOUBLE_EQ(robot.joints[1].low, -0.1);
  EXPECT_DOUBLE_EQ(robot.joints[1].high, 0.3) << "the tighter one";
  EXPECT_TRUE(holds(robot.notes,
                    "accelerations are taken as four times the velocity, since URDF has none: j1"));
  const auto refused = [&](const std::string& text, std::int64_t line, const char* words) {
    expect_refused_at(read, text, line, words);
  };
  refused("joint_limits:\n  j1:\n    has_velocity_limits: true\n    max_velocity: 0\n", 4, "is 0");
  refused("joint_limits:\n  j1:\n    has_velocity_limits: 7\n", 3, "neither true nor false");
  refused("joint_limits:\n  j1: 3\n", 2, "no list of keys");
  refused("joint_limits:\n---\njoint_limits:\n", 1, "something follows the document");
  refused("joint_limits:\n  j1: [\n", 3, "broken YAML");
  refused("joint_limits:\n  j9: {has_velocity_limits: false}\n", 2, "did you mean");
  refused("joint_limits:\n  j1: {}\n  j1: {}\n", 3, "names \"j1\" twice");
  refused("joint_limits:\n  j1:\n    has_velocity_limits: true\n", 3, "max_velocity is missing");
  refused("velocity: 3\n", 1, "the file has no joint_limits");
  refused("default_velocity_scaling_factor: 0\n", 1, ": default_velocity_scaling_factor is 0");
  refused("type octile\n", -1, "this is a MovingAI map");
  // The factors are of all joints, those too of which the file says nothing else.
  const Robot slow = read(
      "default_velocity_scaling_factor: 0.5\ndefault_acceleration_scaling_factor: 0.25\n"
      "joint_limits:\n");
  const Robot fast = parse_robot(kUrdf, "r.urdf");
  for (int j = 0; j < 2; ++j) {
    EXPECT_DOUBLE_EQ(slow.joints[j].velocity, 0.5 * fast.joints[j].velocity);
    EXPECT_DOUBLE_EQ(slow.joints[j].acceleration, 0.125 * fast.joints[j].acceleration);
  }
}

TEST_F(FilesOfRobot, SoftLimitsAreTheTighterOnes) {
  const std::string text = with(kUrdf, "effort=\"1\"/>",
                                "effort=\"1\"/><safety_controller k_velocity=\"1\" "
                                "soft_lower_limit=\"-0.1\" soft_upper_limit=\"9\"/>");
  const Joint joint = parse_robot(text, "r.urdf").joints[1];
  EXPECT_EQ(joint.low, -0.1);
  EXPECT_EQ(joint.high, 0.3);
}

/// A cube of side 2 in centimetres, moved by 10 along x.
const char* const kDae = R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="centimeter" meter="0.01"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="a" count="9">0 0 0 2 0 0 0 0 2</float_array>
<technique_common><accessor source="#a" count="3" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><translate>10 0 0</translate>
<instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";

TEST_F(FilesOfRobot, MeshesOfManyFormats) {
  const Triangles dae = read_mesh(file(kDae, "m.dae"));
  ASSERT_EQ(dae.size(), 1u);
  EXPECT_LT((dae[0][0] - Eigen::Vector3d(0.1, 0, 0)).norm(), 1e-7);
  EXPECT_LT((dae[0][1] - Eigen::Vector3d(0.12, 0, 0)).norm(), 1e-7);
  EXPECT_LT((dae[0][2] - Eigen::Vector3d(0.1, 0, 0.02)).norm(), 1e-7) << "z stays up";
  EXPECT_EQ(read_mesh(file(with(kDae, "Z_UP", "Y_UP"), "y.dae")), dae)
      << "as RViz and MoveIt have it";

  const Triangles obj = read_mesh(
      file("mtllib /etc/passwd\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n", "m.OBJ"));
  ASSERT_EQ(obj.size(), 2u) << "a face of four corners";
  EXPECT_THROW(read_mesh(file("x", "m.glb")), Error);
  for (const char* name : {"n.obj", "n.dae"}) {
    for (const char* text :
         {"x", "v 0 0 0\n", "v 0 0 0\nf 1 2 3\n", "v 1e9 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
          "<COLLADA/>", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"}) {
      EXPECT_THROW(read_mesh(file(text, name)), Error) << name << ": " << text;
    }
  }
}

TEST_F(FilesOfRobot, MeshesOfPackages) {
  file(kDae, "m.dae");
  const std::string text = with(kUrdf, "<sphere radius=\"0.2\"/>",
                                "<mesh filename=\"package://parts/m.dae\" scale=\"1 -1 2\"/>");
  expect_error(text, ErrorCode::file_unsupported, "--package parts=FOLDER");
  const Robot robot = parse_robot(text, "r.urdf", {.packages = {{"parts", folder()}}});
  EXPECT_EQ(robot.files, std::vector{path("m.dae")});
  const Solid& mesh = robot.links[1].solids.at(0);
  EXPECT_LT((mesh.triangles->at(0)[2] - Eigen::Vector3d(0.1, 0, 0.04)).norm(), 1e-7);
}

TEST(Body, TheRobotsOfOurTestsAreReadAndFreeSomewhere) {
  const std::map<std::string, std::string> parts{{"parts", kRobots}};
  for (const char* name :
       {"ur5", "puma560", "scara", "planar2", "planar3", "seven", "ur5_gripper", "branch"}) {
    Chain chain;
    chain.packages = parts;
    if (name == std::string("ur5_gripper")) chain.tip = "tool0";
    if (name == std::string("branch")) chain.tip = "tool";
    const Robot robot = read_robot(test_robot(name), chain);
    const Query query = generate_query(robot, {.seed = 1, .obstacles = 0});
    EXPECT_TRUE(SceneSensor(robot, {}).position_free(query.start)) << name;
  }
}

}  // namespace
}  // namespace lasius::arm
