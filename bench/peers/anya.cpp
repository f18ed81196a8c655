#include "bench/peers/anya.h"

#include <algorithm>
#include <cmath>

#include "bench/peers/runs.h"

namespace lasius::peers {
namespace {

constexpr double kSnap = 1e-6;  // interval ends this close to a column are on it
constexpr double kThin = 1e-9;  // intervals thinner than this hold no corner
constexpr double kTie = 1e-10;  // costs this close are equal

double distance(double x0, double y0, double x1, double y1) noexcept {
  const double dx = x1 - x0, dy = y1 - y0;
  return std::sqrt(dx * dx + dy * dy);
}

double snapped(double x) noexcept {
  const double column = static_cast<double>(static_cast<int>(x + 0.5));
  return std::abs(x - column) < kSnap ? column : x;
}

// The row that is entered when the line is crossed in direction dy.
int row_ahead(int line, int dy) noexcept { return dy > 0 ? line : line - 1; }
int row_behind(int line, int dy) noexcept { return dy > 0 ? line - 1 : line; }

}  // namespace

double Anya::plan(Cell start, Cell goal, std::vector<Point>& path) {
  path.clear();
  roots_.clear();
  nodes_.clear();
  spare_.clear();
  heap_.clear();
  ++stamp_;
  used_ = 0;
  goal_ = goal;
  target_ = centre(goal);
  best_ = kNoPath;

  push_root(start.x + 0.5, start.y + 0.5, 0, -1, kNoCorner);
  const std::uint64_t* row = grid_->row(start.y);
  const int left = last_blocked(row, start.x) + 1, right = first_blocked(row, start.x);
  see_goal(0, start.y, left, right);
  fresh_.clear();
  add_cone(0, left, right, start.y, -1);
  add_cone(0, left, right, start.y + 1, 1);
  for (const Node& node : fresh_) store(node);

  while (!heap_.empty() && heap_.front().bound < best_ - kTie) {
    std::pop_heap(heap_.begin(), heap_.end());
    const std::uint32_t place = heap_.back().node;
    heap_.pop_back();
    spare_.push_back(place);
    expand(nodes_[place]);
  }

  if (best_ == kNoPath) return kNoPath;
  path.push_back(target_);
  if (has_via_) path.push_back(best_via_);
  for (std::int32_t r = best_root_; r >= 0; r = roots_[r].parent) {
    path.push_back({roots_[r].x, roots_[r].y});
  }
  std::reverse(path.begin(), path.end());
  return best_;
}

// Expands a node, then its best successor for as long as that one would be the next to be taken.
void Anya::expand(Node node) {
  for (;;) {
    const Root& root = roots_[node.root];
    if (root.corner != kNoCorner && root.cost > entry(root.corner).cost + kTie) return;
    fresh_.clear();
    node.dy == 0 ? expand_flat(node) : expand_cone(node);
    if (fresh_.empty()) return;
    std::size_t first = 0;
    for (std::size_t i = 1; i < fresh_.size(); ++i) {
      if (fresh_[i].bound < fresh_[first].bound) first = i;
    }
    for (std::size_t i = 0; i < fresh_.size(); ++i) {
      if (i != first) store(fresh_[i]);
    }
    node = fresh_[first];
    if (node.bound >= best_ - kTie) return;
    if (!heap_.empty() && heap_.front().bound < node.bound) return store(node);
  }
}

void Anya::expand_cone(const Node& node) {
  const Root& root = roots_[node.root];
  const double ratio = (node.line + node.dy - root.y) / (node.line - root.y);
  const int ahead = row_ahead(node.line, node.dy);
  const std::uint64_t* row = grid_->row(ahead);
  int x = static_cast<int>(node.left);
  const int first = last_blocked(row, x) + 1;
  int run_left = first <= x ? first : first_free(row, x, grid_->width());
  while (run_left < node.right) {
    const int run_right = first_blocked(row, std::max(run_left, x));
    expand_run(node, ratio, run_left, run_right);
    x = run_right;
    run_left = first_free(row, x, grid_->width());
  }
}

// One run of free cells in the row ahead that the interval opens into.
void Anya::expand_run(const Node& node, double ratio, int run_left, int run_right) {
  const Root root = roots_[node.root];
  const double left = std::max<double>(node.left, run_left);
  const double right = std::min<double>(node.right, run_right);
  const int ahead = row_ahead(node.line, node.dy);
  if (ahead == goal_.y && run_left <= goal_.x && goal_.x < run_right) {
    const double straight = root.x + root.slope * (node.line - root.y);
    const double through = std::clamp(straight, left, right);
    const double length = root.cost + distance(root.x, root.y, through, node.line) +
                          distance(through, node.line, target_.x, target_.y);
    if (length < best_) {
      best_ = length;
      best_root_ = node.root;
      best_via_ = {through, static_cast<double>(node.line)};
      has_via_ = std::abs(straight - through) > kThin;
    }
  }

  const double seen_left = root.x + (left - root.x) * ratio;
  const double seen_right = root.x + (right - root.x) * ratio;
  const double cone_left = std::max<double>(run_left, snapped(seen_left));
  const double cone_right = std::min<double>(run_right, snapped(seen_right));
  if (cone_right - cone_left > kThin) {
    add_cone(node.root, cone_left, cone_right, node.line + node.dy, node.dy);
  }

  const std::uint64_t* behind = grid_->row(row_behind(node.line, node.dy));
  if (left == run_left) {
    if (root.x < run_left && !bit(behind, run_left - 1)) {
      turn_below(node, ratio, run_right, run_left);
    }
  } else if (const int x = static_cast<int>(left); x == left && bit(behind, x - 1)) {
    turn_behind(node, ratio, x, -1);
  }
  if (right == run_right) {
    if (root.x > run_right && !bit(behind, run_right)) {
      turn_below(node, ratio, run_left, run_right);
    }
  } else if (const int x = static_cast<int>(right); x == right && bit(behind, x)) {
    turn_behind(node, ratio, x, 1);
  }
}

// Around a block of the row ahead, beside the run at x: the part that it hides of the run, which
// ends at `far`.
void Anya::turn_below(const Node& node, double ratio, int far, int x) {
  const Root root = roots_[node.root];
  const std::int32_t turn = make_root(node.root, x, node.line);
  if (turn < 0) return;
  const double seen = snapped(root.x + (x - root.x) * ratio);
  const double left = far > x ? x : std::max<double>(far, seen);
  const double right = far > x ? std::min<double>(far, seen) : x;
  if (right - left > kThin) add_cone(turn, left, right, node.line + node.dy, node.dy);
}

// Around a block of the row just left, beside the interval: what lies ahead beyond the last ray,
// and along the line.
void Anya::turn_behind(const Node& node, double ratio, int x, int side) {
  const Root root = roots_[node.root];
  const std::int32_t turn = make_root(node.root, x, node.line);
  if (turn < 0) return;
  const std::uint64_t* row = grid_->row(row_ahead(node.line, node.dy));
  const double ray = snapped(root.x + (x - root.x) * ratio);
  if (side < 0) {
    const int run_left = last_blocked(row, x - 1) + 1;
    if (ray - run_left > kThin) add_cone(turn, run_left, ray, node.line + node.dy, node.dy);
  } else {
    const int run_right = first_blocked(row, x);
    if (run_right - ray > kThin) add_cone(turn, ray, run_right, node.line + node.dy, node.dy);
  }
  add_flat(turn, x, node.line, side);
}

// Along a line to where the cells on its two sides change.
void Anya::expand_flat(const Node& node) {
  const std::uint64_t* above = grid_->row(node.line - 1);
  const std::uint64_t* below = grid_->row(node.line);
  const int dx = node.dx, x = static_cast<int>(node.left);
  int c = dx > 0 ? x : x - 1;  // the cell column ahead
  const bool up = bit(above, c), down = bit(below, c);
  if (up && down) return;
  c = dx > 0 ? first_change<true>(above, below, c) : first_change<false>(above, below, c);
  if (bit(above, c) && (bit(below, c) || down)) return;  // a wall, or a squeeze
  if (bit(below, c) && up) return;
  const int end = dx > 0 ? c : c + 1;
  if ((up || down) && !bit(above, c) && !bit(below, c)) {
    const std::int32_t turn = make_root(node.root, end, node.line);
    if (turn >= 0) {
      const std::uint64_t* row = up ? above : below;
      const int dy = up ? -1 : 1;
      const int left = dx > 0 ? end : last_blocked(row, c) + 1;
      const int right = dx > 0 ? first_blocked(row, c) : end;
      see_goal(turn, up ? node.line - 1 : node.line, left, right);
      add_cone(turn, left, right, node.line + dy, dy);
    }
  }
  add_flat(node.root, end, node.line, dx);
}

// A new turn, or -1 where the corner was reached as cheaply before: then what follows is as well.
std::int32_t Anya::make_root(std::int32_t parent, int x, int y) {
  const Root& from = roots_[parent];
  const double cost = from.cost + distance(from.x, from.y, x, y);
  const auto corner =
      static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(grid_->width() + 1) +
      static_cast<std::uint32_t>(x);
  Entry& known = entry(corner);
  if (known.cost <= cost + kTie) return -1;
  known.cost = cost;
  push_root(x, y, cost, parent, corner);
  return static_cast<std::int32_t>(roots_.size()) - 1;
}

void Anya::push_root(double x, double y, double cost, std::int32_t parent, std::uint32_t corner) {
  const double to_goal = distance(x, y, target_.x, target_.y);
  const double slope = y == target_.y ? 0 : (target_.x - x) / (target_.y - y);
  roots_.push_back({x, y, cost, to_goal, slope, parent, corner});
}

void Anya::add_cone(std::int32_t r, double left, double right, int line, int dy) {
  const Root& root = roots_[r];
  double goal_y = target_.y;
  double straight, bound = root.cost;
  if ((goal_y - line) * dy > 0) {
    straight = root.x + root.slope * (line - root.y);
  } else {
    // A goal behind the line is mirrored: the path has to cross the line first.
    goal_y = 2.0 * line - goal_y;
    straight = root.x + (target_.x - root.x) * (line - root.y) / (goal_y - root.y);
  }
  if (straight < left || straight > right) {
    const double end = straight < left ? left : right;
    bound += distance(root.x, root.y, end, line) + distance(end, line, target_.x, goal_y);
  } else {
    bound += goal_y == target_.y ? root.to_goal : distance(root.x, root.y, target_.x, goal_y);
  }
  if (bound >= best_ - kTie) return;
  fresh_.push_back({left, right, bound, r, line, static_cast<std::int8_t>(dy), 0});
}

void Anya::add_flat(std::int32_t r, int x, int line, int dx) {
  const Root& root = roots_[r];
  const double bound = root.cost + std::abs(root.x - x) + distance(x, line, target_.x, target_.y);
  if (bound >= best_ - kTie) return;
  const double at = x;
  fresh_.push_back({at, at, bound, r, line, 0, static_cast<std::int8_t>(dx)});
}

// The goal in a run of free cells that the root sees as a whole.
void Anya::see_goal(std::int32_t r, int row, int run_left, int run_right) {
  if (row != goal_.y || goal_.x < run_left || goal_.x >= run_right) return;
  const Root& root = roots_[r];
  const double length = root.cost + root.to_goal;
  if (length >= best_) return;
  best_ = length;
  best_root_ = r;
  has_via_ = false;
}

void Anya::store(const Node& node) {
  std::uint32_t place;
  if (spare_.empty()) {
    place = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back(node);
  } else {
    place = spare_.back();
    spare_.pop_back();
    nodes_[place] = node;
  }
  heap_.push_back({node.bound, place});
  std::push_heap(heap_.begin(), heap_.end());
}

Anya::Entry& Anya::entry(std::uint32_t corner) {
  if (2 * used_ > mask_) grow_table();
  std::size_t i = (corner * std::uint64_t{0x9e3779b97f4a7c15}) >> 32 & mask_;
  while (table_[i].stamp == stamp_ && table_[i].corner != corner) i = (i + 1) & mask_;
  if (table_[i].stamp != stamp_) {
    table_[i] = {corner, stamp_, kNoPath};
    ++used_;
  }
  return table_[i];
}

void Anya::grow_table() {
  std::vector<Entry> old(2 * table_.size(), Entry{0, stamp_ - 1, 0});
  old.swap(table_);
  mask_ = table_.size() - 1;
  used_ = 0;
  for (const Entry& e : old) {
    if (e.stamp == stamp_) entry(e.corner).cost = e.cost;
  }
}

}  // namespace lasius::peers
