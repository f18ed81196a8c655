// Pictures of a plan on a polygon world.
#pragma once

#include <optional>
#include <string>

#include "tools/draw/page.h"
#include "tools/polygon/polygon_answer.h"

namespace lasius::tool {

/// Panels: MAKLINK lines, midpoints and Dijkstra's path; the final path; the convergence. For
/// algorithms without iterations the final path only.
void write_polygon_picture(const std::string& file, const LoadedWorld& world,
                           const PolygonAnswer& answer);

/// A page of a world, its axes, its ground with these, and a start and goal on it.
Page world_page(const LoadedWorld& world, std::string title);
Axes axes_of(const LoadedWorld& world, const Box& box);
Axes draw_ground(Canvas& canvas, const Box& box, const LoadedWorld& world);
void draw_ends(Canvas& canvas, const Axes& axes, std::optional<Point> start,
               std::optional<Point> goal);

/// All paths of a batch.
void write_paths_picture(const std::string& file, const LoadedWorld& world,
                         const std::vector<std::vector<Point>>& paths, const std::string& caption);

}  // namespace lasius::tool
