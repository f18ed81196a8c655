// An order that is given in part: which stops come before which, and what may be carried.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "core/tour/order/rows.h"

namespace lasius::tour {

/// A stop that comes before another.
using Before = std::pair<int, int>;

/// The stops of a circle, each before the next and the last before the first; empty where the
/// relation has none.
std::vector<int> circle_of(int size, std::span<const Before> relation);

/// Which stops come before which, and the load that each adds to what is carried, which never
/// exceeds the capacity. Takes size * size bits.
class PartialOrder {
 public:
  static constexpr std::int64_t kUnlimited = std::numeric_limits<std::int64_t>::max();

  /// Any order will do.
  PartialOrder() = default;
  /// `relation` has no circle; `loads` are one a stop, or none.
  PartialOrder(int size, std::span<const Before> relation, std::vector<int> loads = {},
               std::int64_t capacity = kUnlimited);

  bool any_order() const noexcept { return next_.empty() && !limited(); }
  bool has_relation() const noexcept { return !next_.empty(); }
  bool limited() const noexcept { return capacity_ != kUnlimited; }
  std::int64_t capacity() const noexcept { return capacity_; }
  int load(int stop) const noexcept { return loads_.empty() ? 0 : loads_[stop]; }

  /// Whether `a` comes before `b`, over others too.
  bool before(int a, int b) const noexcept {
    return words_ > 0 && later_[a * words_ + b / 64] >> (b % 64) & 1;
  }
  /// Whether no order has `b` right behind `a`.
  bool parted(int a, int b) const noexcept;
  /// What comes behind a stop, and before it, with no other between (the transitive reduction).
  std::span<const int> next(int stop) const noexcept { return next_[stop]; }
  std::span<const int> previous(int stop) const noexcept { return previous_[stop]; }
  /// Whether no more is carried than may be, from stop to stop of an order.
  bool carries(std::span<const int> order) const noexcept;

 private:
  std::size_t words_ = 0;             // of a row
  std::vector<std::uint64_t> later_;  // row by row: the stops behind each
  Rows<int> next_, previous_;
  std::vector<int> loads_;
  std::int64_t capacity_ = kUnlimited;
};

}  // namespace lasius::tour
