// Maps from files and seeds, and back.
#include "lasius/grid/generate.h"
#include "lasius/io.h"
#include "python/extension/arrays.h"
#include "python/extension/call.h"
#include "python/extension/modules.h"
#include "python/extension/names.h"

namespace lasius::python {
namespace {

/// Rows (x, y) of a map of that height from one kind of coordinates to the other.
template <auto kConvert>
py::array_t<double> converted(const WorldFrame& frame, const Rows& rows, int height) {
  std::vector<Point> points = points_from(rows, "points");
  for (Point& p : points) p = (frame.*kConvert)(p, height);
  return to_array(std::span(points));
}

py::tuple read(const std::string& path, bool unknown_is_free, double free_below) {
  const Map map = [&] {
    const py::gil_scoped_release released;
    return read_any_map(path, {unknown_is_free, free_below});
  }();
  return py::make_tuple(map.grid, map.frame, words(map.image), map.unknown);
}

py::tuple generated(const std::string& kind, int width, int height, std::optional<double> density,
                    std::uint64_t seed) {
  Call call;
  const MapKind made = value_of<MapKind>("kind", map_kind_names(), kind);
  if (density && *density < 0)
    throw py::value_error("density is " + std::to_string(*density) +
                          ": it must be 0 or more, or None");
  return call.answer([&] {
    return generate(made, {width, height, density.value_or(-1), seed}, call.condition());
  });
}

}  // namespace

void bind_maps(py::module_& module) {
  py::class_<WorldFrame>(module, "WorldFrame",
                         "Where a map lies in the world, as ROS map_server has it: metres a cell, "
                         "the lower left corner in metres, yaw in radians; y points up.")
      .def(py::init([](double resolution, double origin_x, double origin_y, double yaw) {
        return WorldFrame{resolution, origin_x, origin_y, yaw};
      }))
      .def_readonly("resolution", &WorldFrame::resolution, "metres a cell")
      .def_readonly("origin_x", &WorldFrame::origin_x, "metres")
      .def_readonly("origin_y", &WorldFrame::origin_y, "metres")
      .def_readonly("yaw", &WorldFrame::yaw, "radians")
      .def("to_cells", &converted<&WorldFrame::to_cells>, py::arg("points"), py::arg("height"),
           "Points (n, 2) in metres as continuous cell coordinates of a map of that many rows.")
      .def("to_world", &converted<&WorldFrame::to_world>, py::arg("points"), py::arg("height"),
           "Points (n, 2) in continuous cell coordinates as metres.")
      .def(py::pickle(
          [](const WorldFrame& f) {
            return py::make_tuple(f.resolution, f.origin_x, f.origin_y, f.yaw);
          },
          [](const py::tuple& t) {
            return WorldFrame{t[0].cast<double>(), t[1].cast<double>(), t[2].cast<double>(),
                              t[3].cast<double>()};
          }));
  module.def("read_map", &read);
  module.def("write_map", [](const Grid& grid, const std::string& path) {
    const py::gil_scoped_release released;
    write_any_map(grid, path);
  });
  module.def("generate", &generated);
  module.def("map_kinds", [] {
    py::list names;
    for (const auto name : map_kind_names()) names.append(text(name));
    return names;
  });
}

}  // namespace lasius::python
