// Robots, scenes and meshes from text and files.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>

#include "core/arm/enclose.h"
#include "core/arm/proximity.h"
#include "core/arm/vec3.h"
#include "lasius/error.h"
#include "tests/core/arm/arms.h"
#include "tests/core/base/other_locale.h"

namespace lasius::arm {
namespace {

constexpr const char* kUrdf = R"(<robot name="r">
  <link name="a"/><link name="b"><collision><origin xyz="0 0 0.5"/>
    <geometry><cylinder radius="0.1" length="1"/></geometry></collision></link>
  <link name="c"><collision><geometry><sphere radius="0.2"/></geometry></collision></link>
  <link name="d"/>
  <joint name="j1" type="continuous"><parent link="a"/><child link="b"/><axis xyz="0 0 2"/></joint>
  <joint name="f" type="fixed"><parent link="b"/><child link="c"/><origin xyz="0 0 1"/></joint>
  <joint name="j2" type="prismatic"><parent link="c"/><child link="d"/>
    <origin xyz="0 0 0.5" rpy="0 1.5707963267948966 0"/><axis xyz="0 0 1"/>
    <limit lower="-0.2" upper="0.3" velocity="0.5" effort="1"/></joint>
</robot>)";

/// What stands in a text, what is put in its place, and the line that is then at fault.
struct Spoilt {
  std::string from, to;
  std::int64_t line;
};

template <class Read>
void expect_lines(std::span<const Spoilt> cases, const std::string& text, const Read& read) {
  for (const auto& [from, to, line] : cases) {
    std::string broken = text;
    broken.replace(broken.find(from), from.size(), to);
    try {
      read(broken);
      ADD_FAILURE() << broken;
    } catch (const Error& error) {
      EXPECT_EQ(error.place().line, line) << error.what();
    }
  }
}

void expect_error(const std::string& text, ErrorCode code, const std::string& words) {
  try {
    parse_robot(text, "r.txt");
    ADD_FAILURE() << "accepted: " << text.substr(0, 80);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code) << error.what();
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    EXPECT_FALSE(error.remedy().empty());
  }
}

TEST(Urdf, AChainWithFixedJointsFolded) {
  const Robot robot = parse_robot(kUrdf, "r.urdf");
  ASSERT_EQ(robot.size(), 2);
  EXPECT_EQ(robot.name, "r");
  EXPECT_EQ(robot.joints[0].axis, Eigen::Vector3d(0, 0, 1));
  EXPECT_GT(robot.joints[0].high, 6);
  // The cylinder of b and the sphere of c, which is fixed to it.
  ASSERT_EQ(robot.joints[0].capsules.size(), 2u);
  EXPECT_EQ(robot.joints[0].capsules[0].to, Eigen::Vector3d(0, 0, 1));
  EXPECT_EQ(robot.joints[0].capsules[1].from, Eigen::Vector3d(0, 0, 1));
  EXPECT_DOUBLE_EQ(robot.joints[0].capsules[1].radius, 0.2);
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
  EXPECT_EQ(part.base.size(), 2u);
  EXPECT_THROW(parse_robot(kUrdf, "r.urdf", {.base = "", .tip = "e"}), Error);
  EXPECT_THROW(parse_robot(kUrdf, "r.urdf", {.base = "d", .tip = "b"}), Error);
  EXPECT_THROW(parse_robot(kUrdf, "r.urdf", {.base = "b", .tip = "c"}), Error);
}

TEST(Urdf, BadFiles) {
  expect_error("<robot", ErrorCode::file_broken, "URDF");
  expect_error("<a/>", ErrorCode::file_broken, "URDF");
  std::string no_room = kUrdf;
  no_room.replace(no_room.find("\"-0.2\""), 6, "\"0.4\"");
  expect_error(no_room, ErrorCode::file_broken, "no room");
  std::string huge = kUrdf;
  huge.replace(huge.find("radius=\"0.1\""), 12, "radius=\"1e9\"");
  expect_error(huge, ErrorCode::file_broken, "out of range");
  for (const char* radius : {"x", "nan", "0", "-1"}) {
    std::string no_size = kUrdf;
    no_size.replace(no_size.find("radius=\"0.1\""), 12, "radius=\"" + std::string(radius) + "\"");
    expect_error(no_size, ErrorCode::file_broken, "cannot be read");
  }
  std::string floating = kUrdf;
  floating.replace(floating.find("prismatic"), 9, "floating");
  expect_error(floating, ErrorCode::file_unsupported, "j2");
  std::string mesh = kUrdf;
  mesh.replace(mesh.find("<sphere radius=\"0.2\"/>"), 22, "<mesh filename=\"package://x/y.dae\"/>");
  expect_error(mesh, ErrorCode::file_unsupported, "y.dae");
}

