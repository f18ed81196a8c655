// A lower bound of costs from a point, cheap to make: from blocks of cells.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/cost/edge_field.h"
#include "core/cost/terrain.h"

namespace lasius::cost {

/// The straight way at the least weight of all.
class StraightBound : public EdgeField::Bound {
 public:
  StraightBound(const Terrain& terrain, Point from) : least_(terrain.least()), from_(from) {}
  double at(Point p) const override {
    const double dx = p.x - from_.x, dy = p.y - from_.y;
    return least_ * std::sqrt(dx * dx + dy * dy);
  }

 private:
  double least_;
  Point from_;
};

/// The same, or where it is more a certified field over blocks of cells, each as cheap as its
/// cheapest free cell: any path through a block costs so much at least.
class CoarseBound final : public StraightBound {
 public:
  static constexpr int kBlock = 8;  ///< cells a side

  /// @param coarse  the blocks of the map, by blocks_of; outlives the bound, as `chords` does
  CoarseBound(const Terrain& terrain, const Terrain& coarse, const CellChords& chords, Cell from)
      : StraightBound(terrain, centre(from)),
        coarse_(coarse),
        chords_(chords),
        block_{from.x / kBlock, from.y / kBlock},
        field_(coarse) {
    // The field is of the block's centre: from anywhere else in it what leads there may be saved.
    const Point at = inside(centre(from), block_);
    saved_ = coarse_.weight(block_.x, block_.y) * std::hypot(at.x - 0.5, at.y - 0.5);
  }
  /// False when stopped. @param most  costs above it need not be known
  bool make(double most, Poller& poller) {
    const StraightBound nothing(coarse_, {block_.x + 0.5, block_.y + 0.5});
    field_.begin(chords_, block_, 0.03, nullptr);
    if (!field_.march(nothing, most, poller) || !field_.certify(poller)) return false;
    made_ = true;
    return true;
  }

  double at(Point p) const override {
    const double straight = StraightBound::at(p);
    if (!made_) return straight;
    const Cell block{std::min(static_cast<int>(p.x / kBlock), coarse_.width() - 1),
                     std::min(static_cast<int>(p.y / kBlock), coarse_.height() - 1)};
    const std::size_t index = coarse_.index(block.x, block.y);
    if (block == block_ || !field_.has(index)) return straight;
    // Off the block's edges, of which values are known, by a little.
    Point local = inside(p, block);
    local = {std::clamp(local.x, kOff, 1 - kOff), std::clamp(local.y, kOff, 1 - kOff)};
    double values[8];
    field_.values_of(block, values);
    const double weight = coarse_.at(index);
    const double cost = chords_.cheapest(local, values, weight).cost / field_.excess();
    return std::max(straight, cost - 2 * kOff * weight - saved_);
  }

 private:
  static constexpr double kOff = 1e-3;

  static Point inside(Point p, Cell block) noexcept {
    return {p.x / kBlock - block.x, p.y / kBlock - block.y};
  }

  const Terrain& coarse_;
  const CellChords& chords_;
  Cell block_;
  EdgeField field_;
  double saved_ = 0;
  bool made_ = false;
};

/// The blocks of a map as cells of another, whose unit of length is a block.
inline Terrain blocks_of(const Terrain& terrain) {
  constexpr int kBlock = CoarseBound::kBlock;
  Grid grid((terrain.width() + kBlock - 1) / kBlock, (terrain.height() + kBlock - 1) / kBlock);
  std::vector<double> weights(static_cast<std::size_t>(grid.width()) * grid.height(), kInfinity);
  for (int y = 0; y < terrain.height(); ++y) {
    for (int x = 0; x < terrain.width(); ++x) {
      double& weight = weights[static_cast<std::size_t>(y / kBlock) * grid.width() + x / kBlock];
      weight = std::min(weight, kBlock * terrain.weight(x, y));
    }
  }
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      double& weight = weights[static_cast<std::size_t>(y) * grid.width() + x];
      if (weight < kInfinity) continue;
      grid.set_blocked({x, y});
      weight = 1;
    }
  }
  return Terrain(grid, weights);
}

}  // namespace lasius::cost
