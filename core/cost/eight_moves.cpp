#include "core/cost/eight_moves.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>

#include "core/cost/moves.h"

namespace lasius::cost {
namespace {

// A knight's move goes first into the cell that move kOver leads to.
constexpr int kOver[8] = {0, 0, 2, 2, 1, 1, 3, 3};
constexpr double kKnight = 2.23606797749979;

/// For each set of open sides, as bits, the moves that pass no corner which they may not.
std::array<unsigned, 16> moves_past(Corners corners) {
  const unsigned needed = corners == Corners::forbid ? 2 : corners == Corners::one_side ? 1 : 0;
  std::array<unsigned, 16> allowed;
  for (unsigned open = 0; open < 16; ++open) {
    allowed[open] = 15;
    for (int i = 4; i < 8; ++i) {
      const unsigned sides = (open >> (i - 4) & 1) + (open >> ((i - 3) & 3) & 1);
      if (sides >= needed) allowed[open] |= 1U << i;
    }
  }
  return allowed;
}

}  // namespace

/// What a search is over.
struct EightMoves::Question {
  Question(const Terrain& map, Cell start, Cell goal, Corners corners, bool with_knights)
      : terrain(map),
        weights(&map.at(0)),
        allowed(moves_past(corners)),
        least(map.least() * (1 - 1e-12)),
        knights(with_knights) {
    for (int i = 0; i < 16; ++i) step[i] = std::ptrdiff_t{kDy[i]} * map.stride() + kDx[i];
    whole = apart(start, goal);
  }
  /// Less than any walk costs, by more than rounding.
  double apart(Cell a, Cell b) const noexcept {
    const int dx = std::abs(a.x - b.x), dy = std::abs(a.y - b.y);
    if (knights) return least * std::sqrt(static_cast<double>(dx * dx + dy * dy));
    return least * (std::max(dx, dy) + (kDiagonal - 1) * std::min(dx, dy));
  }

  const Terrain& terrain;
  const double* weights;
  std::array<unsigned, 16> allowed;
  double least;
  bool knights;
  std::ptrdiff_t step[16];
  double whole;  ///< from start to goal
};

void EightMoves::Side::begin(const Question& question, Cell from_cell, Cell to_cell) {
  const std::size_t cells =
      static_cast<std::size_t>(question.terrain.stride()) * (question.terrain.height() + 2);
  source = from_cell;
  target = to_cell;
  waiting = 1;
  cost.grow(cells);
  from.grow(cells);
  std::fill_n(cost.data(), cells, kInfinity);
  const std::size_t at = question.terrain.index(source.x, source.y);
  cost.data()[at] = 0;
  queue.reset(question.whole / 2, 0.25 * question.terrain.least());
  queue.push(static_cast<std::uint32_t>(at), question.whole / 2);
}

// Takes a cell from the queue, which has one.
void EightMoves::spread(Side& side, const Side& other, const Question& question) {
  double* const cost = side.cost.data();
  const double* const weights = question.weights;
  const std::ptrdiff_t* const step = question.step;
  const std::size_t at = side.queue.pop();
  --side.waiting;
  // Cells come from all over the front: what is wanted of the next one is fetched meanwhile.
  if (const std::uint32_t next = side.queue.next(); next != BucketQueue::kNone) {
    for (const std::ptrdiff_t row : {step[3], std::ptrdiff_t{0}, step[1]}) {
      __builtin_prefetch(cost + next + row);
      __builtin_prefetch(weights + next + row);
    }
  }
  // Popped once already at this cost: the sign tells.
  if (std::signbit(cost[at])) return;
  const double here = cost[at];
  cost[at] = -here;
  // What moves would make, without a branch: what is blocked makes it infinite, and no less.
  const double weight = weights[at];
  double there[16];
  unsigned less = 0, open = 0;
  for (int i = 0; i < 8; ++i) {
    const std::size_t to = at + step[i];
    there[i] = here + (i < 4 ? 0.5 : 0.5 * kDiagonal) * (weight + weights[to]);
    less |= static_cast<unsigned>(there[i] < std::abs(cost[to])) << i;
  }
  for (int i = 0; i < 4; ++i) open |= static_cast<unsigned>(weights[at + step[i]] < kInfinity) << i;
  less &= question.allowed[open];
  for (int i = 8; question.knights && i < 16; ++i) {
    if ((open >> kOver[i - 8] & 1) == 0) continue;
    const std::size_t to = at + step[i], over = at + step[kOver[i - 8]];
    const std::size_t beside = to - step[kOver[i - 8]];
    there[i] = here + 0.25 * kKnight * (weight + weights[over] + weights[beside] + weights[to]);
    less |= static_cast<unsigned>(there[i] < std::abs(cost[to])) << i;
  }
  if (less == 0) return;
  for (const Cell c = question.terrain.cell(at); less != 0; less &= less - 1) {
    const int i = std::countr_zero(less);
    const Cell next{c.x + kDx[i], c.y + kDy[i]};
    const double left = question.apart(next, side.target);
    if (there[i] + left > best_) continue;
    const std::size_t to = at + step[i];
    cost[to] = there[i];
    side.from.data()[to] = static_cast<std::uint8_t>(i);
    const double key = there[i] + (left - question.apart(next, side.source)) / 2;
    side.queue.push(static_cast<std::uint32_t>(to), key);
    ++side.waiting;
    const double through = there[i] + std::abs(other.cost.data()[to]);
    if (!(through < best_)) continue;
    best_ = through;
    meeting_ = to;
  }
}

// Either side's key of a cell is its cost from there and half of what is left less half of what is
// behind (Ikeda et al. 1994), so that both weigh a step alike. A walk that is cheaper than the best
// has a cell in either queue, whose keys sum up to no more than its cost.
std::vector<Cell> EightMoves::search(const Terrain& terrain, Cell start, Cell goal, Corners corners,
                                     Poller& poller, bool knights) {
  constexpr int kTurn = 32;  // cells that a side takes before the other may
  if (start == goal) return {start};
  const Question question(terrain, start, goal, corners, knights);
  Side& ahead = sides_[0];
  Side& back = sides_[1];
  ahead.begin(question, start, goal);
  back.begin(question, goal, start);
  best_ = kInfinity;
  while (ahead.queue.advance(poller) && back.queue.advance(poller)) {
    const double floors = ahead.queue.floor() + back.queue.floor();
    // Keys are rounded.
    if (floors >= best_ + 1e-12 * (best_ + question.whole)) break;
    const bool turn = back.waiting < ahead.waiting;
    Side& side = turn ? back : ahead;
    for (int i = 0; i < kTurn && side.queue.advance(poller); ++i) {
      spread(side, turn ? ahead : back, question);
      if (poller.stop_after(8)) return {};
    }
  }
  std::vector<Cell> walk;
  if (poller.stopped() || !(best_ < kInfinity)) return walk;
  const auto trace = [&](Side& side) {
    for (std::size_t at = meeting_; terrain.cell(at) != side.source;) {
      at -= question.step[side.from.data()[at]];
      walk.push_back(terrain.cell(at));
    }
  };
  trace(ahead);
  std::ranges::reverse(walk);
  walk.push_back(terrain.cell(meeting_));
  trace(back);
  return walk;
}

}  // namespace lasius::cost