TEST(Urdf, FaultsAreNamedByLine) {
  const Spoilt cases[] = {
      {"radius=\"0.1\"", "radius=\"0\"", 2},
      {"radius=\"0.2\"", "radius=\"0\"", 4},
      {"0 0 2", "0 0 0", 6},
      {"\"0.3\"", "\"-0.3\"", 8},
      {"prismatic", "planar", 8},
      {"velocity=\"0.5\"", "velocity=\"-2.5\"", 8},
      {"type=\"prismatic\"", "type=\"prismatic", 8},
      {"</joint>\n</robot>", "</robot>", 10},
  };
  expect_lines(cases, kUrdf, [](const std::string& text) { parse_robot(text, "r.urdf"); });
}

TEST(Urdf, AVelocityLimitOf0IsNone) {
  std::string text = kUrdf;
  text.replace(text.find("velocity=\"0.5\""), 14, "velocity=\"0\"");
  EXPECT_EQ(parse_robot(text, "r.urdf").joints[1].velocity, 1);
  std::string negative = kUrdf;
  negative.replace(negative.find("0.5\" effort"), 3, "-2.5");
  expect_error(negative, ErrorCode::file_broken, "joint \"j2\" has the velocity limit -2.5");
}

TEST(ShortRobot, WhatItsFieldsMean) {
  const Robot robot = parse_robot(R"({"format": "lasius-arm/1", "base": [0, 0, 1],
      "base_radius": 0.2, "may_touch": [[0, 2]], "joints": [
      {"axis": [0, 0, 3], "link": [1, 0, 0], "limits": [-1, 1]},
      {"type": "prismatic", "axis": [1, 0, 0], "link": [0, 2, 0], "radius": 0.1,
       "limits": [0, 1], "velocity": 0.5, "acceleration": 3}]})",
                                  "r.json");
  ASSERT_EQ(robot.size(), 2);
  EXPECT_EQ(robot.joints[0].axis, Eigen::Vector3d(0, 0, 1));
  EXPECT_TRUE(robot.joints[0].capsules.empty()) << "no radius, no body";
  EXPECT_EQ(robot.joints[1].frame.translation(), Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(robot.base.size(), 1u);
  EXPECT_EQ(robot.may_touch.size(), 1u);
  EXPECT_LT(distance(tip_position(robot, joints({0.0, 0.5})), {1.5, 2, 1}), 1e-12);
}

TEST(ShortRobot, BadFields) {
  const auto joint = [](const std::string& fields) {
    return "{\"format\": \"lasius-arm/1\", \"joints\": [{" + fields + "}]}";
  };
  const std::string good = R"("axis": [0, 0, 1], "link": [1, 0, 0], "limits": [-1, 1])";
  EXPECT_NO_THROW(parse_robot(joint(good), "r.json"));
  const std::pair<std::string, std::string> cases[] = {
      {joint(good + R"(, "type": "round")"), "joints[0].type is \"round\""},
      {joint(good + R"(, "velocity": 0)"), "joints[0].velocity is 0"},
      {joint(good + R"(, "velocity": "fast")"), "not a number"},
      {joint(good + R"(, "radius": -1)"), "joints[0].radius"},
      {joint(R"("axis": [0, 0, 0], "link": [1, 0, 0], "limits": [-1, 1])"), "no length"},
      {joint(R"("axis": [0, 0, 1], "link": [1, 0, 0], "limits": [1, -1])"), "above its second"},
      {joint(R"("axis": [0, 0, 1], "link": [1e9, 0, 0], "limits": [-1, 1])"), "joints[0].link"},
      {joint(R"("axis": [0, 0, 1], "link": [1, 0], "limits": [-1, 1])"), "list of 3"},
      {R"({"format": "lasius-arm/1", "joints": 3})", "joints is not a list"},
      {R"({"format": "lasius-arm/1", "joints": [3]})", "joints[0] is not an object"},
      {R"({"format": "lasius-arm/1", "joints": [], "name": 3})", "name is not a text"},
      {R"({"format": 3})", "format is 3"},
      {"null", "no \"format\""},
      {"{\n\"a\": \xff}", "line 2, byte 7: this is not JSON"},
      {"{\n\"a\": 1e999}", "line 2, byte 11: a number is too large"},
  };
  for (const auto& [text, words] : cases) expect_error(text, ErrorCode::file_broken, words);
  expect_error(
      R"({"format": "lasius-arm/1", "joints": [{)" + good + R"(}], "may_touch": [[0, 9]]})",
      ErrorCode::file_broken, "may_touch");
}

