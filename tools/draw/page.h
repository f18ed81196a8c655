// A page of panels, each with its letter and caption below.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/draw/canvas.h"

namespace lasius::tool {

/// No side of a picture of a map is longer, in pixels.
inline constexpr int kMostSide = 2000;

struct Panel {
  std::string caption;
  std::function<void(Canvas&, const Box&)> draw;
  bool chart = false;  ///< fills its place; the others keep the map's shape
};

/// How panels are arranged; sides in pixels.
struct Layout {
  int columns = 1;
  double map_width = 0, map_height = 0;
  double place_width = 0, place_height = 0;  ///< of a panel, as large as the map at least
};

/// The arrangement that shows a map of so many cells largest.
Layout map_layout(int panels, int cells_wide, int cells_high);

/// Writes the page by the file's ending. @throws Error(output_failed).
void write_page(const std::string& file, const std::string& title, const Layout& layout,
                const std::vector<Panel>& panels);

}  // namespace lasius::tool
