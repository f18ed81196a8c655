// Component lasius::polygon: worlds of rings, the planner among them.
#include "lasius/polygon.h"

#include "python/extension/arrays.h"
#include "python/extension/batch.h"
#include "python/extension/call.h"
#include "python/extension/modules.h"
#include "python/extension/names.h"
#include "python/extension/parameter_class.h"
#include "python/extension/progress.h"
#include "python/extension/results.h"

namespace lasius::python {
namespace {

namespace pg = lasius::polygon;

/// (outer, [hole, ...]) of arrays (n, 2).
py::tuple rings(const pg::Polygon& polygon) {
  py::list holes;
  for (const pg::Ring& hole : polygon.holes) holes.append(to_array(std::span(hole)));
  return py::make_tuple(to_array(std::span(polygon.outer)), holes);
}

py::list rings(const std::vector<pg::Polygon>& polygons) {
  py::list all;
  for (const pg::Polygon& polygon : polygons) all.append(rings(polygon));
  return all;
}

pg::Polygon polygon_from(const py::handle& source) {
  const auto [outer, holes] = source.cast<std::pair<Rows, std::vector<Rows>>>();
  pg::Polygon polygon{points_from(outer, "a ring"), {}};
  for (const Rows& hole : holes) polygon.holes.push_back(points_from(hole, "a ring"));
  return polygon;
}

pg::World world(const py::object& boundary, const py::list& obstacles,
                const std::vector<Rows>& walls, std::optional<Point> start,
                std::optional<Point> goal, double margin) {
  pg::World made{polygon_from(boundary), {}, start, goal, margin};
  for (const py::handle& obstacle : obstacles) made.obstacles.push_back(polygon_from(obstacle));
  for (const Rows& wall : walls) made.walls.push_back(points_from(wall, "a line"));
  pg::check(made);
  return made;
}

/// (lines, values, path, length), or None.
py::object crossing(const std::optional<pg::Crossing>& way) {
  if (!way || way->path.empty()) return py::none();
  return py::make_tuple(to_array(way->lines), to_array(way->values), to_array(std::span(way->path)),
                        way->length);
}

/// In the order of the fields of lasius.polygon.Result.
py::tuple fields(const pg::Result& r) {
  return py::make_tuple(search_fields(r), to_array(std::span(r.path)), r.goal_reached,
                        r.nearest_free, r.nearest_reachable, crossing(r.crossing),
                        crossing(r.dijkstra), crossing(r.discrete_optimum),
                        crossing(r.sequence_optimum), r.optimum, r.note);
}

py::tuple made_planner(const pg::World& world, std::optional<double> margin,
                       const std::string& join, const std::string& boundary) {
  Call call;
  const pg::GrowOptions options{margin, value_of<pg::Join>("join", pg::kJoinNames, join),
                                value_of<pg::Boundary>("boundary", pg::kBoundaryNames, boundary)};
  return call.answer([&] { return pg::Planner::make(world, options, call.condition()); });
}

py::tuple plan_among(const pg::Planner& planner, std::optional<Point> start,
                     std::optional<Point> goal, const pg::Params& params, double target_gap,
                     double goal_tolerance, std::optional<double> time_limit,
                     const py::object& callback) {
  Call call(time_limit);
  const pg::Observer observe = observer<Progress>(call, callback);
  const pg::Result result = call.run([&] {
    return planner.plan({start, goal, call.condition(), target_gap, goal_tolerance}, params,
                        observe);
  });
  return py::make_tuple(call.error(), fields(result));
}

py::tuple batch_among(const pg::Planner& planner, const Rows& starts, const Rows& goals,
                      const pg::Params& params, int threads, int seeds,
                      std::optional<double> time_limit, double target_gap, double goal_tolerance,
                      const py::object& callback) {
  Call call;
  auto requests = requests_from<pg::Request>(points_from(starts, "starts"),
                                             points_from(goals, "goals"), target_gap);
  for (pg::Request& request : requests) request.goal_tolerance = goal_tolerance;
  return run_batch(call, requests.size(), threads, seeds, time_limit, callback,
                   [&](const BatchOptions& options, const pg::BatchReceiver& receive) {
                     pg::plan_batch(planner, requests, params, options, receive);
                   });
}

/// (ends (n, 4), regions (n, 2)) of all lines.
py::tuple lines(const pg::Planner& planner) {
  std::vector<double> ends;
  std::vector<int> regions;
  for (const pg::Line& line : planner.maklink().lines) {
    ends.insert(ends.end(), {line.a.x, line.a.y, line.b.x, line.b.y});
    regions.insert(regions.end(), {line.left, line.right});
  }
  return py::make_tuple(to_array(ends).reshape({-1, 4}), to_array(regions).reshape({-1, 2}));
}

void bind_world(py::module_& module) {
  py::class_<pg::World>(module, "World")
      .def(py::init(&world))
      .def("boundary", [](const pg::World& w) { return rings(w.boundary); })
      .def("obstacles", [](const pg::World& w) { return rings(w.obstacles); })
      .def("walls",
           [](const pg::World& w) {
             py::list all;
             for (const pg::Ring& wall : w.walls) all.append(to_array(std::span(wall)));
             return all;
           })
      .def_readonly("notes", &pg::World::notes)
      .def_readonly("start", &pg::World::start)
      .def_readonly("goal", &pg::World::goal)
      .def_readonly("margin", &pg::World::margin)
      .def("to_geojson", [](const pg::World& w) { return pg::to_geojson(w); })
      .def("write", [](const pg::World& w, const std::string& path) { pg::write_world(w, path); });
  module.def("read_world",
             [](const std::string& path, bool repair) { return pg::read_world(path, {repair}); });
  module.def("parse_geojson", [](const std::string& words, bool repair) {
    return pg::parse_geojson(words, "GeoJSON", {repair});
  });
}

}  // namespace

void bind_polygon(py::module_& module) {
  bind_world(module);
  bind_parameter_class<pg::Params>(module).def(py::init<const std::string&>());
  bind_progress<Progress>(module, "Progress");
  module.def("algorithms", [] { return described(pg::algorithms()); });
  module.def("make_planner", &made_planner);
  py::class_<pg::Planner>(module, "Planner")
      .def("plan", &plan_among)
      .def("batch", &batch_among)
      .def_property_readonly("margin", &pg::Planner::margin)
      .def_property_readonly("components", &pg::Planner::components)
      .def("free", &pg::Planner::free)
      .def("nearest_free", &pg::Planner::nearest_free)
      .def("free_space", [](const pg::Planner& p) { return rings(p.free_space()); })
      .def("grown_obstacles", [](const pg::Planner& p) { return rings(p.grown_obstacles()); })
      .def("lines", &lines);
}

}  // namespace lasius::python
