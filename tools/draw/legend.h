// Words that are never cut, and the legend of a picture.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/draw/axes.h"

namespace lasius::tool {

/// The text in lines of at most `width` pixels; a word that is wider is broken.
std::vector<std::string> wrapped(Canvas& canvas, const std::string& text, double size, double width,
                                 bool bold = false);

/// Writes the text in lines around or from `top`, its upper edge. Returns its height in pixels.
double draw_wrapped(Canvas& canvas, Point top, const std::string& text, double size, double width,
                    Align align, bool bold = false);

/// A symbol with what it stands for.
struct Key {
  std::string label;
  std::function<void(Canvas&, Point left)> symbol;  ///< `left`: middle of its left edge
  double width = 26;                                ///< of the symbol, pixels
};
Key line_key(const std::string& label, Colour colour, double width);
Key dashed_key(const std::string& label, Colour colour);
Key area_key(const std::string& label, Colour colour);
Key start_key();
Key goal_key();

/// Keys beside and under each other, no wider than the width given.
class Legend {
 public:
  Legend(Canvas& canvas, std::vector<Key> keys, double width);
  double height() const { return height_; }
  void draw(Canvas& canvas, Point top_left) const;

 private:
  struct Entry {
    Key key;
    Point at;  ///< upper left corner
    std::vector<std::string> lines;
  };
  std::vector<Entry> entries_;
  double height_ = 0;
};

/// Values as colours; a range of one value has the first.
struct ColourScale {
  Range range;
  bool logarithmic = false;
  std::function<Colour(double share)> colour;  ///< share in [0, 1]

  double share(double value) const;  ///< in [0, 1]: values outside of the range are as its ends
  Colour at(double value) const { return colour(share(value)); }
};
/// The scale between its ends, as a key; whole numbers.
Key scale_key(Canvas& canvas, const std::string& label, const ColourScale& scale);
/// The scale with marks, kBarHeight pixels high, below a map and its axes.
void draw_bar(Canvas& canvas, const Box& map, const ColourScale& scale);
inline constexpr double kBarHeight = 34;

}  // namespace lasius::tool
