#include "core/arm/robot/urdf.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/arm/robot/joint_limits.h"
#include "core/arm/robot/refusals.h"
#include "core/arm/robot/srdf.h"
#include "core/arm/robot/urdf_file.h"
#include "core/arm/robot/urdf_geometry.h"
#include "core/arm/robot/urdf_joints.h"
#include "core/arm/robot/vec3.h"
#include "core/base/did_you_mean.h"
#include "core/base/invalid_parameter.h"
#include "core/base/number_text.h"
#include "lasius/base/error.h"

namespace lasius::arm {
namespace {

using LinkPtr = urdf::LinkConstSharedPtr;

/// The names of a map's entries.
template <class Map>
std::vector<std::string_view> names_of(const Map& map) {
  std::vector<std::string_view> names;
  names.reserve(map.size());
  for (const auto& entry : map) names.push_back(entry.first);
  return names;
}

/// "a, b, c", of many the first ten.
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 10;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i)
    text += (i > 0 ? ", " : "") + names[i];
  return names.size() > kMost ? text + " and " + std::to_string(names.size() - kMost) + " more"
                              : text;
}

/// A robot from the links of a file: the chain first, then what hangs on it.
class RobotMaker {
 public:
  RobotMaker(const UrdfFile& source, const Chain& chain)
      : source_(source),
        model_(source.model()),
        chain_(chain),
        base_(chain.base.empty() ? model_.getRoot() : find_link(chain.base, "base ")),
        tip_(chain.tip.empty() ? only_leaf() : find_link(chain.tip, "tip ")) {
    if (!chain.joint_limits.empty()) {
      limits_ = read_joint_limits(chain.joint_limits, names_of(model_.joints_));
      robot_.files.push_back(chain.joint_limits);
    }
    for (const auto& [name, value] : chain.set_joints) find_joint(name);
  }

  Robot make() {
    robot_.name = model_.getName();
    place_chain();
    for (const auto& [name, value] : chain_.set_joints) check_set(*find_joint(name), value);
    place_rest();
    if (!chain_.bodiless) add_links();
    allow_contacts();
    return std::move(robot_);
  }

 private:
  /// Where a link is in the body that it moves with.
  struct Place {
    int body;
    Placement at;
  };

  LinkPtr find_link(const std::string& name, const std::string& what = {}) const {
    if (LinkPtr link = model_.getLink(name)) return link;
    refuse("the robot has no " + what + "link " + in_quotes(name),
           did_you_mean(name, names_of(model_.links_)));
  }
  urdf::JointConstSharedPtr find_joint(const std::string& name) const {
    if (auto joint = model_.getJoint(name)) return joint;
    const auto names = names_of(model_.joints_);
    refuse("the robot has no joint " + in_quotes(name),
           names.empty() ? "it has none at all" : did_you_mean(name, names));
  }
  LinkPtr only_leaf() const;
  void place_chain();
  void place_rest();
  void add_links();
  void allow_contacts();
  void read_states(const Srdf& srdf);
  void check_set(const urdf::Joint& joint, double value) const;
  double fixed_value(const urdf::Joint& joint);
  Placement placement_of(const urdf::Joint& joint);
  bool in_chain(const std::string& joint) const {
    return std::ranges::any_of(robot_.joints, [&](const Joint& j) { return j.name == joint; });
  }

  const UrdfFile& source_;
  const urdf::ModelInterface& model_;
  const Chain& chain_;
  LinkPtr base_, tip_;
  JointLimitsFile limits_;
  std::map<std::string, Place, std::less<>> places_;  // by link
  std::map<std::string, int, std::less<>> numbers_;   // of links that have a body
  Robot robot_;
};

LinkPtr RobotMaker::only_leaf() const {
  LinkPtr leaf;
  std::vector<std::string> names;
  for (const auto& [name, link] : model_.links_) {
    if (!link->child_links.empty()) continue;
    leaf = link;
    names.push_back(name);
  }
  if (names.size() == 1) return leaf;
  refuse("the robot ends in several links: " + listed(names), "choose one of them as the tip");
}

