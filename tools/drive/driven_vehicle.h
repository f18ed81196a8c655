// What drives where that is a vehicle, and what is told of it beside what all drives tell.
#pragma once

#include <algorithm>
#include <iosfwd>
#include <optional>
#include <vector>

#include "lasius/vehicle/drive.h"
#include "tools/record/problem.h"
#include "tools/vehicle/vehicle_answer.h"

namespace lasius::tool {

/// A vehicle's drive, beside its DriveResult.
struct DrivenVehicle {
  LoadedVehicle vehicle;
  VehicleEnd start;
  std::vector<VehicleEnd> goals;
  int met = -1;  ///< which of them; -1: none
  /// Their options: tolerances, costs.
  vehicle::NavigatorOptions how = {};
  std::vector<vehicle::Pose> poses = {};     ///< as vehicle::DriveResult has them
  std::vector<vehicle::Segment> moves = {};  ///< likewise
  /// No way of the vehicle through the world as it is at tick 0 is shorter.
  std::optional<double> lower_bound = {};

  /// The one that is met, else the first.
  const VehicleEnd& goal() const { return goals[static_cast<std::size_t>(std::max(met, 0))]; }
  std::vector<vehicle::Pose> goal_poses() const;
};

/// @param recorded  the result that is replayed, whose vehicle it is, if any
/// @throws Error, UsageError
DrivenVehicle read_driven_vehicle(const DriveCommand& command, const LoadedMap& map,
                                  const std::optional<Json>& recorded);
/// The question that such a drive answers. @throws UsageError, Error
DriveCommand recorded_drive_of_vehicle(const Recorded& from);

/// Drives through `truth`; `how` and the rest as of vehicle::drive(). Keeps poses, moves
/// and which goal is met; tells what is near to an end that touches something.
DriveResult drive_vehicle(DrivenVehicle& driven, const LoadedMap& map, Frame frame,
                          const Grid& truth, const Changes& changes, const DriveOptions& how);
void look_for_bound(DrivenVehicle& driven, const Grid& world, const StopCondition& stop);

/// What decides the drive, its ends, and its path: a pose a tick.
void record_vehicle(Record& record, const DrivenVehicle& driven, const DriveCommand& command,
                    const LoadedMap& map);
/// "track" and "segments", null where nothing was driven; in metres, too, where the command is.
void add_track(Json& json, const DrivenVehicle& driven, const DriveCommand& command,
               const LoadedMap& map, bool found);
/// x,y,yaw, a line a tick, none where nothing was driven; check-path reads it.
void write_poses(std::ostream& out, const DrivenVehicle& driven, const DriveCommand& command,
                 const LoadedMap& map, bool found);

}  // namespace lasius::tool
