#include "tools/drive/film.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tools/draw/colours.h"
#include "tools/drive/gif.h"

namespace lasius::tool {
namespace {

using namespace tick_codes;

enum Mark : std::uint8_t { kTrack = kCodes, kWay, kMover, kRobot, kTarget, kColours };

std::array<Colour, kColours> film_colours() {
  std::array<Colour, kColours> colours{};
  const std::array<Colour, 2> free{Colour{0.87, 0.89, 0.92}, kFree};
  const std::array<Colour, kWallKinds> walls{
      Colour{0.3, 0.33, 0.37}, {0.93, 0.55, 0.57}, {0.98, 0.8, 0.55}};
  colours[kUnseen] = free[0];
  colours[kSeen] = free[1];
  std::size_t next = kWalls;
  for (const Colour& below : free)
    for (const Colour& wall : walls)
      for (int shade = 1; shade <= kShades; ++shade)
        colours[next++] = blend(below, wall, 1.0 * shade / kShades);
  colours[kTrack] = {0.92, 0.45, 0.45};
  colours[kWay] = kStart;
  colours[kMover] = {0.55, 0.2, 0.65};
  colours[kRobot] = kPath;
  colours[kTarget] = kGoal;
  return colours;
}

double scale_of(const Grid& map) {
  const double most = Film::kMostSide, cells = std::max(map.width(), map.height());
  return cells < most ? std::floor(most / cells) : most / cells;
}
int pixels_of(double scale, int side) {
  return std::max(1, static_cast<int>(std::floor(scale * side)));
}

}  // namespace

Film::Film(const Grid& map, Cell goal)
    : scale_(scale_of(map)),
      width_(pixels_of(scale_, map.width())),
      height_(pixels_of(scale_, map.height())),
      goal_(goal),
      ground_(map, width_, height_),
      track_(width_, height_, kUnseen) {}

void Film::observe(const DriveTick& tick, const DriveRecorder& recorder) {
  const Point robot = centre(tick.robot);
  if (tick.tick > 0) draw_line(track_, robot_, robot, kTrack);
  robot_ = robot;
  if (frames_.wants(tick.tick) || tick.arrived) frames_.add(drawn(tick, recorder));
}

Film::Frame Film::drawn(const DriveTick& tick, const DriveRecorder& recorder) {
  Frame frame(width_, height_, kUnseen);
  draw_cells(frame, tick, recorder);
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x)
      if (track_.at(x, y) == kTrack) frame.at(x, y) = kTrack;
  if (tick.way != nullptr)
    for (std::size_t i = 1; i < tick.way->path.size(); ++i)
      draw_line(frame, tick.way->path[i - 1], tick.way->path[i], kWay);
  for (const Rectangle& r : tick.obstacles) {
    const Span columns = pixels(r.x, r.width, width_), rows = pixels(r.y, r.height, height_);
    for (int y = rows.from; y < rows.to; ++y)
      for (int x = columns.from; x < columns.to; ++x) frame.at(x, y) = kMover;
  }
  draw_disc(frame, centre(goal_), std::clamp(0.5 * scale_, 3.0, 8.0), kTarget);
  draw_disc(frame, centre(tick.robot), std::clamp(0.5 * scale_, 3.0, 8.0), kRobot);
  return frame;
}

/// Under some cells, at least one.
Span Film::pixels(int cell, int cells, int side) const {
  const int from = std::min(side - 1, static_cast<int>(scale_ * cell));
  return {from, std::clamp(static_cast<int>(scale_ * (cell + cells)), from + 1, side)};
}

void Film::draw_cells(Frame& frame, const DriveTick& tick, const DriveRecorder& recorder) {
  const Frame& cells = ground_.codes(tick, recorder);
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x)
      frame.at(x, y) = cells.at(x * cells.width / width_, y * cells.height / height_);
}

void Film::draw_line(Frame& frame, Point from, Point to, std::uint8_t colour) const {
  const double dx = to.x - from.x, dy = to.y - from.y;
  const int steps = 1 + static_cast<int>(2 * scale_ * std::max(std::abs(dx), std::abs(dy)));
  for (int i = 0; i <= steps; ++i)
    draw_disc(frame, {from.x + dx * i / steps, from.y + dy * i / steps},
              std::clamp(0.12 * scale_, 0.7, 1.5), colour);
}

void Film::draw_disc(Frame& frame, Point at, double radius, std::uint8_t colour) const {
  const double x = at.x * scale_ - 0.5, y = at.y * scale_ - 0.5;
  const auto low = [&](double middle) {
    return std::max(0, static_cast<int>(std::ceil(middle - radius)));
  };
  for (int row = low(y); row <= std::min(height_ - 1.0, y + radius); ++row)
    for (int column = low(x); column <= std::min(width_ - 1.0, x + radius); ++column)
      if ((column - x) * (column - x) + (row - y) * (row - y) <= radius * radius)
        frame.at(column, row) = colour;
}

void Film::write(std::ostream& out) const {
  constexpr int kHundredths = 6;
  // A drive that never began has no tick.
  write_gif(out, film_colours(),
            frames_.all().empty() ? std::vector{Frame(width_, height_, kUnseen)} : frames_.all(),
            kHundredths);
}

}  // namespace lasius::tool
