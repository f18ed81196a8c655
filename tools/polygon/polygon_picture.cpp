#include "tools/polygon/polygon_picture.h"

#include <algorithm>

#include "tools/console/values.h"
#include "tools/draw/canvas.h"
#include "tools/draw/colours.h"
#include "tools/draw/line_chart.h"
#include "tools/draw/page.h"
#include "tools/draw/text.h"

namespace lasius::tool {

Axes axes_of(const LoadedWorld& world, const Box& box) {
  const Point low = world.low(), high = world.high();
  return {.box = box, .x = {low.x, high.x}, .y = {low.y, high.y}};
}

namespace {

constexpr Colour kSolid{0.36, 0.39, 0.44};
constexpr Colour kLine{0.26, 0.57, 0.78};
constexpr Colour kMidpoint{0.03, 0.19, 0.42};
constexpr Colour kDijkstra{0.55, 0.3, 0.65};

/// Free space in white on the grown obstacles' grey, the obstacles as drawn in a darker one; the
/// axes around it.
void draw_world(Canvas& canvas, const Axes& axes, const LoadedWorld& world,
                std::vector<polygon::Polygon> pieces) {
  canvas.fill(axes.box, kPaleWall);
  // One within a hole of another begins to the right of it.
  const auto left = [](const auto& piece) {
    return std::ranges::min(piece.outer, {}, &Point::x).x;
  };
  std::ranges::stable_sort(pieces, {}, left);
  for (const auto& piece : pieces) {
    canvas.area(axes.at(piece.outer), kFree, 1);
    for (const auto& hole : piece.holes) canvas.area(axes.at(hole), kPaleWall, 1);
  }
  canvas.clip(axes.box);
  for (const auto& obstacle : world.planner.world().obstacles)
    if (obstacle.holes.empty()) canvas.area(axes.at(obstacle.outer), kSolid, 1);
  for (const auto& wall : world.planner.world().walls) canvas.polyline(axes.at(wall), kSolid, 2);
  canvas.unclip();
  draw_axes(canvas, axes, "x, the world's units", "y, the world's units", false);
}

void draw_graph(Canvas& canvas, const Axes& axes, const LoadedWorld& world,
                const PolygonAnswer& answer) {
  for (const auto& line : world.planner.maklink().lines) {
    canvas.dashed(axes.at(line.a.x, line.a.y), axes.at(line.b.x, line.b.y), kLine, 1.2);
    const Point midpoint = line.midpoint();
    canvas.disc(axes.at(midpoint.x, midpoint.y), 3, kMidpoint);
  }
  if (answer.result.dijkstra)
    canvas.polyline(axes.at(answer.result.dijkstra->path), kDijkstra, 2.5);
}

std::string path_caption(const PolygonAnswer& answer) {
  const auto& result = answer.result;
  if (result.path.empty()) return no_path_text(result.status);
  std::string text = "path, length " + fixed(result.length, 3);
  if (result.optimal) return text + ", proven shortest";
  const auto compare = [&](const char* name, double optimum) {
    text += against(result.length, optimum, name, fixed(optimum, 3));
  };
  if (answer.result.optimum) compare("optimum", *answer.result.optimum);
  if (result.discrete_optimum)
    compare("optimum of the algorithm's own crossings", result.discrete_optimum->length);
  return text;
}

}  // namespace

Page world_page(const LoadedWorld& world, std::string title) {
  const Point low = world.low(), high = world.high();
  const double margin = world.planner.margin();
  const std::string near = "nearer than " + fixed(margin, 2) + " to that, or outside";
  return {.title = std::move(title),
          .legend = {start_key(), goal_key(), area_key("obstacle", kSolid),
                     area_key(margin > 0 ? near : "outside", kPaleWall)},
          .wide = high.x - low.x,
          .high = high.y - low.y,
          .cells = false};
}

Axes draw_ground(Canvas& canvas, const Box& box, const LoadedWorld& world) {
  const Axes axes = axes_of(world, box);
  draw_world(canvas, axes, world, world.planner.free_space());
  return axes;
}

void draw_ends(Canvas& canvas, const Axes& axes, std::optional<Point> start,
               std::optional<Point> goal) {
  if (goal) canvas.diamond(axes.at(goal->x, goal->y), 11, kGoal);
  if (start) canvas.ring(axes.at(start->x, start->y), 8, kStart);
}

void write_polygon_picture(const std::string& file, const LoadedWorld& world,
                           const PolygonAnswer& answer) {
  const auto& result = answer.result;
  std::vector<Panel> panels;
  // A panel with the world as its ground.
  const auto add = [&](const std::string& caption, const auto& pieces, const auto& draw) {
    panels.push_back({caption, [&world, &answer, &pieces, draw](Canvas& canvas, const Box& box) {
                        const Axes axes = axes_of(world, box);
                        draw_world(canvas, axes, world, pieces);
                        draw_ends(canvas, axes, answer.start, answer.goal);
                        draw(canvas, axes);
                      }});
  };
  Page page = world_page(world, polygon_title(world, answer.parameters));
  if (result.dijkstra) {
    page.legend.push_back(dashed_key("MAKLINK line", kLine));
    page.legend.push_back({"its midpoint",
                           [](Canvas& canvas, Point p) {
                             canvas.disc({p.x + 4, p.y}, 3, kMidpoint);
                           },
                           8});
    page.legend.push_back(line_key("Dijkstra's path over midpoints", kDijkstra, 2.5));
    add("MAKLINK lines, midpoints, Dijkstra's path, length " + fixed(result.dijkstra->length, 3),
        world.planner.maklink().free_space,
        [&](Canvas& canvas, const Axes& axes) { draw_graph(canvas, axes, world, answer); });
  }
  if (!result.path.empty()) page.legend.push_back(line_key("path", kPath, 3));
  add(path_caption(answer), world.planner.free_space(),
      [&](Canvas& canvas, const Axes& axes) { canvas.polyline(axes.at(result.path), kPath, 3); });
  if (!result.curves.best.empty())
    panels.push_back(
        {"convergence: best path so far; paths by iteration",
         [&](Canvas& canvas, const Box& box) {
           const bool genetic = polygon::find_algorithm(answer.parameters.algorithm()).kind ==
                                Algorithm::Kind::genetic;
           Convergence convergence{
               .best = {"best path so far", result.curves.best},
               .tours = {{genetic ? "mean of the population" : "mean tour of the ants",
                          result.curves.mean}},
               .unit = "the world's units"};
           if (answer.result.optimum)
             convergence.levels.push_back(
                 {"optimum " + fixed(*answer.result.optimum, 3), *answer.result.optimum});
           if (result.discrete_optimum)
             convergence.levels.push_back(
                 {"optimum of its own crossings " + fixed(result.discrete_optimum->length, 3),
                  result.discrete_optimum->length,
                  {0.55, 0.25, 0.6}});
           draw_convergence(canvas, box, convergence);
         },
         true});
  page.bands.push_back({{std::move(panels)}});
  write_page(file, page);
}

void write_paths_picture(const std::string& file, const LoadedWorld& world,
                         const std::vector<std::vector<Point>>& paths, const std::string& caption) {
  Page page = world_page(world, "batch on " + file_name(world.options.file));
  page.legend.push_back(line_key("path", kPath, 1.5));
  page.bands = {{{{{caption, [&](Canvas& canvas, const Box& box) {
                      const Axes axes = draw_ground(canvas, box, world);
                      for (const auto& path : paths)
                        draw_ends(canvas, axes, path.front(), path.back());
                      for (const auto& path : paths) canvas.polyline(axes.at(path), kPath, 1.5);
                    }}}}}};
  write_page(file, page);
}

}  // namespace lasius::tool
