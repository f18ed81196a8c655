// Lists of different lengths, one behind another.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace lasius::tour {

template <class T>
class Rows {
 public:
  /// Puts an item into the last row, which is not ended yet.
  void push(const T& item) { items_.push_back(item); }
  void end_row() { ends_.push_back(items_.size()); }
  bool empty() const noexcept { return items_.empty(); }
  /// Nothing of rows that were never made.
  std::span<const T> operator[](int row) const noexcept {
    const auto i = static_cast<std::size_t>(row);
    if (i >= ends_.size()) return {};
    const std::size_t begin = i == 0 ? 0 : ends_[i - 1];
    return {items_.data() + begin, ends_[i] - begin};
  }

 private:
  std::vector<T> items_;
  std::vector<std::size_t> ends_;
};

}  // namespace lasius::tour
