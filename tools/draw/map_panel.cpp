#include "tools/draw/map_panel.h"

#include <algorithm>

#include "tools/draw/axes.h"

namespace lasius::study {

void paint_walls(Canvas& canvas, const Box& box, const Grid& grid) {
  const int width = std::min(grid.width(), static_cast<int>(box.width));
  const int height = std::min(grid.height(), static_cast<int>(box.height));
  const auto share = tool::blocked_share(grid, tool::whole(grid), width, height);
  tool::Raster<Colour> pixels(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      pixels.at(x, y) = tool::blend({1, 1, 1}, kMapWall, share.at(x, y));
  canvas.image(pixels, box);
  tool::draw_axes(canvas,
                  {.box = box,
                   .x = {0, 1.0 * grid.width()},
                   .y = {1.0 * grid.height(), 0},
                   .whole_x = true,
                   .whole_y = true},
                  "x, cells", "y, cells", false);
}

void mark_ends(Canvas& canvas, const Box& box, double scale, Cell start, Cell goal) {
  const double radius = std::clamp(scale / 2, 6.0, 12.0);
  const auto page = [&](Cell c) {
    return Point{box.x + (c.x + 0.5) * scale, box.y + (c.y + 0.5) * scale};
  };
  canvas.ring(page(start), radius, tool::kStart);
  canvas.diamond(page(goal), radius + 2, tool::kGoal);
}

void save(const Canvas& canvas, const std::filesystem::path& file) {
  canvas.save(file.string() + ".svg");
  canvas.save(file.string() + ".png");
}

}  // namespace lasius::study
