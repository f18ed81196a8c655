#include "tools/bitmap/sheet.h"

#include <algorithm>
#include <cmath>

#include "tools/console/values.h"
#include "tools/draw/axes.h"
#include "tools/draw/colours.h"
#include "tools/draw/text.h"

namespace lasius::tool {
namespace {

constexpr double kSweptOpacity = 0.16;

}  // namespace

Window shown_of(const LoadedMap& map, const std::vector<Cell>& ends) {
  const Grid& grid = map.grid();
  Window free{{grid.width(), 0}, {grid.height(), 0}};
  const auto take = [&](int x, int y) {
    free.columns = {std::min(free.columns.from, x), std::max(free.columns.to, x + 1)};
    free.rows = {std::min(free.rows.from, y), std::max(free.rows.to, y + 1)};
  };
  for (const Cell c : ends)
    if (grid.contains(c)) take(c.x, c.y);
  for (int y = 0; y < grid.height(); ++y)
    for (int x = 0; x < grid.width(); ++x)
      if (grid.free({x, y})) take(x, y);
  const Window all = whole(grid);
  if (free.width() <= 0) return all;
  const int room = static_cast<int>(std::ceil(map.radius)) +
                   std::max(3, std::max(free.width(), free.height()) / 50);
  const auto with_room = [room](const Span& side, int cells) {
    return Span{std::max(0, side.from - room), std::min(cells, side.to + room)};
  };
  const Window window{with_room(free.columns, grid.width()), with_room(free.rows, grid.height())};
  const double share = 1.0 * window.width() * window.height() / all.width() / all.height();
  return share <= 0.9 ? window : all;
}

Axes Sheet::axes(const Box& box) const {
  return {.box = box,
          .x = {1.0 * window.columns.from, 1.0 * window.columns.to},
          .y = {1.0 * window.rows.to, 1.0 * window.rows.from},
          .whole_x = true,
          .whole_y = true};
}

std::string Sheet::length(double cells, int decimals) const {
  // A line does not end between number and unit.
  return fixed(map.length_in(run.frame, cells), decimals) + "\u00a0" + unit();
}

void Sheet::frame(Canvas& canvas, const Box& box) const {
  const bool world = metres() && map.frame->yaw == 0;
  Axes axes = this->axes(box);
  axes.whole_x = axes.whole_y = !world;
  if (world) {
    const Point low = map.to_world({axes.x.low, axes.y.low});
    const Point high = map.to_world({axes.x.high, axes.y.high});
    axes.x = {low.x, high.x};
    axes.y = {low.y, high.y};
  }
  draw_axes(canvas, axes, world ? "x, m" : "x, cells", world ? "y, m" : "y, cells", false);
}

std::string Sheet::note() const {
  const Window all = whole(grid);
  const double left = 1 - 1.0 * window.width() * window.height() / all.width() / all.height();
  if (left <= 0) return {};
  const auto span = [](const Span& side) {
    return std::to_string(side.from) + " to " + std::to_string(side.to - 1);
  };
  return "cropped to columns " + span(window.columns) + ", rows " + span(window.rows) +
         ": the rest, " + fixed(100 * left, 0) + "% of the map, has no free cell" +
         (map.frame && !map.unknown_is_free ? " (unknown or blocked)" : "");
}

Page Sheet::page(std::string title) const {
  Page page{.title = std::move(title),
            .note = note(),
            .legend = {start_key(), goal_key(), area_key("blocked", kWall)},
            .wide = 1.0 * window.width(),
            .high = 1.0 * window.height()};
  if (unknown != nullptr && unknown->count_free() < std::int64_t{1} * map.width * map.height)
    page.legend.push_back(
        area_key(map.unknown_is_free ? "unknown, counted as free" : "unknown, counted as blocked",
                 kUnknownCell));
  if (map.grown())
    page.legend.push_back(
        area_key("no place for the centre: nearer than " + length(map.radius), kGrown));
  return page;
}

std::string map_title(const LoadedMap& map, const RunOptions& run) {
  return map_title(map, run, run.params.algorithm());
}

std::string map_title(const LoadedMap& map, const RunOptions& run, std::string_view algorithm) {
  return std::string(algorithm) + " on " + file_name(map.file) + ", " + std::to_string(map.width) +
         " x " + std::to_string(map.height) + " cells, seed " + std::to_string(run.params.seed);
}

double wall_strength(double blocked) {
  return blocked > 0 ? std::max(0.35, std::sqrt(blocked)) : 0;
}

void paint_map(Canvas& canvas, const Box& box, const Sheet& sheet,
               const std::function<Colour(Span columns, Span rows)>& ground) {
  const Window& window = sheet.window;
  // One pixel a cell, or one a pixel of the page where cells are smaller.
  const auto share =
      blocked_share(sheet.grid, window, std::min(window.width(), static_cast<int>(box.width)),
                    std::min(window.height(), static_cast<int>(box.height)));
  const bool grown = sheet.map.grown();
  const auto inner =
      grown ? blocked_share(sheet.map.as_read(), window, share.width, share.height) : share;
  const auto unknown = sheet.unknown != nullptr
                           ? blocked_share(*sheet.unknown, window, share.width, share.height)
                           : Raster<float>(share.width, share.height);
  const bool hides = sheet.unknown != nullptr && !sheet.map.unknown_is_free;
  Raster<Colour> pixels(share.width, share.height);
  for (int y = 0; y < share.height; ++y) {
    const Span rows = cells_under(y, share.height, window.rows);
    for (int x = 0; x < share.width; ++x) {
      const Span columns = cells_under(x, share.width, window.columns);
      const double unknown_here = wall_strength(unknown.at(x, y));
      Colour colour = ground(columns, rows);
      if (!hides && colour == kFree) colour = blend(colour, kUnknownCell, unknown_here);
      if (grown) colour = blend(colour, kGrown, wall_strength(share.at(x, y)));
      if (hides) colour = blend(colour, kUnknownCell, unknown_here);
      const float obstacles = inner.at(x, y) - (hides ? unknown.at(x, y) : 0);
      pixels.at(x, y) = blend(colour, kWall, wall_strength(obstacles));
    }
  }
  canvas.image(pixels, box);
  sheet.frame(canvas, box);
}

void draw_marks(Canvas& canvas, const Box& box, const Sheet& sheet, Point start, Point goal,
                bool small) {
  const double cell = box.width / sheet.window.width();
  const double radius =
      small ? std::clamp(0.6 * cell, 6.0, 9.0) : std::clamp(0.6 * cell, 8.0, 18.0);
  const Axes axes = sheet.axes(box);
  const auto shown = [&](Point p) {
    return p.x >= 0 && p.y >= 0 && p.x <= sheet.grid.width() && p.y <= sheet.grid.height();
  };
  if (shown(goal)) canvas.diamond(axes.at(goal.x, goal.y), radius + 3, kGoal);
  if (shown(start)) canvas.ring(axes.at(start.x, start.y), radius, kStart);
}

std::vector<CurvePiece> Sheet::on_page(const Box& box, const Result& result) const {
  std::vector<CurvePiece> curve = result.curve;
  for (std::size_t i = 1; result.curve.empty() && i < result.path.size(); ++i)
    curve.push_back({.from = result.path[i - 1], .to = result.path[i]});
  const Axes axes = this->axes(box);
  for (CurvePiece& piece : curve) {
    for (Point* p : {&piece.from, &piece.to, &piece.centre}) *p = axes.at(p->x, p->y);
    piece.radius *= box.width / window.width();
  }
  return curve;
}

void draw_plan(Canvas& canvas, const Box& box, const Sheet& sheet, const Answer& answer) {
  const Result& result = answer.result;
  const auto curve = sheet.on_page(box, result);
  if (sheet.map.grown()) {
    canvas.clip(box);
    const double diameter = 2 * sheet.map.radius * box.width / sheet.window.width();
    canvas.curve(curve, kPath, diameter, kSweptOpacity);
    canvas.unclip();
  }
  for (const Alternative& other : result.alternatives)
    canvas.polyline(sheet.axes(box).at(other.path), kOtherPath, 2);
  draw_marks(canvas, box, sheet, answer.start.at(), answer.goal.at(), false);
  canvas.curve(curve, {1, 1, 1}, 5, 1);
  canvas.curve(curve, kPath, 3, 1);
  const Axes axes = sheet.axes(box);
  const auto dot = [&](const std::optional<Point>& at, Colour colour) {
    if (at) canvas.disc(axes.at(at->x, at->y), 6, colour);
  };
  dot(result.way_out, kStart);
  dot(short_end(answer), kGoal);
}

std::vector<Key> keys_of_plan(const Sheet& sheet, const Answer& answer) {
  if (answer.result.path.empty()) return {};
  std::vector<Key> keys{line_key("path", kPath, 3)};
  if (!answer.result.alternatives.empty()) keys.push_back(line_key("alternatives", kOtherPath, 2));
  if (sheet.map.grown())
    keys.push_back(
        area_key("swept by the robot, a disc of radius " + sheet.length(sheet.map.radius),
                 blend(kFree, kPath, kSweptOpacity)));
  if (answer.result.way_out) keys.push_back(disc_key("way out", kStart));
  if (short_end(answer)) keys.push_back(disc_key("goal reached", kGoal));
  return keys;
}

void draw_path(Canvas& canvas, const Box& box, const Sheet& sheet, const std::vector<Point>& path,
               double width, double rim, Colour colour) {
  const auto points = sheet.axes(box).at(path);
  if (rim > 0) canvas.polyline(points, {1, 1, 1}, width + 2 * rim);
  canvas.polyline(points, colour, width);
}

}  // namespace lasius::tool
