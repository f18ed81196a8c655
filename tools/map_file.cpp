#include "map_file.h"

#include <algorithm>
#include <cmath>

#include "elapsed.h"
#include "exit_code.h"
#include "lasius/clearance.h"
#include "lasius/io.h"

namespace lasius::tool {
namespace {

int clamped(double coordinate) {
  constexpr double kFar = 1e9;
  return static_cast<int>(std::floor(std::clamp(coordinate, -kFar, kFar)));
}

}  // namespace

PreparedMap prepare_map(const MapOptions& options, Frame frame, const std::stop_token& token) {
  const auto start = Clock::now();
  Map map = read_any_map(options.file, {.unknown_is_free = options.unknown_is_free});
  if (frame == Frame::world && !map.frame)
    throw UsageError("--frame world: " + options.file +
                     " gives no frame; name the .yaml file of a ROS map, or use --frame cell");
  const auto hash = map.grid.hash();
  const int width = map.grid.width(), height = map.grid.height();
  const double radius =
      options.radius_metres ? options.radius / map.frame->resolution : options.radius;
  if (radius > 0) map.grid = grow_obstacles(map.grid, radius);
  const double read_ms = ms_since(start);
  const auto prepare_start = Clock::now();
  const PrepareOptions more{.threads = options.threads, .stop = {.token = token}};
  Planner planner =
      options.prepare ? Planner(std::move(map.grid), more) : Planner(std::move(map.grid));
  return {.file = options.file,
          .hash = hash,
          .width = width,
          .height = height,
          .frame = map.frame,
          .unknown_is_free = options.unknown_is_free,
          .radius = radius,
          .prepare = options.prepare,
          .planner = std::move(planner),
          .read_ms = read_ms,
          .prepare_ms = ms_since(prepare_start)};
}

std::vector<Point> PreparedMap::to_world(const std::vector<Point>& path) const {
  std::vector<Point> metres;
  metres.reserve(path.size());
  for (const Point p : path) metres.push_back(to_world(p));
  return metres;
}

Cell to_cell(const PreparedMap& map, Point point, Frame frame) {
  const Point cells = frame == Frame::world ? map.frame->to_cells(point, map.height) : point;
  return {clamped(cells.x), clamped(cells.y)};
}

}  // namespace lasius::tool
