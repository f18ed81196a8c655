#include "tools/draw/map_panel.h"

#include <algorithm>

#include "tools/draw/colours.h"

namespace lasius::tool {

Axes draw_map(Canvas& canvas, const Box& box, const Grid& grid, Cell start, Cell goal) {
  const auto share =
      blocked_share(grid, whole(grid), std::min(grid.width(), static_cast<int>(box.width)),
                    std::min(grid.height(), static_cast<int>(box.height)));
  Raster<Colour> pixels(share.width, share.height);
  std::ranges::transform(share.values, pixels.values.begin(), [](float blocked) {
    return blend({1, 1, 1}, kWall, blocked);
  });
  canvas.image(pixels, box);
  const Axes axes{.box = box,
                  .x = {0, 1.0 * grid.width()},
                  .y = {1.0 * grid.height(), 0},
                  .whole_x = true,
                  .whole_y = true};
  draw_axes(canvas, axes, "x, cells", "y, cells", false);
  const double radius = std::clamp(box.width / grid.width() / 2, 6.0, 12.0);
  canvas.ring(axes.at(start.x + 0.5, start.y + 0.5), radius, kStart);
  canvas.diamond(axes.at(goal.x + 0.5, goal.y + 0.5), radius + 2, kGoal);
  return axes;
}

std::vector<Key> map_keys() { return {start_key(), goal_key(), area_key("blocked", kWall)}; }

void save(const Page& page, const std::filesystem::path& file) {
  for (const char* ending : {".svg", ".png"}) write_page(file.string() + ending, page);
}

void save(const std::vector<LineChart>& charts, const std::filesystem::path& file) {
  std::vector<Panel> panels;
  for (const LineChart& chart : charts)
    panels.push_back({"", [&](Canvas& canvas, const Box& box) { draw(canvas, box, chart); }, true});
  save(Page{.title = "",
            .cells = false,
            .bands = {{.rows = {panels}, .columns = static_cast<int>(panels.size())}}},
       file);
}

}  // namespace lasius::tool
