// Robots and scenes: URDF and JSON. What is accepted is valid and can be used.
#include <string>

#include "lasius/arm/sensor.h"
#include "tests/fuzz/reading.h"

namespace lasius::fuzz {
namespace {

template <class Parse>
auto accepted(const Parse& parse) -> std::optional<decltype(parse())> {
  try {
    return parse();
  } catch (const Error& error) {
    require(!error.problem().empty() && !error.remedy().empty());
    return {};
  }
}

}  // namespace

void check(const std::string& text) {
  using namespace lasius::arm;
  if (const auto scene = accepted([&] { return parse_scene(text, "nowhere/fuzz"); })) {
    validate(*scene);
  }
  for (const Chain& chain : {Chain{}, Chain{.tip = "b", .use_visual = true}}) {
    if (const auto robot = accepted([&] { return parse_robot(text, "nowhere/fuzz", chain); })) {
      JointVector q(robot->size());
      for (int j = 0; j < robot->size(); ++j) q[j] = robot->joints[j].low;
      accepted([&] { return SceneSensor(*robot, {}).position_free(q); });
    }
  }
}

}  // namespace lasius::fuzz
