#include "tools/bitmap/bitmap_report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tools/bitmap/cost_ground.h"
#include "tools/bitmap/path_clearance.h"
#include "tools/bitmap/sheet.h"
#include "tools/report/packed.h"
#include "tools/report/report.h"

namespace lasius::tool {
namespace {

constexpr int kMostWallPixels = 1024;  // of the map, a side

/// [[x, y, x, y], ...] to a hundredth of a cell.
Json lines_json(const std::vector<std::array<Point, 2>>& lines) {
  Json list = Json::array();
  const auto rounded = [](double value) { return std::round(100 * value) / 100; };
  for (const auto& [from, to] : lines)
    list.push_back({rounded(from.x), rounded(from.y), rounded(to.x), rounded(to.y)});
  return list;
}

}  // namespace

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

Json map_view_json(const LoadedMap& map, const Window& window) {
  const bool any_unknown =
      map.unknown && map.unknown->count_free() < std::int64_t{1} * map.width * map.height;
  Json json = {{"width", map.width},
               {"height", map.height},
               {"window", {window.columns.from, window.rows.from, window.width(), window.height()}},
               {"walls", walls_json(map.grid(), window)},
               {"obstacles", map.grown() ? walls_json(map.as_read(), window) : Json(nullptr)},
               {"unknown", any_unknown ? walls_json(*map.unknown, window) : Json(nullptr)},
               {"unknown_free", map.unknown_is_free},
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
  const auto along = clearance_along(grid, path, length);
  Json values = Json::array();
  for (const double value : along.values) values.push_back(std::round(1000 * value) / 1000);
  return {{"step", along.step}, {"values", values}, {"most", kMostClearance}};
}

void write_bitmap_report(std::ostream& out, const Record& record, const LoadedMap& map,
                         const RunOptions& run, const Answer& answer, const RunFrames* frames) {
  Json content = run_json(record, "bitmap", map_title(map, run));
  const Window window = shown_of(map, {answer.start.cell, answer.goal.cell});
  content["map"] = map_view_json(map, window);
  if (map.costs)
    content["map"]["weights"] = weights_view_json(map.costs->field, map.as_read(), window);
  if (answer.shown_proof) {
    const ShownLines shown = shown_lines(*answer.shown_proof, map.as_read());
    content["map"]["level_lines"] = lines_json(shown.lines);
    content["map"]["lines_apart"] = shown.apart;
  }
  const auto reached = short_end(answer);
  content["ends"] = {point(answer.start.at()), point(answer.goal.at()),
                     reached ? point(*reached) : Json(nullptr)};
  content["clearance"] = clearance_json(map.as_read(), answer.result.path, record.result.length);
  content["radius"] = map.radius;
  content["frames"] = frames != nullptr ? frames->json() : Json(nullptr);
  write_report_page(out, content);
}

}  // namespace lasius::tool
