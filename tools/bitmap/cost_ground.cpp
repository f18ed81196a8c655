#include "tools/bitmap/cost_ground.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/cost/level_values.h"
#include "tools/draw/axes.h"
#include "tools/draw/colours.h"
#include "tools/report/packed.h"

namespace lasius::tool {
namespace {

constexpr Colour kCosts[] = {{1, 1, 1}, {1, 0.94, 0.74}, {0.99, 0.77, 0.5}, {0.85, 0.5, 0.42}};
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

std::vector<std::array<Point, 2>> level_lines(const CostProof& proof, const Grid& map) {
  std::vector<std::array<Point, 2>> lines;
  const auto widest = std::ranges::find(proof.levels, 1, &CostProof::Level::block);
  if (widest == proof.levels.end()) return lines;
  cost::LevelValues level(*widest, map.width(), map.height());
  const auto any = [](std::size_t) { return std::optional<std::string>(); };
  if (level.read(any)) return lines;
  const int k = widest->intervals;
  const auto corner = [&](std::size_t at, std::size_t i) { return level.find(at)[i * k]; };
  double most = 1e-9;
  for (const std::size_t at : level.cells())
    for (std::size_t i = 0; i < 4; ++i) most = std::max(most, corner(at, i));
  const double apart = ticks(0, most, kLevelLines)[1];
  constexpr Point kCorners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (const std::size_t at : level.cells()) {
    const std::array values{corner(at, 0), corner(at, 1), corner(at, 2), corner(at, 3)};
    const Cell cell = level.cell(at);
    const auto [low, high] = std::ranges::minmax(values);
    for (double line = apart * std::ceil(low / apart); line < high; line += apart) {
      std::vector<Point> crossed;
      for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t next = (i + 1) % 4;
        if ((values[i] < line) == (values[next] < line)) continue;
        const double t = (line - values[i]) / (values[next] - values[i]);
        crossed.push_back({cell.x + kCorners[i].x + t * (kCorners[next].x - kCorners[i].x),
                           cell.y + kCorners[i].y + t * (kCorners[next].y - kCorners[i].y)});
      }
      for (std::size_t i = 0; i + 1 < crossed.size(); i += 2)
        lines.push_back({crossed[i], crossed[i + 1]});
    }
  }
  return lines;
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
