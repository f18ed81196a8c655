#include "python/extension/arrays.h"

#include <limits>
#include <type_traits>

namespace lasius::python {
namespace {

static_assert(std::is_standard_layout_v<Cell> && sizeof(Cell) == 2 * sizeof(std::int32_t));
static_assert(std::is_standard_layout_v<Point> && sizeof(Point) == 2 * sizeof(double));

[[noreturn]] void refuse(py::handle source, const char* wanted) {
  throw py::type_error(py::str("{!r} is no {}").format(source, wanted));
}

/// The two parts of a pair.
std::pair<py::object, py::object> parts(py::handle source, const char* wanted) {
  if (!PySequence_Check(source.ptr()) || PySequence_Size(source.ptr()) != 2) {
    PyErr_Clear();
    refuse(source, wanted);
  }
  return {py::reinterpret_steal<py::object>(PySequence_GetItem(source.ptr(), 0)),
          py::reinterpret_steal<py::object>(PySequence_GetItem(source.ptr(), 1))};
}

int whole(py::handle number, py::handle source, const char* wanted) {
  const auto index = py::reinterpret_steal<py::object>(PyNumber_Index(number.ptr()));
  int overflow = 0;
  const long value = index ? PyLong_AsLongAndOverflow(index.ptr(), &overflow) : 0;
  if (!index) {
    PyErr_Clear();
    refuse(source, wanted);
  }
  using Limits = std::numeric_limits<int>;
  if (overflow != 0 || value < Limits::min() || value > Limits::max())
    throw py::value_error(py::str("{!r} is no cell of any map").format(source));
  return static_cast<int>(value);
}

double real(py::handle number, py::handle source, const char* wanted) {
  const double value = PyFloat_AsDouble(number.ptr());
  if (value == -1 && PyErr_Occurred() != nullptr) {
    PyErr_Clear();
    refuse(source, wanted);
  }
  return value;
}

template <class Pair, class Row, class Make>
std::vector<Pair> pairs_from(const Row& rows, const char* name, const Make& make) {
  const py::ssize_t count = row_count(rows, 2, name);
  std::vector<Pair> pairs;
  pairs.reserve(static_cast<std::size_t>(count));
  const auto* numbers = rows.data();
  for (py::ssize_t i = 0; i < count; ++i) pairs.push_back(make(numbers[2 * i], numbers[2 * i + 1]));
  return pairs;
}

}  // namespace

Cell cell_from(py::handle source) {
  constexpr const char* kWanted = "cell: give two integers, (x, y)";
  const auto [x, y] = parts(source, kWanted);
  return {whole(x, source, kWanted), whole(y, source, kWanted)};
}

Point point_from(py::handle source) {
  constexpr const char* kWanted = "point: give two numbers, (x, y)";
  const auto [x, y] = parts(source, kWanted);
  return {real(x, source, kWanted), real(y, source, kWanted)};
}

py::ssize_t row_count(const py::array& rows, int columns, const char* name) {
  if (rows.size() == 0) return 0;
  if (rows.ndim() == 2 && rows.shape(1) == columns) return rows.shape(0);
  throw py::value_error(py::str("{} has the shape {}: give (n, {})")
                            .format(name, py::object(rows.attr("shape")), columns));
}

std::vector<Cell> cells_from(const IntRows& rows, const char* name) {
  return pairs_from<Cell>(rows, name, [](int x, int y) { return Cell{x, y}; });
}

std::vector<Point> points_from(const Rows& rows, const char* name) {
  return pairs_from<Point>(rows, name, [](double x, double y) { return Point{x, y}; });
}

py::array_t<double> to_array(std::span<const Point> points) {
  return py::array_t<double>({static_cast<py::ssize_t>(points.size()), py::ssize_t{2}},
                             reinterpret_cast<const double*>(points.data()));
}

py::array_t<std::int32_t> to_array(std::span<const Cell> cells) {
  return py::array_t<std::int32_t>({static_cast<py::ssize_t>(cells.size()), py::ssize_t{2}},
                                   reinterpret_cast<const std::int32_t*>(cells.data()));
}

}  // namespace lasius::python
