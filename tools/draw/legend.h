// Words in lines, and the legend of a picture.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "tools/draw/axes.h"

namespace lasius::tool {

/// Writes the text from `top`, its upper edge, in lines of at most `width` pixels; a word that is
/// wider is broken. Returns its height in pixels.
double draw_wrapped(Canvas& canvas, Point top, const std::string& text, double size, double width,
                    Align align, bool bold = false);

/// Values as colours; a range of one value has the first.
struct ColourScale {
  Range range;
  bool logarithmic = false;
  std::span<const Colour> colours;  ///< at even shares of it, blended between; two or more

  double share(double value) const;  ///< in [0, 1]: values outside of the range are as its ends
  Colour shade(double share) const;
  Colour at(double value) const { return shade(share(value)); }
};
/// The scale with marks, kBarHeight pixels high, below a map and its axes.
void draw_bar(Canvas& canvas, const Box& map, const ColourScale& scale);
inline constexpr double kBarHeight = 42;

/// A symbol with what it stands for.
struct Key {
  std::string label;
  std::function<void(Canvas&, Point left)> symbol;  ///< `left`: middle of its left edge
  double width = 26;                                ///< of the symbol, pixels
};
Key line_key(const std::string& label, Colour colour, double width);
Key dashed_key(const std::string& label, Colour colour);
Key area_key(const std::string& label, Colour colour);
Key disc_key(const std::string& label, Colour colour);
Key start_key(const std::string& label = "start");
Key goal_key(const std::string& label = "goal");
/// The scale between its ends, told as whole numbers.
Key scale_key(const std::string& label, const ColourScale& scale);

/// Keys beside and under each other, no wider than `width`. Returns their height in pixels.
double draw_legend(Canvas& canvas, Point top_left, double width, const std::vector<Key>& keys);

}  // namespace lasius::tool
