// How far cells are from the goals for a vehicle that only has to fit.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/poller.h"
#include "core/vehicle/lattice.h"
#include "core/vehicle/prices.h"
#include "core/vehicle/sweep.h"

namespace lasius::vehicle {

/// For each cell a bit a heading: whether the footprint is free at its centre.
class FreeHeadings {
 public:
  /// Stops where the poller asks to; what is left then is not free.
  FreeHeadings(const Space::Impl& space, const Lattice& lattice, Poller& poller);
  std::uint16_t at(int x, int y) const noexcept {
    return bits_[static_cast<std::size_t>(y) * width_ + x];
  }
  std::uint16_t operator[](std::size_t cell) const noexcept { return bits_[cell]; }

 private:
  int width_;
  std::vector<std::uint16_t> bits_;
};

/// Distances over eight neighbours, told as far as they are asked for. A step is one where the
/// vehicle is free at both ends at a heading near the step's direction. Of a step along a row or
/// column 29 units, along a diagonal 41: never more than its length. Over weights a step is that
/// times the mean of both, at most 16 * kBuckets.
class Flood {
 public:
  static constexpr int kUnits = 29;

  /// Of one flood at a time, on one map.
  struct Memory {
    std::vector<std::int32_t> distance;
    std::vector<std::uint32_t> touched;
    std::vector<std::vector<std::uint32_t>> buckets;
  };

  /// @param squeeze  where only the disc in the footprint fits, a step counts fourfold; else there
  /// is none
  /// @param poller  once it stopped, cells that are not known yet are infinitely far
  Flood(const FreeHeadings& free, const Space::Impl& space, const Prices& prices, bool squeeze,
        Memory& memory, Poller& poller);
  /// A cell from which a goal is so far, any number of at least 0; before the first question.
  void add_source(int x, int y, double cells);
  /// Cells to the goals; infinite where there is no way. Beyond 3e7 more than the nearest source
  /// has it is that much.
  double at(int x, int y) {
    const std::size_t cell = static_cast<std::size_t>(y) * width_ + x;
    while (memory_.distance[cell] > level_ && waiting_ > 0 && !poller_.stopped()) advance();
    const std::int32_t distance = memory_.distance[cell];
    return distance == kFar ? kInfinite : (first_ + distance) * (1.0 / kUnits);
  }

 private:
  static constexpr int kBuckets = 256;  ///< more than the longest step has
  static constexpr int kWeighted = 16;  ///< times as many, over weights
  static constexpr int kUnfit = 4;      ///< times the length of a step that does not fit
  static constexpr std::int32_t kFar = 1 << 30;
  static constexpr std::int32_t kLast = kFar - 1;  ///< what is farther has this level
  static constexpr double kInfinite = 1e30;
  void begin();
  void advance();
  void put(std::size_t cell, std::int32_t distance);

  const FreeHeadings& free_;
  const Prices& prices_;
  const std::vector<std::int32_t>& clearance_;  ///< of centres, squared, in half cells
  bool squeeze_;
  std::int32_t needed_;  ///< by the disc
  int width_, height_;
  std::int32_t buckets_;
  std::array<std::uint16_t, 8> near_{};  ///< headings for a step
  Memory& memory_;
  Poller& poller_;
  std::vector<std::pair<double, std::uint32_t>> sources_;  ///< units; by cell then
  double first_ = 0;  ///< units of the least source, which has level 0: levels are of 32 bits
  std::size_t next_source_ = 0;
  std::int32_t level_ = -1;
  std::int64_t waiting_ = 0;
};

}  // namespace lasius::vehicle
