// `lasius tour MAP --vehicle`.
#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "lasius/vehicle/tour.h"
#include "tools/bitmap/bitmap_problem.h"
#include "tools/bitmap/map_ends.h"
#include "tools/bitmap/sheet.h"
#include "tools/command_line/map_options.h"
#include "tools/console/values.h"
#include "tools/record/outputs.h"
#include "tools/record/recorded.h"
#include "tools/tour/stops_file.h"
#include "tools/tour/tour_files.h"
#include "tools/tour/tour_kind.h"
#include "tools/tour/tour_picture.h"
#include "tools/tour/tour_problem.h"
#include "tools/vehicle/vehicle_answer.h"
#include "tools/vehicle/vehicle_json.h"
#include "tools/vehicle/vehicle_picture.h"

namespace lasius::tool {
namespace {

class VehicleTour final : public TourProblem {
 public:
  VehicleTour(TourCommand command, std::optional<LoadedVehicle> vehicle)
      : TourProblem(std::move(command)), vehicle_(std::move(vehicle)) {}

  Forms show(const Record& run) const override {
    return {
        .csv = [&](std::ostream& out) { write_timed_poses(out, *on_, *command_.vehicle, legs_); },
        .picture = [&](auto& file) { write_picture(file, run.algorithm.name); },
        .yaml = [&](std::ostream& out) { write_ros_poses(out, *on_, *command_.vehicle, legs_); },
        .page =
            [&](std::ostream& out) {
              write_tour_page(out, run, answer_, command_.run,
                              vehicle_view_json(*on_, *command_.vehicle, legs_));
            }};
  }

 private:
  void read_world(const std::stop_token& token) override {
    RunOptions& run = command_.run;
    command_.vehicle->run = run;
    on_.emplace(load_vehicle_map(*command_.vehicle, vehicle_, token));
    answer_.map = on_->map;
    note_files(answer_.map, run);
    if (!command_.stops_file.empty())
      command_.stops = read_stops(command_.stops_file, run.frame, true);
    note_map(answer_.map, run, token);
  }

  TourResult tour_of(const TourRequest& request, const Watch& watch) override {
    TourResult tour;
    tour.status = Status::interrupted;
    if (!on_->planner) return tour;
    vehicle::TourRequest asked{request, command_.stops.yaws};
    for (std::size_t i = 0; i < asked.yaws.size(); ++i)
      if (asked.yaws[i]) asked.yaws[i] = end_at(static_cast<int>(i), *asked.yaws[i]).pose.yaw;
    const double scale = answer_.map.costs ? 1 : answer_.map.length_in(command_.run.frame, 1);
    vehicle::TourResult found = vehicle::plan_tour(
        *on_->planner, asked, told_to(watch, scale, in_metres() && !answer_.map.costs ? "m" : ""));
    poses_ = std::move(found.poses);
    for (std::size_t i = 0; i < found.legs.size(); ++i)
      legs_.push_back({.start = chosen(found, found.legs[i].from),
                       .goals = {chosen(found, found.legs[i].to)},
                       .result = std::move(found.plans[i])});
    if (found.order.size() == 1 && found.legs.empty()) {  // files hold where it stands
      VehicleEnd end = chosen(found, found.order.front());
      vehicle::Result standing;
      standing.segments = {{.begin = end.pose}};
      standing.goal = 0;
      legs_.push_back({.start = end, .goals = {end}, .result = std::move(standing)});
    }
    for (const LeftOut& out : found.left_out) said_[out.stop] = out.why;
    return std::move(static_cast<TourResult&>(found));
  }

  /// A stop as an end of plans, where it looks in the command's frame.
  VehicleEnd end_at(int stop, double yaw) const {
    const Place& place = place_at(stop);
    return vehicle_end(answer_.map, {{in_metres() ? place.asked : place.at(), true}, yaw},
                       command_.run.frame);
  }
  VehicleEnd chosen(const vehicle::TourResult& tour, int stop) const {
    const auto i = std::ranges::find(tour.order, stop) - tour.order.begin();
    const vehicle::Pose& pose = poses_[static_cast<std::size_t>(i)];
    VehicleEnd end = end_at(stop, in_metres() ? yaw_across(answer_.map, pose.yaw) : pose.yaw);
    end.pose = pose;
    return end;
  }

  // What the library says behind the place, which it knows in cells.
  std::string why_not(const Place& place, const std::string& name) const override {
    const auto stop = static_cast<int>(&place - answer_.stops.data());
    const std::string& said = said_.at(stop);
    std::string text = name + place_text(place, command_.run.frame);
    const auto behind = [&](std::string why) {  // a place in metres ends with a comma
      if (why.starts_with(':') && text.ends_with(',')) text.pop_back();
      return text + why + metres_hint(answer_.map, command_.run.frame, place);
    };
    if (!said.ends_with(" is blocked")) return behind(said.substr(said.rfind(')') + 1));
    const auto& yaws = command_.stops.yaws;
    const auto yaw = yaws.empty() ? std::nullopt : yaws[static_cast<std::size_t>(stop)];
    vehicle::Pose pose = end_at(stop, yaw.value_or(0)).pose;
    if (!yaw) pose.yaw = 0;  // the first that was tried, in cells
    const auto cell = on_->planner->space().contact(pose);
    if (!cell) return text + " is blocked";
    if (yaw && is_end(stop))
      return name + pose_text(on_->map, command_.run.frame, pose) +
             touched_text(on_->map, command_.run.frame, *cell,
                          nearest_free(on_->map.as_read(), on_->planner->space(), pose, {}));
    return behind(": the footprint meets cell (" + std::to_string(cell->x) + ", " +
                  std::to_string(cell->y) + ")" +
                  (yaw ? "" : ", and others at the other headings"));
  }
  void look_at_ends() override {}  // the error says it all

