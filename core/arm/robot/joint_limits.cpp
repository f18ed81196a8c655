#include "core/arm/robot/joint_limits.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>

#include "core/arm/robot/refusals.h"
#include "core/base/did_you_mean.h"
#include "core/base/file_kind.h"
#include "core/base/number_text.h"
#include "core/base/special_values.h"
#include "core/base/text_lines.h"
#include "core/base/yaml_documents.h"
#include "core/map_files/byte_reader.h"

namespace lasius::arm {
namespace {

/// The values of one level of the file.
class Level {
 public:
  Level(const YAML::Node& node, const std::string& file, std::string path)
      : node_(node), file_(file), path_(std::move(path)) {
    if (!node_.IsMap())
      fail(node_, "", "is no list of keys and values", "see MoveIt's joint_limits.yaml");
  }

  double number(const std::string& key, double otherwise) const {
    const YAML::Node value = node_[key];
    if (!value.IsDefined()) return otherwise;
    double number = 0;
    if (!value.IsScalar() || !YAML::convert<double>::decode(value, number) ||
        !std::isfinite(number)) {
      fail(value, key, "is no finite number", "write it as " + key + ": 1.0");
    }
    return number;
  }
  /// Above 0, where the flag `has` is true.
  double limit(const std::string& has, const std::string& key) const {
    if (!flag(has)) return kNaN;
    const double value = number(key, kNaN);
    if (std::isnan(value)) fail(node_[has], key, "is missing", "give it, or leave out " + has);
    if (value <= 0) fail(node_[key], key, "is " + number_text(value), "it must be above 0");
    return value;
  }
  bool flag(const std::string& key) const {
    const YAML::Node value = node_[key];
    bool is = false;
    if (!value.IsDefined()) return false;
    if (!value.IsScalar() || !YAML::convert<bool>::decode(value, is))
      fail(value, key, "is neither true nor false", "write it as " + key + ": true");
    return is;
  }
  double factor(const std::string& key) const {
    const double value = number(key, 1);
    if (!(value > 0 && value <= 1))
      fail(node_[key], key, "is " + number_text(value), "it must be above 0, at most 1");
    return value;
  }
  YAML::Node at(const std::string& key) const { return node_[key]; }

  /// `key` names what is at fault; empty: the level.
  [[noreturn]] void fail(const YAML::Node& at, const std::string& key, const std::string& problem,
                         const std::string& remedy) const {
    const YAML::Mark mark = at.IsDefined() ? at.Mark() : node_.Mark();
    const std::string level = path_.empty() && key.empty() ? "the file" : path_;
    broken({.file = file_, .line = mark.is_null() ? 1 : mark.line + 1},
           level + (level.empty() || key.empty() ? "" : ": ") + key + " " + problem, remedy);
  }

 private:
  YAML::Node node_;
  const std::string& file_;
  std::string path_;
};

JointLimitsFile read_level(const YAML::Node& root, const std::string& file,
                           const std::vector<std::string_view>& known) {
  const Level top(root, file, "");
  JointLimitsFile limits;
  limits.velocity = top.factor("default_velocity_scaling_factor");
  limits.acceleration = top.factor("default_acceleration_scaling_factor");
  const YAML::Node joints = top.at("joint_limits");
  if (!joints.IsDefined())
    top.fail(root, "", "has no joint_limits", "see MoveIt's joint_limits.yaml");
  if (joints.IsNull()) return limits;
  const Level list(joints, file, "joint_limits");
  for (const auto& entry : joints) {
    const std::string name = entry.first.Scalar();
    if (std::ranges::find(known, name) == known.end())
      list.fail(entry.first, "", "names \"" + name + "\", which the robot has not",
                known.empty() ? "it has no joints" : did_you_mean(name, known));
    if (limits.joints.contains(name))
      list.fail(entry.first, "", "names \"" + name + "\" twice", "leave one of them out");
    const Level joint(entry.second, file, "joint_limits." + name);
    const bool placed = joint.flag("has_position_limits");
    limits.joints[name] = {
        placed ? joint.number("min_position", kNaN) : kNaN,
        placed ? joint.number("max_position", kNaN) : kNaN,
        limits.velocity * joint.limit("has_velocity_limits", "max_velocity"),
        limits.acceleration * joint.limit("has_acceleration_limits", "max_acceleration"),
        joint.limit("has_jerk_limits", "max_jerk")};
  }
  return limits;
}

}  // namespace

JointLimitsFile read_joint_limits(const std::string& file,
                                  const std::vector<std::string_view>& joints) {
  constexpr std::int64_t kMostBytes = 1 << 16;
  std::string text = read_text(file, kMostBytes);
  refuse_other_kinds(text, file, {FileKind::joint_limits}, "give MoveIt's joint_limits.yaml");
  end_lines_in_lf(text);
  try {
    if (documents_in(text) > 1) broken({.file = file, .line = 1}, kMoreDocuments, kOneDocument);
    return read_level(YAML::Load(text), file, joints);
  } catch (const YAML::Exception& error) {
    broken({.file = file, .line = error.mark.is_null() ? 1 : error.mark.line + 1},
           "broken YAML: " + error.msg, "correct it");
  }
}

}  // namespace lasius::arm
