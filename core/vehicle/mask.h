// Cells that a motion of the lattice meets over its whole sweep, as bits.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/kernel_choice.h"
#include "core/vehicle/bit_columns.h"
#include "kernels/base/mask.h"

namespace lasius::vehicle {

/// Up to 64 columns of a mask.
struct MaskColumn {
  int x = 0, y = 0;       ///< of its first bit, from the cell that the motion begins in
  int rows = 0;           ///< words, zeros at the end among them: a multiple of kMaskRows
  std::size_t first = 0;  ///< of its words
};

/// Masks, whose words lie in one pool.
class Masks {
 public:
  struct Mask {
    int first = 0, count = 0;  ///< columns
    float reach = 0;           ///< no cell of it is farther from the middle of the first cell
  };
  /// Cells as rows of (first, last) columns that may overlap.
  struct Row {
    int y, first, last;
  };

  Mask add(const std::vector<Row>& rows);
  /// The same seen from the cell (x, y).
  Mask moved(const Mask& mask, int x, int y);

  /// Whether nothing of the mask is blocked when its motion begins at cell (x, y).
  bool free(const Mask& mask, const BitColumns& bits, int x, int y) const noexcept {
    for (int c = mask.first; c < mask.first + mask.count; ++c) {
      const MaskColumn& column = columns_[c];
      const int left = x + column.x;
      const std::uint64_t* a = bits.from(left, y + column.y);
      const std::uint64_t* b = a + bits.rows();
      const std::uint64_t* m = words_.data() + column.first;
      if (meets_(a, b, m, column.rows, bits.shift(left))) return false;
    }
    return true;
  }
  /// Its cells, as rows that do not overlap, of at most 64 columns.
  std::vector<Row> rows(const Mask& mask) const;

 private:
  float reach_of(int first, int count) const noexcept;

  kernels::MeetsFn meets_ = kernels::meets_mask(chosen_isa());
  std::vector<MaskColumn> columns_;
  std::vector<std::uint64_t> words_;
};

}  // namespace lasius::vehicle
