// Grid, and questions about it: packed from arrays of one byte a cell with any strides.
#include "lasius/grid/grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "lasius/grid/clearance.h"
#include "lasius/path/path.h"
#include "lasius/path/shortest_walk.h"
#include "lasius/path/smooth.h"
#include "python/extension/arrays.h"
#include "python/extension/call.h"
#include "python/extension/modules.h"
#include "python/extension/names.h"

namespace lasius::python {
namespace {

/// Cells whose byte is from `low` on one of `span` + 1 values, modulo 256, are one kind.
struct Free {
  std::uint8_t low;
  std::uint8_t span;
  bool inside;  ///< those are free, else the others

  Nonzero marked() const noexcept { return inside ? Nonzero::free : Nonzero::blocked; }
};

constexpr int kBlock = 64;  ///< rows that are read together, columns of them at a time

/// Rows of cells as bytes 0 and 1, 1 where it is one of the values.
void mark(const std::uint8_t* cells, py::ssize_t down, py::ssize_t right, const Free& free,
          int width, std::span<std::uint8_t> marks) {
  const auto is_marked = [&free](std::uint8_t cell) {
    return static_cast<std::uint8_t>(static_cast<std::uint8_t>(cell - free.low) <= free.span);
  };
  const int rows = static_cast<int>(marks.size()) / width;
  if (right == 1) {  // a loop of its own, which compilers make vectors of
    for (int y = 0; y < rows; ++y, cells += down) {
      std::uint8_t* const row = &marks[static_cast<std::size_t>(y) * width];
      for (int x = 0; x < width; ++x) row[x] = is_marked(cells[x]);
    }
    return;
  }
  std::array<std::array<std::uint8_t, kBlock>, kBlock> block;  // a line of memory may be a column
  for (int left = 0; left < width; left += kBlock) {
    const int columns = std::min(kBlock, width - left);
    for (int x = 0; x < columns; ++x) {
      const std::uint8_t* const column = cells + (left + x) * right;
      for (int y = 0; y < rows; ++y) block[y][x] = is_marked(column[y * down]);
    }
    for (int y = 0; y < rows; ++y)
      std::copy_n(block[y].data(), columns, &marks[static_cast<std::size_t>(y) * width + left]);
  }
}

Grid packed(const py::array& cells, const Free& free) {
  const auto side = [&cells](int axis) {
    return static_cast<int>(std::min<py::ssize_t>(cells.shape(axis), Grid::kMaxSide + 1));
  };
  const int width = side(1), height = side(0);
  const auto* const first = static_cast<const std::uint8_t*>(cells.data());
  const py::ssize_t down = cells.strides(0), right = cells.strides(1);
  const py::gil_scoped_release released;  // the array is the caller's, who waits
  if (free.low == 0 && free.span == 0 && right == 1 && down == width)
    return Grid(width, height,
                {first, static_cast<std::size_t>(width) * static_cast<std::size_t>(height)},
                free.inside ? Nonzero::blocked : Nonzero::free);
  Grid grid(width, height);
  std::vector<std::uint8_t> marks(static_cast<std::size_t>(width) * std::min(kBlock, height));
  for (int y = 0; y < height; y += kBlock) {
    const int rows = std::min(kBlock, height - y);
    const auto part = std::span(marks).first(static_cast<std::size_t>(width) * rows);
    mark(first + y * down, down, right, free, width, part);
    grid.paste({0, y, width, rows}, part, free.marked());
  }
  return grid;
}

/// free: True, False, a value, or a range of values, from `least` to `most`.
Free free_values(const py::handle& free, int least, int most) {
  if (py::isinstance<py::bool_>(free) || py::isinstance(free, py::dtype::of<bool>().attr("type")))
    return {0, 0, PyObject_IsTrue(free.ptr()) == 0};
  const bool is_range = py::isinstance(free, py::module_::import("builtins").attr("range"));
  const auto refuse = [&free](const char* why) {
    return py::value_error(py::str("free={!r}: {}").format(free, why));
  };
  if (is_range && (!py::bool_(py::reinterpret_borrow<py::object>(free)) ||
                   !py::object(free.attr("step")).equal(py::int_(1))))
    throw refuse("a range of values has step 1 and is not empty");
  const auto bound = [&](int end) {
    const py::object value =
        is_range ? py::object(free[py::int_(end)]) : py::reinterpret_borrow<py::object>(free);
    if (!PyIndex_Check(value.ptr()))
      throw py::type_error(
          py::str("free={!r}: give True (what is not 0 is free), False (what is 0), "
                  "a value, or a range of values")
              .format(free));
    int beyond = 0;  // what a long long can hold
    const auto number = PyLong_AsLongLongAndOverflow(value.attr("__index__")().ptr(), &beyond);
    if (beyond != 0 || number < least || number > most) throw refuse("the array has no such value");
    return static_cast<int>(number);
  };
  const int low = bound(0), high = bound(-1);
  return {static_cast<std::uint8_t>(low), static_cast<std::uint8_t>(high - low), true};
}

Grid grid_from_array(const py::array& cells, const py::object& free) {
  const char kind = cells.dtype().kind();
  if (cells.itemsize() != 1 || (kind != 'b' && kind != 'u' && kind != 'i'))
    throw py::type_error(
        py::str("an array of {}: give bool, uint8 or int8, as `array < threshold` makes")
            .format(cells.dtype()));
  if (cells.ndim() != 2)
    throw py::value_error(
        py::str("an array of {} dimensions: give one [y, x]").format(cells.ndim()));
  if (cells.size() == 0) throw py::value_error("an array without cells: a map has at least one");
  const int least = kind == 'i' ? -128 : 0;
  return packed(cells, free_values(free, least, kind == 'b' ? 1 : least + 255));
}

py::array_t<bool> as_array(const Grid& grid, bool free) {
  py::array_t<bool> cells({grid.height(), grid.width()});
  bool* const to = cells.mutable_data();
  const py::gil_scoped_release released;
  for (int y = 0; y < grid.height(); ++y) {
    const auto row = grid.bytes({0, y, grid.width(), 1}, free ? Nonzero::free : Nonzero::blocked);
    std::ranges::copy(row, to + static_cast<std::ptrdiff_t>(y) * grid.width());
  }
  return cells;
}

/// Distances in cells, [y, x]; None if stopped.
py::object clearance_array(const Grid& grid, Call& call) {
  py::array_t<double> distances({grid.height(), grid.width()});
  double* const to = distances.mutable_data();
  const bool done = call.run([&] {
    const auto field = clearance(grid, call.condition());
    if (!field) return false;
    std::ranges::transform(field->squared_half_cells, to,
                           [](std::int32_t squared) { return std::sqrt(squared) / 2; });
    return true;
  });
  return done ? py::object(distances) : py::none();
}

/// The bits of all rows, for pickle.
py::tuple state_of(const Grid& grid) {
  std::string bits;
  const auto row_bytes = static_cast<std::size_t>(grid.words()) * sizeof(std::uint64_t);
  bits.reserve(row_bytes * static_cast<std::size_t>(grid.height()));
  for (int y = 0; y < grid.height(); ++y)
    bits.append(reinterpret_cast<const char*>(grid.row(y)), row_bytes);
  return py::make_tuple(grid.width(), grid.height(), py::bytes(bits));
}

Grid grid_of_state(const py::tuple& state) {
  Grid grid(state[0].cast<int>(), state[1].cast<int>());
  const auto bits = state[2].cast<std::string>();
  std::vector<std::uint64_t> words(static_cast<std::size_t>(grid.words()));
  const std::size_t row_bytes = words.size() * sizeof(std::uint64_t);
  if (bits.size() != row_bytes * static_cast<std::size_t>(grid.height()))
    throw py::value_error("a pickled Grid whose bits do not fit its size");
  for (int y = 0; y < grid.height(); ++y) {
    std::memcpy(words.data(), bits.data() + static_cast<std::size_t>(y) * row_bytes, row_bytes);
    grid.set_row(y, words.data());
  }
  return grid;
}

void bind_questions(py::module_& module) {
  module.def("clearance", [](const Grid& grid) {
    Call call;
    const auto distances = clearance_array(grid, call);
    return py::make_tuple(call.error(), distances);
  });
  module.def("grow_obstacles", [](const Grid& grid, double radius) {
    Call call;
    return call.answer([&] { return grow_obstacles(grid, radius, call.condition()); });
  });
  module.def("shortest_walk", [](const Grid& grid, Cell start, Cell goal,
                                 const std::string& neighbours, const std::string& corners) {
    Call call;
    const auto moves = value_of<Neighbours>("neighbours", kNeighboursNames, neighbours);
    const auto rule = corners_from(corners);
    return call.answer(
        [&] { return shortest_walk(grid, start, goal, moves, rule, call.condition()); });
  });
  module.def("path_length",
             [](const Rows& path) { return path_length(points_from(path, "path")); });
  module.def("path_fault", [](const Grid& grid, const Rows& path, const std::string& corners) {
    return path_fault(grid, points_from(path, "path"), corners_from(corners));
  });
  module.def("visible", &visible);
  module.def("pull_taut", [](const Grid& grid, const Rows& path, const std::string& corners) {
    Call call;
    const auto points = points_from(path, "path");
    const auto rule = corners_from(corners);
    const auto taut = call.run([&] { return pull_taut(grid, points, rule, call.condition()); });
    return py::make_tuple(call.error(), to_array(std::span(taut)));
  });
}

}  // namespace

void bind_grid(py::module_& module) {
  py::class_<Grid>(module, "Grid",
                   "A bitmap of free and blocked cells, one bit a cell; it never changes.")
      .def(py::init(&grid_from_array), py::arg("array"), py::kw_only(), py::arg("free"))
      .def_property_readonly("width", &Grid::width, "columns")
      .def_property_readonly("height", &Grid::height, "rows")
      .def_property_readonly(
          "shape", [](const Grid& grid) { return py::make_tuple(grid.height(), grid.width()); },
          "(height, width), as of an array [y, x]")
      .def("free", &Grid::free, py::arg("cell"), "True for a free cell (x, y) of the map.")
      .def("count_free", &Grid::count_free, "The number of free cells.")
      .def_property_readonly("hash", &Grid::hash, "The map's fingerprint in result files.")
      .def("to_array", &as_array, py::kw_only(), py::arg("free"),
           "The cells as a bool array [y, x], True where they are free, or with free=False where "
           "they are blocked.")
      .def("__eq__",
           [](const Grid& a, const py::object& other) {
             return py::isinstance<Grid>(other) && a == other.cast<const Grid&>();
           })
      .def("__hash__", &Grid::hash)
      .def("__repr__",
           [](const Grid& grid) {
             return "Grid(" + std::to_string(grid.width()) + " x " + std::to_string(grid.height()) +
                    " cells)";
           })
      .def(py::pickle(&state_of, &grid_of_state))
      .def("__copy__", [](const py::object& grid) { return grid; })
      .def("__deepcopy__", [](const py::object& grid, const py::object&) { return grid; });
  bind_questions(module);
}

}  // namespace lasius::python
