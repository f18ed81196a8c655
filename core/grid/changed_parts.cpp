#include "core/grid/changed_parts.h"

#include <cstdint>

namespace lasius {

Rectangle widened(const Rectangle& part, int margin, const Grid& map) noexcept {
  const auto within = [](std::int64_t at, int side) {
    return static_cast<int>(std::clamp<std::int64_t>(at, 0, side));
  };
  const std::int64_t x = part.x, y = part.y;
  const int left = within(x - margin, map.width()), top = within(y - margin, map.height());
  return {left, top, within(x + part.width + margin, map.width()) - left,
          within(y + part.height + margin, map.height()) - top};
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
    const Rectangle both = round_both(last, one);
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
