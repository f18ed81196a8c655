#include "core/cost/proof_level.h"

#include <algorithm>

namespace lasius::cost {

CostProof::Level proof_level(const Terrain& terrain, const EdgeField& field, bool from_start,
                             int block) {
  const int k = field.intervals();
  CostProof::Level level{.from_start = from_start, .block = block, .intervals = k};
  std::vector<std::uint32_t> cells = field.cells();
  std::ranges::sort(cells);
  std::vector<double> values(4 * static_cast<std::size_t>(k));
  for (const std::uint32_t at : cells) {
    const Cell cell = terrain.cell(at);
    const bool left = field.has(at - 1), above = field.has(at - terrain.stride());
    if (left)
      ++level.runs.back();
    else
      level.runs.insert(level.runs.end(), {cell.y, cell.x, 1});
    field.values_of(cell, values.data());
    for (int place = 0; place < 4 * k; ++place) {
      const bool on_top = place <= k, on_left = place >= 3 * k || place == 0;
      if (!(above && on_top) && !(left && on_left)) level.values.push_back(values[place]);
    }
  }
  return level;
}

}  // namespace lasius::cost
