#include "bench/peers/row_ceiling.h"

#include <array>
#include <random>

namespace lasius::peers {

RowCeiling::RowCeiling(int width, int height, std::uint64_t seed)
    : width_(width),
      height_(height),
      rows_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
  std::mt19937_64 random(seed);
  for (Row& row : rows_) {
    for (std::uint32_t& word : row.words) word = static_cast<std::uint32_t>(random());
  }
}

std::uint64_t RowCeiling::walk(Path path, int walkers, std::int64_t steps) {
  const bool jump = path == Path::jump;
  if (walkers == 1) return jump ? jump_with<1>(steps) : walk_with<1>(steps);
  return jump ? jump_with<8>(steps) : walk_with<8>(steps);
}

template <int W>
std::uint64_t RowCeiling::jump_with(std::int64_t steps) {
  const auto size = static_cast<std::uint64_t>(rows_.size());
  const Row* const rows = rows_.data();
  std::array<std::uint64_t, W> at{};
  for (std::size_t i = 0; i < W; ++i) at[i] = i * size / W;
  std::uint64_t sum = 0;
  for (std::int64_t done = 0; done < steps; done += W) {
    for (std::uint64_t& a : at) {
      std::uint32_t word = static_cast<std::uint32_t>(done);  // or the table's cycles would show
      for (const std::uint32_t w : rows[a].words) word += w;
      a = word * size >> 32;
      sum += word;
    }
  }
  return sum;
}

template <int W>
std::uint64_t RowCeiling::walk_with(std::int64_t steps) {
  const std::int64_t size = static_cast<std::int64_t>(width_) * height_;
  // East, south-east or south, by two bits of the row: as ants go that know where the goal is.
  const std::array<std::int64_t, 4> moves = {1, width_ + 1, width_ + 1, width_};
  const Row* const rows = rows_.data();
  std::array<std::int64_t, W> at{};
  std::uint64_t sum = 0;
  for (std::int64_t done = 0; done < steps;) {
    for (std::int64_t& a : at) {
      place_ = place_ * 6364136223846793005u + 1442695040888963407u;
      a = static_cast<std::int64_t>((place_ >> 32) % static_cast<std::uint64_t>(size));
    }
    for (int step = 0; step < height_; ++step) {
      for (std::int64_t& a : at) {
        std::uint32_t word = 0;
        for (const std::uint32_t w : rows[a].words) word += w;
        a += moves[word >> 30];
        a = a >= size ? a - size : a;
        sum += word;
      }
    }
    done += static_cast<std::int64_t>(W) * height_;
  }
  return sum;
}

}  // namespace lasius::peers
