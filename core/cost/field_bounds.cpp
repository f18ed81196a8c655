// What a certified field says of paths: to a point, and of those that leave its cells.

#include <algorithm>

#include "core/cost/edge_field.h"

namespace lasius::cost {

double EdgeField::bound(Cell target, Point at) const {
  if (!has(terrain_.index(target.x, target.y))) return kInfinity;
  double values[kMostPlaces];
  values_of(target, values);
  return chords_->cheapest(at, values, terrain_.weight(target.x, target.y)).cost / excess_;
}

double EdgeField::bound_of_leaving() const {
  const int k = chords_->intervals();
  double least = kInfinity;
  for (const std::uint32_t at : cells_) {
    const Cell cell = terrain_.cell(at);
    constexpr int kX[4] = {0, 1, 0, -1}, kY[4] = {-1, 0, 1, 0};
    std::uint32_t nodes[kMostPlaces];
    bool have = false;
    for (int edge = 0; edge < 4; ++edge) {
      const Cell beside{cell.x + kX[edge], cell.y + kY[edge]};
      if (!open(beside) || has(terrain_.index(beside.x, beside.y))) continue;
      if (!have) places_of(cell, nodes);
      have = true;
      if (before_ != nullptr) {
        for (int i = 0; i <= k; ++i) {
          const int place = (edge * k + i) % chords_->places();
          least = std::min(least, value_[nodes[place]] + value_before(cell, place));
        }
      } else {
        least = bound_of_leaving(cell, edge, nodes, least);
      }
    }
  }
  // The values of both levels may be too great by as much as either is off.
  return least / std::max(excess_, before_ != nullptr ? before_->excess_ : 1);
}

// The least of `most` and of what is at points of the edge, less what it may be less between them:
// what is left to the other end falls along an edge by no more than the cell's weight. Most edges
// are told by their middle.
double EdgeField::bound_of_leaving(Cell cell, int edge, const std::uint32_t* nodes,
                                   double most) const {
  constexpr int kPoints = kRestPoints;
  const int k = chords_->intervals();
  const double weight = terrain_.weight(cell.x, cell.y);
  const double off = weight * 0.5 / (kPoints * k);
  const auto next = [&](int place) { return place + 1 < chords_->places() ? place + 1 : 0; };
  const Point begin = chords_->at(edge * k), end = chords_->at(next(edge * k + k - 1));
  const auto at = [&](double share) {
    return Point{cell.x + begin.x + share * (end.x - begin.x),
                 cell.y + begin.y + share * (end.y - begin.y)};
  };
  double lowest = kInfinity;
  for (int place = edge * k, i = 0; i <= k; place = next(place), ++i)
    lowest = std::min(lowest, value_[nodes[place]]);
  if (lowest + rest_->at(at(0.5), cell) - weight * (0.5 + 1e-9) - off > most) return most;
  double least = most + off;
  for (int i = 0; i <= kPoints * k; ++i) {
    const int low = std::min(i / kPoints, k - 1) + edge * k, high = next(low);
    const double share = static_cast<double>(i) / kPoints - (low - edge * k);
    const Point a = chords_->at(low), b = chords_->at(high);
    const Point p{cell.x + a.x + share * (b.x - a.x), cell.y + a.y + share * (b.y - a.y)};
    const double value = value_[nodes[low]] + share * (value_[nodes[high]] - value_[nodes[low]]);
    least = std::min(least, value + rest_->at(p, cell));
  }
  return std::min(most, least - off);
}

}  // namespace lasius::cost
