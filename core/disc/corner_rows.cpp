#include "core/disc/corner_rows.h"

#include <algorithm>
#include <bit>

#include "core/disc/bit_rows.h"

namespace lasius::disc {

CornerRows::CornerRows(const Grid& grid, const Words& part)
    : part_(part),
      stride_(static_cast<std::size_t>(part.last - part.first) + 2),
      words_((static_cast<std::size_t>(part.bottom - part.top) + 1) * stride_ + 1),
      ranks_(words_.size()) {
  for (int y0 = part.top & ~7; y0 <= part.bottom; y0 += 8) {
    for (int i = part.first; i < part.last; ++i) {
      for (int y = std::max(y0, part.top); y <= std::min(y0 + 7, part.bottom); ++y) {
        const std::uint64_t* above = grid.row(y - 1);
        const std::uint64_t* below = grid.row(y);
        const std::uint64_t ne = above[i], nw = above[i] << 1 | above[i - 1] >> 63;
        const std::uint64_t se = below[i], sw = below[i] << 1 | below[i - 1] >> 63;
        const std::uint64_t one = (ne ^ nw ^ se ^ sw) & ~((ne & nw) | (se & sw));
        ranks_[at(i, y)] = static_cast<std::uint32_t>(corners_.size());
        if (one == 0) continue;
        words_[at(i, y)] = {one & nw, one & ne, one & sw, one & se};
        for (std::uint64_t left = one; left != 0; left &= left - 1) {
          const std::uint64_t bit = left & (0 - left);
          const std::uint32_t type = (bit & (ne | se)) != 0 ? 1u : 0u;
          const std::uint32_t down = (bit & (sw | se)) != 0 ? 2u : 0u;
          corners_.push_back({static_cast<std::uint16_t>(64 * i + std::countr_zero(left)),
                              static_cast<std::uint16_t>(y), type | down});
        }
      }
    }
  }
}

std::uint32_t CornerRows::number(int x, int y) const noexcept {
  const std::size_t at_word = at(x >> 6, y);
  const Word& word = words_[at_word];
  const std::uint64_t all = word[0] | word[1] | word[2] | word[3];
  return ranks_[at_word] + count_bits(all & ((std::uint64_t{1} << (x & 63)) - 1));
}

}  // namespace lasius::disc