void RobotMaker::place_chain() {
  std::vector<LinkPtr> links;  // from the tip down to the base
  LinkPtr last = tip_;
  for (; last != nullptr && last != base_; last = last->getParent()) links.push_back(last);
  if (last != base_)
    refuse("link " + in_quotes(tip_->name) + " does not hang on " + in_quotes(base_->name),
           "choose a base between the root and the tip");
  std::ranges::reverse(links);
  std::vector<std::string> invented;  // accelerations
  Placement at;
  places_[base_->name] = {0, at};
  for (const LinkPtr& link : links) {
    const urdf::Joint& joint = *link->parent_joint;
    at = at * placement(joint.parent_to_joint_origin_transform);
    if (joint.mimic != nullptr)
      unsupported(
          source_.joint(joint.name),
          "joint \"" + joint.name + "\" of the chain follows \"" + joint.mimic->joint_name + '"',
          "choose a base or tip that leaves it out, or take its <mimic> out");
    if (moves(joint)) {
      robot_.joints.push_back(moving_joint(joint, at, source_, limits_, robot_.notes));
      at = {};
      const auto limit = limits_.joints.find(joint.name);
      if (limit == limits_.joints.end() || std::isnan(limit->second.acceleration))
        invented.push_back(joint.name);
    } else if (joint.type != urdf::Joint::FIXED) {
      unsupported(source_.joint(joint.name),
                  "joint \"" + joint.name + "\" is neither fixed nor turns or slides",
                  "planar and floating joints are not supported");
    }
    if (robot_.size() > Robot::kMaxJoints)
      unsupported(source_.joint(joint.name), "the chain has too many joints",
                  "at most " + std::to_string(Robot::kMaxJoints) + " are supported");
    places_[link->name] = {robot_.size(), at};
  }
  if (model_.joints_.empty()) broken(source_.whole(), "it has no joint", "give it one that moves");
  if (robot_.joints.empty())
    refuse("no joint moves between " + in_quotes(base_->name) + " and " + in_quotes(tip_->name),
           "choose another base or tip");
  robot_.tip = to_eigen(at);
  if (!invented.empty()) {
    robot_.notes.push_back(
        "accelerations are taken as four times the velocity, since URDF has none: " +
        listed(invented));
  }
}

void RobotMaker::check_set(const urdf::Joint& joint, double value) const {
  if (in_chain(joint.name))
    refuse("joint " + in_quotes(joint.name) + " is one of the chain, whose values are planned",
           "set only joints beside it");
  if (!moves(joint))
    refuse("joint " + in_quotes(joint.name) + " does not move",
           "set only joints that turn or slide");
  const auto [low, high] = range_of(joint, limits_);
  if (!(value >= low && value <= high))
    refuse("joint " + in_quotes(joint.name) + " is set to " + number_text(value),
           "its limits are " + number_text(low) + " .. " + number_text(high));
}

/// The value of a joint beside the chain.
double RobotMaker::fixed_value(const urdf::Joint& joint) {
  const urdf::Joint* at = &joint;
  double times = 1, plus = 0;  // of the value of `at`
  for (std::size_t step = 0;; ++step) {
    if (const auto set = chain_.set_joints.find(at->name); set != chain_.set_joints.end())
      return times * set->second + plus;
    if (at->mimic == nullptr) break;
    const std::string& leader = at->mimic->joint_name;
    if (in_chain(leader))
      unsupported(source_.joint(joint.name),
                  "joint \"" + joint.name + "\" follows \"" + leader + "\", which moves",
                  "set it to a value at which it stands (--set-joint " + joint.name + "=VALUE)");
    plus += times * at->mimic->offset;
    times *= at->mimic->multiplier;
    at = model_.getJoint(leader).get();
    if (at == nullptr || step > model_.joints_.size())
      broken(source_.joint(joint.name), "joint \"" + joint.name + "\" follows no joint that stands",
             "name a joint in its <mimic>");
  }
  const auto [low, high] = range_of(*at, limits_);
  const double value = low <= 0 && high >= 0 ? 0 : 0.5 * (low + high);
  return times * value + plus;
}

/// Where the child of a joint beside the chain is in the frame of its parent.
Placement RobotMaker::placement_of(const urdf::Joint& joint) {
  const Placement at = placement(joint.parent_to_joint_origin_transform);
  if (joint.type == urdf::Joint::FIXED) return at;
  const double value = moves(joint) ? fixed_value(joint) : 0;
  if (!std::isfinite(value))
    broken(source_.joint(joint.name), "joint \"" + joint.name + "\" has limits that are no numbers",
           "give it a <limit> with lower below upper");
  constexpr double kMost = 1e6;  // radians, or metres
  if (std::abs(value) > kMost)
    broken(
        source_.joint(joint.name),
        "joint \"" + joint.name + "\" stands at " + number_text(value) + ", farther than 1000000",
        "correct its <limit> or <mimic>");
  robot_.notes.push_back("joint " + in_quotes(joint.name) + " stands at " + number_text(value));
  const Vec3 axis = vec(joint.axis);
  if (value == 0 || !(length(axis) > 1e-9)) return at;
  const Vec3 along = (1 / length(axis)) * axis;
  if (joint.type == urdf::Joint::PRISMATIC) return at * Placement{kNoRotation, value * along};
  return at * Placement{rotation_about(along, value), {}};
}

