// SRDF: what MoveIt's setup assistant adds to a URDF.
#pragma once

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lasius::arm {

struct Srdf {
  /// A posture of a group of joints.
  struct State {
    std::string name, group;
    std::map<std::string, double> values;
  };
  std::string robot;  ///< its name
  std::vector<State> states;
  /// Pairs, the first below the second, and links that may touch all but those of enabled pairs.
  std::set<std::pair<std::string, std::string>> disabled, enabled;
  std::set<std::string> disabled_links;
  std::set<std::string> unknown;  ///< links and joints that the robot has not, as MoveIt skips them

  bool may_touch(const std::string& a, const std::string& b) const {
    const std::pair pair(std::min(a, b), std::max(a, b));
    return disabled.contains(pair) ||
           ((disabled_links.contains(a) || disabled_links.contains(b)) && !enabled.contains(pair));
  }
};

/// Of a robot of these links and joints. @throws Error(file_missing, file_broken) with the line.
Srdf read_srdf(const std::string& file, const std::vector<std::string_view>& links,
               const std::vector<std::string_view>& joints);

}  // namespace lasius::arm
