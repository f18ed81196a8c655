// A part of a map as a vehicle sees it: what is asked about few cells costs no look at all of them.
#pragma once

#include <cmath>
#include <optional>

#include "core/base/invalid_parameter.h"
#include "lasius/grid/grid.h"
#include "lasius/vehicle/space.h"

namespace lasius::vehicle {

/// Refuses what Request does. @param name  of what a number of the pose is, as in "a coordinate"
inline void require_pose(const Pose& pose, const char* name) {
  for (const double value : {pose.x, pose.y, pose.yaw}) {
    require_parameter(std::fabs(value) <= 1e5, name, value,
                      "give finite numbers of at most 100000");
  }
}

/// Beyond its cells all is blocked.
class Window {
 public:
  /// @param part     not empty
  /// @param blocked  of a cell, also outside the map
  template <class Blocked>
  Window(const Vehicle& vehicle, const Rectangle& part, const Blocked& blocked)
      : left_(part.x), top_(part.y), space_(cells(part, blocked), vehicle) {}

  bool free(const Pose& pose) const { return space_.free(moved(pose)); }
  /// The first contact of a motion, in the map's cells.
  std::optional<Contact> first_contact(const Segment& motion) const {
    Segment here = motion;
    here.begin = moved(motion.begin);
    auto contact = space_.first_contact(std::span(&here, 1));
    if (contact) {
      contact->pose.x += left_;
      contact->pose.y += top_;
      contact->cell = {contact->cell.x + left_, contact->cell.y + top_};
    }
    return contact;
  }

  /// The cells within so many of a place, which is at most 10^6 cells away.
  static Rectangle around(const Pose& pose, double reach) {
    const int r = static_cast<int>(std::ceil(reach)) + 1;
    return {static_cast<int>(std::floor(pose.x)) - r, static_cast<int>(std::floor(pose.y)) - r,
            2 * r + 1, 2 * r + 1};
  }

 private:
  // Whole cells are taken off: nothing is rounded.
  Pose moved(const Pose& pose) const noexcept { return {pose.x - left_, pose.y - top_, pose.yaw}; }
  template <class Blocked>
  static Grid cells(const Rectangle& part, const Blocked& blocked) {
    Grid grid(part.width, part.height);
    for (int y = 0; y < part.height; ++y)
      for (int x = 0; x < part.width; ++x)
        if (blocked(Cell{part.x + x, part.y + y})) grid.set_blocked({x, y});
    return grid;
  }

  int left_, top_;
  Space space_;
};

}  // namespace lasius::vehicle
