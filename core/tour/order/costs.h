// What the order of stops costs: whole numbers, so that sums are exact and nothing needs a
// tolerance.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lasius::tour {

/// Of a leg, at least 0 and at most kLargest.
using Cost = std::int32_t;
constexpr Cost kLargest = 500'000'000;

/// Costs that are found when they are first asked for. Symmetric. One thread at a time.
class Pricer {
 public:
  virtual ~Pricer() = default;
  virtual Cost price(int a, int b) = 0;        ///< the cost itself
  virtual Cost lower(int a, int b) const = 0;  ///< at most the cost; the cost where it is known
  virtual Cost largest() const = 0;            ///< no cost is above
};

/// The symmetric costs between `size` stops: a matrix of size * size numbers, or a pricer's.
/// Holds neither.
class Costs {
 public:
  Costs(int size, const Cost* matrix) noexcept : size_(size), matrix_(matrix) {}
  /// `late`: a price may take long, so as few as can be are asked for.
  Costs(int size, Pricer& pricer, bool late = true) noexcept
      : size_(size), late_(late), pricer_(&pricer) {}

  int size() const noexcept { return size_; }
  bool priced_late() const noexcept { return late_; }
  Cost operator()(int a, int b) const {
    return matrix_ != nullptr ? matrix_[static_cast<std::size_t>(a) * size_ + b]
                              : pricer_->price(a, b);
  }
  /// At most the cost.
  Cost lower(int a, int b) const {
    return matrix_ != nullptr ? (*this)(a, b) : pricer_->lower(a, b);
  }
  Cost largest() const {
    if (matrix_ == nullptr) return pricer_->largest();
    Cost most = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(size_) * size_; ++i)
      if (matrix_[i] > most) most = matrix_[i];
    return most;
  }

 private:
  int size_;
  bool late_ = false;
  const Cost* matrix_ = nullptr;
  Pricer* pricer_ = nullptr;
};

/// Which ends a tour has.
struct Ends {
  bool open = false;  ///< else closed: a start is then only where the order begins, and no goal
  int start = -1;     ///< the first stop; -1: any
  int goal = -1;      ///< the last one, another than the start; -1: any
};

/// The cost of an order of stops, with the way back where it is closed.
inline std::int64_t cost_of(const Costs& costs, const std::vector<int>& order, bool open) {
  std::int64_t sum = 0;
  for (std::size_t i = 1; i < order.size(); ++i) sum += costs(order[i - 1], order[i]);
  if (!open && order.size() > 1) sum += costs(order.back(), order.front());
  return sum;
}

}  // namespace lasius::tour
