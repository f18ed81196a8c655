#include "tools/bitmap/level_lines.h"

#include <algorithm>
#include <cmath>

#include "core/cost/level_values.h"

namespace lasius::tool {

CornerValues corner_values(const CostProof& proof, const Grid& map) {
  const auto widest = std::ranges::find(proof.levels, 1, &CostProof::Level::block);
  if (widest == proof.levels.end()) return {};
  cost::LevelValues level(*widest, map.width(), map.height());
  if (level.read([](std::size_t) { return std::optional<std::string>(); })) return {};
  CornerValues corners;
  const int k = widest->intervals;
  for (const std::size_t at : level.cells()) {
    const double* const around = level.find(at);
    const auto& values =
        corners.values.emplace_back(std::array{around[0], around[k], around[2 * k], around[3 * k]});
    corners.cells.push_back(level.cell(at));
    corners.most = std::max(corners.most, std::ranges::max(values));
  }
  return corners;
}

std::vector<std::array<Point, 2>> level_lines(const CornerValues& corners, double apart) {
  constexpr Point kCorners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  std::vector<std::array<Point, 2>> lines;
  for (std::size_t at = 0; at < corners.cells.size(); ++at) {
    const Cell cell = corners.cells[at];
    const auto& values = corners.values[at];
    const auto [low, high] = std::ranges::minmax(values);
    for (double i = std::ceil(low / apart); i * apart < high; ++i) {
      const double line = i * apart;
      std::vector<Point> crossed;
      for (std::size_t from = 0; from < 4; ++from) {
        const std::size_t to = (from + 1) % 4;
        if ((values[from] < line) == (values[to] < line)) continue;
        const double t = (line - values[from]) / (values[to] - values[from]);
        crossed.push_back({cell.x + kCorners[from].x + t * (kCorners[to].x - kCorners[from].x),
                           cell.y + kCorners[from].y + t * (kCorners[to].y - kCorners[from].y)});
      }
      for (std::size_t pair = 0; pair + 1 < crossed.size(); pair += 2)
        lines.push_back({crossed[pair], crossed[pair + 1]});
    }
  }
  return lines;
}

}  // namespace lasius::tool
