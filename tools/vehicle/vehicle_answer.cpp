#include "tools/vehicle/vehicle_answer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>
#include <utility>

#include "tools/bitmap/bitmap_problem.h"
#include "tools/bitmap/map_ends.h"
#include "tools/bitmap/poses_file.h"
#include "tools/console/elapsed.h"
#include "tools/console/values.h"
#include "tools/vehicle/vehicle_json.h"

namespace lasius::tool {
namespace {

bool in_metres(const VehicleCommand& command) { return command.run.frame == Frame::world; }

bool at_goal(Fault fault) { return fault == Fault::goal_blocked || fault == Fault::goal_outside; }

/// Whether a number of an end is beyond all maps, or all turns; then says so.
bool refuse_numbers(VehicleAnswer& answer) {
  constexpr double kFarthest = 1e5;  // cells
  const auto refuse = [&](const VehicleEnd& end, bool start) {
    const bool turned = !(std::abs(end.asked.yaw) <= kMostTurned);
    const bool far = !(std::abs(end.pose.x) <= kFarthest && std::abs(end.pose.y) <= kFarthest);
    if (!turned && !far) return false;
    answer.result.status = Status::invalid;
    answer.result.fault = start ? Fault::start_outside : Fault::goal_outside;
    answer.result.error = turned ? "its yaw is more than " + to_text(kMostTurned) + " radians"
                                 : "it is outside of the map";
    return true;
  };
  return refuse(answer.start, true) ||
         std::ranges::any_of(answer.goals, [&](const auto& goal) { return refuse(goal, false); });
}

/// Why an end is refused, and what is near that is not.
std::string invalid_text(const VehicleMap& on, const VehicleCommand& command,
                         const VehicleAnswer& answer) {
  const bool goal = at_goal(answer.result.fault);
  const Frame frame = command.run.frame;
  const VehicleEnd& end = goal ? answer.goal() : answer.start;
  const auto& cell = answer.result.touched;
  return (goal ? "goal " : "start ") + pose_text(on.map, frame, end.pose) +
         (cell ? touched_text(on.map, frame, *cell, answer.nearest_free)
               : ": " + answer.result.error) +
         metres_hint(on.map, frame, end.place);
}

/// All that decides the plan.
Json parameters_of(const VehicleMap& on, const VehicleCommand& command) {
  const RunOptions& run = command.run;
  Json json = Json::object();
  add_limits(json, run);
  json["unknown"] = on.map.unknown_is_free ? "free" : "blocked";
  json["frame"] = kFrames[in_metres(command) ? 1 : 0];
  json["vehicle"] = vehicle_json(on.vehicle.vehicle);
  json["speeds"] = speeds_json(on.vehicle.speeds);
  json["goal_tolerance"] = number(on.map.cells_of(run.map.radius_metres, run.goal_tolerance));
  json["heading_tolerance"] = number(command.heading_tolerance);
  json["smooth"] = command.smooth;
  if (run.spacing) json["spacing"] = number(spacing_of(on.map, run));
  return json;
}

Json path_json(const VehicleMap& on, const VehicleCommand& command, const VehicleAnswer& answer) {
  Json json = json::roomy_object();
  const bool metres = in_metres(command), found = answer.has_path();
  const auto& segments = answer.result.segments;
  std::vector<Point> path, path_world;
  for (const auto& timed : timed_poses(on, command, answer)) {
    const vehicle::Pose& pose = timed.at.pose;
    path.push_back({pose.x, pose.y});
    const vehicle::Pose world = pose_in_frame(on, command, answer, pose);
    path_world.push_back({world.x, world.y});
  }
  json["path"] = points(path);
  json["segments"] = found ? segments_json(on.map, segments, false) : Json();
  json["cusps"] = found ? Json(answer.result.cusps) : Json();
  if (on.vehicle.vehicle.curvature_rate > 0)
    json["corners"] = found ? Json(answer.result.corners) : Json();
  json["priced_length"] = found ? number(vehicle::cost(on.vehicle.vehicle, segments)) : Json();
  if (on.map.costs) json["cost"] = found ? number(answer.result.cost) : Json();
  json["duration"] =
      found ? number(vehicle::Profile(segments, on.vehicle.speeds).duration()) : Json();
  if (command.run.goal_tolerance > 0 || command.heading_tolerance > 0)
    json["goal_reached"] = found ? pose_json(segments.back().end()) : Json();
  add_goals(json, answer.goals, found ? answer.result.goal : -1, metres);
  if (!metres) return json;
  json["start_world"] = asked_json(answer.start);
  json["goal_world"] = asked_json(answer.goal());
  json["length_m"] = found ? number(on.map.metres(answer.result.length)) : Json();
  json["path_world"] = points(path_world);
  json["segments_world"] = found ? segments_json(on.map, segments, true) : Json();
  return json;
}

Json effort_json(const VehicleAnswer& answer) {
  Json json = {{"expanded", answer.result.expanded}, {"checked", answer.result.checked}};
  if (const auto& cell = answer.result.touched) json["touched"] = {cell->x, cell->y};
  if (answer.nearest_free) json["nearest_free"] = pose_json(*answer.nearest_free);
  return json;
}

/// What is said beside status and length.
std::string summary(const Record& record, const VehicleAnswer& answer) {
  std::string text = counted(static_cast<std::int64_t>(answer.result.segments.size()), "segment") +
                     ", " + counted(answer.result.cusps, "cusp");
  if (answer.result.corners > 0)
    text += ", rests at " + counted(answer.result.corners, "corner") + " where the curvature jumps";
  if (record.cost) {
    text += ", cost " + decimal_text(*record.cost, 3);
    return record.gap ? text + printed(", at most %.3f%% above the least", 100 * *record.gap)
                      : text;
  }
  if (!answer.result.lower_bound) return text;
  text += "; no way of this vehicle is below " +
          decimal_text(record.scale * *answer.result.lower_bound, 3);
  if (!record.unit.empty()) text += " " + record.unit;
  return record.gap ? text + printed(", a gap of %.3f%%", 100 * *record.gap) : text;
}

}  // namespace

const Algorithm& lattice_algorithm() {
  static constexpr Algorithm kLattice{
      .name = "lattice",
      .summary = "a lattice of headings, exact ends, certified sweeps",
      .source = "docs/vehicles.md",
      .parameters = {},
      .kind = Algorithm::Kind::exact};
  return kLattice;
}

VehicleMap load_vehicle_map(const VehicleCommand& command,
                            const std::optional<LoadedVehicle>& vehicle,
                            const std::stop_token& token) {
  const RunOptions& run = command.run;
  LoadedMap map = read_map(run.map, run.frame);
  LoadedVehicle loaded = vehicle ? *vehicle : read_vehicle(command.file, map, run.frame);
  VehicleMap on{std::move(map), std::move(loaded)};
  const auto begin = Clock::now();
  if (run.map.costs.asked())
    on.map.costs = load_costs(*on.map.grid_alone, on.map.frame, run.map.costs,
                              run.map.radius_metres, vehicle::inscribed_radius(on.vehicle.vehicle));
  on.planner = vehicle::Planner::make(on.map.as_read(), on.vehicle.vehicle, {.token = token},
                                      on.map.costs ? &on.map.costs->field : nullptr);
  on.map.ready_ms = ms_since(begin);
  return on;
}

void note_files(const VehicleMap& on, RunOptions& run) {
  note_files(on.map, run);
  if (!on.map.costs) return;
  const auto& notes = on.map.costs->notes;
  run.notes.insert(run.notes.end(), notes.begin(), notes.end());
}

std::optional<vehicle::Pose> nearest_free(const Grid& grid, const vehicle::Space& space,
                                          const vehicle::Pose& from, const StopCondition& stop) {
  const auto into = [](double at, int size) {
    return at < 0 ? std::ceil(-at) : std::min(0.0, -std::ceil(at - size));
  };
  const double right = into(from.x, grid.width()), down = into(from.y, grid.height());
  const int reach = std::min(
      200, static_cast<int>(std::ceil(3 * vehicle::circumscribed_radius(space.vehicle()))) + 10);
  std::vector<Cell> steps;
  for (int y = -reach; y <= reach; ++y)
    for (int x = -reach; x <= reach; ++x)
      if (x * x + y * y <= reach * reach) steps.push_back({x, y});
  std::ranges::stable_sort(steps, {}, [&](Cell c) {
    const double x = right + c.x, y = down + c.y;
    return x * x + y * y;
  });
  for (std::size_t i = 0; i < steps.size(); ++i) {
    constexpr std::size_t kPoll = 1024;
    if (i % kPoll == 0 && stop.poll() != StopCondition::Cause::none) return std::nullopt;
    const vehicle::Pose pose{from.x + (right + steps[i].x), from.y + (down + steps[i].y), from.yaw};
    if (space.free(pose)) return pose;
  }
  return std::nullopt;
}

std::string pose_text(const LoadedMap& map, Frame frame, const vehicle::Pose& cells) {
  const vehicle::Pose pose = frame == Frame::world ? to_world(map, cells) : cells;
  return "(" + rounded_text(pose.x, 4) + ", " + rounded_text(pose.y, 4) + ", " +
         rounded_text(pose.yaw, 4) + ")";
}

std::string touched_text(const LoadedMap& map, Frame frame, Cell cell,
                         const std::optional<vehicle::Pose>& nearest) {
  std::string text = map.as_read().contains(cell)
                         ? ": the footprint meets the blocked cell "
                         : ": the footprint reaches out of the map, to cell ";
  text += "(" + std::to_string(cell.x) + ", " + std::to_string(cell.y) + ")";
  if (nearest)
    text += "; the nearest pose of this heading, whole cells away, that meets nothing is " +
            pose_text(map, frame, *nearest);
  return text;
}

VehicleEnd vehicle_end(const LoadedMap& map, const PoseEnd& asked, Frame frame) {
  const Place place = end_place(map, asked, frame);
  const Point at = place.at();
  const double yaw = frame == Frame::world ? yaw_across(map, asked.yaw) : asked.yaw;
  return {asked, place, {at.x, at.y, yaw}};
}

Json asked_json(const VehicleEnd& end) {
  return {number(end.asked.x), number(end.asked.y), number(end.asked.yaw)};
}

void add_goals(Json& json, const std::vector<VehicleEnd>& goals, int met, bool metres) {
  if (goals.size() < 2) return;
  for (const VehicleEnd& goal : goals) {
    json["goals"].push_back(pose_json(goal.pose));
    if (metres) json["goals_world"].push_back(asked_json(goal));
  }
  json["goal_index"] = met >= 0 ? Json(met) : Json();
}

VehicleAnswer plan_vehicle(const VehicleMap& on, const VehicleCommand& command,
                           const VehicleEnd& start, const std::vector<VehicleEnd>& goals,
                           const StopCondition& stop) {
  VehicleAnswer answer{start, goals};
  answer.result.status = Status::interrupted;
  if (!on.planner) return answer;
  const RunOptions& run = command.run;
  std::vector<vehicle::Pose> poses;
  for (const VehicleEnd& goal : goals) poses.push_back(goal.pose);
  if (refuse_numbers(answer)) return answer;
  const auto begin = Clock::now();
  answer.result = on.planner->plan(
      {.start = start.pose,
       .goals = std::move(poses),
       .goal_tolerance = on.map.cells_of(run.map.radius_metres, run.goal_tolerance),
       .heading_tolerance = command.heading_tolerance,
       .smooth = command.smooth,
       .stop = stop});
  answer.elapsed_ms = ms_since(begin);
  if (answer.result.status == Status::invalid && answer.result.touched)
    answer.nearest_free = nearest_free(on.map.as_read(), on.planner->space(),
                                       (at_goal(answer.result.fault) ? answer.goal() : start).pose,
                                       {.token = stop.token});
  return answer;
}

std::vector<vehicle::TimedPose> timed_poses(const VehicleMap& on, const VehicleCommand& command,
                                            const VehicleAnswer& answer) {
  if (!answer.has_path()) return {};
  return vehicle::Profile(answer.result.segments, on.vehicle.speeds)
      .samples(spacing_of(on.map, command.run));
}

void write_timed_poses(std::ostream& out, const VehicleMap& on, const VehicleCommand& command,
                       std::span<const VehicleAnswer> answers) {
  const double unit = in_metres(command) ? on.map.metres(1) : 1;
  out << "x,y,yaw,kappa,v,t,gear\n";
  double begun = 0;
  for (const VehicleAnswer& answer : answers) {
    double time = begun;
    for (const vehicle::TimedPose& timed : timed_poses(on, command, answer)) {
      const vehicle::Pose pose = pose_in_frame(on, command, answer, timed.at.pose);
      const double kappa =
          timed.at.curvature == 0 ? 0 : (in_metres(command) ? -1 : 1) * timed.at.curvature / unit;
      const double speed = timed.at.gear == 0 ? timed.speed : timed.speed * unit;
      time = begun + timed.time;
      for (const double value : {pose.x, pose.y, pose.yaw, kappa, speed, time})
        out << to_text(value) << ",";
      out << timed.at.gear << "\n";
    }
    begun = time;
  }
}

void write_ros_poses(std::ostream& out, const VehicleMap& on, const VehicleCommand& command,
                     std::span<const VehicleAnswer> answers) {
  std::vector<lasius::Pose> poses;
  for (const VehicleAnswer& answer : answers)
    for (const vehicle::TimedPose& timed : timed_poses(on, command, answer)) {
      const vehicle::Pose& cells = timed.at.pose;
      const vehicle::Pose pose = in_metres(command) ? pose_in_frame(on, command, answer, cells)
                                 : on.map.frame     ? to_world(on.map, cells)
                                                    : cells;
      poses.push_back({pose.x, pose.y, pose.yaw});
    }
  write_ros_path(out, poses);
}

vehicle::Pose pose_in_frame(const VehicleMap& on, const VehicleCommand& command,
                            const VehicleAnswer& answer, const vehicle::Pose& cells) {
  if (!in_metres(command)) return cells;
  vehicle::Pose world = to_world(on.map, cells);
  for (const VehicleEnd* end : {&answer.start, &answer.goal()})
    if (cells.x == end->pose.x && cells.y == end->pose.y) {
      world.x = end->asked.x;
      world.y = end->asked.y;
    }
  return world;
}

Record vehicle_record(const VehicleMap& on, const VehicleCommand& command,
                      const VehicleAnswer& answer) {
  const vehicle::Result& found = answer.result;
  SearchResult result;
  result.status = found.status;
  if (found.status == Status::limit) result.limit = Limit::time;
  result.fault = found.fault;
  if (answer.has_path()) result.length = found.length;
  result.lower_bound = found.lower_bound;
  result.optimal = answer.has_path() && found.lower_bound && found.gap() == 0.0;
  Record record{
      .options = command.run,
      .algorithm = lattice_algorithm(),
      .inputs = {{"map", map_json(on.map)}},
      .start = pose_json(answer.start.pose),
      .goal = pose_json(answer.goal().pose),
      .parameters = parameters_of(on, command),
      .result = result,
      .gap = answer.has_path() ? found.gap() : std::nullopt,
      .error = found.status == Status::invalid ? invalid_text(on, command, answer) : found.error,
      .elapsed_ms = answer.elapsed_ms,
      .unit = in_metres(command) ? "m" : "",
      .scale = on.map.length_in(command.run.frame, 1),
      .axes = 3};
  Json findings = Json::object();
  if (on.map.costs) {
    record.cost = answer.has_path() ? found.cost : std::nan("");
    record_costs(*on.map.costs, findings, record.parameters);
  }
  for (const auto& timed : timed_poses(on, command, answer)) {
    const vehicle::Pose pose = pose_in_frame(on, command, answer, timed.at.pose);
    record.path.insert(record.path.end(), {pose.x, pose.y, pose.yaw});
  }
  if (!command.run.json && answer.has_path()) record.remarks.push_back(summary(record, answer));
  record.answer =
      answer_json(record, path_json(on, command, answer), effort_json(answer), std::move(findings));
  return record;
}

}  // namespace lasius::tool
