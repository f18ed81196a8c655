#include "tools/draw/map_panel.h"

#include <algorithm>

#include "tools/draw/colours.h"

namespace lasius::study {
namespace {

constexpr tool::Colour kWall{0.42, 0.45, 0.49};

}  // namespace

tool::Axes draw_map(tool::Canvas& canvas, const tool::Box& box, const Grid& grid, Cell start,
                    Cell goal) {
  const auto share = tool::blocked_share(grid, tool::whole(grid),
                                         std::min(grid.width(), static_cast<int>(box.width)),
                                         std::min(grid.height(), static_cast<int>(box.height)));
  tool::Raster<tool::Colour> pixels(share.width, share.height);
  std::ranges::transform(share.values, pixels.values.begin(), [](float blocked) {
    return tool::blend({1, 1, 1}, kWall, blocked);
  });
  canvas.image(pixels, box);
  const tool::Axes axes{.box = box,
                        .x = {0, 1.0 * grid.width()},
                        .y = {1.0 * grid.height(), 0},
                        .whole_x = true,
                        .whole_y = true};
  draw_axes(canvas, axes, "x, cells", "y, cells", false);
  const double radius = std::clamp(box.width / grid.width() / 2, 6.0, 12.0);
  canvas.ring(axes.at(start.x + 0.5, start.y + 0.5), radius, tool::kStart);
  canvas.diamond(axes.at(goal.x + 0.5, goal.y + 0.5), radius + 2, tool::kGoal);
  return axes;
}

std::vector<tool::Key> map_keys() {
  return {tool::start_key(), tool::goal_key(), tool::area_key("blocked", kWall)};
}

void save(const tool::Page& page, const std::filesystem::path& file) {
  for (const char* ending : {".svg", ".png"}) write_page(file.string() + ending, page);
}

void save(const std::vector<LineChart>& charts, const std::filesystem::path& file) {
  std::vector<tool::Panel> panels;
  for (const LineChart& chart : charts)
    panels.push_back(
        {"", [&](tool::Canvas& canvas, const tool::Box& box) { draw(canvas, box, chart); }, true});
  save(tool::Page{.title = "",
                  .cells = false,
                  .bands = {{.rows = {panels}, .columns = static_cast<int>(panels.size())}}},
       file);
}

}  // namespace lasius::study
