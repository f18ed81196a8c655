#include "tools/drive/driven_vehicle.h"

#include <ostream>
#include <utility>

#include "tools/bitmap/map_ends.h"
#include "tools/console/values.h"
#include "tools/record/recorded.h"
#include "tools/vehicle/vehicle_json.h"

namespace lasius::tool {
namespace {

bool in_metres(const DriveCommand& command) { return command.run.frame == Frame::world; }

/// At each tick.
std::vector<vehicle::Pose> driven_poses(const DrivenVehicle& driven, const LoadedMap& map,
                                        bool metres) {
  std::vector<vehicle::Pose> told = driven.poses;
  if (metres)
    for (vehicle::Pose& pose : told) pose = to_world(map, pose);
  return told;
}

Json track_json(const std::vector<vehicle::Pose>& poses) {
  Json json = Json::array();
  for (const vehicle::Pose& pose : poses) json.push_back(pose_json(pose));
  return json;
}

}  // namespace

std::vector<vehicle::Pose> DrivenVehicle::goal_poses() const {
  std::vector<vehicle::Pose> asked;
  asked.reserve(goals.size());
  for (const VehicleEnd& goal : goals) asked.push_back(goal.pose);
  return asked;
}

DrivenVehicle read_driven_vehicle(const DriveCommand& command, const LoadedMap& map,
                                  const std::optional<Json>& recorded) {
  const VehicleCommand& asked = *command.vehicle;
  const RunOptions& run = command.run;
  DrivenVehicle driven{
      .vehicle = recorded ? LoadedVehicle{.vehicle = recorded_vehicle((*recorded)["parameters"])}
                          : read_vehicle(asked.file, map, run.frame),
      .start = vehicle_end(map, asked.start, run.frame),
      .goals = {}};
  for (const PoseEnd& goal : asked.goals) driven.goals.push_back(vehicle_end(map, goal, run.frame));
  driven.how = {.goal_tolerance = map.cells_of(run.map.radius_metres, run.goal_tolerance),
                .heading_tolerance = asked.heading_tolerance,
                .smooth = asked.smooth};
  return driven;
}

DriveCommand recorded_drive_of_vehicle(const Recorded& from) {
  DriveCommand command;
  command.run = recorded_run(from, find_algorithm("exact"));
  const bool metres = in_metres(command);
  VehicleCommand& asked = command.vehicle.emplace();
  asked.start = recorded_pose(from.result, metres ? "start_world" : "start");
  asked.goals = recorded_goals(from.result, metres);
  asked.heading_tolerance = recorded_real(from.result, "parameters/heading_tolerance", 0, kNoLimit);
  asked.smooth = recorded<bool>(from.result, "parameters/smooth");
  return command;
}

DriveResult drive_vehicle(DrivenVehicle& driven, const LoadedMap& map, Frame frame,
                          const Grid& truth, const Changes& changes, const DriveOptions& how) {
  vehicle::DriveResult result =
      vehicle::drive(map.grid(), truth, driven.vehicle.vehicle, driven.start.pose,
                     driven.goal_poses(), changes, how, driven.how);
  driven.met = result.goal;
  driven.poses = std::move(result.poses);
  driven.moves = std::move(result.moves);
  if (result.status != Status::invalid) return result;
  const bool start = result.fault == Fault::start_blocked || result.fault == Fault::start_outside;
  const vehicle::Pose& pose = (start ? driven.start : driven.goal()).pose;
  const Grid& grid = start ? truth : map.grid();
  const vehicle::Space space(grid, driven.vehicle.vehicle);
  if (const auto cell = space.contact(pose))
    result.error =
        (start ? "start " : "goal ") + pose_text(map, frame, pose) +
        touched_text(map, frame, *cell, nearest_free(grid, space, pose, {.token = how.stop.token}));
  return result;
}

void look_for_bound(DrivenVehicle& driven, const Grid& world, const StopCondition& stop) {
  const auto planner = vehicle::Planner::make(world, driven.vehicle.vehicle, stop);
  if (!planner) return;
  const vehicle::Result way = planner->plan({.start = driven.start.pose,
                                             .goals = driven.goal_poses(),
                                             .goal_tolerance = driven.how.goal_tolerance,
                                             .heading_tolerance = driven.how.heading_tolerance,
                                             .smooth = false,
                                             .stop = stop});
  driven.lower_bound = way.lower_bound;
  // Both are sums that round: of the same way the bound is not above it.
  const double length = vehicle::driven_length(driven.moves);
  if (driven.lower_bound > length && driven.lower_bound <= length * (1 + 1e-9))
    driven.lower_bound = length;
}

void record_vehicle(Record& record, const DrivenVehicle& driven, const DriveCommand& command,
                    const LoadedMap& map) {
  record.start = pose_json(driven.start.pose);
  record.goal = pose_json(driven.goal().pose);
  record.parameters["vehicle"] = vehicle_json(driven.vehicle.vehicle);
  record.parameters["heading_tolerance"] = number(command.vehicle->heading_tolerance);
  record.parameters["smooth"] = command.vehicle->smooth;
  record.axes = 3;
  if (!record.has_path()) return;
  for (const vehicle::Pose& pose : driven_poses(driven, map, in_metres(command)))
    record.path.insert(record.path.end(), {pose.x, pose.y, pose.yaw});
}

void add_track(Json& json, const DrivenVehicle& driven, const DriveCommand& command,
               const LoadedMap& map, bool found) {
  json["track"] = found ? track_json(driven.poses) : Json();
  json["segments"] = found ? segments_json(map, driven.moves, false) : Json();
  add_goals(json, driven.goals, driven.met, in_metres(command));
  if (!in_metres(command)) return;
  json["start_world"] = asked_json(driven.start);
  json["goal_world"] = asked_json(driven.goal());
  json["track_world"] = found ? track_json(driven_poses(driven, map, true)) : Json();
  json["segments_world"] = found ? segments_json(map, driven.moves, true) : Json();
}

void write_poses(std::ostream& out, const DrivenVehicle& driven, const DriveCommand& command,
                 const LoadedMap& map, bool found) {
  out << "x,y,yaw\n";
  if (!found) return;
  for (const vehicle::Pose& pose : driven_poses(driven, map, in_metres(command)))
    out << to_text(pose.x) << "," << to_text(pose.y) << "," << to_text(pose.yaw) << "\n";
}

}  // namespace lasius::tool
