// The axes of charts, and curves over them.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "tools/draw/canvas.h"

namespace lasius::tool {

inline constexpr double kLabelSize = 14;  ///< of the text of legends

/// What an axis shows.
struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;

  /// Takes in a value where it is finite.
  void add(double value);
  bool empty() const { return !(low <= high); }
};

/// Round numbers that cover [low, high] in about `count` steps, low < high.
std::vector<double> ticks(double low, double high, int count);

/// Round values within a range: on a logarithmic axis 1, 2, 5 times powers of ten.
std::vector<double> axis_marks(const Range& range, bool logarithmic, int count);

/// A number as "0.0025", "40" or "3e-07".
std::string short_number(double value);

/// Where a value lies in a range: 0 at its low end, 1 at its high one.
double share_of(const Range& range, bool logarithmic, double value);

/// Two axes around a box.
struct Axes {
  Box box;                                ///< without labels
  Range x, y;                             ///< of a map either may fall: low is left, and below
  bool logarithmic = false;               ///< y, for values of which some are many times others
  bool whole_x = false, whole_y = false;  ///< marks at whole numbers only

  Point at(double px, double py) const;
  std::vector<Point> at(std::span<const Point> points) const;
  bool shows(double py) const { return py >= y.low && py <= y.high; }
};

/// Frame, marks and names around the box: they need kAxisLeft to its left and kAxisBottom below.
/// `grid`: lines through the box at the marks.
void draw_axes(Canvas& canvas, const Axes& axes, const std::string& across, const std::string& up,
               bool grid);
inline constexpr double kAxisLeft = 64, kAxisBottom = 40;
inline constexpr double kMarkSize = 12.5;  ///< of the text at marks

/// The stretches of a curve that the axes show; as stairs a value holds until the next.
void draw_curve(Canvas& canvas, const Axes& axes, const std::vector<double>& x,
                const std::vector<double>& y, bool stairs, Colour colour, double width);

}  // namespace lasius::tool
