#include <bit>

#include "core/disc/space_builder.h"

namespace lasius::disc {

CornerRows::CornerRows(const Grid& grid)
    : height_(grid.height()), stride_(static_cast<std::size_t>(grid.words()) + 2) {
  const std::size_t size = (static_cast<std::size_t>(height_) + 1) * stride_;
  for (auto& rows : rows_) rows.assign(size, 0);
  ranks_.assign(size, 0);
  for (int y = 1; y < height_; ++y) {
    const std::uint64_t* above = grid.row(y - 1);
    const std::uint64_t* below = grid.row(y);
    for (int i = 0; i < grid.words(); ++i) {
      const std::uint64_t ne = above[i], nw = above[i] << 1 | above[i - 1] >> 63;
      const std::uint64_t se = below[i], sw = below[i] << 1 | below[i - 1] >> 63;
      const std::uint64_t one = (ne ^ nw ^ se ^ sw) & ~((ne & nw) | (se & sw));
      const std::size_t word = at(y) + static_cast<std::size_t>(i);
      rows_[0][word] = one & nw;
      rows_[1][word] = one & ne;
      rows_[2][word] = one & sw;
      rows_[3][word] = one & se;
      ranks_[word] = static_cast<std::uint32_t>(corners_.size());
      for (std::uint64_t left = one; left != 0; left &= left - 1) {
        const int bit = std::countr_zero(left);
        std::uint32_t type = 0;
        while ((rows_[type][word] >> bit & 1) == 0) ++type;
        corners_.push_back(
            {static_cast<std::uint16_t>(64 * i + bit), static_cast<std::uint16_t>(y), type});
      }
    }
  }
}

std::uint32_t CornerRows::number(int x, int y) const noexcept {
  const std::size_t word = at(y) + static_cast<std::size_t>(x >> 6);
  const std::uint64_t all = rows_[0][word] | rows_[1][word] | rows_[2][word] | rows_[3][word];
  const std::uint64_t below = all & ((std::uint64_t{1} << (x & 63)) - 1);
  return ranks_[word] + static_cast<std::uint32_t>(std::popcount(below));
}

std::uint64_t CornerRows::window(std::uint32_t type, int x, int y) const noexcept {
  if (y < 0 || y > height_) return 0;
  const std::uint64_t* word = rows_[type].data() + at(y) + (x >> 6);
  const int shift = x & 63;
  return shift == 0 ? word[0] : word[0] >> shift | word[1] << (64 - shift);
}

}  // namespace lasius::disc
