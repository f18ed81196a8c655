// Cells of a map on the pixels of a picture: large maps shrink without losing thin walls.
#pragma once

#include <vector>

#include "lasius/grid/grid.h"

namespace lasius::tool {

/// One value a pixel, row-major.
template <class T>
struct Raster {
  int width = 0;
  int height = 0;
  std::vector<T> values;

  Raster() = default;
  Raster(int w, int h, T fill = {})
      : width(w),
        height(h),
        values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), fill) {}
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
  T& at(int x, int y) { return values[index(x, y)]; }
  const T& at(int x, int y) const { return values[index(x, y)]; }
};

/// Half-open range of cells.
struct Span {
  int from = 0;
  int to = 0;
};

/// The value of a raster of so many cells a pixel that `better` prefers over some cells, never NaN.
template <class T, class Better>
T chosen(const Raster<T>& raster, int cells_a_pixel, Span columns, Span rows,
         const Better& better) {
  T result = raster.at(columns.from / cells_a_pixel, rows.from / cells_a_pixel);
  for (int y = rows.from / cells_a_pixel; y <= (rows.to - 1) / cells_a_pixel; ++y)
    for (int x = columns.from / cells_a_pixel; x <= (columns.to - 1) / cells_a_pixel; ++x) {
      const T value = raster.at(x, y);
      if (value == value && (result != result || better(value, result))) result = value;
    }
  return result;
}

/// The cells of `shown` under pixel `pixel` of `pixels`: at least one.
Span cells_under(int pixel, int pixels, const Span& shown);

/// Cells of a map that are shown.
struct Window {
  Span columns, rows;

  int width() const { return columns.to - columns.from; }
  int height() const { return rows.to - rows.from; }
};
Window whole(const Grid& grid);

/// Share of blocked cells among some, at least one, in [0, 1]; and under each pixel.
float blocked_share(const Grid& grid, Span columns, Span rows);
Raster<float> blocked_share(const Grid& grid, const Window& window, int width, int height);

struct Colour {
  double red, green, blue;
  friend bool operator==(const Colour&, const Colour&) = default;
};

/// `from` at 0, `to` at 1.
Colour blend(Colour from, Colour to, double share);

}  // namespace lasius::tool
