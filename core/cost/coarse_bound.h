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
  double at(Point p, Cell) const override {
    const double dx = p.x - from_.x, dy = p.y - from_.y;
    return least_ * std::sqrt(dx * dx + dy * dy);
  }
  /// The same, less what rounding may add.
  double proven(Point p, Cell cell) const { return at(p, cell) / (1 + 1e-12); }

 private:
  double least_;
  Point from_;
};

/// A certified field over blocks of cells, each as cheap as its cheapest free cell: any path
/// through a block costs so much at least.
struct Blocks {
  static constexpr int kSide = 8;       ///< cells
  static constexpr int kIntervals = 2;  ///< an edge

  static Cell of(Cell cell) noexcept { return {cell.x / kSide, cell.y / kSide}; }
  /// What a point of the block is, with the block as the unit.
  static Point inside(Point p, Cell block) noexcept {
    return {p.x / kSide - block.x, p.y / kSide - block.y};
  }
  /// The field is of the centre of the block that the start is in: what may be saved by starting
  /// where the start is.
  static double saved(const Terrain& blocks, Cell start, Point from) noexcept {
    const Cell block = of(start);
    const Point at = inside(from, block);
    return blocks.weight(block.x, block.y) * distance(at, kMiddle);
  }
  /// What a path costs at least to a point of a block, from the values around it.
  static double within(const CellChords& chords, Point local, const double* values, double weight) {
    constexpr double kOff = 1e-3;  // from the block's edges, so that each is looked at
    local = {std::clamp(local.x, kOff, 1 - kOff), std::clamp(local.y, kOff, 1 - kOff)};
    return chords.cheapest(local, values, weight).cost - 2 * kOff * weight;
  }
};

/// The bound of such a field from the start, or the straight one where that is greater.
class CoarseBound final : public StraightBound {
 public:
  /// @param blocks  of the map, by blocks_of; outlives the bound, as `chords` does
  CoarseBound(const Terrain& terrain, const Terrain& blocks, const CellChords& chords, Cell start,
              Point from)
      : StraightBound(terrain, from),
        blocks_(blocks),
        chords_(chords),
        block_(Blocks::of(start)),
        field_(blocks),
        saved_(Blocks::saved(blocks, start, from)) {}
  /// False when stopped. @param most  costs above it need not be known
  bool make(double most, Poller& poller) {
    const NoBound none;
    field_.begin(chords_, block_, kSlack, nullptr);
    // What is lost to the slack is marched for, too: beyond the field nothing is known.
    if (!field_.march(none, most * (1 + 2 * kSlack), poller) || !field_.certify(poller))
      return false;
    beyond_ = field_.bound_of_leaving();
    made_ = true;
    return true;
  }
  const EdgeField& field() const noexcept { return field_; }

  double at(Point p, Cell cell) const override {
    const double straight = StraightBound::at(p, cell);
    if (!made_) return straight;
    const Cell block = Blocks::of(cell);
    const std::size_t index = blocks_.index(block.x, block.y);
    if (block == block_ || !field_.has(index)) return straight;
    double values[4 * Blocks::kIntervals];
    field_.values_of(block, values);
    const double cost =
        Blocks::within(chords_, Blocks::inside(p, block), values, blocks_.at(index));
    // A path that leaves the field's blocks and comes back has cost what leaving costs.
    return std::max(straight, std::min(cost / field_.excess(), beyond_) - saved_);
  }

 private:
  static constexpr double kSlack = 0.03;
  struct NoBound final : EdgeField::Bound {
    double at(Point, Cell) const override { return 0; }
  };

  const Terrain& blocks_;
  const CellChords& chords_;
  Cell block_;
  EdgeField field_;
  double saved_;
  double beyond_ = 0;
  bool made_ = false;
};

/// The blocks of a map as cells of another, whose unit of length is a block.
inline Terrain blocks_of(const Terrain& terrain) {
  constexpr int kBlock = Blocks::kSide;
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
