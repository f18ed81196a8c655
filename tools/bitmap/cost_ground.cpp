#include "tools/bitmap/cost_ground.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "tools/draw/axes.h"
#include "tools/draw/colours.h"
#include "tools/report/packed.h"

namespace lasius::tool {
namespace {

constexpr Colour kCosts[] = {{1, 1, 1}, {1, 0.94, 0.74}, {0.99, 0.77, 0.5}, {0.85, 0.5, 0.42}};
constexpr Colour kLevelLine{0.35, 0.45, 0.62};
constexpr int kLevelLines = 12;

/// The mean weight of the free cells; NaN: there is none.
double mean_weight(const CostField& costs, const Grid& map, Span columns, Span rows) {
  double sum = 0;
  int free = 0;
  for (int y = rows.from; y < rows.to; ++y) {
    for (int x = columns.from; x < columns.to; ++x) {
      if (map.blocked({x, y})) continue;
      sum += costs.weight({x, y});
      ++free;
    }
  }
  return free > 0 ? sum / free : std::numeric_limits<double>::quiet_NaN();
}

/// A cell of a level with the values at its corners, clockwise from the upper left one.
struct Valued {
  Cell cell;
  std::array<double, 4> values;
};

/// A level's cells row by row. Values on an edge between two of its cells are those of the first.
std::vector<Valued> corners_of(const CostProof::Level& level) {
  std::vector<Valued> cells;
  const int k = level.intervals;
  auto value = level.values.begin();
  std::size_t above = 0;  // the first cell that may be the one above
  for (std::size_t run = 0; run + 2 < level.runs.size(); run += 3) {
    const int y = level.runs[run], first = level.runs[run + 1], count = level.runs[run + 2];
    for (int x = first; x < first + count; ++x) {
      while (above < cells.size() && (cells[above].cell.y < y - 1 ||
                                      (cells[above].cell.y == y - 1 && cells[above].cell.x < x)))
        ++above;
      const Valued* const over =
          above < cells.size() && cells[above].cell == Cell{x, y - 1} ? &cells[above] : nullptr;
      const Valued* const left =
          !cells.empty() && cells.back().cell == Cell{x - 1, y} ? &cells.back() : nullptr;
      Valued one{.cell = {x, y}, .values = {}};
      for (int place = 0; place < 4 * k; ++place) {
        const bool from_over = over != nullptr && place <= k;
        const bool from_left = left != nullptr && (place == 0 || place >= 3 * k);
        double at = 0;
        if (!from_over && !from_left) {
          if (value == level.values.end()) return cells;
          at = *value++;
        }
        if (place % k != 0) continue;
        const auto corner = static_cast<std::size_t>(place / k);
        one.values[corner] = from_over   ? over->values[3 - corner]
                             : from_left ? left->values[corner == 0 ? 1 : 2]
                                         : at;
      }
      cells.push_back(one);
    }
  }
  return cells;
}

}  // namespace

ColourScale cost_scale(const CostField& costs, const Grid& map) {
  const auto [least, most] = costs.range(map);
  return {{least, most}, most > 10 * least, kCosts};
}

Colour cost_ground(const CostField& costs, const Grid& map, const ColourScale& scale, Span columns,
                   Span rows) {
  const double weight = mean_weight(costs, map, columns, rows);
  return weight == weight ? scale.at(weight) : kFree;
}

void draw_level_lines(Canvas& canvas, const Axes& axes, const CostProof& proof) {
  const auto widest = std::ranges::find(proof.levels, 1, &CostProof::Level::block);
  if (widest == proof.levels.end()) return;
  const std::vector<Valued> cells = corners_of(*widest);
  double most = 0;
  for (const Valued& one : cells) most = std::max(most, std::ranges::max(one.values));
  const auto marks = ticks(0, std::max(most, 1e-9), kLevelLines);
  const double apart = marks.size() > 1 ? marks[1] - marks[0] : 0;
  if (!(apart > 0)) return;
  for (const auto& [cell, values] : cells) {
    const auto [low, high] = std::ranges::minmax(values);
    for (double line = apart * std::ceil(low / apart); line < high; line += apart) {
      const Point corners[] = {{1.0 * cell.x, 1.0 * cell.y},
                               {cell.x + 1.0, 1.0 * cell.y},
                               {cell.x + 1.0, cell.y + 1.0},
                               {1.0 * cell.x, cell.y + 1.0}};
      std::vector<Point> crossed;
      for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t next = (i + 1) % 4;
        const double from = values[i], to = values[next];
        if ((from < line) == (to < line)) continue;
        const double t = (line - from) / (to - from);
        crossed.push_back(axes.at(corners[i].x + t * (corners[next].x - corners[i].x),
                                  corners[i].y + t * (corners[next].y - corners[i].y)));
      }
      for (std::size_t i = 0; i + 1 < crossed.size(); i += 2)
        canvas.line(crossed[i], crossed[i + 1], kLevelLine, 1);
    }
  }
}

Json weights_view_json(const CostField& costs, const Grid& map, const Window& window) {
  constexpr int kMostPixels = 512;  // a side
  const double shrink =
      std::min(1.0, 1.0 * kMostPixels / std::max(window.width(), window.height()));
  const auto pixels = [&](int cells) {
    return std::max(1, static_cast<int>(std::lround(shrink * cells)));
  };
  const int width = pixels(window.width()), height = pixels(window.height());
  const ColourScale scale = cost_scale(costs, map);
  std::vector<std::uint8_t> shares;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double weight = mean_weight(costs, map, cells_under(x, width, window.columns),
                                        cells_under(y, height, window.rows));
      const double share = weight == weight ? scale.share(weight) : 0;
      shares.push_back(static_cast<std::uint8_t>(std::lround(255 * share)));
    }
  }
  return {{"width", width},
          {"height", height},
          {"shares", packed(shares)},
          {"least", scale.range.low},
          {"most", scale.range.high}};
}

}  // namespace lasius::tool
