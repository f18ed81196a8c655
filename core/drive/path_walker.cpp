#include "core/drive/path_walker.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <queue>
#include <utility>

#include "core/base/special_values.h"
#include "core/grid/move_rule.h"

namespace lasius {
namespace {

struct Half {
  std::int64_t x, y;
};
Half halves(Point p) noexcept {
  return {static_cast<std::int64_t>(2 * p.x), static_cast<std::int64_t>(2 * p.y)};
}

std::int64_t floor_of(std::int64_t a, std::int64_t b) noexcept {  // b > 0
  return a >= 0 ? a / b : -((b - 1 - a) / b);
}
std::int64_t ceil_of(std::int64_t a, std::int64_t b) noexcept { return -floor_of(-a, b); }

}  // namespace

bool touches(Point a, Point b, Cell cell) noexcept {
  const Half p = halves(a), q = halves(b);
  const std::int64_t left = 2 * std::int64_t{cell.x}, top = 2 * std::int64_t{cell.y};
  if (std::max(p.x, q.x) < left || std::min(p.x, q.x) > left + 2) return false;
  if (std::max(p.y, q.y) < top || std::min(p.y, q.y) > top + 2) return false;
  bool above = false, below = false;
  for (int corner = 0; corner < 4; ++corner) {
    const std::int64_t x = left + std::int64_t{2} * (corner & 1), y = top + (corner & 2);
    const std::int64_t side = (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
    above |= side >= 0;
    below |= side <= 0;
  }
  return above && below;
}

// In half cells, the longer side of the segment taken as x.
struct PathWalker::Lines {
  Lines(Point a, Point b) noexcept : from(halves(a)), to(halves(b)) {
    steep = std::abs(to.y - from.y) > std::abs(to.x - from.x);
    if (steep) {
      std::swap(from.x, from.y);
      std::swap(to.x, to.y);
    }
    const auto [low, high] = std::minmax(from.x, to.x);
    first = ceil_of(low, 2) - 1;
    count = static_cast<int>(floor_of(high, 2) - first + 1);
  }

  /// Calls visit(cell) for the cells of a line that the segment touches, numbered along it.
  template <class Visit>
  void visit(int line, const Visit& visit) const {
    const std::int64_t x = to.x >= from.x ? first + line : first + count - 1 - line;
    const auto [low, high] = std::minmax(from.x, to.x);
    std::int64_t y0 = from.y, y1 = to.y, scale = 1;
    if (to.x != from.x) {
      const std::int64_t run = to.x - from.x, sign = run > 0 ? 1 : -1;
      scale = std::abs(run);
      y0 = from.y * scale + sign * (std::clamp(2 * x, low, high) - from.x) * (to.y - from.y);
      y1 = from.y * scale + sign * (std::clamp(2 * x + 2, low, high) - from.x) * (to.y - from.y);
    }
    const auto [y_low, y_high] = std::minmax(y0, y1);
    for (std::int64_t y = ceil_of(y_low, 2 * scale) - 1; y <= floor_of(y_high, 2 * scale); ++y) {
      const int along = static_cast<int>(x), across = static_cast<int>(y);
      visit(steep ? Cell{across, along} : Cell{along, across});
    }
  }

  Half from, to;
  bool steep;
  std::int64_t first;
  int count;
};

void PathWalker::begin(std::vector<Point> path, bool of_disc) {
  path_ = std::move(path);
  beside_ = of_disc ? 1 : 0;
  for (Point& p : path_) p = {std::round(2 * p.x) / 2, std::round(2 * p.y) / 2};
  segment_ = begun_segment_ = 0;
  line_ = 0;
}

std::int32_t& PathWalker::slot(Cell cell) noexcept {
  return slots_[static_cast<std::size_t>((cell.y - corner_.y) * kBox + cell.x - corner_.x)];
}

void PathWalker::add(const Grid& grid, Cell cell) {
  const int dx = cell.x - corner_.x, dy = cell.y - corner_.y;
  if (dx < 0 || dy < 0 || dx >= kBox || dy >= kBox || grid.blocked(cell)) return;
  if (slot(cell) < 0) {
    slot(cell) = static_cast<std::int32_t>(nodes_.size());
    nodes_.push_back({cell, kInfinity, -1, false});
  }
  last_line_.push_back(slot(cell));
}

// The free cells of the next lines. True if the path ends there. Each line is at most one cell from
// the one before, so that the box holds them. The next piece begins with the last line of this one.
bool PathWalker::gather(const Grid& grid, Cell from) {
  nodes_.clear();
  corner_ = {from.x - kBox / 2, from.y - kBox / 2};
  add(grid, from);
  begun_segment_ = segment_;
  std::size_t segment = segment_;
  int line = line_;
  for (int left = kLines; segment + 1 < path_.size(); ++segment, line = 0) {
    const Lines lines(path_[segment], path_[segment + 1]);
    for (; line < lines.count; ++line, --left) {
      if (left == 0) return false;
      last_line_.clear();
      lines.visit(line, [&](Cell cell) {
        for (int y = -beside_; y <= beside_; ++y)
          for (int x = -beside_; x <= beside_; ++x) add(grid, {cell.x + x, cell.y + y});
      });
      segment_ = segment;
      line_ = line;
    }
  }
  return true;
}

// Dijkstra from the first node.
void PathWalker::search(const Grid& grid, Corners corners) {
  static const kernels::Moves moves = moves_of(Neighbours::eight);
  using Entry = std::pair<double, std::int32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  nodes_[0].length = 0;
  open.emplace(0, 0);
  while (!open.empty()) {
    const std::int32_t at = open.top().second;
    open.pop();
    if (std::exchange(nodes_[at].done, true)) continue;
    for (int i = 0; i < moves.count; ++i) {
      const kernels::Move& move = moves.move[i];
      const Cell to = nodes_[at].cell + move.to;
      if (std::max(std::abs(to.x - corner_.x - kBox / 2), std::abs(to.y - corner_.y - kBox / 2)) >
          kBox / 2) {
        continue;
      }
      const std::int32_t node = slot(to);
      if (node < 0 || !move_exists(grid, corners, nodes_[at].cell, move)) continue;
      const double length = nodes_[at].length + move.length;
      if (length < nodes_[node].length) {
        nodes_[node].length = length;
        nodes_[node].parent = at;
        open.emplace(length, node);
      }
    }
  }
}

void PathWalker::next(const Grid& grid, Corners corners, Cell from, std::vector<Cell>& walk) {
  walk.assign(1, from);
  if (path_.size() < 2) return;
  const bool whole = gather(grid, from);
  search(grid, corners);
  // A cell of the last line; of a whole path its end.
  std::int32_t end = 0;
  const Cell goal{static_cast<int>(path_.back().x), static_cast<int>(path_.back().y)};
  for (const std::int32_t node : last_line_)
    if (nodes_[node].done && (!whole || nodes_[node].cell == goal)) end = node;
  walk.clear();
  for (std::int32_t at = end; at >= 0; at = nodes_[at].parent) walk.push_back(nodes_[at].cell);
  std::ranges::reverse(walk);
  for (const Node& node : nodes_) slot(node.cell) = -1;
}

bool PathWalker::touches_rest(Cell cell) const noexcept {
  for (std::size_t i = begun_segment_; i + 1 < path_.size(); ++i)
    if (touches(path_[i], path_[i + 1], cell)) return true;
  return path_.size() == 1 && touches(path_[0], path_[0], cell);
}

std::size_t PathWalker::vertices_after(Cell cell) const noexcept {
  std::size_t i = std::min(segment_ + 2, path_.size());
  while (i > begun_segment_ + 2 && !touches(path_[i - 2], path_[i - 1], cell)) --i;
  return path_.size() - i;
}

}  // namespace lasius
