// The axes of charts, and curves over them.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "tools/draw/canvas.h"

namespace lasius::tool {

inline constexpr double kLabelSize = 14;  ///< of the text at marks and curves

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

/// Two axes around a box.
struct Axes {
  Box box;                   ///< without labels
  Range x, y;                ///< of a map or a view either may fall: low is left, and below
  bool logarithmic = false;  ///< y, for values of which some are many times others

  Point at(double px, double py) const;
  bool shows(double py) const { return py >= y.low && py <= y.high; }
};

/// Lines at about `count` round values of y, their labels to the left.
void draw_rows(Canvas& canvas, const Axes& axes, int count);

/// Marks at about `count` round values of x, and what x is. An empty label: marks alone.
/// `whole`: at whole numbers only.
void draw_columns(Canvas& canvas, const Axes& axes, int count, const std::string& label,
                  bool whole);

/// Frame, marks and names around a map or a view; they need kPlaneLeft to its left and
/// kPlaneBottom below. `whole`: marks at whole numbers only.
void draw_plane_axes(Canvas& canvas, const Axes& axes, const std::string& across,
                     const std::string& up, bool whole = false);
inline constexpr double kPlaneLeft = 58, kPlaneBottom = 38;

/// What y is, turned, `left` of the box.
void draw_side_label(Canvas& canvas, const Box& box, double left, const std::string& label);

/// The stretches of a curve that the axes show; as stairs a value holds until the next.
void draw_curve(Canvas& canvas, const Axes& axes, const std::vector<double>& x,
                const std::vector<double>& y, bool stairs, Colour colour, double width);

}  // namespace lasius::tool
