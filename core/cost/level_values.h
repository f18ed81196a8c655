// The cells of a level of a proof and the values around them, as its lists have them.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/number_text.h"
#include "lasius/cost/proof.h"
#include "lasius/grid/geometry.h"

namespace lasius::cost {

/// Of a map, or of its blocks, of width x height cells.
class LevelValues {
 public:
  LevelValues(const CostProof::Level& level, int width, int height)
      : level_(level), width_(width), height_(height) {}

  /// Reads the lists. Their first fault, or the first cell's of which `fault_of` an index tells
  /// one.
  template <class FaultOf>
  std::optional<std::string> read(const FaultOf& fault_of) {
    const std::vector<int>& runs = level_.runs;
    slot_.assign(static_cast<std::size_t>(stride()) * (height_ + 2), -1);
    if (runs.empty() || runs.size() % 3 != 0) return "runs are not of three numbers";
    std::size_t next = 0;
    std::int64_t last = -1;
    for (std::size_t i = 0; i < runs.size(); i += 3) {
      const int y = runs[i], x = runs[i + 1], count = runs[i + 2];
      if (y < 0 || y >= height_ || x < 0 || count < 1 || count > width_ - x)
        return "the run at " + pair_text(x, y) + " leaves the map";
      if (static_cast<std::int64_t>(index(x, y)) <= last)
        return "the run at " + pair_text(x, y) + " is out of order";
      for (int j = x; j < x + count; ++j) {
        const std::size_t at = index(j, y);
        last = static_cast<std::int64_t>(at);
        if (auto fault = fault_of(at)) return fault;
        if (auto fault = add(at, next)) return fault;
      }
    }
    if (next != level_.values.size()) return "there are more values than places for them";
    return {};
  }

  const std::vector<std::size_t>& cells() const noexcept { return cells_; }  ///< indices
  bool has(std::size_t at) const noexcept { return slot_[at] >= 0; }
  /// The values around a cell, clockwise from its upper left corner; null for one that is not in
  /// the level.
  const double* find(std::size_t at) const noexcept {
    return has(at) ? values_.data() + slot_[at] * places() : nullptr;
  }
  /// As of Terrain: with a border of one cell.
  std::size_t index(int x, int y) const noexcept {
    return static_cast<std::size_t>(y + 1) * stride() + (x + 1);
  }
  Cell cell(std::size_t index) const noexcept {
    return {static_cast<int>(index % stride()) - 1, static_cast<int>(index / stride()) - 1};
  }
  std::string named(std::size_t at) const {
    return (level_.block > 1 ? "block " : "cell ") + pair_text(cell(at).x, cell(at).y);
  }

 private:
  int stride() const noexcept { return width_ + 2; }
  int places() const noexcept { return 4 * level_.intervals; }

  /// Values on an edge that it shares with the cell above or left of it are theirs.
  std::optional<std::string> add(std::size_t at, std::size_t& next) {
    const int k = level_.intervals;
    values_.resize(values_.size() + places());
    slot_[at] = static_cast<std::int64_t>(cells_.size());
    cells_.push_back(at);
    double* values = values_.data() + values_.size() - places();
    const double *above = find(at - stride()), *left = find(at - 1);
    for (int place = 0; place < places(); ++place) {
      const bool on_top = above != nullptr && place <= k;
      const bool on_left = left != nullptr && (place >= 3 * k || place == 0);
      if (!on_top && !on_left) {
        if (next == level_.values.size()) return "values are missing from " + named(at) + " on";
        values[place] = level_.values[next++];
        if (!std::isfinite(values[place])) return named(at) + " has a value that is no number";
        continue;
      }
      values[place] = on_top ? above[3 * k - place] : left[place == 0 ? k : 5 * k - place];
      if (on_top && on_left && values[place] != left[k])
        return named(at) + " has two values in a corner";
    }
    return {};
  }

  const CostProof::Level& level_;
  int width_, height_;
  std::vector<std::int64_t> slot_;  // by index, -1: none
  std::vector<std::size_t> cells_;
  std::vector<double> values_;
};

}  // namespace lasius::cost
