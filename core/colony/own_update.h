// A caller's own rules in a colony on a bitmap.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/held_bytes.h"
#include "core/base/large_array.h"
#include "core/colony/update.h"
#include "lasius/grid/grid.h"
#include "lasius/params/own_rules.h"
#include "lasius/params/params.h"

namespace lasius {

/// @throws Error(invalid_parameter) where rules do not go with a map or with parameters, which are
/// valid.
void check_own_rules(const OwnRules& own, const Grid& grid, const Params& params);

/// Where nothing is the caller's own.
inline const OwnRules& no_own_rules() {
  static const OwnRules none;
  return none;
}

/// The weights of an iteration by the caller's own schedule, which there is.
/// @throws Error(invalid_parameter) for one out of range.
StepWeights own_weights(const OwnRules& own, const Params& params, int iteration);

/// The tours of an iteration as numbers of cells and moves, written when they are asked for.
class NumberedTours {
 public:
  /// What an update is given of these tours, which outlive its use. Memory is used again unless the
  /// caller keeps that of a view.
  IterationTours view(const Tours& tours, const Grid& grid, Trail trail);

  /// Of one of the tours, that of the best so far after those of the ants.
  std::span<const TrailPlace> cells_of(int tour) noexcept;
  std::span<const TrailPlace> arcs_of(int tour) noexcept;
  /// Of the ants' tours.
  std::span<const TrailPlace> cells() noexcept;
  std::span<const TrailPlace> arcs() noexcept;
  int ants() const noexcept { return static_cast<int>(tours_->ants.size()); }

  std::int64_t bytes() const noexcept {
    return held_bytes(written_) + (lists_ == nullptr ? 0 : lists_->bytes());
  }

 private:
  struct Lists {
    GrowingArray<TrailPlace> cells, arcs;  // of all tours, that of the best so far last
    std::vector<std::int64_t> offsets;     // of a tour's first cell, and the end
    std::vector<double> lengths;           // of the ants' tours
    std::vector<int> ranked;

    std::int64_t bytes() const noexcept {
      return cells.bytes() + arcs.bytes() + held_bytes(offsets, lengths, ranked);
    }
  };
  enum Written : std::uint8_t { kCells = 1, kArcs = 2 };

  const Tour& tour(int number) const noexcept {
    return number < ants() ? tours_->ants[number] : tours_->best_so_far;
  }
  /// From a cell to the next, by move.
  std::array<TrailPlace, kernels::kMaxMoves> steps() const noexcept;

  std::shared_ptr<Lists> lists_;
  std::vector<std::uint8_t> written_;  // by tour: what of it is in the lists
  const Tours* tours_ = nullptr;
  TrailPlace start_ = 0;
  int width_ = 0;
};

}  // namespace lasius
