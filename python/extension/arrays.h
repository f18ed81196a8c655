// What crosses the border to Python as plain values: cells and points as tuples (x, y), lists of
// them as numpy arrays.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstdint>
#include <span>
#include <vector>

#include "lasius/grid/geometry.h"

namespace lasius::python {

namespace py = pybind11;

/// Two integers, (x, y): a tuple, a list, an array. @throws py::type_error for anything else,
/// numbers with a fraction included.
Cell cell_from(py::handle source);
/// Two numbers, likewise.
Point point_from(py::handle source);

/// Rows of integers, as a function takes them: converted only where nothing is lost.
using IntRows = py::array_t<std::int32_t, py::array::c_style>;
/// Rows of numbers; anything that numpy makes an array of numbers of.
using Rows = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// @throws py::value_error unless `rows` has the shape (n, columns), or is empty; returns n.
py::ssize_t row_count(const py::array& rows, int columns, const char* name);

/// Rows (x, y) as cells or points. @throws py::value_error for another shape.
std::vector<Cell> cells_from(const IntRows& rows, const char* name);
std::vector<Point> points_from(const Rows& rows, const char* name);

/// Points as an array of shape (n, 2), copied; so are cells and numbers.
py::array_t<double> to_array(std::span<const Point> points);
py::array_t<std::int32_t> to_array(std::span<const Cell> cells);
template <class Number>
py::array_t<Number> to_array(const std::vector<Number>& numbers) {
  return py::array_t<Number>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

/// The text of a `to_string`.
inline py::str text(std::string_view name) { return py::str(name.data(), name.size()); }

/// A file's name, or a sentence with one: bytes that are no UTF-8 as os.fsdecode has them.
inline py::object words(std::string_view name) {
  return py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(name.data(), static_cast<py::ssize_t>(name.size()), "surrogateescape"));
}

}  // namespace lasius::python

namespace pybind11::detail {

template <>
struct type_caster<lasius::Cell> {
  PYBIND11_TYPE_CASTER(lasius::Cell, const_name("tuple[int, int]"));
  bool load(handle source, bool) {
    value = lasius::python::cell_from(source);
    return true;
  }
  static handle cast(lasius::Cell c, return_value_policy, handle) {
    return make_tuple(c.x, c.y).release();
  }
};

template <>
struct type_caster<lasius::Point> {
  PYBIND11_TYPE_CASTER(lasius::Point, const_name("tuple[float, float]"));
  bool load(handle source, bool) {
    value = lasius::python::point_from(source);
    return true;
  }
  static handle cast(lasius::Point p, return_value_policy, handle) {
    return make_tuple(p.x, p.y).release();
  }
};

}  // namespace pybind11::detail