  Record head(Json& findings) const override {
    Record record = TourProblem::head(findings);
    for (const auto& [end, told] :
         {std::pair(answer_.start, &record.start), {answer_.goal, &record.goal}})
      if (end) *told = pose_json(end_at(*end, *yaw_of(*end)).pose);
    record.parameters["vehicle"] = vehicle_json(on_->vehicle.vehicle);
    record.parameters["speeds"] = speeds_json(on_->vehicle.speeds);
    return record;
  }
  std::optional<double> yaw_of(int stop) const {
    return command_.stops.yaws.empty() ? std::nullopt
                                       : command_.stops.yaws[static_cast<std::size_t>(stop)];
  }

  void add_answer(Json& json) const override {
    Json yaws = Json::array(), poses = Json::array(), poses_world = Json::array();
    for (std::size_t i = 0; i < answer_.stops.size(); ++i)
      yaws.push_back(optional_number(yaw_of(static_cast<int>(i))));
    for (const vehicle::Pose& pose : poses_) {
      poses.push_back(pose_json(pose));
      if (in_metres()) poses_world.push_back(pose_json(to_world(answer_.map, pose)));
    }
    json["yaws"] = std::move(yaws);
    json["poses"] = std::move(poses);
    if (in_metres()) json["poses_world"] = std::move(poses_world);
    for (const auto& [end, key] :
         {std::pair(answer_.start, "start_world"), {answer_.goal, "goal_world"}})
      if (end && in_metres()) json[key].push_back(number(*yaw_of(*end)));
    double duration = 0;
    int cusps = 0;
    for (std::size_t i = 0; i < json["legs"].size(); ++i) {
      const vehicle::Result& plan = legs_[i].result;
      const double time = vehicle::Profile(plan.segments, on_->vehicle.speeds).duration();
      Json& leg = json["legs"][i];
      leg["segments"] = segments_json(answer_.map, plan.segments, false);
      if (in_metres()) leg["segments_world"] = segments_json(answer_.map, plan.segments, true);
      leg["cusps"] = plan.cusps;
      leg["duration"] = number(time);
      leg["lower_bound"] = optional_number(plan.lower_bound);
      duration += time;
      cusps += plan.cusps;
    }
    const bool found = !answer_.tour.order.empty();
    json["cusps"] = found ? Json(cusps) : Json();
    json["duration"] = found ? number(duration) : Json();
  }

  void write_picture(const std::string& file, std::string_view algorithm) const {
    const auto swept = [&](Canvas& canvas, const Axes& axes) {
      for (const VehicleAnswer& leg : legs_) {
        std::vector<vehicle::Pose> poses;
        for (const auto& timed : timed_poses(*on_, *command_.vehicle, leg))
          poses.push_back(timed.at.pose);
        draw_sweep(canvas, axes, on_->vehicle.vehicle, poses, leg.start.pose, leg.goal().pose);
      }
    };
    write_tour_picture(file, algorithm, command_.run, answer_, swept, {sweep_key()});
  }

  std::optional<LoadedVehicle> vehicle_;  ///< in place of the command's file
  std::optional<VehicleMap> on_;
  std::vector<vehicle::Pose> poses_;
  std::vector<VehicleAnswer> legs_;
  std::map<int, std::string> said_;  ///< of stops that are left out
};

}  // namespace

void take_vehicle(const OptionTable& table, TourCommand& tour, const VehicleCommand& vehicle,
                  const std::vector<std::string>& starts, const std::string& goal) {
  table.refuse({"--cover", "--capacity", "--most-stops", "--radius", "--prepare", "--prepared",
                "--corners", "--algorithm", "--set", "--preset"},
               " with --vehicle: it is of tours of points and discs; leave it out");
  if (starts.size() > 1)
    throw UsageError("--start is given " + std::to_string(starts.size()) +
                     " times, and one vehicle goes; give one --start");
  tour.vehicle = vehicle;
  tour.run.inputs.push_back(vehicle.file);
  if (!starts.empty()) tour.start = pose_value("--start", starts.front(), tour.run);
  if (!goal.empty()) tour.goal = pose_value("--goal", goal, tour.run);
}

std::unique_ptr<Problem> vehicle_tour(TourCommand command, const Json* recorded) {
  std::optional<LoadedVehicle> vehicle;
  if (recorded != nullptr) {
    const Json& parameters = value_at(*recorded, "parameters");
    vehicle = LoadedVehicle{.vehicle = recorded_vehicle(parameters),
                            .speeds = recorded_speeds(parameters)};
    vehicle->speeds.steady_curvature = vehicle->vehicle.curvature_rate > 0;
    command.vehicle.emplace();
    for (const Json& yaw : value_at(*recorded, "yaws"))
      command.stops.yaws.push_back(yaw.is_null() ? std::nullopt : std::optional(yaw.get<double>()));
    command.stops.yaws.resize(command.stops.points.size());
    const std::string frame = command.run.frame == Frame::world ? "_world" : "";
    for (const auto& [key, end] : {std::pair("start", &command.start), {"goal", &command.goal}})
      if (!value_at(*recorded, key).is_null()) *end = recorded_pose(*recorded, key + frame);
  }
  return std::make_unique<VehicleTour>(std::move(command), std::move(vehicle));
}

}  // namespace lasius::tool
