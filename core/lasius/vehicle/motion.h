// Motions of vehicles: arcs, lines and rotations in place, from which every pose follows.
#pragma once

#include <span>
#include <vector>

#include "lasius/export.h"
#include "lasius/vehicle/vehicle.h"

namespace lasius::vehicle {

/// One motion from a pose, of constant curvature or of one that grows with what is driven.
struct Segment {
  Pose begin;  ///< of the motion
  /// At the begin: change of yaw for each cell driven forwards, radians a cell.
  double curvature = 0;
  double curvature_rate = 0;  ///< change of the curvature for each cell driven forwards
  double length = 0;          ///< driven, cells, at least 0; 0 of a rotation
  int gear = 1;               ///< 1 forwards, -1 backwards, 0 a rotation in place
  /// Of a rotation: how far yaw changes, radians, of either sign. Of a line of what drives to any
  /// side: from its yaw, which it keeps, to where it drives.
  double angle = 0;
  friend bool operator==(const Segment&, const Segment&) = default;

  /// Its extent: length, or of a rotation |angle|.
  LASIUS_EXPORT double extent() const noexcept;
  /// The pose after `at` of the extent, 0 at the begin. Yaw goes on from begin.yaw without a jump.
  /// Where |yaw| exceeds 10^6 radians, or is no number, the place means nothing.
  LASIUS_EXPORT Pose pose(double at) const noexcept;
  /// The curvature there.
  LASIUS_EXPORT double curvature_at(double at) const noexcept;
  /// The greatest |curvature| on it.
  LASIUS_EXPORT double sharpest() const noexcept;
  /// The pose after all of it.
  LASIUS_EXPORT Pose end() const noexcept;
};

/// Length driven, cells; rotations count 0.
LASIUS_EXPORT double driven_length(std::span<const Segment> segments) noexcept;
/// What they cost by the vehicle's prices, cells.
LASIUS_EXPORT double cost(const Vehicle& vehicle, std::span<const Segment> segments) noexcept;
/// Changes between forwards and backwards, with or without a rotation between.
LASIUS_EXPORT int cusps(std::span<const Segment> segments) noexcept;
/// Where the curvature jumps though the gear does not change.
LASIUS_EXPORT int corners(std::span<const Segment> segments) noexcept;

/// A pose on a path.
struct PathPose {
  Pose pose;             ///< of the vehicle
  double curvature = 0;  ///< there
  int gear = 1;          ///< of the segment
  int segment = 0;       ///< its index
  double at = 0;         ///< extent of the segment before it
};
/// Poses along a path, at most `spacing` apart (cells; of a rotation, radians), with both ends of
/// every segment, save that equal poses of one gear are told once: at a cusp a pose stands twice,
/// once for each gear.
/// @throws Error(invalid_parameter) unless spacing > 0, or for more than 10^8 poses of a segment
LASIUS_EXPORT std::vector<PathPose> poses(std::span<const Segment> segments, double spacing);

/// Shortest way without obstacles, along arcs of the radius and lines: the words of Dubins, or of
/// Reeds & Shepp where it may reverse (there a cell backwards counts as one forwards).
/// @param radius above 0
LASIUS_EXPORT double free_length(const Pose& from, const Pose& to, double radius, bool reverse);
/// The segments of that way, from `from`; they end at `to` within 1e-8 of each coordinate at |x|,
/// |y| up to 32768, the yaw modulo a turn.
LASIUS_EXPORT std::vector<Segment> free_way(const Pose& from, const Pose& to, double radius,
                                            bool reverse);

}  // namespace lasius::vehicle
