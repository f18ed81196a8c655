// Robots, scenes and meshes from text and files.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>

#include "core/arm/robot/vec3.h"
#include "lasius/base/error.h"
#include "tests/core/arm/robot/arms.h"
#include "tests/core/arm/robot/refusals.h"
#include "tests/core/base/made_files.h"
#include "tests/core/base/other_locale.h"

namespace lasius::arm {
namespace {

TEST(ShortRobot, WhatItsFieldsMean) {
  const Robot robot = parse_robot(R"({"format": "lasius-arm/1", "base": [0, 0, 1],
      "base_radius": 0.2, "may_touch": [[0, 2]], "joints": [
      {"axis": [0, 0, 3], "link": [1, 0, 0], "limits": [-1, 1]},
      {"type": "prismatic", "axis": [1, 0, 0], "link": [0, 2, 0], "radius": 0.1,
       "limits": [0, 1], "velocity": 0.5, "acceleration": 3}]})",
                                  "r.json");
  ASSERT_EQ(robot.size(), 2);
  EXPECT_EQ(robot.joints[0].axis, Eigen::Vector3d(0, 0, 1));
  ASSERT_EQ(robot.links.size(), 3u);
  EXPECT_TRUE(robot.links[1].solids.empty()) << "no radius, no body";
  ASSERT_EQ(robot.notes.size(), 1u);
  expect_says(robot.notes[0], "without a \"radius\" links have no body: those of joints 0");
  EXPECT_EQ(robot.joints[1].frame.translation(), Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(robot.links[0].solids.size(), 1u);
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
      {joint(good + R"(, "name": "a"}, {"name": "a", )" + good),
       "joints[1].name is another joint's"},
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
      {"{\r\"a\": 1,\r\"a\": 2}", "line 3, byte 12: \"a\" is given again"},
  };
  for (const auto& [text, words] : cases) expect_error(text, ErrorCode::file_broken, words);
  for (const std::string pair : {"[0, 9]", "[0.5, 1]"})
    expect_error(
        R"({"format": "lasius-arm/1", "joints": [{)" + good + R"(}], "may_touch": [)" + pair + "]}",
        ErrorCode::file_broken, "may_touch");
}

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

using StlFile = Files;

TEST_F(StlFile, TextAndBinaryAreTheSame) {
  const std::string ascii = R"(solid s
 facet normal 0 0 1
  outer loop
   vertex 0 0 0
   vertex 1 0 0
   vertex 0 2.5 0
  endloop
 endfacet
endsolid s
)";
  const auto text = read_stl(file(ascii, "a.stl"));
  std::string only_cr = ascii;
  std::ranges::replace(only_cr, '\n', '\r');
  EXPECT_EQ(read_stl(file(only_cr, "c.stl")), text);
  const auto binary = read_stl(file(binary_stl(1, {0, 0, 0, 1, 0, 0, 0, 2.5f, 0}), "b.stl"));
  ASSERT_EQ(text.size(), 1u);
  EXPECT_EQ(text, binary);
  EXPECT_EQ(text[0][2], Eigen::Vector3d(0, 2.5, 0));
  std::string two = "solid s facet\n";
  for (int i = 0; i < 2; ++i)
    two +=
        "facet normal 0 0 1 outer loop vertex 0 0 0 vertex +1 0 0 vertex 0 2.5 0 endloop endfacet ";
  EXPECT_EQ(read_stl(file(two + "\nendsolid", "l.stl")), Triangles(2, text[0])) << "on one line";
  const OtherLocale other;
  EXPECT_EQ(read_stl(path("a.stl")), text);
}

TEST_F(StlFile, BadOnes) {
  const auto refused = [&](const std::string& bytes) {
    EXPECT_THROW(read_stl(file(bytes, "bad.stl")), Error) << bytes.substr(0, 40);
  };
  refused("");
  refused("solid empty\nendsolid\n");
  refused("solid s\nvertex 1 2\n");
  refused("solid s\nvertex 1 2 x\n");
  refused("solid s\nvertex 1 2 3\nvertex 1 2 3\n");
  refused("solid s\nfacet\nvertex 1 2 3\nfacet\n");
  for (const char* facet :
       {"vertex 0 0 0 1\nvertex 1 0 0\nvertex 0 1 0\n", "vertex 0 0 0vertex 1 0 0\n",
        "vertx 0 0 0\nvertx 1 0 0\nvertx 0 1 0\nendfacet\n", "vertex 0,0,0\n"})
    refused("solid s\nfacet\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendfacet\nfacet\n" +
            std::string(facet) + "endsolid\n");
  refused("solid s\nvertex 1 2 1e9\nvertex 1 2 3\nvertex 1 2 3\n");
  refused(binary_stl(2, {0, 0, 0, 1, 0, 0, 0, 1, 0}));
  refused(binary_stl(0xffffffff, {0, 0, 0, 1, 0, 0, 0, 1, 0}));
  refused(binary_stl(1, {0, 0, 0, 1, 0, 0, 0, std::nanf(""), 0}));
  refused("a picture of a box");
  EXPECT_THROW(read_stl(path("missing.stl")), Error);
  EXPECT_THROW(read_stl(folder()), Error);
}

