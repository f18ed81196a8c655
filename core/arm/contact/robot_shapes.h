// What of a robot is tested against what, prepared once for any number of scenes.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/arm/contact/lane_model.h"
#include "core/arm/contact/pair_table.h"
#include "core/arm/contact/shape.h"
#include "core/arm/robot/kinematics.h"

namespace lasius::arm {

/// A robot's links, prepared once for any number of scenes.
class RobotShapes {
 public:
  /// Precondition: a robot that `validate` accepts; what is asked of it keeps this clearance,
  /// metres.
  RobotShapes(const Robot& robot, double clearance);

  double clearance() const noexcept { return clearance_; }
  const Kinematics& kinematics() const noexcept { return arm_; }
  /// All that moves with a body; null: nothing.
  const Shape* body(int i) const noexcept { return bodies_[i]; }
  std::span<const ShapePair> pairs() const noexcept { return pairs_; }
  /// That of a pair, where at most two joints are between.
  const PairTable* table(std::size_t pair) const noexcept { return tables_[pair].get(); }
  int link_of(int solid) const noexcept { return links_[solid]; }
  /// What is looked at before all else.
  const LaneModel& lanes() const noexcept { return *lanes_; }

 private:
  using LinkShapes = std::vector<const Shape*>;  // the whole of each link; null: nothing

  void add_pairs(const Robot& robot, const LinkShapes& whole,
                 const std::vector<std::vector<int>>& of_body);

  double clearance_;
  Kinematics arm_;
  ShapeStore store_;
  std::vector<int> links_;  // of each solid
  std::vector<const Shape*> bodies_;
  std::optional<LaneModel> lanes_;
  std::vector<ShapePair> pairs_;
  std::vector<std::unique_ptr<PairTable>> tables_;
};

}  // namespace lasius::arm
