// Maps on the pages of a study.
#pragma once

#include <filesystem>

#include "lasius/grid.h"
#include "tools/draw/canvas.h"
#include "tools/draw/colours.h"

namespace lasius::study {

using tool::Align;
using tool::Box;
using tool::Canvas;
using tool::Colour;
using tool::kInk;

inline constexpr Colour kMapWall{0.42, 0.45, 0.49};

/// The walls of a map over the whole box, and axes around it: they take tool::kAxisLeft and
/// tool::kAxisBottom.
void paint_walls(Canvas& canvas, const Box& box, const Grid& grid);

/// Start and goal, `scale` pixels a cell.
void mark_ends(Canvas& canvas, const Box& box, double scale, Cell start, Cell goal);

/// Writes FILE.svg and FILE.png.
void save(const Canvas& canvas, const std::filesystem::path& file);

}  // namespace lasius::study
