#include <algorithm>
#include <bit>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/number_text.h"
#include "core/cost/cell_chords.h"
#include "core/cost/coarse_bound.h"
#include "core/cost/level_values.h"
#include "core/cost/terrain.h"
#include "lasius/cost/proof.h"

namespace lasius {
namespace {

using cost::Blocks;
using cost::CellChords;
using cost::Terrain;

/// A level whose values may be off by more than this, as a factor less 1, proves nothing: rounding
/// is off by less.
constexpr double kMostExcess = 1e-3;

using Fault = std::optional<std::string>;

/// A level as its values tell: where they are, and how far they obey.
class Field {
 public:
  Field(const CostProof::Level& level, const Terrain& terrain)
      : terrain_(terrain),
        chords_(level.intervals),
        values_(level, terrain.width(), terrain.height()) {}

  /// Reads cells and values. @param before  the cells of the level have to be cells of it
  Fault read(const Field* before) {
    return values_.read([&](std::size_t at) -> Fault {
      if (!(terrain_.at(at) < kInfinity)) return values_.named(at) + " is blocked";
      if (before != nullptr && !before->has(at))
        return values_.named(at) + " is not in the level before";
      return {};
    });
  }

  /// Every chord of every cell, and the ways from the source's centre.
  Fault check(Cell source) {
    const double* around = find(terrain_.index(source.x, source.y));
    if (around == nullptr) return "the cell that it begins in is missing";
    const double from =
        chords_.excess_from(cost::kMiddle, around, terrain_.weight(source.x, source.y));
    if (from > 1 + kMostExcess) return "values around its end are above what they cost from there";
    double most = from, greatest = 0;
    for (const std::size_t at : values_.cells()) {
      const double* values = find(at);
      const double excess = chords_.excess(values, terrain_.at(at));
      if (!(excess <= 1 + kMostExcess))
        return values_.named(at) +
               " has values that differ by more than a chord between them costs";
      most = std::max(most, excess);
      greatest = std::max(greatest, *std::max_element(values, values + chords_.places()));
    }
    // Differences of values are rounded, too.
    excess_ = most + 1e-12 + 4e-16 * chords_.intervals() * greatest / terrain_.least();
    return {};
  }

  bool has(std::size_t at) const noexcept { return values_.has(at); }
  double excess() const noexcept { return excess_; }
  const CellChords& chords() const noexcept { return chords_; }
  /// The values around a cell; null for one that is not in the level.
  const double* find(std::size_t at) const noexcept { return values_.find(at); }
  /// What no path costs less that ends in the centre of a cell; infinite off the level.
  double at_centre(Cell cell) const noexcept {
    const double* values = find(terrain_.index(cell.x, cell.y));
    if (values == nullptr) return kInfinity;
    return chords_.cheapest(cost::kMiddle, values, terrain_.weight(cell.x, cell.y)).cost / excess_;
  }

  /// visit(cell, its index, edge): edges to free cells, of `before` where there is one, that the
  /// level leaves out.
  template <class Visit>
  void each_border(const Field* before, const Visit& visit) const {
    const int beside[4] = {-terrain_.stride(), 1, terrain_.stride(), -1};
    for (const std::size_t at : values_.cells()) {
      for (int edge = 0; edge < 4; ++edge) {
        const std::size_t other = at + beside[edge];
        if (has(other) || !(terrain_.at(other) < kInfinity)) continue;
        if (before == nullptr || before->has(other)) visit(terrain_.cell(at), at, edge);
      }
    }
  }
  /// The value at `share` of an edge, clockwise.
  double along(std::size_t at, int edge, double share) const noexcept {
    const int k = chords_.intervals();
    const int low = std::min(static_cast<int>(share * k), k - 1);
    const double* values = find(at);
    const double a = values[edge * k + low], b = values[(edge * k + low + 1) % chords_.places()];
    return a + (share * k - low) * (b - a);
  }

