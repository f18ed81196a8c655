#include "core/tour/cover/sweep_cells.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace lasius::tour {

namespace {

constexpr double kSame = 1e-9, kTouching = 1e-6;
constexpr double kStripsOfWidth = 8;

struct Strip {
  double from, to;
};

// Sides of cells are at whole numbers; the tool's places begin a radius away from them.
std::vector<Strip> axis_strips(const ToolLines& lines, const Stretch& extent) {
  const double r = lines.radius();
  std::vector<double> events;
  for (double side = std::round(extent.from); side <= extent.to + kSame; ++side)
    for (const double event : {side - r, side, side + r})
      if (event >= extent.from - kSame && event <= extent.to + kSame) events.push_back(event);
  std::sort(events.begin(), events.end());
  std::vector<Strip> strips;
  double last = events.front();
  if (lines.tight()) strips.push_back({last, last});
  for (const double event : events) {
    if (event - last < kSame) continue;
    strips.push_back({last, event});
    if (lines.tight())
      strips.push_back({event, event});  // a corridor as wide as the tool has one line
    last = event;
  }
  return strips;
}

std::vector<Strip> strips_of(const ToolLines& lines, const Heading& heading, double width) {
  const Stretch extent = lines.extent(heading);
  if (heading.straight()) return axis_strips(lines, extent);
  const int count = std::max(1, static_cast<int>(extent.length() / width * kStripsOfWidth));
  const double step = extent.length() / count;
  std::vector<Strip> strips;
  strips.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    strips.push_back({extent.from + i * step, extent.from + (i + 1) * step});
  return strips;
}

// A stretch of one strip, and how it goes on.
struct Node {
  Stretch stretch;
  int cell = -1;
  int onward = 0, back = 0;  // stretches of the next strip, and of the last, that it overlaps
  double shared_onward = 0, shared_back = 0;
  int before = -1;  // one of the last strip
};

}  // namespace

std::vector<SweepCell> sweep_cells(const ToolLines& lines, const Heading& heading, double width,
                                   Poller& poller) {
  std::vector<SweepCell> cells;
  std::vector<Node> last, now;
  std::vector<Stretch> places;
  const auto close = [&](const std::vector<Node>& nodes) {
    for (const Node& node : nodes)
      cells[node.cell].wall_behind = node.shared_onward < node.stretch.length() / 2;
  };
  for (const Strip& strip : strips_of(lines, heading, width)) {
    const double c = (strip.from + strip.to) / 2;
    lines.on_line(heading, c, places);
    if (poller.stop_after(lines.work_of_line(places))) break;
    now.clear();
    for (const Stretch& place : places) now.push_back({.stretch = place});
    for (std::size_t i = 0, j = 0; i < last.size() && j < now.size();) {
      const double shared = std::min(last[i].stretch.to, now[j].stretch.to) -
                            std::max(last[i].stretch.from, now[j].stretch.from);
      if (shared > kTouching) {
        ++last[i].onward;
        ++now[j].back;
        last[i].shared_onward += shared;
        now[j].shared_back += shared;
        now[j].before = static_cast<int>(i);
      }
      if (last[i].stretch.to < now[j].stretch.to)
        ++i;
      else
        ++j;
    }
    close(last);
    for (Node& node : now) {
      if (node.back == 1 && last[node.before].onward == 1) {
        const Node& before = last[node.before];
        const double leap = std::abs(node.stretch.from - before.stretch.from) +
                            std::abs(node.stretch.to - before.stretch.to);
        const double longer = std::max(node.stretch.length(), before.stretch.length());
        if (leap <= std::max(width, longer / 3)) node.cell = before.cell;
      }
      if (node.cell < 0) {
        node.cell = static_cast<int>(cells.size());
        cells.push_back({.from = strip.from,
                         .wall_before = node.shared_back < node.stretch.length() / 2,
                         .slices = {}});
      }
      cells[node.cell].to = strip.to;
      cells[node.cell].slices.push_back({c, node.stretch});
    }
    std::swap(last, now);
  }
  close(last);
  return cells;
}

}  // namespace lasius::tour
