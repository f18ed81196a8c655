#include "core/grid/changed_parts.h"

#include <algorithm>
#include <cstdint>

namespace lasius {

Rectangle widened(const Rectangle& part, int margin, const Grid& map) noexcept {
  const int left = std::max(0, part.x - margin), top = std::max(0, part.y - margin);
  const int right = std::min(map.width(), part.x + part.width + margin);
  const int bottom = std::min(map.height(), part.y + part.height + margin);
  return {left, top, right - left, bottom - top};
}

ChangedParts parts_of(std::span<const Cell> changed, int margin, const Grid& map) {
  const auto cost = [&](const Rectangle& part) {
    const Rectangle wide = widened(part, margin, map);
    return std::int64_t{wide.width} * wide.height;
  };
  ChangedParts found{};
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < changed.size(); ++i) {
    const Rectangle one{changed[i].x, changed[i].y, 1, 1};
    const Rectangle last = found.parts.empty() ? one : found.parts.back().cells;
    const int left = std::min(last.x, one.x), top = std::min(last.y, one.y);
    const Rectangle both{left, top, std::max(last.x + last.width, one.x + 1) - left,
                         std::max(last.y + last.height, one.y + 1) - top};
    const std::int64_t more = cost(both) - cost(last);
    if (found.parts.empty() || more > cost(one)) {
      found.parts.push_back({one, i + 1});
      sum += cost(one);
    } else {
      found.parts.back() = {both, i + 1};
      sum += more;
    }
  }
  found.most = 2 * sum > std::int64_t{map.width()} * map.height();
  return found;
}

}  // namespace lasius
