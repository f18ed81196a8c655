// The cost of every state of a lattice from the start, 64 cells at a time.
#pragma once

#include <array>
#include <cmath>
#include <compare>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "core/vehicle/connectors.h"
#include "core/vehicle/edge_planes.h"
#include "core/vehicle/steering.h"

namespace lasius::vehicle {

/// Dijkstra from the start, whose costs are whole numbers of kUnit cells (of edges at
/// least one): the states of one level and heading lie beside each other, and a motion takes a word
/// of them with a shift and an and. For searches that would enter most of the lattice.
class LatticeFlood {
 public:
  static constexpr double kUnit = 0.2;  ///< straight motions of 1, 1.41 and 2.24 cells: 5, 7 and 11
  static constexpr int kBuckets = 1024;
  static constexpr std::uint16_t kNever = std::numeric_limits<std::uint16_t>::max();

  /// Candidates of a level: bits of a word of a heading's plane.
  struct Item {
    std::uint32_t word;
    std::uint64_t bits;
  };
  /// Of one flood at a time, on one map.
  struct Memory {
    std::vector<std::uint16_t> level;
    std::vector<std::uint64_t> open;
    std::array<std::vector<Item>, kBuckets> buckets;
  };
  /// A state, and a bound from below of what a path by it costs.
  struct Try {
    double total = 0;
    int x = 0, y = 0, heading = 0;
    auto operator<=>(const Try&) const = default;
  };

  /// Whether every motion costs less than kBuckets units.
  static bool takes(const Lattice& lattice) noexcept;
  static int units(double cost) noexcept {
    return static_cast<int>(std::floor(cost / kUnit + 0.5));
  }
  /// Of a start; kNever where it is dearer than every level.
  static int units(const Connector& start) noexcept {
    return start.cost < (kNever - 1) * kUnit ? units(start.cost) : kNever;
  }
  static int units(const Edge& edge) noexcept {
    const int whole = units(static_cast<double>(edge.cost));
    return whole > 0 ? whole : 1;
  }

  LatticeFlood(const EdgePlanes& planes, const Lattice& lattice, int width, int height,
               Memory& memory);
  /// Until no end can be cheaper than the best one. Its index; -1: none was reached, or stopped.
  /// @param levels  at most kNever
  int run(std::span<const Connector> starts, std::span<const Connector> ends, Poller& poller,
          int levels = kNever);
  /// Whether the last run ended because of what is dearer than its levels: a cheapest way may be
  /// among that.
  bool ran_out() const noexcept { return ran_out_; }
  /// In units, from a start; kNever where that is not known.
  std::uint16_t level(int x, int y, int heading) const noexcept {
    return memory_.level[(static_cast<std::size_t>(heading) * height_ + y) * width_ + x];
  }
  double cost(int x, int y, int heading) const noexcept { return kUnit * level(x, y, heading); }
  /// Appends the path to a state that was reached. @param starts  as run() had them
  void append(std::span<const Connector> starts, Cell at, int heading,
              std::vector<Segment>& to) const;
  /// What was reached no farther than `far` from a goal along each axis, from which a way may cost
  /// less than `most`; the most promising first.
  std::vector<Try> about(const Pose& goal, double far, double most, Steering& steering,
                         Poller& poller) const;

 private:
  void settle(const Item& item, int level);
  /// The edge by which a state was reached.
  int last(int x, int y, int heading) const noexcept;

  const EdgePlanes& planes_;
  const Lattice& lattice_;
  int width_, height_, words_;
  Memory& memory_;
  std::int64_t waiting_ = 0;
  bool ran_out_ = false;
};

}  // namespace lasius::vehicle
