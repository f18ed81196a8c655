#include "core/vehicle/mask.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace lasius::vehicle {

Masks::Mask Masks::add(const std::vector<Row>& rows) {
  int left = rows[0].first;
  int right = rows[0].last;
  int top = rows[0].y;
  int bottom = top;
  for (const Row& row : rows) {
    left = std::min(left, row.first);
    right = std::max(right, row.last);
    top = std::min(top, row.y);
    bottom = std::max(bottom, row.y);
  }
  Mask mask{static_cast<int>(columns_.size()), (right - left) / 64 + 1, 0};
  std::vector<std::uint64_t> bits(bottom - top + 1);
  for (int x = left; x <= right; x += 64) {
    std::ranges::fill(bits, 0);
    for (const Row& row : rows) {
      const int first = std::max(row.first, x) - x;
      const int last = std::min(row.last, x + 63) - x;
      if (first > last) continue;
      bits[row.y - top] |= (~std::uint64_t{0} << first) & (~std::uint64_t{0} >> (63 - last));
    }
    const auto used = [](std::uint64_t word) { return word != 0; };
    const auto begin = std::ranges::find_if(bits, used);
    const auto end = std::find_if(bits.rbegin(), bits.rend(), used).base();
    const auto used_rows = static_cast<int>(std::max<std::ptrdiff_t>(0, end - begin));
    const int padded =
        (used_rows + kernels::kMaskRows - 1) / kernels::kMaskRows * kernels::kMaskRows;
    columns_.push_back({x, top + static_cast<int>(begin - bits.begin()), padded, words_.size()});
    words_.insert(words_.end(), begin, begin + used_rows);
    words_.resize(columns_.back().first + padded);
  }
  mask.reach = reach_of(mask.first, mask.count);
  return mask;
}

Masks::Mask Masks::moved(const Mask& mask, int x, int y) {
  Mask to{static_cast<int>(columns_.size()), mask.count, 0};
  for (int c = mask.first; c < mask.first + mask.count; ++c) {
    MaskColumn column = columns_[c];
    column.x -= x;
    column.y -= y;
    columns_.push_back(column);
  }
  to.reach = reach_of(to.first, to.count);
  return to;
}

std::vector<Masks::Row> Masks::rows(const Mask& mask) const {
  std::vector<Row> runs;
  for (int c = mask.first; c < mask.first + mask.count; ++c) {
    const MaskColumn& column = columns_[c];
    for (int i = 0; i < column.rows; ++i) {
      std::uint64_t left = words_[column.first + i];
      while (left != 0) {
        const int first = std::countr_zero(left);
        const int length = std::countr_one(left >> first);
        runs.push_back({column.y + i, column.x + first, column.x + first + length - 1});
        left = first + length < 64 ? left & (~std::uint64_t{0} << (first + length)) : 0;
      }
    }
  }
  return runs;
}

float Masks::reach_of(int first, int count) const noexcept {
  double most = 0;
  for (int c = first; c < first + count; ++c) {
    const MaskColumn& column = columns_[c];
    for (int i = 0; i < column.rows; ++i) {
      const std::uint64_t word = words_[column.first + i];
      if (word == 0) continue;
      const double y = std::abs(column.y + i) + 0.5;
      const int low = column.x + std::countr_zero(word);
      const int high = column.x + 63 - std::countl_zero(word);
      const double x = std::max(std::abs(low), std::abs(high)) + 0.5;
      most = std::max(most, x * x + y * y);
    }
  }
  return static_cast<float>(std::sqrt(most) + 1e-3);
}

}  // namespace lasius::vehicle
