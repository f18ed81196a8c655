// What a scene's shapes have, and what a robot's bodies touch by their making.
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <utility>

#include "lasius/base/error.h"
#include "tests/core/arm/robot/arms.h"
#include "tests/core/base/made_files.h"
#include "tests/core/base/refusal.h"

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
      const std::string more = fields + ", \"" + name + "\": 1";
      expect_says(error_of([&] { return scene(more); }, more).problem(),
                  name + " is not a field of a ");
    }
  }
}

TEST_F(Shapes, AnotherWordForSizeIsKnown) {
  const std::string box = R"("shape": "box", "dims": [1, 1, 1])";
  EXPECT_EQ(error_of([&] { return scene(box); }, box).remedy(), "did you mean \"size\"?");
}

TEST_F(Shapes, MeshesReachNoFurtherThan1000Metres) {
  const std::string mesh = R"("shape": "mesh", "file": "m.stl", "scale": )";
  EXPECT_NO_THROW(scene(mesh + "500"));
  EXPECT_THROW(scene(mesh + "500.001"), Error);
}

}  // namespace
}  // namespace lasius::arm
