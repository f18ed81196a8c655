// The most that any walk on rows of weights can do: load one row a step, and nothing else.
#pragma once

#include <cstdint>
#include <vector>

namespace lasius::peers {

/// A table of 32-byte rows, one a cell, and walkers on it. A step loads the whole row of its cell
/// and goes where the row says. Walkers are interleaved, as the loads of one depend on each other.
class RowCeiling {
 public:
  enum class Path {
    walk,  ///< to a cell next to it, from scattered starts, `height` steps each: caches help
    jump,  ///< to any cell: the memory system as it is
  };

  RowCeiling(int width, int height, std::uint64_t seed = 1);
  /// Makes `steps` steps with 1 or 8 interleaved walkers; returns a checksum.
  std::uint64_t walk(Path path, int walkers, std::int64_t steps);

 private:
  struct alignas(32) Row {
    std::uint32_t words[8];
  };
  template <int W>
  std::uint64_t walk_with(std::int64_t steps);
  template <int W>
  std::uint64_t jump_with(std::int64_t steps);

  int width_, height_;
  std::vector<Row> rows_;
  std::uint64_t place_ = 1;  // of the generator of starts
};

}  // namespace lasius::peers
