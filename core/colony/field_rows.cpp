// How a field's rows of weights are made, and which of them a change makes stale.

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <type_traits>

#include "core/base/special_values.h"
#include "core/colony/field.h"
#include "core/colony/field_tile.h"
#include "core/grid/move_rule.h"

namespace lasius {
namespace {

using kernels::kTileSide;

// Rows are made in batches, a loop over the values of them all for each operation: powers are long
// chains, of which many overlap, and the rest goes by vectors.
constexpr int kBatch = 256;
static_assert(kBatch >= kernels::kMaxMoves);
using Floats = std::array<float, kBatch>;
using Doubles = std::array<double, kBatch>;

constexpr auto kEveryCell = [] {
  std::array<std::uint16_t, kernels::kTileCells> cells{};
  for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = static_cast<std::uint16_t>(i);
  return cells;
}();

/// Calls `action` with a number of moves: a common one as a constant, for which loops unroll.
template <class Action>
void with_count(int moves, const Action& action) {
  switch (moves) {
    case 4:
      return action(std::integral_constant<int, 4>());
    case 8:
      return action(std::integral_constant<int, 8>());
    default:
      return action(moves);
  }
}

// By value, so that loops over them vectorise, which they do not over std's.
template <class T>
T smaller(T a, T b) noexcept {
  return b < a ? b : a;
}
template <class T>
T larger(T a, T b) noexcept {
  return a < b ? b : a;
}

/// The largest value of its row beside each.
template <class Values, class Count>
void spread_largest(const Values& values, int count, Count moves, Values& largest) noexcept {
  for (int row = 0; row < count; row += moves) {
    auto most = std::numeric_limits<typename Values::value_type>::min();
    for (int k = 0; k < moves; ++k) most = larger(most, values[row + k]);
    std::fill_n(&largest[row], static_cast<int>(moves), most);
  }
}

/// Shares of the largest in the row among the moves that exist; of the others, something up to 1.
template <class Count>
void divide_by_largest(const Floats& values, const Floats& heuristic, int count, Count moves,
                       Doubles& shares) noexcept {
  Floats existing, largest;
  for (int i = 0; i < count; ++i) {
    const float value = values[i];  // read in any case: no branch
    existing[i] = heuristic[i] > 0 ? value : 0.0f;
  }
  spread_largest(existing, count, moves, largest);
  for (int i = 0; i < count; ++i) {
    shares[i] = static_cast<double>(smaller(values[i], largest[i])) / largest[i];
  }
}

/// Pheromone's weight of each move, or its product with the heuristic.
void weigh_trail(const Doubles& trail, const Floats& heuristic, int count, bool mixture,
                 Floats& weight) noexcept {
  constexpr auto kSmallest = static_cast<float>(HeuristicRows::kSmallest);
  for (int i = 0; i < count; ++i) {
    const float value = larger(static_cast<float>(trail[i]), kSmallest);
    weight[i] = heuristic[i] > 0 ? value : 0.0f;
  }
  if (mixture) return;
  for (int i = 0; i < count; ++i) weight[i] *= heuristic[i];
}

/// One over K'(j)^alpha * d(j, E)^beta (Li, Wang & Ma, eq. 9) as a share of the row's largest, as a
/// race wants it.
template <class Count>
void weigh_index(Doubles& index, const Floats& heuristic, int count, Count moves,
                 Floats& weight) noexcept {
  for (int i = 0; i < count; ++i) index[i] *= heuristic[i];
  Doubles largest;
  spread_largest(index, count, moves, largest);
  for (int i = 0; i < count; ++i) {
    const auto mean =
        static_cast<float>(smaller(largest[i] / index[i], 1 / HeuristicRows::kSmallest));
    weight[i] = heuristic[i] > 0 ? mean : 0.0f;
  }
}

}  // namespace

void Field::fill_heuristic(Tile& tile) const {
  for (int y = 0; y < kTileSide; ++y) {
    for (int x = 0; x < kTileSide; ++x) {
      heuristic_.fill(
          {tile.x0 + x, tile.y0 + y}, weights_.beta,
          tile.heuristic + static_cast<std::ptrdiff_t>(y * kTileSide + x) * moves_.count);
    }
  }
}

void Field::fill_every_row(Tile& tile) const { fill_rows(tile, kEveryCell); }

void Field::fill_rows(Tile& tile, std::span<const std::uint16_t> cells) const {
  with_count(moves_.count, [&](auto moves) { fill_rows_of(tile, cells, moves); });
}

/// Of pheromone the weight is (tau / largest)^alpha, times (eta / largest)^beta if ants learn,
/// times the heuristic unless that stands beside it; of the terminal index see weigh_index.
template <class Count>
void Field::fill_rows_of(Tile& tile, std::span<const std::uint16_t> cells, Count moves) const {
  const bool index = params_.update == Update::terminal_index;
  const int row = mixture_ ? 2 * moves : moves;
  const auto least = static_cast<float>(least_ * per_scale_);
  const auto most = static_cast<float>(std::min(most_ * per_scale_, 3e38));
  Floats heuristic, tau, eta, weight;
  Doubles share, taught;
  while (!cells.empty()) {
    const auto batch = cells.first(std::min<std::size_t>(cells.size(), kBatch / moves));
    cells = cells.subspan(batch.size());
    const int count = static_cast<int>(batch.size()) * moves;
    for (int at = 0; const int cell : batch) {
      std::copy_n(tile.heuristic + std::ptrdiff_t{cell} * moves, static_cast<int>(moves),
                  &heuristic[at]);
      if (index) {
        read_index(tile, cell, moves, &share[at]);
      } else {
        read_trail(tile, cell, moves, &tau[at], &eta[at]);
      }
      at += moves;
    }
    if (!index) {
      for (int i = 0; i < count; ++i) tau[i] = smaller(larger(tau[i], least), most);
      divide_by_largest(tau, heuristic, count, moves, share);
    }
    raise_(share.data(), count, weights_.alpha);
    if (learned_) {
      divide_by_largest(eta, heuristic, count, moves, taught);
      raise_(taught.data(), count, weights_.beta);
      for (int i = 0; i < count; ++i) share[i] *= taught[i];
    }
    if (index) {
      weigh_index(share, heuristic, count, moves, weight);
    } else {
      weigh_trail(share, heuristic, count, mixture_, weight);
    }
    for (int at = 0; const int cell : batch) {
      float* const to = tile.rows + std::ptrdiff_t{cell} * row;
      std::copy_n(&weight[at], static_cast<int>(moves), to);
      if (mixture_) std::copy_n(&heuristic[at], static_cast<int>(moves), to + moves);
      at += moves;
    }
  }
}

/// Stored tau of each move out of a cell; if ants learn, what the cells that
/// they lead to have taught.
template <class Count>
void Field::read_trail(const Tile& tile, int cell, Count moves, float* tau, float* eta) const {
  const int x = cell % kTileSide, y = cell / kTileSide;
  const bool inside = std::min(x, y) >= reach_ && std::max(x, y) < kTileSide - reach_;
  const auto led_to = [&](int k) {  // by a move: the tile, if there is one, and the cell in it
    const auto [dx, dy] = moves_[k].to;
    return std::pair{inside ? &tile : find({tile.x0 + x + dx, tile.y0 + y + dy}),
                     ((y + dy) & (kTileSide - 1)) * kTileSide + ((x + dx) & (kTileSide - 1))};
  };
  if (params_.trail == Trail::arcs) {
    std::copy_n(tile.tau + std::ptrdiff_t{cell} * moves, static_cast<int>(moves), tau);
  } else {
    for (int k = 0; k < moves; ++k) {
      const auto [to, at] = led_to(k);
      tau[k] = to == nullptr ? untouched_ : to->tau[at];
    }
  }
  if (!learned_) return;
  for (int k = 0; k < moves; ++k) {
    const auto [to, at] = led_to(k);
    eta[k] = to == nullptr ? 1 : to->eta[at];
  }
}

/// K'(j) = K(j) - q Kmin of each move, Kmin over all free cells around (Li, Wang & Ma, eq. 8); tau
/// holds K.
template <class Count>
void Field::read_index(const Tile& tile, int cell, Count moves, double* index) const {
  const Cell from{tile.x0 + cell % kTileSide, tile.y0 + cell / kTileSide};
  double least = kInfinity;
  for (int k = 0; k < moves; ++k) {
    const Cell to = from + moves_[k].to;
    index[k] = 0;
    if (grid_->blocked(to)) continue;
    index[k] = tau(to, 0);
    least = std::min(least, index[k]);
  }
  for (int k = 0; k < moves; ++k) {
    index[k] = std::max(index[k] - params_.index_spread * least, 0x1p-200);
  }
}

void Field::edited(const Rectangle& part) {
  const bool everywhere = params_.heuristic == Heuristic::distance_field;
  if (everywhere) heuristic_.reset(*grid_, moves_, goal_, params_, stop_);
  for_all_tiles(1, stop_, [&](Tile& tile) {
    const bool beside =
        tile.x0 < part.x + part.width + reach_ && tile.y0 < part.y + part.height + reach_ &&
        part.x < tile.x0 + kTileSide + reach_ && part.y < tile.y0 + kTileSide + reach_;
    if (!beside && !everywhere) return;
    fill_heuristic(tile);
    fill_every_row(tile);
  });
}

void Field::refresh(const StepWeights& weights, int threads) {
  const bool heuristic = weights.beta != weights_.beta && heuristic_.depends_on_beta();
  // Bounds make rows drift without a deposit; so do new exponents.
  const bool bounded = least_ > 0 || most_ < kInfinity;
  const bool touched = bounded || was_bounded_ || weights.alpha != weights_.alpha ||
                       (weights.beta != weights_.beta && learned_);
  was_bounded_ = bounded;
  weights_ = weights;
  for_all_tiles(threads, stop_, [&](Tile& tile) {
    if (heuristic) fill_heuristic(tile);
    if (heuristic || all_stale_) {
      fill_every_row(tile);
    } else {
      refresh_tile(tile, touched);
    }
  });
  all_stale_ = false;
  for (Tile* tile : used_) {
    if (!tile->any_changed) continue;
    tile->changed.fill(0);
    tile->any_changed = false;
  }
}

void Field::refresh_tile(Tile& tile, bool touched) const {
  // A row reads its cell's neighbours (with arcs, its own cell): bits of cells beyond the tile
  // count too, up to the longest move.
  const bool arcs = params_.trail == Trail::arcs;
  const int around = arcs ? 0 : 1;
  constexpr int kPad = kernels::kMaxReach;
  // Bit x + kPad of entry y + kPad is cell (x, y).
  std::array<std::uint64_t, kTileSide + 2 * kPad> bits{};
  bool any = false;
  for (int ty = -around; ty <= around; ++ty) {
    for (int tx = -around; tx <= around; ++tx) {
      const Tile* from = find({tile.x0 + tx * kTileSide, tile.y0 + ty * kTileSide});
      if (from == nullptr || !(touched ? from->any_touched : from->any_changed)) continue;
      any = true;
      const int first = ty < 0 ? kTileSide - kPad : 0, last = ty > 0 ? kPad : kTileSide;
      for (int y = first; y < last; ++y) {
        // Of a cell that was forgotten only the change tells.
        const std::uint64_t word = from->changed[y] | (touched ? from->touched[y] : 0);
        bits[y + ty * kTileSide + kPad] |= tx < 0   ? word >> (kTileSide - kPad)
                                           : tx > 0 ? word << (kTileSide + kPad)
                                                    : word << kPad;
      }
    }
  }
  if (!any) return;
  std::array<std::uint16_t, kernels::kTileCells> stale;
  int count = 0;
  for (int y = 0; y < kTileSide; ++y) {
    std::uint64_t row = arcs ? bits[y + kPad] : 0;
    for (int k = 0; !arcs && k < moves_.count; ++k) {
      const auto [dx, dy] = moves_[k].to;
      const std::uint64_t word = bits[y + dy + kPad];
      row |= dx > 0 ? word >> dx : word << -dx;
    }
    for (auto left = static_cast<std::uint32_t>(row >> kPad); left != 0; left &= left - 1) {
      stale[count++] = static_cast<std::uint16_t>(y * kTileSide + std::countr_zero(left));
    }
  }
  fill_rows(tile, std::span(stale).first(count));
}

}  // namespace lasius
