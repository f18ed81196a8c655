// Where a map changed, until somebody asks.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/held_bytes.h"
#include "core/grid/changed_parts.h"

namespace lasius {

/// Rectangles in which cells changed; those beside each other become one.
class PendingParts {
 public:
  void add(const Rectangle& part) {
    if (!parts_.empty()) {
      Rectangle& last = parts_.back();
      const Rectangle both = round_both(last, part);
      if (area(both) <= 4 * (area(last) + area(part))) {
        last = both;
        return;
      }
    }
    parts_.push_back(part);
    constexpr std::size_t kMost = 256;  // where nobody asks
    if (parts_.size() < kMost) return;
    Rectangle all = part;
    for (const Rectangle& one : parts_) all = round_both(all, one);
    parts_.assign(1, all);
  }
  const std::vector<Rectangle>& parts() const noexcept { return parts_; }
  void drop_last() noexcept { parts_.pop_back(); }
  void clear() noexcept { parts_.clear(); }
  std::int64_t bytes() const noexcept { return held_bytes(parts_); }

 private:
  static std::int64_t area(const Rectangle& r) noexcept { return std::int64_t{r.width} * r.height; }

  std::vector<Rectangle> parts_;
};

}  // namespace lasius
