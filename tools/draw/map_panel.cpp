#include "tools/draw/map_panel.h"

#include <algorithm>

namespace lasius::study {

void paint_walls(Canvas& canvas, const Box& box, const Grid& grid) {
  constexpr Colour kWall{0.42, 0.45, 0.49};
  const int width = std::min(grid.width(), static_cast<int>(box.width));
  const int height = std::min(grid.height(), static_cast<int>(box.height));
  const auto share = tool::blocked_share(grid, width, height);
  tool::Raster<Colour> pixels(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) pixels.at(x, y) = tool::blend({1, 1, 1}, kWall, share.at(x, y));
  canvas.image(pixels, box);
  canvas.frame(box, kInk, 1);
}

void mark_ends(Canvas& canvas, const Box& box, double scale, Cell start, Cell goal) {
  const double radius = std::clamp(scale / 3, 5.0, 9.0);
  const auto page = [&](Cell c) {
    return Point{box.x + (c.x + 0.5) * scale, box.y + (c.y + 0.5) * scale};
  };
  canvas.disc(page(start), radius, tool::kStart);
  canvas.diamond(page(goal), radius + 2, {0.55, 0.1, 0.5});
}

void save(const Canvas& canvas, const std::filesystem::path& file) {
  canvas.save(file.string() + ".svg");
  canvas.save(file.string() + ".png");
}

}  // namespace lasius::study