TEST(Enclose, ABoxIsInsideItsCapsules) {
  const Placement pose{roll_pitch_yaw({0.3, -0.8, 2}), {1, 2, 3}};
  for (const Vec3 size :
       {Vec3{1, 0.2, 0.2}, Vec3{0.1, 0.9, 0.4}, Vec3{0.5, 0.5, 0.01}, Vec3{1, 1, 1}}) {
    const auto capsules = enclose_box(pose, size);
    EXPECT_LE(capsules.size(), 4u);
    for (int i = 0; i < 1000; ++i) {
      const auto part = [&](int n) { return (i / n % 10) / 9.0 - 0.5; };
      const Vec3 p = pose * Vec3{part(1) * size.x, part(10) * size.y, part(100) * size.z};
      double nearest = 1e300;
      for (const Capsule& c : capsules) {
        nearest = std::min(nearest, distance_to_point({c.from, c.to}, p) - c.radius);
      }
      EXPECT_LE(nearest, 1e-12);
    }
  }
}

class Folder : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = testing::TempDir() + "lasius-arm-XXXXXX";
    folder_ = ::mkdtemp(name.data());
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string write(const std::string& name, const std::string& bytes) {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return (folder_ / name).string();
  }
  std::filesystem::path folder_;
};

std::string binary_stl(std::uint32_t claimed, const std::vector<float>& corners) {
  std::string bytes(80, 'x');
  bytes.append(reinterpret_cast<const char*>(&claimed), 4);
  for (std::size_t i = 0; i + 9 <= corners.size(); i += 9) {
    bytes.append(12, '\0');
    bytes.append(reinterpret_cast<const char*>(corners.data() + i), 36);
    bytes.append(2, '\0');
  }
  return bytes;
}

using StlFile = Folder;

TEST_F(StlFile, TextAndBinaryAreTheSame) {
  const auto text = read_stl(write("a.stl", R"(solid s
 facet normal 0 0 1
  outer loop
   vertex 0 0 0
   vertex 1 0 0
   vertex 0 2.5 0
  endloop
 endfacet
endsolid s
)"));
  const auto binary = read_stl(write("b.stl", binary_stl(1, {0, 0, 0, 1, 0, 0, 0, 2.5f, 0})));
  ASSERT_EQ(text.size(), 1u);
  EXPECT_EQ(text, binary);
  EXPECT_EQ(text[0][2], Eigen::Vector3d(0, 2.5, 0));
  const OtherLocale other;
  EXPECT_EQ(read_stl((folder_ / "a.stl").string()), text);
}

TEST_F(StlFile, BadOnes) {
  const auto refused = [&](const std::string& bytes) {
    EXPECT_THROW(read_stl(write("bad.stl", bytes)), Error) << bytes.substr(0, 40);
  };
  refused("");
  refused("solid empty\nendsolid\n");
  refused("solid s\nvertex 1 2\n");
  refused("solid s\nvertex 1 2 x\n");
  refused("solid s\nvertex 1 2 3\nvertex 1 2 3\n");
  refused("solid s\nfacet\nvertex 1 2 3\nfacet\n");
  refused("solid s\nvertex 1 2 1e9\nvertex 1 2 3\nvertex 1 2 3\n");
  refused(binary_stl(2, {0, 0, 0, 1, 0, 0, 0, 1, 0}));
  refused(binary_stl(0xffffffff, {0, 0, 0, 1, 0, 0, 0, 1, 0}));
  refused(binary_stl(1, {0, 0, 0, 1, 0, 0, 0, std::nanf(""), 0}));
  refused("a picture of a box");
  EXPECT_THROW(read_stl((folder_ / "missing.stl").string()), Error);
  EXPECT_THROW(read_stl(folder_.string()), Error);
}

TEST_F(StlFile, AMeshOfARobotMayBeMirroredButNotFlattened) {
  write("M.STL", "solid s\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 1\nendsolid\n");
  const auto scaled = [&](const std::string& scale) {
    std::string text = kUrdf;
    text.replace(text.find("<sphere radius=\"0.2\"/>"), 22,
                 "<mesh filename=\"M.STL\" scale=\"" + scale + "\"/>");
    return parse_robot(text, (folder_ / "r.urdf").string());
  };
  EXPECT_EQ(scaled("2 2 2").size(), 2);
  EXPECT_EQ(scaled("1 -1 1").size(), 2);
  EXPECT_EQ(scaled("1 1 1").meshes, std::vector{(folder_ / "M.STL").string()});
  for (const char* scale : {"1 0 1", "1 1 nan"}) {
    EXPECT_THROW(scaled(scale), Error) << scale;
  }
  try {
    scaled("1 1 0");
  } catch (const Error& error) {
    EXPECT_EQ(error.place().line, 4) << error.what();
    EXPECT_NE(std::string(error.what()).find("is scaled by 0"), std::string::npos);
  }
}

using AnyFile = Folder;

TEST_F(AnyFile, SaysWhatIsWrongWithIt) {
  const auto expect = [](const std::string& file, ErrorCode code, const std::string& words) {
    for (const auto& read : {+[](const std::string& name) { read_robot(name); },
                             +[](const std::string& name) { read_scene(name); },
                             +[](const std::string& name) { read_stl(name); }}) {
      try {
        read(file);
        ADD_FAILURE() << file << " was read";
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), code) << error.what();
        EXPECT_EQ(error.place().file, file);
        EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
      }
    }
  };
  expect((folder_ / "none").string(), ErrorCode::file_missing, "cannot be opened");
  expect(folder_.string(), ErrorCode::file_broken, "is a folder");
  expect(write("empty", ""), ErrorCode::file_broken, "is empty");
  const std::string large = write("large", "{");
  std::filesystem::resize_file(large, (256 << 20) + 1);
  expect(large, ErrorCode::file_unsupported, "is larger than");
  const std::string unreadable = "/proc/self/mem";  // its first byte is on no page
  expect(unreadable, ErrorCode::file_broken, "reading failed");
}

