#include "tools/drive/ground.h"

#include <algorithm>
#include <cmath>

namespace lasius::tool::tick_codes {
namespace {

/// By the shares of a pixel's cells that are blocked, known to be, or both.
std::uint8_t code_of(bool seen, double there, double known) {
  const double most = std::max(there, known);
  if (most <= 0) return seen ? kSeen : kUnseen;
  const Wall kind = there > 0 && known > 0 ? kKnown : there > 0 ? kUnknown : kBelieved;
  const int shade = std::max(1, static_cast<int>(std::ceil(kShades * std::sqrt(most))));
  return static_cast<std::uint8_t>(kWalls + (seen ? kWallKinds * kShades : 0) + kind * kShades +
                                   shade - 1);
}

}  // namespace

Ground::Ground(const Grid& map, int columns, int rows)
    : there_(map),
      known_(map),
      tick_(-1),
      codes_(std::min(columns, map.width()), std::min(rows, map.height())) {}

/// The pixels of a row, whose cells are in `rows`, that differ from those of the last tick; some
/// beside them, too.
Span Ground::changed(const Grid& there, const Grid& known, const DriveRecorder& recorder,
                     Span rows) const {
  if (!begun_) return {0, codes_.width};
  const int width = there.width();
  Span cells{width, 0};
  const auto add = [&](int from, int to) {
    cells = {std::min(cells.from, from), std::max(cells.to, to)};
  };
  for (int y = rows.from; y < rows.to; ++y)
    for (int w = 0; w < there.words(); ++w)
      if (there.row(y)[w] != there_.row(y)[w] || known.row(y)[w] != known_.row(y)[w])
        add(64 * w, 64 * w + 64);
  const auto& seen = recorder.seen();
  const int side = recorder.cells_a_pixel();
  for (int y = rows.from / side; y <= (rows.to - 1) / side; ++y)
    for (int x = 0; x < seen.width; ++x)
      if (seen.at(x, y) > tick_) add(x * side, x * side + side);
  if (cells.to == 0) return {0, 0};
  const auto pixel = [&](int cell) {
    return static_cast<int>(std::int64_t{cell} * codes_.width / width);
  };
  return {std::max(0, pixel(cells.from) - 1), std::min(codes_.width, pixel(cells.to) + 2)};
}

const Raster<std::uint8_t>& Ground::codes(const DriveTick& tick, const DriveRecorder& recorder) {
  const Grid& there = *tick.world;
  const Grid& known = tick.robot_knows->map();
  const Window all = whole(there);
  for (int y = 0; y < codes_.height; ++y) {
    const Span down = cells_under(y, codes_.height, all.rows);
    const Span pixels = changed(there, known, recorder, down);
    for (int x = pixels.from; x < pixels.to; ++x) {
      const Span across = cells_under(x, codes_.width, all.columns);
      const bool seen = recorder.latest(recorder.seen(), across, down) >= 0;
      codes_.at(x, y) =
          code_of(seen, blocked_share(there, across, down), blocked_share(known, across, down));
    }
  }
  there_ = there;
  known_ = known;
  tick_ = tick.tick;
  begun_ = true;
  return codes_;
}

}  // namespace lasius::tool::tick_codes
