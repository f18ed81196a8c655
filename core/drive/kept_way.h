// A vehicle's way that is driven: where the vehicle is on it, and what is left.
#pragma once

#include <span>
#include <vector>

#include "lasius/base/stop.h"
#include "lasius/grid/grid.h"
#include "lasius/vehicle/motion.h"
#include "lasius/vehicle/vehicle.h"

namespace lasius::vehicle {

/// What is kept of a plan. Places on it only go on.
class KeptWay {
 public:
  explicit KeptWay(const Vehicle& vehicle);

  void keep(std::vector<Segment> way);
  void drop() noexcept { way_.clear(); }
  bool kept() const noexcept { return !way_.empty(); }

  /// Goes on to the nearest place of the next part of the way. How far the vehicle is from that:
  /// cells, and of what it is turned what the farthest point of the footprint moves by.
  double locate(const Pose& robot);
  /// The vehicle has not driven all of the first segment.
  bool in_first() const noexcept;
  /// From the place on; a motion without length at the end.
  std::vector<Segment> rest() const;

 private:
  static constexpr double kNothing = 1e-9;  // what is shorter is left out
  struct Place {
    std::size_t segment = 0;
    double at = 0;  ///< extent of it before the place
  };
  std::vector<Segment> way_;
  Place place_;
  double around_;  ///< radius of the circle about the footprint
};

/// What is left of a motion after `at` of its extent.
Segment rest_of(const Segment& motion, double at) noexcept;
/// The first `extent` of a motion.
Segment begin_of(const Segment& motion, double extent) noexcept;

/// Whether the sweep of a way meets one of some cells, whatever else there is.
bool meets(const Vehicle& vehicle, std::span<const Segment> way, std::span<const Cell> cells);

/// Ways out of what the vehicle meets where it stands, the shortest first: single motions, over
/// which it meets no cell but those, to a pose where it meets none. Those found so far if stopped.
std::vector<Segment> ways_out(const Vehicle& vehicle, const Grid& map, const Pose& pose,
                              const StopCondition& stop = {});

/// The cells that the footprint meets at a pose, outside the map, too; some twice.
std::vector<Cell> met_cells(const Vehicle& vehicle, const Pose& pose);

/// A certified way from beside `rest` back to it, and what is left of that from there on; empty
/// where none is near. Sets the number of its first segments that lead back.
std::vector<Segment> rejoined(const Vehicle& vehicle, const Grid& map, const Pose& pose, double off,
                              std::span<const Segment> rest, int& back);

}  // namespace lasius::vehicle
