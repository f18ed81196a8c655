// A plan of a vehicle, with all that is told of it.
#pragma once

#include <algorithm>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lasius/vehicle/planner.h"
#include "lasius/vehicle/profile.h"
#include "tools/bitmap/map_file.h"
#include "tools/options/options.h"
#include "tools/record/record.h"
#include "tools/vehicle/vehicle_file.h"

namespace lasius::tool {

/// A map as a vehicle plans on it.
struct VehicleMap {
  LoadedMap map;
  LoadedVehicle vehicle;
  std::optional<vehicle::Planner> planner = {};  ///< nothing: the token fired before it was made
};
/// @throws Error, UsageError
VehicleMap load_vehicle_map(const VehicleCommand& command,
                            const std::optional<LoadedVehicle>& vehicle,
                            const std::stop_token& token);
/// The files that the map and its costs name, among the inputs; of layers without effect notes.
void note_files(const VehicleMap& on, RunOptions& run);

/// A start or goal, as it was given and in cells.
struct VehicleEnd {
  PoseEnd asked;
  Place place;         ///< of its point
  vehicle::Pose pose;  ///< in cells
};
VehicleEnd vehicle_end(const LoadedMap& map, const PoseEnd& asked, Frame frame);
/// The pose nearest to one that touches something, of the same heading and whole cells away; of
/// those that are equally near the first by rows. It is sought a few vehicles around that pose, or
/// around the map's nearest point to one outside. Nothing where none is there, or once stopped.
std::optional<vehicle::Pose> nearest_free(const Grid& grid, const vehicle::Space& space,
                                          const vehicle::Pose& from, const StopCondition& stop);
/// As in "(1.5, 2, 0.7854)".
std::string pose_text(const LoadedMap& map, Frame frame, const vehicle::Pose& cells);
/// What is said behind a pose that touches a cell, and what is near that does not.
std::string touched_text(const LoadedMap& map, Frame frame, Cell cell,
                         const std::optional<vehicle::Pose>& nearest);
/// As it was given.
Json asked_json(const VehicleEnd& end);
/// Of several "goals", "goals_world" and "goal_index", null where `met` is -1.
void add_goals(Json& json, const std::vector<VehicleEnd>& goals, int met, bool metres);

/// What plans for vehicles, as results name it.
const Algorithm& lattice_algorithm();

struct VehicleAnswer {
  VehicleEnd start;
  std::vector<VehicleEnd> goals;
  vehicle::Result result = {};
  std::optional<vehicle::Pose> nearest_free = {};  ///< of an end that touches something
  double elapsed_ms = 0;

  bool has_path() const { return !result.segments.empty(); }
  /// The one that is met, else the first.
  const VehicleEnd& goal() const {
    return goals[static_cast<std::size_t>(std::max(result.goal, 0))];
  }
};
/// Plans under `stop`.
VehicleAnswer plan_vehicle(const VehicleMap& on, const VehicleCommand& command,
                           const VehicleEnd& start, const std::vector<VehicleEnd>& goals,
                           const StopCondition& stop);

/// Poses along the answer's path, at most the command's spacing apart, timed.
std::vector<vehicle::TimedPose> timed_poses(const VehicleMap& on, const VehicleCommand& command,
                                            const VehicleAnswer& answer);
/// x, y, yaw, curvature, speed, time and gear of each pose, in the command's frame, of plans one
/// after another.
void write_timed_poses(std::ostream& out, const VehicleMap& on, const VehicleCommand& command,
                       std::span<const VehicleAnswer> answers);
/// The same as nav_msgs/Path: in metres of the map's frame where it has one. A pose that stands
/// twice is a cusp.
void write_ros_poses(std::ostream& out, const VehicleMap& on, const VehicleCommand& command,
                     std::span<const VehicleAnswer> answers);
/// A pose as the command's frame has it: of the ends as they were given.
vehicle::Pose pose_in_frame(const VehicleMap& on, const VehicleCommand& command,
                            const VehicleAnswer& answer, const vehicle::Pose& cells);

Record vehicle_record(const VehicleMap& on, const VehicleCommand& command,
                      const VehicleAnswer& answer);

/// What a page shows of plans one after another: {footprint, poses [[x, y, yaw, kappa, v, t, gear],
/// ...]} in cells, at most some thousand of them.
Json vehicle_view_json(const VehicleMap& on, const VehicleCommand& command,
                       std::span<const VehicleAnswer> answers);
/// The page of a plan: a view "vehicle" with what map_view_json says of the map, and `vehicle`.
void write_vehicle_page(std::ostream& out, const Record& record, const VehicleMap& on,
                        const VehicleCommand& command, const VehicleAnswer& answer);

/// The map, what the footprint sweeps, the path and the footprint at both ends.
/// @throws Error(output_failed)
void write_vehicle_picture(const std::string& file, const VehicleMap& on,
                           const VehicleCommand& command, const VehicleAnswer& answer);

}  // namespace lasius::tool
