// Robots from URDF.
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "lasius/base/error.h"
#include "tests/core/arm/robot/arms.h"
#include "tests/core/arm/robot/refusals.h"

namespace lasius::arm {
namespace {

TEST(Urdf, AChainWithFixedJointsFolded) {
  const Robot robot = parse_robot(kUrdf, "r.urdf");
  ASSERT_EQ(robot.size(), 2);
  EXPECT_EQ(robot.name, "r");
  EXPECT_EQ(robot.joints[0].axis, Eigen::Vector3d(0, 0, 1));
  EXPECT_TRUE(robot.joints[0].continuous);
  EXPECT_EQ(robot.joints[0].high, 1000);
  // The cylinder of b and the sphere of c, which is fixed to it.
  ASSERT_EQ(robot.links.size(), 2u);
  EXPECT_EQ(robot.links[0].name, "b");
  EXPECT_EQ(robot.links[1].name, "c");
  EXPECT_EQ(robot.links[0].body, 1);
  EXPECT_EQ(robot.links[1].body, 1);
  EXPECT_EQ(robot.links[1].solids.at(0).pose.translation(), Eigen::Vector3d(0, 0, 1));
  EXPECT_DOUBLE_EQ(robot.links[1].solids[0].radius, 0.2);
  const Joint& slide = robot.joints[1];
  EXPECT_EQ(slide.kind, Joint::Kind::prismatic);
  EXPECT_EQ(slide.frame.translation(), Eigen::Vector3d(0, 0, 1.5));
  EXPECT_DOUBLE_EQ(slide.low, -0.2);
  EXPECT_DOUBLE_EQ(slide.velocity, 0.5);
  EXPECT_DOUBLE_EQ(slide.acceleration, 2);
  // Slides along the world's x at 0.
  EXPECT_LT(distance(tip_position(robot, joints({0.0, 0.3})), {0.3, 0, 1.5}), 1e-9);
}

TEST(Urdf, ChainsByName) {
  const Robot part = parse_robot(kUrdf, "r.urdf", {.base = "b", .tip = "d"});
  EXPECT_EQ(part.size(), 1);
  ASSERT_EQ(part.links.size(), 2u);
  EXPECT_EQ(part.links[1].body, 0);
  EXPECT_THROW(parse_robot(kUrdf, "r.urdf", {.base = "", .tip = "e"}), Error);
  EXPECT_THROW(parse_robot(kUrdf, "r.urdf", {.base = "d", .tip = "b"}), Error);
  EXPECT_THROW(parse_robot(kUrdf, "r.urdf", {.base = "b", .tip = "c"}), Error);
}

TEST(Urdf, BadFiles) {
  expect_error("<robot name=\"r\"><link name=\"b\"/></robot>", ErrorCode::file_broken, "no joint");
  expect_error("<robot", ErrorCode::file_broken, "URDF");
  expect_error("<a/>", ErrorCode::file_broken, "URDF");
  expect_error(with(kUrdf, "\"-0.2\"", "\"0.4\""), ErrorCode::file_broken, "no room");
  const std::string size = "radius=\"0.1";
  expect_error(with(kUrdf, size, "radius=\"1e9"), ErrorCode::file_broken, "out of range");
  for (const std::string radius : {"x", "nan", "0", "-1"}) {
    expect_error(with(kUrdf, size, "radius=\"" + radius), ErrorCode::file_broken, "cannot be read");
  }
  expect_error(with(kUrdf, "prismatic", "floating"), ErrorCode::file_unsupported, "j2");
  expect_error(with(kUrdf, "<sphere radius=\"0.2\"/>", "<mesh filename=\"package://x/y.dae\"/>"),
               ErrorCode::file_unsupported, "y.dae");
}

TEST(Urdf, FaultsAreNamedByLine) {
  using namespace std::string_literals;
  std::string deep, hidden;  // the latter in tags that look closed
  for (int i = 0; i < 300; ++i) deep += "<x>", hidden += "<x y='/>'>";
  const Spoilt cases[] = {
      {"radius=\"0.1\"", "radius=\"0\"", 2},
      {"radius=\"0.2\"", "radius=\"0\"", 4},
      {"0 0 2", "0 0 0", 6},
      {"\"0.3\"", "\"-0.3\"", 8},
      {"prismatic", "planar", 8},
      {"prismatic", "bending", 8},
      {"<robot name=\"r\">", "<robot>", 1},
      {"<robot name=\"r\">", "<robot name=\"r\"\nversion=\"2.0\">", 1},
      {"<child link=\"d\"/>", "<origin xyz=\"${x} 0 0\"/>", 8},
      {"\"-0.2\"", "\"nan\"", 8},
      {"\"-0.2\"", "\"-1e300\"", 8},
      {"<child link=\"d\"/>", "", 8},
      {"<link name=\"d\"/>", "<link name=\"c\"/>", 5},
      {"name=\"j2\"", "name=\"f\"", 8},
      {"0 0 2", "0 2", 6},
      {"velocity=\"0.5\"", "velocity=\"-2.5\"", 8},
      {"<link name=\"d\"/>", "<xacro:include filename=\"d\"/>", 5},
      {"0 0 2", "${height} 0 2", 6},
      {"type=\"prismatic\"", "type=\"prismatic", 8},
      {"</joint>\n</robot>", "</robot>", 10},
      {"<parent link=\"a\"/>", "<parent link=\"b\"/>", 6},
      {"<child link=\"d\"/>", "<child link=\"c\"/>", 8},
      {"<child link=\"d\"/>", "<child link=\"b\"/>", 8},
      {"xyz=\"0 0 1\"/></joint>", "xyz=\"0 0 1\0\"/></joint>"s, 7},
      {"<link name=\"d\"/>", "<link name=\"d\">" + deep + "</link>", 5},
      {"<link name=\"d\"/>", "<link name=\"d\">\n" + hidden + "</link>", 6},
      {"<link name=\"d\"/>", "<link name=\"d\"" + std::string(9000, ' ') + "/>", 5},
  };
  expect_lines(cases, kUrdf, [](const std::string& text) { parse_robot(text, "r.urdf"); });
}

TEST(Urdf, LinksThatAreNoTreeAreRefusedByName) {
  const auto refused = [](const std::vector<std::array<const char*, 2>>& joints,
                          const std::string& says) {
    std::string text = "<robot name=\"r\">";
    for (const char* link : {"a", "b", "c", "d"}) {
      text += "<link name=\"" + std::string(link) + "\"/>";
    }
    for (std::size_t i = 0; i < joints.size(); ++i) {
      text += "\n<joint type=\"fixed\" name=\"j" + std::to_string(i) + "\"><parent link=\"" +
              joints[i][0] + "\"/><child link=\"" + joints[i][1] + "\"/></joint>";
    }
    expect_error(text + "</robot>", ErrorCode::file_broken, says);
  };
  refused({{"a", "b"}, {"b", "c"}, {"d", "d"}}, "line 4: joint \"j2\" joins link \"d\" to itself");
  refused({{"a", "d"}, {"b", "d"}, {"c", "b"}, {"a", "c"}},
          "line 3: link \"d\" is the child of two joints, \"j0\" (line 2) and \"j1\"");
  refused({{"a", "b"}, {"c", "d"}, {"d", "c"}},
          "line 3: the links \"c\", \"d\" are joined in a loop");
  refused({{"b", "c"}, {"a", "b"}, {"c", "d"}, {"d", "a"}},
          "line 2: the links \"d\", \"a\", \"b\", \"c\" are joined in a loop");
  refused({{"c", "d"}, {"a", "b"}, {"b", "a"}}, "the links \"a\", \"b\" are joined in a loop");
  refused({{"a", "b"}, {"a", "c"}}, "Two root links found: [a] and [d]");
  refused({{"a", "b"}, {"a", "c"}, {"a", "e"}}, "child link [e]");
}

TEST(Urdf, AFileIsTakenForWhatItsNameSaysWhereItsTextDoesNot) {
  expect_says(error_of([] { return parse_robot("robot", "r.urdf"); }), "no URDF");
  expect_says(error_of([] { return parse_robot("robot", "r.json"); }), "not JSON");
}

TEST(Urdf, AVelocityLimitThatIsNotAbove0IsRefused) {
  for (const std::string velocity : {"0", "-2.5"}) {
    expect_error(with(kUrdf, "0.5\" effort", velocity + "\" effort"), ErrorCode::file_broken,
                 "joint \"j2\" has the velocity limit " + velocity);
  }
}

TEST(Urdf, WhatIsAssumedIsTold) {
  const Robot robot = parse_robot(kUrdf, "r.urdf");
  const std::vector<std::string> expected{
      "joint \"j1\" has no velocity limit: 1 a second is taken",
      "accelerations are taken as four times the velocity, since URDF has none: j1, j2",
      "links without collision geometry have no body: a, d"};
  EXPECT_EQ(robot.notes, expected);
}

}  // namespace
}  // namespace lasius::arm
