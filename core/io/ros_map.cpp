#include "core/io/ros_map.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/text_lines.h"
#include "core/base/yaml_documents.h"

namespace lasius {
namespace {

constexpr std::size_t kLargestFile = 1 << 16;

// The values of the file's top level, each checked, each fault with its key's line.
class Fields {
 public:
  Fields(const ByteReader& in, const YAML::Node& root) : in_(in), root_(root) {
    if (!root.IsMap())
      in_.fail_at_line(1, "this is no list of keys and values", "start with 'image: map.pgm'");
    std::set<std::string> keys;
    for (const auto& entry : root_) {
      if (!entry.first.IsScalar() || keys.insert(entry.first.Scalar()).second) continue;
      in_.fail_at_line(entry.first.Mark().line + 1, "'" + entry.first.Scalar() + "' is given again",
                       "leave one of the two lines out");
    }
  }

  // Line 1 for a key that is missing.
  std::int64_t line_of(const std::string& key) const {
    for (const auto& entry : root_)
      if (entry.first.IsScalar() && entry.first.Scalar() == key) return entry.first.Mark().line + 1;
    return 1;
  }
  [[noreturn]] void fail(const std::string& key, const std::string& problem,
                         const std::string& remedy) const {
    in_.fail_at_line(line_of(key), "'" + key + "' " + problem, remedy);
  }

  bool has(const std::string& key) const { return root_[key].IsDefined(); }
  YAML::Node get(const std::string& key, const std::string& usual) const {
    const YAML::Node node = root_[key];
    if (!node.IsDefined())
      fail(key, "is missing", "add a line such as '" + key + ": " + usual + "'");
    return node;
  }
  std::string text(const std::string& key, const std::string& usual) const {
    const YAML::Node node = get(key, usual);
    if (!node.IsScalar() || node.Scalar().empty())
      fail(key, "is empty or no text", "write it as '" + key + ": " + usual + "'");
    if (node.Scalar().find('\0') != std::string::npos)
      fail(key, "holds a zero byte", "write it as '" + key + ": " + usual + "'");
    return node.Scalar();
  }
  double number(const std::string& key, const std::string& usual) const {
    return number(get(key, usual), key, usual);
  }
  double number(const YAML::Node& node, const std::string& key, const std::string& usual) const {
    double value = 0;
    if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !std::isfinite(value))
      fail(key, "is no finite number", "write it as '" + key + ": " + usual + "'");
    return value;
  }
  bool flag(const std::string& key) const {
    const YAML::Node node = get(key, "0");
    int number = 0;
    bool value = false;
    if (node.IsScalar() && YAML::convert<int>::decode(node, number)) {
      return number != 0;  // as map_server takes it
    } else if (node.IsScalar() && YAML::convert<bool>::decode(node, value)) {
      return value;
    }
    fail(key, "is neither 0 nor 1", "write it as '" + key + ": 0'");
  }

 private:
  const ByteReader& in_;
  YAML::Node root_;
};

WorldFrame read_frame(const Fields& fields) {
  WorldFrame frame;
  frame.resolution = fields.number("resolution", "0.05");
  constexpr double kMostMetres = 1e299;  // so that all lengths of a map are finite
  if (!(frame.resolution > 0 && frame.resolution <= kMostMetres))
    fields.fail("resolution", "is not above 0, or above 1e299", "give the metres a cell");
  const std::string usual = "[0.0, 0.0, 0.0]";
  const YAML::Node origin = fields.get("origin", usual);
  if (!origin.IsSequence() || origin.size() != 3)
    fields.fail("origin", "is not a list of x, y and yaw", "write it as 'origin: " + usual + "'");
  frame.origin_x = fields.number(origin[0], "origin", usual);
  frame.origin_y = fields.number(origin[1], "origin", usual);
  frame.yaw = fields.number(origin[2], "origin", usual);
  return frame;
}

RosMap::Mode read_mode(const Fields& fields) {
  if (!fields.has("mode")) return RosMap::Mode::trinary;
  const std::string mode = fields.text("mode", "trinary");
  const auto is = [&](std::string_view name) {  // small or capital letters
    return std::ranges::equal(mode, name, {},
                              [](char c) { return c >= 'A' && c <= 'Z' ? c | 32 : c; });
  };
  if (is("trinary")) return RosMap::Mode::trinary;
  if (is("scale")) return RosMap::Mode::scale;
  if (is("raw")) return RosMap::Mode::raw;
  fields.fail("mode", "is '" + mode.substr(0, 20) + "'", "the modes are trinary, scale and raw");
}

RosMap read_fields(const Fields& fields) {
  RosMap ros;
  ros.image = fields.text("image", "map.pgm");
  ros.image_line = fields.line_of("image");
  ros.frame = read_frame(fields);
  ros.mode = read_mode(fields);
  ros.negate = fields.flag("negate");
  ros.occupied_thresh = fields.number("occupied_thresh", "0.65");
  ros.free_thresh = fields.number("free_thresh", "0.196");
  if (!(0 <= ros.free_thresh && ros.free_thresh <= ros.occupied_thresh &&
        ros.occupied_thresh <= 1)) {
    fields.fail("free_thresh", "and 'occupied_thresh' are out of order",
                "0 <= free_thresh <= occupied_thresh <= 1 must hold");
  }
  return ros;
}

}  // namespace

RosMap read_ros_yaml(ByteReader& in) {
  std::string text(kLargestFile + 1, '\0');
  text.resize(in.read(text.data(), text.size()));
  if (text.size() > kLargestFile)
    in.fail_at_line(1, "larger than any ROS map description", "name the YAML file, not the image");
  end_lines_in_lf(text);
  try {
    if (documents_in(text) > 1) in.fail_at_line(1, kMoreDocuments, kOneDocument);
    return read_fields(Fields(in, YAML::Load(text)));
  } catch (const YAML::Exception& error) {
    in.fail_at_line(error.mark.is_null() ? 1 : error.mark.line + 1, "broken YAML: " + error.msg,
                    "correct it");
  }
}

double ros_darkness(const RosMap& ros, int level, int white) {
  return static_cast<double>(ros.negate ? level : white - level) / white;
}

int ros_grey(int level, int white) { return (level * 255 + white / 2) / white; }

PixelRule ros_rule(const RosMap& ros, const ReadOptions& options) {
  const int unknown =
      PixelRule::kUnknown | (options.unknown_is_free ? PixelRule::kFree : PixelRule::kBlocked);
  const double free_below = options.free_below;
  const auto blocked_if = [](bool blocked) -> int {
    return blocked ? PixelRule::kBlocked : PixelRule::kFree;
  };
  if (ros.mode == RosMap::Mode::raw) {
    const auto kind = [=](int level, int white) {
      const int grey = ros_grey(level, white);
      return grey > 100 ? unknown : blocked_if(grey >= 100 * free_below);
    };
    return {kind, unknown, PixelRule::Transparent::ignored};
  }
  const auto kind = [=](int level, int white) {
    const double p = ros_darkness(ros, level, white);
    if (p <= ros.free_thresh || p >= ros.occupied_thresh)
      return blocked_if(p >= ros.occupied_thresh);
    if (ros.mode == RosMap::Mode::trinary) return unknown;
    return blocked_if(p - ros.free_thresh >= free_below * (ros.occupied_thresh - ros.free_thresh));
  };
  return {kind, unknown, PixelRule::Transparent::unknown};
}

}  // namespace lasius
