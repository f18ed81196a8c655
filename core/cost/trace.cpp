// A path back along the values of a field.

#include <algorithm>
#include <cmath>

#include "core/cost/edge_field.h"

namespace lasius::cost {

// From cell to cell, each time by the straight way that costs least together with the value where
// it leaves the cell. Values fall strictly, so that it ends.
std::optional<std::vector<Leg>> EdgeField::trace(Cell target, Point at) const {
  if (!has(terrain_.index(target.x, target.y))) return std::nullopt;
  double values[kMostPlaces];
  std::vector<Leg> legs{{target, {target.x + at.x, target.y + at.y}}};
  values_of(target, values);
  const double weight = terrain_.weight(target.x, target.y) * scale_;
  CellChords::Exit exit = chords_->cheapest(at, values, weight);
  Cell cell = target;
  while (exit.interval >= 0) {
    const Point here{cell.x + exit.at.x, cell.y + exit.at.y};
    const double value = exit.value;
    const Cell left = cell;
    const int x = static_cast<int>(std::floor(here.x)), y = static_cast<int>(std::floor(here.y));
    exit = {kInfinity, kInfinity, {}, -1};
    bool back = false;
    for (int cy = here.y == y ? y - 1 : y; cy <= y; ++cy) {
      for (int cx = here.x == x ? x - 1 : x; cx <= x; ++cx) {
        const Cell next{cx, cy};
        if (next == left || !has(terrain_.index(cx, cy))) continue;
        const bool diagonal = cx != left.x && cy != left.y;
        if (diagonal && !terrain_.free(cx, left.y) && !terrain_.free(left.x, cy)) continue;
        if (next == source_) {
          back = true;
          continue;
        }
        values_of(next, values);
        const auto there =
            chords_->cheapest({here.x - cx, here.y - cy}, values, terrain_.weight(cx, cy) * scale_);
        if (!(there.value < value) || !(there.cost < exit.cost)) continue;
        exit = there;
        cell = next;
      }
    }
    // Into its own cell a trace from the source comes back only where no other leads on.
    if (back && (target != source_ || exit.interval < 0)) {
      legs.push_back({source_, here});
      std::ranges::reverse(legs);
      return legs;
    }
    if (exit.interval >= 0) legs.push_back({cell, here});
  }
  return std::nullopt;
}

}  // namespace lasius::cost
