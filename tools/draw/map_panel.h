// Maps on the pages of a study.
#pragma once

#include <filesystem>

#include "lasius/grid.h"
#include "tools/draw/canvas.h"

namespace lasius::study {

/// The walls of a map, framed, over the whole box.
void paint_walls(tool::Canvas& canvas, const tool::Box& box, const Grid& grid);

/// Start and goal, `scale` pixels a cell.
void mark_ends(tool::Canvas& canvas, const tool::Box& box, double scale, Cell start, Cell goal);

/// Writes FILE.svg and FILE.png.
void save(const tool::Canvas& canvas, const std::filesystem::path& file);

}  // namespace lasius::study
