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

Raster<std::uint8_t> codes_of(const DriveTick& tick, const DriveRecorder& recorder, int columns,
                              int rows) {
  const Grid& there = *tick.world;
  const Grid& known = tick.robot_knows->map();
  columns = std::min(columns, there.width());
  rows = std::min(rows, there.height());
  const Window all = whole(there);
  const auto there_share = blocked_share(there, all, columns, rows);
  const auto known_share = blocked_share(known, all, columns, rows);
  Raster<std::uint8_t> codes(columns, rows);
  for (int y = 0; y < rows; ++y) {
    const Span down = cells_under(y, rows, all.rows);
    for (int x = 0; x < columns; ++x) {
      const Span across = cells_under(x, columns, all.columns);
      const bool seen = recorder.latest(recorder.seen(), across, down) >= 0;
      codes.at(x, y) = code_of(seen, there_share.at(x, y), known_share.at(x, y));
    }
  }
  return codes;
}

}  // namespace lasius::tool::tick_codes