/// Every link that is not of the chain hangs on one that is, or the other way round.
void RobotMaker::place_rest() {
  std::vector<LinkPtr> reached;
  for (const auto& [name, place] : places_) reached.push_back(model_.getLink(name));
  while (!reached.empty()) {
    const LinkPtr link = reached.back();
    reached.pop_back();
    const Place place = places_.at(link->name);
    for (const auto& child : link->child_links) {
      if (places_.contains(child->name)) continue;
      places_[child->name] = {place.body, place.at * placement_of(*child->parent_joint)};
      reached.push_back(child);
    }
    const LinkPtr parent = link->getParent();
    if (parent == nullptr || places_.contains(parent->name)) continue;
    places_[parent->name] = {place.body, place.at * inverse(placement_of(*link->parent_joint))};
    reached.push_back(parent);
  }
}

void RobotMaker::add_links() {
  LinkGeometry geometry(source_, chain_);
  std::vector<std::string> without;
  // Parents before children.
  std::vector<std::pair<LinkPtr, int>> open{{model_.getRoot(), -1}};  // and the link they hang on
  while (!open.empty()) {
    auto [link, parent] = open.back();
    open.pop_back();
    const Place& place = places_.at(link->name);
    std::vector<Solid> solids = geometry.read(*link, place.at, robot_);
    if (solids.empty()) {
      without.push_back(link->name);
    } else {
      numbers_[link->name] = static_cast<int>(robot_.links.size());
      robot_.links.push_back({link->name, place.body, parent, std::move(solids)});
      parent = numbers_[link->name];
    }
    for (const auto& child : link->child_links) open.emplace_back(child, parent);
  }
  if (robot_.links.empty())
    broken(source_.whole(), "no link has collision geometry",
           "take what is drawn (--use-visual), or plan for the tip alone (--bodiless)");
  if (!without.empty())
    robot_.notes.push_back("links without collision geometry have no body: " + listed(without));
}

void RobotMaker::allow_contacts() {
  const auto allow = [&](const std::string& a, const std::string& b) {
    const auto first = numbers_.find(a), second = numbers_.find(b);
    if (first == numbers_.end() || second == numbers_.end()) return;  // without a body
    robot_.may_touch.emplace_back(first->second, second->second);
  };
  for (const auto& [a, b] : chain_.allow_contact) allow(find_link(a)->name, find_link(b)->name);
  if (chain_.srdf.empty()) return;
  const Srdf srdf = read_srdf(chain_.srdf, names_of(model_.links_), names_of(model_.joints_));
  robot_.files.push_back(chain_.srdf);
  if (srdf.robot != model_.getName())
    robot_.notes.push_back("the SRDF is of a robot of another name: " + in_quotes(srdf.robot));
  if (!srdf.unknown.empty()) {
    robot_.notes.push_back("the SRDF names what the robot has not: " +
                           listed({srdf.unknown.begin(), srdf.unknown.end()}));
  }
  for (const auto& [a, first] : numbers_) {
    for (const auto& [b, second] : numbers_)
      if (first < second && srdf.may_touch(a, b)) robot_.may_touch.emplace_back(first, second);
  }
  read_states(srdf);
}

void RobotMaker::read_states(const Srdf& srdf) {
  for (const Srdf::State& state : srdf.states) {
    JointVector q(robot_.size());
    std::vector<std::string> missing;
    for (int j = 0; j < robot_.size(); ++j) {
      const std::string& name = robot_.joints[j].name;
      const auto value = state.values.find(name);
      if (value == state.values.end()) missing.push_back(name);
      q[j] = value == state.values.end() ? 0 : value->second;
    }
    if (static_cast<int>(missing.size()) == robot_.size()) continue;  // of another part
    const std::string what = "state " + in_quotes(state.name);
    if (!missing.empty()) {
      robot_.notes.push_back(what + " is left out: it does not say " + listed(missing));
    } else if (!robot_.states.emplace(state.name, q).second) {
      robot_.notes.push_back(what + " is given twice: that of group " + in_quotes(state.group) +
                             " is left out");
    } else if (state.values.size() > robot_.joints.size()) {
      robot_.notes.push_back(what + " sets joints beside the chain, too, which stand");
    }
  }
}

}  // namespace

Robot parse_urdf(std::string_view text, const std::string& file, const Chain& chain) {
  const UrdfFile source(text, file);
  Robot robot = RobotMaker(source, chain).make();
  try {
    validate(robot);
  } catch (const Error& error) {
    broken(source.whole(), error.problem(), error.remedy());
  }
  return robot;
}

}  // namespace lasius::arm
