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

/// Two axes around a box.
struct Axes {
  Box box;  ///< without labels
  Range x, y;
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

/// What y is, turned, `left` of the box.
void draw_side_label(Canvas& canvas, const Box& box, double left, const std::string& label);

/// The stretches of a curve that the axes show; as stairs a value holds until the next.
void draw_curve(Canvas& canvas, const Axes& axes, const std::vector<double>& x,
                const std::vector<double>& y, bool stairs, Colour colour, double width);

}  // namespace lasius::tool