TEST_F(StlFile, AMeshOfARobotMayBeMirroredButNotFlattened) {
  file("solid s\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 1\nendsolid\n", "M.STL");
  const auto scaled = [&](const std::string& scale) {
    const std::string mesh = "<mesh filename=\"M.STL\" scale=\"" + scale + "\"/>";
    return parse_robot(with(kUrdf, "<sphere radius=\"0.2\"/>", mesh), path("r.urdf"));
  };
  EXPECT_EQ(scaled("2 2 2").size(), 2);
  EXPECT_EQ(scaled("1 -1 1").size(), 2);
  EXPECT_EQ(scaled("1 1 1").files, std::vector{path("M.STL")});
  for (const char* scale : {"1 0 1", "1 1 nan"}) {
    EXPECT_THROW(scaled(scale), Error) << scale;
  }
  const Error error = error_of([&] { return scaled("1 1 0"); });
  EXPECT_EQ(error.place().line, 4) << error.what();
  expect_says(error, "is scaled by 0");
  EXPECT_TRUE(scaled("1 1 1").warnings.empty());
  file("solid s\nvertex 0 0 0\nvertex 400 0 0\nvertex 0 1 1\nendsolid\n", "M.STL");
  EXPECT_EQ(scaled("1 1 1").warnings,
            std::vector{"the mesh " + path("M.STL") +
                        " is 400 m long: if it is in millimetres, scale it by 0.001"});
  EXPECT_TRUE(scaled("0.001 0.001 0.001").warnings.empty());
}

using AnyFile = Files;

TEST_F(AnyFile, SaysWhatIsWrongWithIt) {
  const auto expect = [](const std::string& file, ErrorCode code, const std::string& words) {
    for (const auto& read : {+[](const std::string& name) { read_robot(name); },
                             +[](const std::string& name) { read_scene(name); },
                             +[](const std::string& name) { read_stl(name); }}) {
      const Error error = error_of([&] { read(file); }, file);
      EXPECT_EQ(error.code(), code) << error.what();
      EXPECT_EQ(error.place().file, file);
      expect_says(error, words);
    }
  };
  expect(path("none"), ErrorCode::file_missing, "cannot be opened");
  expect(folder(), ErrorCode::file_broken, "is a folder");
  expect(file("", "empty"), ErrorCode::file_broken, "is empty");
  const std::string large = file("{", "large");
  std::filesystem::resize_file(large, (256 << 20) + 1);
  expect(large, ErrorCode::file_unsupported, "is larger than");
  const std::string unreadable = "/proc/self/mem";  // its first byte is on no page
  expect(unreadable, ErrorCode::file_broken, "reading failed");
}

using SceneFile = Files;

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
  const auto at = static_cast<std::int64_t>(text.find("0.1"));
  const Error large = error_of([&] { return parse_scene(with(text, "0.1", "1e999"), "s.json"); });
  EXPECT_EQ(large.place().offset, at + 4) << large.what();
}

TEST_F(SceneFile, AllShapes) {
  file("solid s\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendsolid s\n", "m.stl");
  const Scene scene = read_scene(file(R"({"format": "lasius-scene/1", "obstacles": [
      {"shape": "box", "size": [1, 2, 3], "position": [1, 0, 0], "rpy": [0, 0, 1.5707963267948966]},
      {"shape": "sphere", "radius": 0.5, "name": "ball"},
      {"shape": "cylinder", "radius": 0.1, "length": 2},
      {"shape": "mesh", "file": "m.stl", "scale": 2}]})",
                                      "s.json"));
  ASSERT_EQ(scene.obstacles.size(), 4u);
  EXPECT_LT(distance(from_eigen(scene.obstacles[0].pose).rotation * Vec3{1, 0, 0}, {0, 1, 0}),
            1e-12);
  EXPECT_EQ(scene.obstacles[1].name, "ball");
  EXPECT_DOUBLE_EQ(scene.obstacles[2].length, 2);
  EXPECT_EQ(scene.obstacles[3].triangles->at(0)[1], Eigen::Vector3d(2, 0, 0));
  EXPECT_EQ(scene.obstacles[3].file, path("m.stl"));
  EXPECT_NO_THROW(validate(scene));
}

}  // namespace
}  // namespace lasius::arm
