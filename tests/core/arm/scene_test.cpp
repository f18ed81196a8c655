// What a scene's shapes have, and what a robot's bodies touch by their making.
#include <gtest/gtest.h>

#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "lasius/error.h"
#include "tests/core/arm/arms.h"
#include "tests/core/map_files/map_files.h"

namespace lasius::arm {
namespace {

class Shapes : public Files {
 protected:
  /// Reads a scene of one obstacle of these fields, beside a mesh in m.stl.
  Scene scene(const std::string& fields) const {
    file("solid s\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 1 0\nendsolid s\n", "m.stl");
    return read_scene(
        file(R"({"format": "lasius-scene/1", "obstacles": [{)" + fields + "}]}", "s.json"));
  }
};

TEST_F(Shapes, HaveNoFieldsOfOthers) {
  const std::pair<std::string, std::string> shapes[] = {
      {R"("shape": "box", "size": [1, 2, 3])", "radius length file scale"},
      {R"("shape": "sphere", "radius": 0.5)", "size length file scale"},
      {R"("shape": "cylinder", "radius": 0.5, "length": 2)", "size file scale"},
      {R"("shape": "mesh", "file": "m.stl")", "size radius length"}};
  for (const auto& [fields, foreign] : shapes) {
    EXPECT_NO_THROW(scene(fields));
    std::istringstream names(foreign);
    for (std::string name; names >> name;) {
      try {
        scene(fields + ", \"" + name + "\": 1");
        ADD_FAILURE() << fields << " with " << name;
      } catch (const Error& error) {
        EXPECT_NE(error.problem().find(name + " is not a field of a "), std::string::npos)
            << error.what();
      }
    }
  }
}

TEST_F(Shapes, MeshesReachNoFurtherThan1000Metres) {
  const std::string mesh = R"("shape": "mesh", "file": "m.stl", "scale": )";
  EXPECT_NO_THROW(scene(mesh + "500"));
  EXPECT_THROW(scene(mesh + "500.001"), Error);
}

// Bodies that are not next to each other and touch where all joints are at 0 may do so.
TEST(Urdf, WhatTouchesByItsMakingMayTouch) {
  const auto chain = [](const std::string& last_offset) {
    const std::string ball = "<collision><geometry><sphere radius=\"0.3\"/></geometry></collision>";
    std::string text = "<robot name=\"r\"><link name=\"l0\">" + ball + "</link>";
    for (int i = 1; i <= 3; ++i) {
      const std::string to = std::to_string(i), from = std::to_string(i - 1);
      text += "<link name=\"l" + to + "\">" + ball + "</link><joint name=\"j" + to +
              "\" type=\"continuous\"><parent link=\"l" + from + "\"/><child link=\"l" + to +
              "\"/><origin xyz=\"0 0 " + (i == 3 ? last_offset : "0.1") + "\"/></joint>";
    }
    return parse_robot(text + "</robot>", "r.urdf");
  };
  using Pairs = std::vector<std::pair<int, int>>;
  EXPECT_EQ(chain("0.1").may_touch, (Pairs{{0, 2}, {0, 3}, {1, 3}}));
  EXPECT_EQ(chain("5").may_touch, (Pairs{{0, 2}}));
  for (const Joint& joint : chain("5").joints) {
    EXPECT_NEAR(joint.low, -2 * std::numbers::pi, 1e-12) << "continuous: a turn either way";
    EXPECT_NEAR(joint.high, 2 * std::numbers::pi, 1e-12);
  }
}

}  // namespace
}  // namespace lasius::arm
