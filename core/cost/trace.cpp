// A path back along the values of a field.

#include <algorithm>
#include <cmath>

#include "core/cost/edge_field.h"

namespace lasius::cost {
namespace {

/// From a point of a cell's boundary into it.
struct Entry {
  double cost = kInfinity;
  Cell along;  ///< that the way runs in first, or the cell itself
  Point at;    ///< where it leaves the edge; within the unit cell
};

/// The cheapest: straight, or first along an edge in a cheaper cell beside it.
Entry cheapest_entry(const Terrain& terrain, Cell cell, Point from, Point to) {
  const double weight = terrain.weight(cell.x, cell.y);
  Entry best{weight * distance(from, to), cell, from};
  const auto along = [&](Cell beside, double off, double foot, Point direction) {
    const double less = terrain.weight(beside.x, beside.y);
    if (!(less < weight)) return;
    // It leaves the edge at the angle of total reflection.
    const double run =
        std::abs(foot) - std::abs(off) * less / std::sqrt(weight * weight - less * less);
    if (!(run > 0)) return;
    const double step = std::copysign(run, foot);
    const Point at{from.x + direction.x * step, from.y + direction.y * step};
    const double cost = less * run + weight * distance(at, to);
    if (cost < best.cost) best = {cost, beside, at};
  };
  const double x = to.x - from.x, y = to.y - from.y;
  if (from.x == 0 || from.x == 1) along({cell.x + (from.x == 0 ? -1 : 1), cell.y}, x, y, {0, 1});
  if (from.y == 0 || from.y == 1) along({cell.x, cell.y + (from.y == 0 ? -1 : 1)}, y, x, {1, 0});
  return best;
}

}  // namespace

// From cell to cell, each time by the straight way that costs least together with the value where
// it leaves the cell. Values fall strictly, so that it ends.
std::optional<std::vector<Leg>> EdgeField::trace(Cell target, Point at) const {
  if (!has(terrain_.index(target.x, target.y))) return std::nullopt;
  double values[kMostPlaces];
  std::vector<Leg> legs{{target, {target.x + at.x, target.y + at.y}}}, passed;
  const auto begun_by = [&](const Entry& back, Point here) {
    std::vector<Leg> path = legs;
    if (back.along != source_) path.push_back({back.along, here});
    path.push_back({source_, {source_.x + back.at.x, source_.y + back.at.y}});
    std::ranges::reverse(path);
    return path;
  };
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
    Entry back;
    for (int cy = here.y == y ? y - 1 : y; cy <= y; ++cy) {
      for (int cx = here.x == x ? x - 1 : x; cx <= x; ++cx) {
        const Cell next{cx, cy};
        if (next == left || !has(terrain_.index(cx, cy))) continue;
        const bool diagonal = cx != left.x && cy != left.y;
        if (diagonal && !terrain_.free(cx, left.y) && !terrain_.free(left.x, cy)) continue;
        const Point within{here.x - cx, here.y - cy};
        const double weight_there = terrain_.weight(cx, cy) * scale_;
        if (next == source_) back = cheapest_entry(terrain_, next, within, source_at_);
        values_of(next, values);
        const auto there = chords_->cheapest(within, values, weight_there);
        if (!(there.value < value) || !(there.cost < exit.cost)) continue;
        exit = there;
        cell = next;
      }
    }
    // The source's cell may be crossed, too, on the way to where it is left for the last time.
    if (back.cost < kInfinity) {
      if (back.cost * scale_ <= exit.cost) return begun_by(back, here);
      passed = begun_by(back, here);
    }
    if (exit.interval >= 0) legs.push_back({cell, here});
  }
  // Values between places are not what ways cost: the last way that was passed over is one.
  if (!passed.empty()) return passed;
  return std::nullopt;
}

}  // namespace lasius::cost
