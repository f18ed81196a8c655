// What a search needs for each cell, kept from one search to the next.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/base/bucket_queue.h"
#include "core/vehicle/flood.h"
#include "core/vehicle/lattice_flood.h"

namespace lasius::vehicle {

/// States of the lattice that were entered, a block a cell.
template <class State>
class States {
 public:
  /// Forgets what was entered. The map is always the same.
  void reset(const Space::Impl& space, int layers) {
    width_ = space.width();
    per_cell_ = Lattice::kHeadings * layers;
    block_.resize(static_cast<std::size_t>(width_) * space.height(), -1);
    for (const Cell& c : cells_) block_[static_cast<std::size_t>(c.y) * width_ + c.x] = -1;
    cells_.clear();
    states_.clear();
    if (states_.capacity() > kKept) states_.shrink_to_fit();
  }
  std::uint32_t index(int x, int y, int heading, int layer) {
    std::int32_t& block = block_[static_cast<std::size_t>(y) * width_ + x];
    if (block < 0) {
      block = static_cast<std::int32_t>(cells_.size());
      cells_.push_back({x, y});
      states_.resize(states_.size() + per_cell_);
    }
    return static_cast<std::uint32_t>(block * per_cell_ + layer * Lattice::kHeadings + heading);
  }
  /// The state if its cell was entered.
  State* find(int x, int y, int heading, int layer) {
    const std::int32_t block = block_[static_cast<std::size_t>(y) * width_ + x];
    return block < 0 ? nullptr
                     : &states_[static_cast<std::size_t>(block) * per_cell_ +
                                static_cast<std::size_t>(layer) * Lattice::kHeadings + heading];
  }
  State& operator[](std::uint32_t index) { return states_[index]; }
  Cell cell(std::uint32_t index) const { return cells_[index / per_cell_]; }
  int heading(std::uint32_t index) const { return static_cast<int>(index % Lattice::kHeadings); }
  int layer(std::uint32_t index) const {
    return static_cast<int>(index % per_cell_) / Lattice::kHeadings;
  }
  std::int64_t size() const { return static_cast<std::int64_t>(states_.size()); }

 private:
  static constexpr std::size_t kKept = std::size_t{1} << 22;
  int width_ = 0;
  int per_cell_ = 0;
  std::vector<std::int32_t> block_;
  std::vector<Cell> cells_;
  std::vector<State> states_;
};

constexpr std::int32_t kNoEdge = std::numeric_limits<std::int32_t>::min();

/// Forwards: the cost from the start, and how the state was reached.
struct Reached {
  float cost = std::numeric_limits<float>::infinity();
  float left = -1;            ///< estimate of the cost to a goal; -1: not yet asked
  std::uint32_t before = 0;   ///< state
  std::int32_t by = kNoEdge;  ///< edge; below 0: ~connector
  bool expanded = false;
};
/// Backwards: the cost to a goal, and the way.
struct Leads {
  float cost = std::numeric_limits<float>::infinity();
  std::uint32_t next = 0;
  std::int32_t by = kNoEdge;
  bool expanded = false;
};

/// Of one search at a time.
struct SearchMemory {
  States<Reached> reached;
  States<Leads> leads;
  Flood::Memory flood;
  LatticeFlood::Memory lattice_flood;
  BucketQueue queue, probe;
};

}  // namespace lasius::vehicle
