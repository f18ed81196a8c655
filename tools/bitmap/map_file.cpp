#include "tools/bitmap/map_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <utility>

#include "lasius/io.h"
#include "tools/console/elapsed.h"
#include "tools/console/exit_code.h"
#include "tools/console/signals.h"
#include "tools/console/values.h"

namespace lasius::tool {
namespace {

int clamped(double whole) {
  using Limits = std::numeric_limits<int>;
  return static_cast<int>(std::clamp<double>(whole, Limits::min(), Limits::max()));
}

/// A number of metres too large to be told in cells, as a number that can be told.
double finite(double number) {
  return std::isnan(number) ? kNoLimit : std::clamp(number, -kNoLimit, kNoLimit);
}

/// Nothing, and the grid as it was, when stopped.
std::optional<Planner> make_planner(Grid& grid, Disc robot, const MapOptions& options, int threads,
                                    Corners corners, const StopCondition& stop) {
  const PrepareOptions more{.threads = threads, .stop = stop, .labels = options.labels};
  const bool at_once = options.prepare && options.prepared.empty();
  auto planner = at_once ? Planner::make_prepared(std::move(grid), more, robot)
                         : Planner::make(std::move(grid), robot, stop);
  // Should this be stopped, the plan is at once.
  if (planner) planner->label(corners, stop);
  return planner;
}

}  // namespace

LoadedMap read_map(const MapOptions& options, Frame frame) {
  const auto start = Clock::now();
  Map read = read_any_map(options.file, {.unknown_is_free = options.unknown_is_free});
  if (frame == Frame::world && !read.frame)
    throw UsageError("--frame world: " + options.file +
                     " gives no frame; name the .yaml file of a ROS map, or use --frame cell");
  const double radius =
      options.radius_metres ? options.radius / read.frame->resolution : options.radius;
  if (!std::isfinite(radius))
    throw UsageError("--radius " + to_text(options.radius) + " is too many cells");
  LoadedMap map{.file = options.file,
                .image = read.image,
                .hash = read.grid.hash(),
                .width = read.grid.width(),
                .height = read.grid.height(),
                .frame = read.frame,
                .unknown_is_free = options.unknown_is_free,
                .radius = radius,
                .prepare = options.prepare,
                .labels = options.labels,
                .prepared = options.prepared,
                .grid_alone = std::move(read.grid),
                .unknown = std::move(read.unknown)};
  map.read_ms = ms_since(start);
  return map;
}

LoadedMap load_map(const MapOptions& options, Frame frame, Corners corners, int threads,
                   const std::stop_token& token) {
  LoadedMap map = read_map(options, frame);
  const StopCondition stop{.token = token};
  const auto start = Clock::now();
  if (options.costs.asked())
    map.costs =
        load_costs(*map.grid_alone, map.frame, options.costs, options.radius_metres, map.radius);
  map.planner = make_planner(*map.grid_alone, {map.radius}, options, threads, corners, stop);
  if (map.planner) map.grid_alone.reset();
  if (map.planner && options.prepare && !options.prepared.empty()) prepare(map, threads, token);
  if (map.planner && map.costs) map.costs->planner.emplace(*map.planner, map.costs->field);
  map.ready_ms = ms_since(start);
  return map;
}

void prepare(LoadedMap& map, int threads, const std::stop_token& token) {
  const auto start = Clock::now();
  if (!map.prepared.empty() && std::filesystem::exists(map.prepared)) {
    map.planner = map.planner->load_preparation(map.prepared);
    map.labels = map.planner->preparation().labels.state == Preparation::State::ready;
  } else {
    std::optional<LastWords> unwritten;
    if (!map.prepared.empty()) unwritten.emplace("interrupted: not written: " + map.prepared);
    map.planner =
        map.planner->prepared({.threads = threads, .stop = {.token = token}, .labels = map.labels});
    // Where labels take too much the graph is kept alone.
    if (!map.prepared.empty() && map.planner->preparation().state == Preparation::State::ready)
      map.planner->save_preparation(map.prepared);
  }
  map.ready_ms += ms_since(start);
}

double LoadedMap::cells_of(bool metres, double length) const {
  return metres ? cells_in(length, frame->resolution) : length;
}

std::vector<Point> LoadedMap::to_world(const std::vector<Point>& path) const {
  std::vector<Point> metres;
  metres.reserve(path.size());
  for (const Point p : path) metres.push_back(to_world(p));
  return metres;
}

Place to_place(const LoadedMap& map, Point point, Frame frame) {
  Point number = point;
  if (frame == Frame::world) {
    const Point cells = map.frame->to_cells(point, map.height);
    // Rows are counted from the top, but hold their lower edge.
    number = {finite(std::floor(cells.x)), finite(std::ceil(cells.y) - 1)};
  }
  return {{clamped(number.x), clamped(number.y)}, number, point};
}

Place end_place(const LoadedMap& map, const End& end, Frame frame) {
  Place place = to_place(map, end, frame);
  if (!end.point) return place;
  Point at = end;
  if (frame == Frame::world) {
    at = map.frame->to_cells(end, map.height);
    for (double* v : {&at.x, &at.y}) {
      constexpr double kRounding = 1e-9;
      const double half = 0.5 * std::round(2 * *v);
      if (std::abs(*v - half) < kRounding) *v = half;
    }
  }
  place.point = at;
  const double row = frame == Frame::world ? std::ceil(at.y) - 1 : std::floor(at.y);
  place.number = {finite(std::floor(at.x)), finite(row)};
  if (at.x == map.width) --place.number.x;  // the map's border is of the cells inside
  if (at.y == map.height && row == at.y) --place.number.y;
  if (at.y == 0) place.number.y = 0;
  place.cell = {clamped(place.number.x), clamped(place.number.y)};
  const Grid& grid = map.as_read();
  for (const Cell c : {place.cell, Cell{clamped(std::ceil(at.x) - 1), clamped(std::ceil(at.y) - 1)},
                       Cell{clamped(std::ceil(at.x) - 1), place.cell.y},
                       Cell{place.cell.x, clamped(std::ceil(at.y) - 1)}})
    if (grid.contains(c) && grid.free(c)) {
      place.cell = c;
      break;
    }
  return place;
}

Place place_of(const LoadedMap& map, Point cell, Frame frame) {
  Place place = to_place(map, cell, Frame::cell);
  if (frame == Frame::world) place.asked = map.to_world({cell.x + 0.5, cell.y + 0.5});
  return place;
}

}  // namespace lasius::tool
