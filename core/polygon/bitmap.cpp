#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/invalid_parameter.h"
#include "core/base/number_text.h"
#include "core/polygon/free_space.h"
#include "core/polygon/world/geos.h"
#include "core/polygon/world/rings.h"
#include "lasius/polygon/world.h"

namespace lasius::polygon {
namespace {

void check_resolution(double resolution) {
  require_parameter(resolution > 0 && std::isfinite(resolution), "resolution", resolution,
                    "it must be above 0");
}

/// Where the edges of free space meet the level y, from the left.
std::vector<double> crossings(const std::vector<Polygon>& pieces, double y) {
  std::vector<double> list;
  for (const Polygon& piece : pieces) {
    for (const Ring* ring : rings_of(piece)) {
      for (std::size_t i = 0; i < ring->size(); ++i) {
        const Point a = (*ring)[i], b = (*ring)[i + 1 < ring->size() ? i + 1 : 0];
        if ((a.y > y) == (b.y > y)) continue;
        list.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
      }
    }
  }
  std::ranges::sort(list);
  return list;
}

/// Blocks the cells that a wall passes through: none leads across it.
void draw_walls(const World& world, double resolution, Point low, Grid& grid) {
  const auto cell = [](double at, int cells) {
    return static_cast<int>(std::clamp(std::floor(at), 0.0, cells - 1.0));
  };
  for (const Ring& wall : world.walls) {
    for (std::size_t i = 0; i + 1 < wall.size(); ++i) {
      // In cells from the lower left corner; b is the upper end.
      const auto in_cells = [&](Point p) {
        return Point{(p.x - low.x) / resolution, (p.y - low.y) / resolution};
      };
      Point a = in_cells(wall[i]), b = in_cells(wall[i + 1]);
      if (a.y > b.y) std::swap(a, b);
      if (b.y < 0 || a.y > grid.height()) continue;
      for (int row = cell(a.y, grid.height()); row <= cell(b.y, grid.height()); ++row) {
        const auto at = [&](double y) {
          return a.y < b.y ? a.x + std::clamp((y - a.y) / (b.y - a.y), 0.0, 1.0) * (b.x - a.x)
                           : a.x;
        };
        const double from = at(row), to = a.y < b.y ? at(row + 1.0) : b.x;
        if (std::max(from, to) < 0 || std::min(from, to) > grid.width()) continue;
        const int left = cell(std::min(from, to), grid.width());
        const int right = cell(std::max(from, to), grid.width());
        grid.fill({left, grid.height() - 1 - row, right + 1 - left, 1}, true);
      }
    }
  }
}

}  // namespace

World from_grid(const Grid& grid, const WorldFrame& frame) {
  check_resolution(frame.resolution);
  if (frame.yaw != 0) {
    throw invalid_parameter("the map is turned by yaw " + number_text(frame.yaw),
                            "turn the map upright, or set yaw to 0");
  }
  const auto corner = [&](int x, int y) {
    return frame.to_world({static_cast<double>(x), static_cast<double>(y)}, grid.height());
  };
  const auto box = [&](int left, int top, int right, int bottom) {
    return Polygon{
        {corner(left, bottom), corner(right, bottom), corner(right, top), corner(left, top)}, {}};
  };
  const Geos geos;
  std::vector<Geos::Geometry> runs;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      if (grid.free({x, y})) continue;
      const int from = x;
      while (x < grid.width() && grid.blocked({x, y})) ++x;
      runs.push_back(geos.polygon(box(from, y, x, y + 1)));
    }
  }
  const auto all = geos.collection(std::move(runs));
  const auto merged = geos.own(GEOSUnaryUnion_r(geos.context(), all.get()));
  const auto simple = geos.own(GEOSSimplify_r(geos.context(), merged.get(), 0));
  World world;
  world.boundary = box(0, 0, grid.width(), grid.height());
  world.obstacles = geos.polygons(simple.get());
  return world;
}

Map to_grid(const World& world, double resolution) {
  check_resolution(resolution);
  check(world);
  const FreeSpace space = make_free_space(world, {.margin = world.margin}, Tangents::many);
  const auto box = bounds_of(world.boundary.outer);
  const Point low = box.low, high = box.high;
  const double wide = std::ceil((high.x - low.x) / resolution);
  const double tall = std::ceil((high.y - low.y) / resolution);
  if (!(wide <= Grid::kMaxSide && tall <= Grid::kMaxSide)) {
    throw invalid_parameter("resolution " + number_text(resolution) + " gives more than " +
                                std::to_string(Grid::kMaxSide) + " cells a side",
                            "give a coarser one");
  }
  Map map{Grid(static_cast<int>(wide), static_cast<int>(tall)),
          WorldFrame{.resolution = resolution, .origin_x = low.x, .origin_y = low.y}};
  map.grid.fill(true);
  for (int y = 0; y < map.grid.height(); ++y) {
    const double level = map.frame->to_world({0, y + 0.5}, map.grid.height()).y;
    const auto cuts = crossings(space.pieces, level);
    for (std::size_t i = 0; i + 1 < cuts.size(); i += 2) {
      // Cells whose centre lies in [from, to).
      const auto first = [&](double x) {
        return static_cast<int>(std::clamp(std::ceil((x - low.x) / resolution - 0.5), 0.0, wide));
      };
      const int from = first(cuts[i]);
      map.grid.fill({from, y, first(cuts[i + 1]) - from, 1}, false);
    }
  }
  draw_walls(world, resolution, low, map.grid);
  return map;
}

}  // namespace lasius::polygon
