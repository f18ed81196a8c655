// Vehicles.
#include <array>
#include <type_traits>

#include "lasius/vehicle/profile.h"
#include "python/extension/arrays.h"
#include "python/extension/call.h"
#include "python/extension/modules.h"
#include "python/extension/vehicle_class.h"

namespace lasius::python {
namespace {

using vehicle::Pose;
using vehicle::Segment;

constexpr py::ssize_t kColumns = 8;  // x, y, yaw, curvature, curvature rate, length, gear, angle

std::vector<Segment> segments_from(const Rows& rows) {
  std::vector<Segment> segments;
  const auto n = row_count(rows, kColumns, "segments");
  for (py::ssize_t i = 0; i < n; ++i)
    segments.push_back({.begin = {rows.at(i, 0), rows.at(i, 1), rows.at(i, 2)},
                        .curvature = rows.at(i, 3),
                        .curvature_rate = rows.at(i, 4),
                        .length = rows.at(i, 5),
                        .gear = static_cast<int>(rows.at(i, 6)),
                        .angle = rows.at(i, 7)});
  return segments;
}

vehicle::Vehicle vehicle_from(const Rows& footprint, double turning_radius, bool reverse,
                              double reverse_cost, double cusp_cost, bool rotate_in_place,
                              double rotation_cost, bool sideways, double curvature_rate) {
  return {.footprint = points_from(footprint, "footprint"),
          .turning_radius = turning_radius,
          .reverse = reverse,
          .reverse_cost = reverse_cost,
          .cusp_cost = cusp_cost,
          .rotate_in_place = rotate_in_place,
          .rotation_cost = rotation_cost,
          .sideways = sideways,
          .curvature_rate = curvature_rate};
}

}  // namespace

std::vector<Pose> poses_from(const Rows& rows, const char* name) {
  std::vector<Pose> poses;
  const auto n = row_count(rows, 3, name);
  for (py::ssize_t i = 0; i < n; ++i)
    poses.push_back({rows.at(i, 0), rows.at(i, 1), rows.at(i, 2)});
  return poses;
}

py::array_t<double> pose_rows(const std::vector<Pose>& poses) {
  static_assert(std::is_standard_layout_v<Pose> && sizeof(Pose) == 3 * sizeof(double));
  return py::array_t<double>({static_cast<py::ssize_t>(poses.size()), py::ssize_t{3}},
                             reinterpret_cast<const double*>(poses.data()));
}

py::array_t<double> segment_rows(const std::vector<Segment>& segments) {
  py::array_t<double> rows({static_cast<py::ssize_t>(segments.size()), kColumns});
  auto to = rows.mutable_unchecked<2>();
  py::ssize_t i = 0;
  for (const Segment& s : segments) {
    py::ssize_t column = 0;
    for (const double value : {s.begin.x, s.begin.y, s.begin.yaw, s.curvature, s.curvature_rate,
                               s.length, static_cast<double>(s.gear), s.angle})
      to(i, column++) = value;
    ++i;
  }
  return rows;
}

py::tuple vehicle_fields(const vehicle::Result& found) {
  const bool path = !found.segments.empty();
  return py::make_tuple(text(to_string(found.status)), text(to_string(found.fault)), found.error,
                        segment_rows(found.segments), path ? found.length : NAN,
                        path ? found.cost : NAN, found.cusps, found.corners, found.goal,
                        found.lower_bound, path ? found.gap() : std::nullopt, found.touched,
                        found.expanded);
}

namespace {

py::tuple plan(const vehicle::Planner& planner, const Pose& start, const Rows& goals,
               double goal_tolerance, double heading_tolerance, double weight, bool smooth,
               std::optional<double> time_limit) {
  Call call(time_limit);
  const vehicle::Request request{.start = start,
                                 .goals = poses_from(goals, "goals"),
                                 .goal_tolerance = goal_tolerance,
                                 .heading_tolerance = heading_tolerance,
                                 .weight = weight,
                                 .smooth = smooth,
                                 .stop = call.condition()};
  const vehicle::Result found = call.run([&] { return planner.plan(request); });
  return py::make_tuple(call.error(), vehicle_fields(found));
}

/// x, y, yaw, curvature, gear, speed, time of poses along segments.
py::array_t<double> timed_poses(const Rows& segments, double spacing,
                                const vehicle::SpeedLimits& limits) {
  const auto along = vehicle::Profile(segments_from(segments), limits).samples(spacing);
  py::array_t<double> rows({static_cast<py::ssize_t>(along.size()), py::ssize_t{7}});
  auto to = rows.mutable_unchecked<2>();
  py::ssize_t i = 0;
  for (const vehicle::TimedPose& timed : along) {
    const Pose& pose = timed.at.pose;
    py::ssize_t column = 0;
    for (const double value : {pose.x, pose.y, pose.yaw, timed.at.curvature,
                               static_cast<double>(timed.at.gear), timed.speed, timed.time})
      to(i, column++) = value;
    ++i;
  }
  return rows;
}

/// (place along the poses, pose, cell, proven), or None.
py::object first_contact(const vehicle::Planner& planner, const Rows& poses) {
  const auto met = planner.space().first_contact(std::span<const Pose>(poses_from(poses, "poses")));
  if (!met) return py::none();
  return py::make_tuple(met->segment + met->at,
                        py::make_tuple(met->pose.x, met->pose.y, met->pose.yaw), met->cell,
                        met->proven);
}

}  // namespace

void bind_vehicle(py::module_& module) {
  py::class_<vehicle::Vehicle>(module, "VehicleValues").def(py::init(&vehicle_from));
  py::class_<vehicle::Planner>(module, "VehiclePlanner")
      .def("plan",
           [](const vehicle::Planner& planner, const std::array<double, 3>& start,
              const Rows& goals, double goal_tolerance, double heading_tolerance, double weight,
              bool smooth, std::optional<double> time_limit) {
             return plan(planner, {start[0], start[1], start[2]}, goals, goal_tolerance,
                         heading_tolerance, weight, smooth, time_limit);
           })
      .def("free",
           [](const vehicle::Planner& planner, const std::array<double, 3>& pose) {
             return planner.space().free(Pose{pose[0], pose[1], pose[2]});
           })
      .def("first_contact", &first_contact);
  module.def("make_vehicle_planner", [](const Grid& grid, const vehicle::Vehicle& vehicle,
                                        const CostField* costs) {
    Call call;
    std::optional<vehicle::Planner> made =
        call.run([&] { return vehicle::Planner::make(grid, vehicle, call.condition(), costs); });
    return py::make_tuple(call.error(), std::move(made));
  });
  module.def("vehicle_timed_poses",
             [](const Rows& segments, double spacing, const std::array<double, 8>& limits) {
               return timed_poses(segments, spacing,
                                  {.speed = limits[0],
                                   .reverse_speed = limits[1],
                                   .acceleration = limits[2],
                                   .braking = limits[3],
                                   .lateral_acceleration = limits[4],
                                   .turn_rate = limits[5],
                                   .turn_acceleration = limits[6],
                                   .steady_curvature = limits[7] != 0});
             });
}

}  // namespace lasius::python
