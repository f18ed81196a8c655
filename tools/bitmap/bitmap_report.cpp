#include "tools/bitmap/bitmap_report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tools/bitmap/sheet.h"
#include "tools/report/packed.h"
#include "tools/report/report.h"

namespace lasius::tool {
namespace {

constexpr int kMostWallPixels = 1024;  // of the map, a side
constexpr int kMostSamples = 600;      // of a path's clearance

Json walls_json(const Grid& grid, const Window& window) {
  const double shrink =
      std::min(1.0, 1.0 * kMostWallPixels / std::max(window.width(), window.height()));
  const auto pixels = [&](int cells) {
    return std::max(1, static_cast<int>(std::lround(shrink * cells)));
  };
  const auto share = blocked_share(grid, window, pixels(window.width()), pixels(window.height()));
  std::vector<std::uint8_t> codes;
  for (const float blocked : share.values)
    codes.push_back(static_cast<std::uint8_t>(std::lround(255 * wall_strength(blocked))));
  return {{"width", share.width}, {"height", share.height}, {"shares", packed(codes)}};
}

/// Points of a polyline at even distances, its ends among them.
std::vector<Point> spread(const std::vector<Point>& path, int count, double step) {
  std::vector<Point> samples{path.front()};
  double walked = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Point a = path[i - 1], b = path[i];
    const double far = std::hypot(b.x - a.x, b.y - a.y);
    while (static_cast<int>(samples.size()) < count &&
           step * static_cast<double>(samples.size()) <= walked + far && far > 0) {
      const double t = (step * static_cast<double>(samples.size()) - walked) / far;
      samples.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
    }
    walked += far;
  }
  samples.push_back(path.back());
  return samples;
}

}  // namespace

double distance_to_blocked(const Grid& grid, Point at, int most) {
  const Cell middle{static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y))};
  double best = most;
  const auto look = [&](int x, int y) {
    if (grid.contains({x, y}) && grid.free({x, y})) return;
    const double dx = std::max({x - at.x, at.x - x - 1, 0.0});
    const double dy = std::max({y - at.y, at.y - y - 1, 0.0});
    best = std::min(best, std::hypot(dx, dy));
  };
  // Ring by ring: cells of ring r are at least r - 1 away.
  for (int r = 0; r - 1 < best; ++r)
    for (int i = -r; i <= r; ++i) {
      look(middle.x + i, middle.y - r);
      look(middle.x + i, middle.y + r);
      look(middle.x - r, middle.y + i);
      look(middle.x + r, middle.y + i);
    }
  return best;
}

Json map_view_json(const LoadedMap& map, const Window& window) {
  Json json = {{"width", map.width},
               {"height", map.height},
               {"window", {window.columns.from, window.rows.from, window.width(), window.height()}},
               {"walls", walls_json(map.grid(), window)},
               {"to_world", nullptr}};
  if (map.frame) {
    const Point origin = map.to_world({0, 0}), x = map.to_world({1, 0}), y = map.to_world({0, 1});
    json["to_world"] = {x.x - origin.x, y.x - origin.x, origin.x,
                        x.y - origin.y, y.y - origin.y, origin.y};
  }
  return json;
}

Json clearance_json(const Grid& grid, const std::vector<Point>& path, double length) {
  if (path.empty()) return nullptr;
  const int count =
      std::clamp(static_cast<int>(std::ceil(std::min(2 * length, 1e6))), 1, kMostSamples);
  const double step = length / count;
  Json values = Json::array();
  for (const Point at : spread(path, count, step))
    values.push_back(std::round(1000 * distance_to_blocked(grid, at, kMostClearance)) / 1000);
  return {{"step", step}, {"values", values}};
}

void write_bitmap_report(std::ostream& out, const Task& task, const LoadedMap& map,
                         const RunOptions& run, const std::vector<Cell>& ends,
                         const std::vector<Point>& path, const RunFrames* frames) {
  Json content = run_json(task, "bitmap", map_title(map, run));
  content["map"] = map_view_json(map, shown_of(map, ends));
  content["clearance"] = clearance_json(map.grid(), path, task.result().length);
  content["most_clearance"] = kMostClearance;
  content["radius"] = map.radius;
  content["frames"] = frames != nullptr ? frames->json() : Json(nullptr);
  write_report_page(out, content);
}

}  // namespace lasius::tool
