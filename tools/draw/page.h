// A page of panels in bands, each panel with its letter and caption below.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/draw/legend.h"

namespace lasius::tool {

/// No side of a picture of a map is longer, in pixels, unless its captions take many lines.
inline constexpr int kMostSide = 2000;

struct Panel {
  std::string caption;
  /// Of a map: onto the box, its axes around it. Of a chart: within the box.
  std::function<void(Canvas&, const Box&)> draw;
  bool chart = false;
  double below = 0;  ///< pixels that it takes below its axes
};

/// Rows of equally many panels; those at the same place of each row stay above each other.
struct Band {
  std::vector<std::vector<Panel>> rows;
  bool small = false;
  int columns = 0;  ///< 0: as many as show the maps large
};

struct Page {
  std::string title;
  std::string note = {};  ///< below the title
  std::vector<Key> legend = {};
  double wide = 1, high = 1;     ///< what each map panel shows, in cells or the world's units
  bool cells = true;             ///< cells are whole pixels where that makes no panel much smaller
  std::vector<Band> bands = {};  ///< one or two
};

/// Arranges the bands so that the maps are shown large, and writes the page by the file's ending.
/// @throws Error(output_failed).
void write_page(const std::string& file, const Page& page);

}  // namespace lasius::tool
