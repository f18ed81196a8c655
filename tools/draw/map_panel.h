// What the pages of a study show.
#pragma once

#include <filesystem>

#include "lasius/grid/grid.h"
#include "tools/draw/line_chart.h"
#include "tools/draw/page.h"

namespace lasius::tool {

/// Walls, start and goal of a map over the whole box, and axes around it, which are returned: what
/// is drawn by them comes above.
Axes draw_map(Canvas& canvas, const Box& box, const Grid& grid, Cell start, Cell goal);
/// What stands for these.
std::vector<Key> map_keys();

/// Writes FILE.svg and FILE.png.
void save(const Page& page, const std::filesystem::path& file);
/// The same, of charts side by side.
void save(const std::vector<LineChart>& charts, const std::filesystem::path& file);

}  // namespace lasius::tool
