// A drive through a world that changes, and what happens to the world.
#include "lasius/drive/drive.h"

#include <array>

#include "lasius/vehicle/drive.h"
#include "python/extension/arrays.h"
#include "python/extension/call.h"
#include "python/extension/modules.h"
#include "python/extension/navigator_class.h"
#include "python/extension/progress.h"
#include "python/extension/vehicle_class.h"

namespace lasius::python {
namespace {

/// (ticks, ms, lengths, costs) of all replans.
py::tuple replans(const std::vector<Replan>& all) {
  std::vector<std::int64_t> ticks;
  std::vector<double> ms, lengths, costs;
  for (const Replan& r : all) {
    ticks.push_back(r.tick);
    ms.push_back(r.ms);
    lengths.push_back(r.length);
    costs.push_back(r.cost);
  }
  return py::make_tuple(to_array(ticks), to_array(ms), to_array(lengths), to_array(costs));
}

/// In the order of the fields of lasius.DriveResult.
py::tuple fields(const DriveResult& r) {
  return py::make_tuple(text(to_string(r.status)), text(to_string(r.limit)),
                        text(to_string(r.fault)), r.error, to_array(std::span<const Cell>(r.track)),
                        r.ticks, replans(r.replans), r.seen, r.length, r.planning_ms, r.waits,
                        r.deferred_changes, r.goal_reached, r.cost);
}

DriveOptions drive_options(double sense, std::int64_t max_ticks,
                           std::optional<double> seconds_per_tick, std::uint64_t seed, Call& call,
                           const py::object& callback) {
  DriveOptions options{.sense = sense,
                       .max_ticks = max_ticks,
                       .seed = seed,
                       .stop = call.condition(),
                       .observer = observer<DriveTick>(call, callback)};
  if (seconds_per_tick) options.seconds_per_tick = *seconds_per_tick;
  return options;
}

py::tuple driven(const Grid& map, const Grid& truth, Cell start, Cell goal, const Changes& changes,
                 const NavigatorOptions& navigator, double sense, std::int64_t max_ticks,
                 std::optional<double> seconds_per_tick, std::optional<double> time_limit,
                 const py::object& callback) {
  Call call(time_limit);
  const DriveOptions options =
      drive_options(sense, max_ticks, seconds_per_tick, navigator.params.seed, call, callback);
  const DriveResult result =
      call.run([&] { return drive(map, truth, start, goal, changes, options, navigator); });
  return py::make_tuple(call.error(), fields(result));
}

/// (error, fields of lasius.DriveResult, poses at each tick, moves)
py::tuple vehicle_driven(const Grid& map, const Grid& truth, const vehicle::Vehicle& driver,
                         const std::array<double, 3>& start, const Rows& goals,
                         const Changes& changes, const vehicle::NavigatorOptions& navigator,
                         double sense, std::int64_t max_ticks,
                         std::optional<double> seconds_per_tick, std::uint64_t seed,
                         std::optional<double> time_limit, const py::object& callback) {
  Call call(time_limit);
  const DriveOptions options =
      drive_options(sense, max_ticks, seconds_per_tick, seed, call, callback);
  const std::vector<vehicle::Pose> ends = poses_from(goals, "goal");
  const vehicle::DriveResult result = call.run([&] {
    return vehicle::drive(map, truth, driver, {start[0], start[1], start[2]}, ends, changes,
                          options, navigator);
  });
  return py::make_tuple(call.error(), fields(result), pose_rows(result.poses),
                        segment_rows(result.moves));
}

py::array_t<std::int32_t> rectangles(const std::vector<Rectangle>& all) {
  std::vector<std::int32_t> numbers;
  for (const Rectangle& r : all) numbers.insert(numbers.end(), {r.x, r.y, r.width, r.height});
  return to_array(numbers).reshape({-1, 4});
}

void bind_tick(py::module_& module) {
  using Seen = View<DriveTick>;
  py::class_<Seen>(module, "DriveTick")
      .def_property_readonly("tick", [](const Seen& v) { return v.get().tick; })
      .def_property_readonly("robot", [](const Seen& v) { return v.get().robot; })
      .def_property_readonly("world", [](const Seen& v) { return Grid(*v.get().world); })
      .def_property_readonly("map", [](const Seen& v) { return Grid(v.get().robot_knows->map()); })
      .def_property_readonly(
          "path",
          [](const Seen& v) {
            const Way* const way = v.get().way;
            return to_array(way == nullptr ? std::span<const Point>() : std::span(way->path));
          })
      .def_property_readonly("obstacles",
                             [](const Seen& v) { return rectangles(v.get().obstacles); })
      .def_property_readonly(
          "news", [](const Seen& v) { return to_array(std::span<const Cell>(v.get().news)); })
      .def_property_readonly("replanned", [](const Seen& v) { return v.get().replanned; })
      .def("stop", &Seen::stop);
}

void bind_changes(py::module_& module) {
  py::class_<Changes>(module, "Changes")
      .def(py::init<>())
      .def("add_change",
           [](Changes& changes, std::int64_t tick, int x, int y, int width, int height,
              bool blocked) {
             changes.cells.push_back({tick, {x, y, width, height}, blocked});
           })
      .def("add_obstacle", [](Changes& changes, std::int64_t tick, int width, int height,
                              double speed, const IntRows& track) {
        changes.obstacles.push_back({tick, width, height, speed, cells_from(track, "track")});
      });
  module.def("read_changes", &read_changes_file);
}

}  // namespace

void bind_drive(py::module_& module) {
  bind_tick(module);
  bind_changes(module);
  module.def("drive", &driven);
  module.def("drive_vehicle", &vehicle_driven);
}

}  // namespace lasius::python