 private:
  const Terrain& terrain_;
  CellChords chords_;
  double excess_ = 1;
  cost::LevelValues values_;
};

/// What a path that leaves a level costs at least, where `before` tells what is left from there.
double leaving(const Field& field, const Field& before) {
  double least = kInfinity;
  const int k = field.chords().intervals();
  field.each_border(&before, [&](Cell, std::size_t at, int edge) {
    for (int i = 0; i <= k; ++i) {
      const double share = static_cast<double>(i) / k;
      least = std::min(least, field.along(at, edge, share) + before.along(at, edge, share));
    }
  });
  return least / std::max(field.excess(), before.excess());
}

/// The same of the first level of cells, where the blocks tell.
double leaving(const Field& field, const Field& blocks, const Terrain& terrain,
               const Terrain& block_terrain, Cell start) {
  double beyond = kInfinity;
  blocks.each_border(nullptr, [&](Cell, std::size_t at, int edge) {
    for (const double share : {0.0, 0.5, 1.0})
      beyond = std::min(beyond, blocks.along(at, edge, share));
  });
  beyond /= blocks.excess();
  const double saved = Blocks::saved(block_terrain, start, centre(start));
  const int points = cost::EdgeField::kRestPoints * field.chords().intervals();
  const cost::StraightBound straight(terrain, centre(start));
  double least = kInfinity;
  field.each_border(nullptr, [&](Cell cell, std::size_t at, int edge) {
    const Cell block = Blocks::of(cell);
    const std::size_t block_at = block_terrain.index(block.x, block.y);
    const double* values = block == Blocks::of(start) ? nullptr : blocks.find(block_at);
    for (int i = 0; i <= points; ++i) {
      const double share = static_cast<double>(i) / points;
      const Point on_edge[4] = {{share, 0}, {1, share}, {1 - share, 1}, {0, 1 - share}};
      const Point p{cell.x + on_edge[edge].x, cell.y + on_edge[edge].y};
      double rest = straight.at(p, cell);
      if (values != nullptr) {
        const double within = Blocks::within(blocks.chords(), Blocks::inside(p, block), values,
                                             block_terrain.at(block_at));
        rest = std::max(rest, std::min(within / blocks.excess(), beyond) - saved);
      }
      // Between the points the rest falls by no more than the cell's weight.
      least = std::min(least, field.along(at, edge, share) + rest - terrain.at(at) * 0.5 / points);
    }
  });
  return least / field.excess();
}

Fault check_order(const std::vector<CostProof::Level>& levels) {
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const CostProof::Level& level = levels[i];
    const bool power = level.intervals >= 2 && level.intervals <= CellChords::kMostIntervals &&
                       std::has_single_bit(static_cast<unsigned>(level.intervals));
    const bool good = i == 0 ? level.block == Blocks::kSide && level.from_start &&
                                   level.intervals == Blocks::kIntervals
                             : level.block == 1 && level.from_start != levels[i - 1].from_start &&
                                   power && level.intervals >= levels[i - 1].intervals;
    if (!good) return "level " + number_text(i) + ": its end, block or intervals are out of order";
  }
  return {};
}

}  // namespace

std::optional<std::string> check_proof(const Grid& grid, const CostField& costs,
                                       const CostProof& proof) {
  const Terrain terrain(grid, costs);
  if (grid.hash() != proof.map_hash) return "the proof is of another map";
  if (costs.hash() != proof.costs_hash) return "the proof is of other costs";
  for (const Cell end : {proof.start, proof.goal}) {
    if (!grid.contains(end) || grid.blocked(end))
      return "the end " + pair_text(end.x, end.y) + " is no free cell of the map";
  }
  if (Fault fault = check_order(proof.levels)) return fault;
  const cost::StraightBound straight(terrain, centre(proof.start));
  double proven = straight.proven(centre(proof.goal), proof.goal);
  if (proof.levels.size() > 1) {
    const Terrain blocks = cost::blocks_of(terrain);
    std::unique_ptr<const Field> before;
    double least = kInfinity;
    for (std::size_t i = 0; i < proof.levels.size(); ++i) {
      const CostProof::Level& level = proof.levels[i];
      const Cell end = level.from_start ? proof.start : proof.goal;
      auto field = std::make_unique<Field>(level, i == 0 ? blocks : terrain);
      Fault fault = field->read(i > 1 ? before.get() : nullptr);
      if (!fault) fault = field->check(i == 0 ? Blocks::of(end) : end);
      if (fault) return "level " + number_text(i) + ": " + *fault;
      if (i == 1) least = leaving(*field, *before, terrain, blocks, proof.start);
      if (i > 1) least = std::min(least, leaving(*field, *before));
      before = std::move(field);
    }
    const Cell other = proof.levels.back().from_start ? proof.goal : proof.start;
    proven = std::max(proven, std::min(least, before->at_centre(other)));
  }
  if (proof.lower_bound <= proven) return {};
  return "the bound is " + number_text(proof.lower_bound) + ", the levels prove " +
         number_text(proven);
}

}  // namespace lasius
