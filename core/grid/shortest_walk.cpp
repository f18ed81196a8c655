#include "lasius/path/shortest_walk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <memory>
#include <vector>

#include "core/base/bucket_queue.h"
#include "core/base/poller.h"
#include "core/grid/move_rule.h"
#include "core/grid/walk_cells.h"

namespace lasius {
namespace {

// Lengths in 2^-32 of a cell: a walk over every cell of the largest map stays below 2^63.
using Length = std::int64_t;
constexpr double kUnit = 0x1p32;
constexpr double kBucketWidth = 0.25;  // cells

/// The least known length of the walks to a cell. Its sign says whether the cell was expanded.
class Reached {
 public:
  Length length() const noexcept { return value_ < 0 ? ~value_ : value_; }
  bool expanded() const noexcept { return value_ < 0; }
  void shorten(Length length) noexcept { value_ = length; }
  void expand() noexcept { value_ = ~value_; }

 private:
  Length value_ = std::numeric_limits<Length>::max();
};
constexpr Length kUnreached = std::numeric_limits<Length>::max();

Length whole(double cells) noexcept { return std::llround(cells * kUnit); }

// What is known of each cell, in tiles that exist where the search has been.
class Knowledge {
 public:
  explicit Knowledge(const Grid& grid)
      : across_((grid.width() + kSide - 1) / kSide),
        tiles_(static_cast<std::size_t>(across_) * ((grid.height() + kSide - 1) / kSide)) {}

  Reached& operator[](Cell c) {
    auto& tile = tiles_[static_cast<std::size_t>(c.y / kSide) * across_ + c.x / kSide];
    if (tile == nullptr) tile = std::make_unique<Tile>();
    return (*tile)[static_cast<std::size_t>(c.y % kSide) * kSide + c.x % kSide];
  }

 private:
  static constexpr int kSide = 32;
  using Tile = std::array<Reached, std::size_t{kSide} * kSide>;
  int across_;
  std::vector<std::unique_ptr<Tile>> tiles_;
};

class WalkSearch {
 public:
  WalkSearch(const Grid& grid, Cell goal, Neighbours neighbours, Corners corners)
      : grid_(grid),
        goal_(goal),
        neighbours_(neighbours),
        corners_(corners),
        moves_(moves_of(neighbours)),
        known_(grid) {
    for (int k = 0; k < moves_.count; ++k) steps_[k] = whole(moves_[k].length);
  }

  /// Fills in lengths until the goal's is known to be the least; false when stopped.
  bool run(Cell start, Poller& poller) {
    open_.reset(to_goal(start), kBucketWidth);
    reach(start, 0);
    while (open_.advance(poller)) {
      // One bucket more than needed makes up for the rounding of estimates.
      if (known_[goal_].length() != kUnreached &&
          open_.floor() > cells(known_[goal_].length()) + kBucketWidth) {
        break;
      }
      expand(cell(open_.pop()));
      if (poller.stop_after(moves_.count)) return false;
    }
    return true;
  }

  /// Calls visit(cell, the move that leads there) from the goal back to the first cell after the
  /// start; false if the goal was not reached, or when stopped.
  template <class Visit>
  bool go_back(Cell start, Poller& poller, const Visit& visit) {
    if (known_[goal_].length() == kUnreached) return false;
    for (Cell c = goal_; c != start;) {
      const int k = last_move(c);
      visit(c, k);
      c = c + moves_[k].to;  // moves can be walked both ways
      if (poller.stop_after(moves_.count)) return false;
    }
    return true;
  }

  /// The goal's length, summed move by move; nothing if it was not reached, or when stopped.
  std::optional<double> length(Cell start, Poller& poller) {
    std::array<std::int64_t, kernels::kMaxMoves> made{};
    if (!go_back(start, poller, [&](Cell, int k) { ++made[k]; })) return std::nullopt;
    double sum = 0;
    for (int k = 0; k < moves_.count; ++k) sum += static_cast<double>(made[k]) * moves_[k].length;
    return sum;
  }

