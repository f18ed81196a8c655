// Whether a motion touches anything, certified over its whole sweep.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>

#include "core/vehicle/bit_columns.h"
#include "core/vehicle/outline.h"
#include "lasius/grid/clearance.h"
#include "lasius/vehicle/space.h"

namespace lasius::vehicle {

/// A map as a vehicle sees it.
class Space::Impl {
 public:
  Impl(const Vehicle& vehicle, const Grid& grid, ClearanceField field);

  const Vehicle& vehicle() const noexcept { return vehicle_; }
  const Outline& outline() const noexcept { return outline_; }
  const BitColumns& bits() const noexcept { return bits_; }
  const ClearanceField& field() const noexcept { return field_; }
  int width() const noexcept { return bits_.width(); }
  int height() const noexcept { return bits_.height(); }

  /// No more than what lies between the point and the nearest that is blocked; 0 outside.
  double clearance(double x, double y) const noexcept;
  /// Squared clearance of a centre, in half cells, below which the middle of the disc in the
  /// footprint is nowhere in the cell; at least 1.
  std::int32_t needed_by_disc() const noexcept {
    const double least = std::max(0.0, 2 * (outline_.inside() - 0.70711));
    return std::max(1, static_cast<std::int32_t>(least * least));
  }
  /// What is known from the discs about the footprint: how far its points may move at least without
  /// meeting anything (below 0: nothing is known), and whether it meets something as it is.
  struct Room {
    double free = 0;
    bool met = false;
  };
  Room room(const Pose& pose) const noexcept;
  /// Whether the footprint, grown by so much along each axis, meets nothing.
  bool free_at(const Pose& pose, double grown) const;
  /// The first blocked cell that it meets.
  std::optional<Cell> met(const Pose& pose, double grown) const;

  /// What is left open: a motion that comes nearer than that may be refused. Cells, along each
  /// axis.
  static constexpr double kCoarse = 0.008;
  static constexpr double kFine = 0.0005;
  static constexpr double kLoose = 0.06;  ///< where another way would do: along walls it is quick

  /// The share of the motion, in [0, 1], at which it touches or comes nearer than `open`; above 1
  /// where it touches nothing. With `earliest` the first such share.
  ///
  /// A piece of a motion over which no point of the footprint moves by more than 2 r lies inside
  /// the footprint at its middle, grown by r.
  /// @param pose_at   the pose after a share
  /// @param reach     no point of the footprint moves farther than that
  /// @param rounding  by which its points may be off at a pose, beyond what the outline allows for
  template <class PoseAt>
  double touch(PoseAt&& pose_at, double reach, double open, bool earliest,
               double rounding = 0) const {
    double from = 0;
    double size = kPiece;
    while (from < 1) {
      const double share = size < reach * (1 - from) ? size / reach : 1 - from;
      const double middle = from + share / 2;
      const double half = reach * share / 2;
      const double grown = half + rounding;
      const Pose pose = pose_at(middle);
      const Room known = room(pose);
      if (known.met && !earliest) return middle;
      if (known.free > grown || (!known.met && grown < kLookCloser && raster_free(pose, grown))) {
        from += share;
        size = 2 * std::max(size, known.free);
        continue;
      }
      if (half <= open) return middle;
      size = half;
    }
    return 2;
  }

  /// The same of a segment.
  double touch(const Segment& motion, double open, bool earliest) const;
  /// Whether none of them touches anything. Counts those that are looked at.
  /// @param last_first  the last is looked at first
  bool all_free(std::span<const Segment> motions, double open, bool last_first,
                std::int64_t& checked) const;

 private:
  static constexpr double kPiece = 4;       ///< by which points move in the first piece, cells
  static constexpr double kLookCloser = 2;  ///< grown by less the rows of cells are looked at

  bool raster_free(const Pose& pose, double grown) const;

  Vehicle vehicle_;
  Outline outline_;
  BitColumns bits_;
  ClearanceField field_;
};

}  // namespace lasius::vehicle
