// Where a vehicle may be, and which motions touch nothing over their whole sweep.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "lasius/base/stop.h"
#include "lasius/export.h"
#include "lasius/grid/grid.h"
#include "lasius/vehicle/motion.h"
#include "lasius/vehicle/vehicle.h"

namespace lasius::vehicle {

/// The first place of a path where the footprint meets what is blocked.
struct Contact {
  int segment = 0;  ///< index of the segment, or of the pose before
  double at = 0;    ///< extent of the segment before it; between poses the share of the way, 0 to 1
  Pose pose;        ///< where it touches, or comes nearer than 0.001 cells along each axis
  Cell cell{};      ///< blocked or outside, and met there
  bool proven = false;  ///< the footprint itself meets the cell at the pose
};

/// A map seen by a vehicle. Blocked are the closed squares of blocked cells and all that is outside
/// the map; the footprint is closed, too: what only touches is blocked. `true` from free() is a
/// proof for every pose of a motion; `false` is wrong only where the footprint comes nearer than
/// 0.02 cells along each axis to what is blocked (0.1% of motions). Copies share what they hold.
/// Thread-safe.
class LASIUS_EXPORT Space {
 public:
  /// Keeps 4 bytes and a bit for each cell. O(cells).
  /// @throws Error as validate()
  Space(const Grid& grid, const Vehicle& vehicle);
  /// The same, or empty if stopped.
  [[nodiscard]] static std::optional<Space> make(const Grid& grid, const Vehicle& vehicle,
                                                 const StopCondition& stop);
  Space(const Space&) noexcept;
  Space& operator=(const Space&) noexcept;
  Space(Space&&) noexcept;
  Space& operator=(Space&&) noexcept;
  ~Space();

  const Vehicle& vehicle() const noexcept;  ///< as given
  /// True if the footprint meets nothing at the pose (exact up to 1e-9 cells, on the safe side).
  bool free(const Pose& pose) const;
  /// True if it meets nothing over the whole motion.
  bool free(const Segment& motion) const;
  /// The blocked cell met at a pose, if any.
  std::optional<Cell> contact(const Pose& pose) const;
  /// The first contact along a path, if any.
  std::optional<Contact> first_contact(std::span<const Segment> path) const;
  /// The same of poses told one by one: between two, x, y and yaw change in proportion, yaw the
  /// shorter way round.
  std::optional<Contact> first_contact(std::span<const Pose> path) const;

  class Impl;                                           ///< internal
  const Impl& impl() const noexcept { return *impl_; }  ///< internal

 private:
  Space() = default;
  std::shared_ptr<const Impl> impl_;
};

}  // namespace lasius::vehicle