 private:
  static double cells(Length length) noexcept { return static_cast<double>(length) / kUnit; }

  std::uint32_t index(Cell c) const noexcept {
    return static_cast<std::uint32_t>(c.y) * static_cast<std::uint32_t>(grid_.width()) +
           static_cast<std::uint32_t>(c.x);
  }
  Cell cell(std::uint32_t index) const noexcept {
    const auto width = static_cast<std::uint32_t>(grid_.width());
    return {static_cast<int>(index % width), static_cast<int>(index / width)};
  }

  // No walk from c to the goal is shorter.
  double to_goal(Cell c) const noexcept {
    const double dx = std::abs(c.x - goal_.x), dy = std::abs(c.y - goal_.y);
    switch (neighbours_) {
      case Neighbours::four:
        return dx + dy;
      case Neighbours::eight:
      case Neighbours::sixteen:
        return std::max(dx, dy) + (std::sqrt(2.0) - 1) * std::min(dx, dy);
      default:
        return std::sqrt(dx * dx + dy * dy);
    }
  }

  void reach(Cell c, Length length) {
    Reached& known = known_[c];
    if (length >= known.length()) return;
    known.shorten(length);
    open_.push(index(c), cells(length) + to_goal(c));
  }

  void expand(Cell c) {
    Reached& known = known_[c];
    if (known.expanded()) return;
    const Length length = known.length();
    known.expand();
    for (int k = 0; k < moves_.count; ++k)
      if (move_exists(grid_, corners_, c, moves_[k])) reach(c + moves_[k].to, length + steps_[k]);
  }

  // The move, made backwards, that the length of a reached cell comes from.
  int last_move(Cell c) {
    const Length length = known_[c].length();
    int k = 0;
    while (!move_exists(grid_, corners_, c, moves_[k]) ||
           known_[c + moves_[k].to].length() != length - steps_[k]) {
      ++k;
    }
    return k;
  }

  const Grid& grid_;
  Cell goal_;
  Neighbours neighbours_;
  Corners corners_;
  kernels::Moves moves_;
  std::array<Length, kernels::kMaxMoves> steps_{};
  Knowledge known_;
  BucketQueue open_;
};

/// What `make(WalkSearch&, Poller&)` makes of a search from start to goal; nothing if that was
/// stopped, or one is blocked.
template <class Value, class Make>
Value search(const Grid& grid, Cell start, Cell goal, Neighbours neighbours, Corners corners,
             const StopCondition& stop, const Make& make) {
  if (grid.blocked(start) || grid.blocked(goal)) return {};
  const auto search = std::make_unique<WalkSearch>(grid, goal, neighbours, corners);
  Poller poller(stop, Poller::kWords - kernels::kMaxMoves);  // one cell more is not too much
  if (!search->run(start, poller)) return {};
  return make(*search, poller);
}

}  // namespace

std::optional<double> shortest_walk(const Grid& grid, Cell start, Cell goal, Neighbours neighbours,
                                    Corners corners, const StopCondition& stop) {
  return search<std::optional<double>>(
      grid, start, goal, neighbours, corners, stop,
      [&](WalkSearch& found, Poller& poller) { return found.length(start, poller); });
}

std::vector<Cell> shortest_walk_cells(const Grid& grid, Cell start, Cell goal,
                                      Neighbours neighbours, Corners corners,
                                      const StopCondition& stop) {
  return search<std::vector<Cell>>(
      grid, start, goal, neighbours, corners, stop, [&](WalkSearch& found, Poller& poller) {
        std::vector<Cell> walk;
        if (!found.go_back(start, poller, [&](Cell c, int) { walk.push_back(c); }))
          return std::vector<Cell>{};
        walk.push_back(start);
        std::ranges::reverse(walk);
        return walk;
      });
}

}  // namespace lasius
