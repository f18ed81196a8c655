#include "tools/drive/drive_recorder.h"

#include <algorithm>
#include <functional>
#include <limits>

#include "lasius/path/path.h"

namespace lasius::tool {
namespace {

constexpr int kMostPixels = 2048;  // a side

int pixels(int cells, int cells_a_pixel) { return (cells + cells_a_pixel - 1) / cells_a_pixel; }

std::int32_t short_tick(std::int64_t tick) {
  return static_cast<std::int32_t>(
      std::min<std::int64_t>(tick, std::numeric_limits<std::int32_t>::max()));
}

}  // namespace

DriveRecorder::DriveRecorder(const Grid& map, double sense)
    : sense_(sense),
      cells_a_pixel_(pixels(std::max(map.width(), map.height()), kMostPixels)),
      seen_(pixels(map.width(), cells_a_pixel_), pixels(map.height(), cells_a_pixel_), kNever),
      learned_(seen_) {}

void DriveRecorder::observe(const DriveTick& tick) {
  look(*tick.world, tick.robot, short_tick(tick.tick));
  for (const Cell c : tick.news)
    learned_.at(c.x / cells_a_pixel_, c.y / cells_a_pixel_) = short_tick(tick.tick);
  obstacles_ = tick.obstacles;
}

/// Pixels that were seen before cost nothing: of most ticks few are left.
void DriveRecorder::look(const Grid& world, Cell robot, std::int32_t tick) {
  const auto side = [&](int at, int most) {
    const auto pixel = [&](double cell) {
      return static_cast<int>(std::clamp(cell / cells_a_pixel_, 0.0, most - 1.0));
    };
    return Span{pixel(at - sense_), pixel(at + sense_) + 1};
  };
  const Span columns = side(robot.x, seen_.width), rows = side(robot.y, seen_.height);
  for (int y = rows.from; y < rows.to; ++y) {
    for (int x = columns.from; x < columns.to; ++x) {
      if (seen_.at(x, y) != kNever) continue;
      const Cell cell{std::min((2 * x + 1) * cells_a_pixel_ / 2, world.width() - 1),
                      std::min((2 * y + 1) * cells_a_pixel_ / 2, world.height() - 1)};
      const double dx = cell.x - robot.x, dy = cell.y - robot.y;
      if (dx * dx + dy * dy > sense_ * sense_) continue;
      if (world.free(cell) && visible(world, robot, cell)) seen_.at(x, y) = tick;
    }
  }
}

std::int32_t DriveRecorder::latest(const Ticks& ticks, Span columns, Span rows) const {
  return chosen(ticks, cells_a_pixel_, columns, rows, std::greater<>());
}

}  // namespace lasius::tool