using SceneFile = Folder;

// In texts of one number a line, so that lines tell which.
TEST_F(SceneFile, FaultsAreNamedByLine) {
  const std::string text = R"({
    "format": "lasius-scene/1",
    "obstacles": [
      {"shape": "box", "size": [1, 2, 3]},
      {"shape": "cylinder",
       "radius": 0.1,
       "length": 2,
       "position": [1,
                    2, 3]}]})";
  EXPECT_EQ(parse_scene(text, "s.json").obstacles.size(), 2u);
  const Spoilt cases[] = {
      {"scene/1", "scene/7", 2}, {"\"size\"", "\"siez\"", 4},   {"cylinder", "cilinder", 5},
      {"0.1", "-0.1", 6},        {"\"length\"", "\"long\"", 7}, {"2, 3]}]", "\"2\", 3]}]", 8},
      {"\"length\": 2,", "", 5},
  };
  expect_lines(cases, text, [](const std::string& scene) { parse_scene(scene, "s.json"); });
  std::string large = text;
  const auto at = large.find("0.1");
  large.replace(at, 3, "1e999");
  try {
    parse_scene(large, "s.json");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.place().offset, static_cast<std::int64_t>(at) + 4) << error.what();
  }
}

TEST_F(SceneFile, AllShapes) {
  write("m.stl", "solid s\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendsolid s\n");
  const Scene scene = read_scene(write("s.json", R"({"format": "lasius-scene/1", "obstacles": [
      {"shape": "box", "size": [1, 2, 3], "position": [1, 0, 0], "rpy": [0, 0, 1.5707963267948966]},
      {"shape": "sphere", "radius": 0.5, "name": "ball"},
      {"shape": "cylinder", "radius": 0.1, "length": 2},
      {"shape": "mesh", "file": "m.stl", "scale": 2}]})"));
  ASSERT_EQ(scene.obstacles.size(), 4u);
  EXPECT_LT(distance(from_eigen(scene.obstacles[0].pose).rotation * Vec3{1, 0, 0}, {0, 1, 0}),
            1e-12);
  EXPECT_EQ(scene.obstacles[1].name, "ball");
  EXPECT_DOUBLE_EQ(scene.obstacles[2].length, 2);
  EXPECT_EQ(scene.obstacles[3].triangles[0][1], Eigen::Vector3d(2, 0, 0));
  EXPECT_EQ(scene.obstacles[3].file, (folder_ / "m.stl").string());
  EXPECT_NO_THROW(validate(scene));
}

TEST(Generate, QuestionsAreFreeAndTheSameBySeed) {
  const Robot robot = shipped("industrial6");
  const Query a = generate_query(robot, {.seed = 3, .obstacles = 15, .wall = 1});
  const Query b = generate_query(robot, {.seed = 3, .obstacles = 15, .wall = 1});
  const Query c = generate_query(robot, {.seed = 4, .obstacles = 15, .wall = 1});
  EXPECT_EQ(a.start, b.start);
  EXPECT_EQ(a.goal, b.goal);
  EXPECT_NE(a.start, c.start);
  EXPECT_EQ(a.scene.obstacles.size(), 16u);
  EXPECT_TRUE(SceneSensor(robot, a.scene).position_free(a.start));
  EXPECT_THROW(generate_query(robot, {.obstacles = -1}), Error);
  EXPECT_THROW(generate_query(robot, {.least_distance = 2}), Error);
}

}  // namespace
}  // namespace lasius::arm
