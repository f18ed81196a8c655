// How a field's rows of weights are made, and which of them a change makes stale.

#include <algorithm>
#include <bit>
#include <limits>

#include "field.h"
#include "field_tile.h"
#include "parallel.h"

namespace lasius {
namespace {

using kernels::kTileSide;

constexpr int kManyTiles = 64;  // fewer are not worth waking threads for

/// Shares of the largest among the moves that exist; of the others, something up to 1.
void divide_by_largest(const float* values, const float* heuristic, int count,
                       double* shares) noexcept {
  float largest = std::numeric_limits<float>::min();
  for (int k = 0; k < count; ++k) {
    largest = std::max(largest, heuristic[k] > 0 ? values[k] : 0.0f);
  }
  for (int k = 0; k < count; ++k) {
    shares[k] = static_cast<double>(std::min(values[k], largest)) / largest;
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

void Field::fill_row(Tile& tile, int x, int y) const {
  const std::ptrdiff_t cell = y * kTileSide + x;
  const float* heuristic = tile.heuristic + cell * moves_.count;
  float* row = tile.rows + cell * (mixture_ ? 2 * moves_.count : moves_.count);
  if (params_.update == Update::terminal_index) return weigh_index(tile, x, y, heuristic, row);
  weigh_trail(tile, x, y, heuristic, row);
  for (int k = 0; k < moves_.count; ++k) {
    if (mixture_) {
      row[moves_.count + k] = heuristic[k];
    } else {
      row[k] *= heuristic[k];
    }
  }
}

/// (tau / largest)^alpha, with learned visibility times (eta / largest)^beta.
void Field::weigh_trail(const Tile& tile, int x, int y, const float* heuristic,
                        float* weights) const {
  std::array<float, kernels::kMaxMoves> tau, eta;
  read_trail(tile, x, y, tau.data(), eta.data());
  const auto least = static_cast<float>(least_ * per_scale_);
  const auto most = static_cast<float>(std::min(most_ * per_scale_, 3e38));
  for (int k = 0; k < moves_.count; ++k) tau[k] = std::clamp(tau[k], least, most);

  std::array<double, kernels::kMaxMoves> share;
  divide_by_largest(tau.data(), heuristic, moves_.count, share.data());
  raise_(share.data(), moves_.count, weights_.alpha);
  if (learned_) {
    std::array<double, kernels::kMaxMoves> taught;
    divide_by_largest(eta.data(), heuristic, moves_.count, taught.data());
    raise_(taught.data(), moves_.count, weights_.beta);
    for (int k = 0; k < moves_.count; ++k) share[k] *= taught[k];
  }
  for (int k = 0; k < moves_.count; ++k) {
    const double weight = std::max(share[k], HeuristicRows::kSmallest);
    weights[k] = heuristic[k] == 0 ? 0.0f : static_cast<float>(weight);
  }
}

/// Stored tau of each move out of a cell; what the cells that they lead to have taught, if ants
/// learn.
void Field::read_trail(const Tile& tile, int x, int y, float* tau, float* eta) const {
  if (params_.trail == Trail::arcs) {
    const std::ptrdiff_t cell = y * kTileSide + x;
    std::copy_n(tile.tau + cell * moves_.count, moves_.count, tau);
    if (!learned_) return;
  }
  const bool inside = std::min(x, y) >= reach_ && std::max(x, y) < kTileSide - reach_;
  for (int k = 0; k < moves_.count; ++k) {
    const auto [dx, dy] = moves_[k].to;
    const Tile* to = inside ? &tile : find({tile.x0 + x + dx, tile.y0 + y + dy});
    const int at = ((y + dy) & (kTileSide - 1)) * kTileSide + ((x + dx) & (kTileSide - 1));
    if (params_.trail == Trail::cells) tau[k] = to == nullptr ? untouched_ : to->tau[at];
    if (learned_) eta[k] = to == nullptr ? 1 : to->eta[at];
  }
}

/// K'(j)^alpha * d(j, E)^beta, K'(j) = K(j) - q Kmin, Kmin over all free cells around (Li, Wang &
/// Ma, eq. 8, 9); tau holds K. Scaled to a largest value of 1.
void Field::weigh_index(const Tile& tile, int x, int y, const float* heuristic,
                        float* weights) const {
  std::array<double, kernels::kMaxMoves> index{}, weight;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < moves_.count; ++k) {
    const auto [dx, dy] = moves_[k].to;
    const Cell to{tile.x0 + x + dx, tile.y0 + y + dy};
    if (grid_->blocked(to)) continue;
    index[k] = tau(to, 0);
    least = std::min(least, index[k]);
  }
  for (int k = 0; k < moves_.count; ++k) {
    weight[k] = std::max(index[k] - params_.index_spread * least, 0x1p-200);
  }
  raise_(weight.data(), moves_.count, weights_.alpha);
  double largest = 0;
  for (int k = 0; k < moves_.count; ++k) {
    weight[k] *= heuristic[k];
    largest = std::max(largest, weight[k]);
  }
  for (int k = 0; k < moves_.count; ++k) {
    const double share = std::max(weight[k] / largest, HeuristicRows::kSmallest);
    weights[k] = heuristic[k] == 0 ? 0.0f : static_cast<float>(share);
  }
}

void Field::refresh(const StepWeights& weights, int threads) {
  const bool heuristic = weights.beta != weights_.beta && heuristic_.depends_on_beta();
  // Bounds make rows drift without a deposit; so do new exponents.
  const bool touched =
      least_ > 0 || weights.alpha != weights_.alpha || (weights.beta != weights_.beta && learned_);
  weights_ = weights;
  const int tiles = static_cast<int>(used_.size());
  parallel_for(tiles, tiles > kManyTiles ? threads : 1, [&](int i, int) {
    if (heuristic) fill_heuristic(*used_[i]);
    refresh_tile(*used_[i], touched, heuristic || all_stale_);
  });
  all_stale_ = false;
  for (Tile* tile : used_) {
    if (!tile->any_changed) continue;
    tile->changed.fill(0);
    tile->any_changed = false;
  }
}

void Field::refresh_tile(Tile& tile, bool touched, bool all) const {
  // A row reads its cell's neighbours (with arcs, its own cell): bits of cells beyond the tile
  // count too, up to the longest move.
  const int reach = params_.trail == Trail::arcs ? 0 : reach_;
  const int around = reach > 0 ? 1 : 0;
  constexpr int kPad = kernels::kMaxReach;
  // Bit x + kPad of entry y + kPad is cell (x, y).
  std::array<std::uint64_t, kTileSide + 2 * kPad> bits{};
  bool any = all;
  for (int ty = -around; ty <= around; ++ty) {
    for (int tx = -around; tx <= around; ++tx) {
      const Tile* from = find({tile.x0 + tx * kTileSide, tile.y0 + ty * kTileSide});
      if (from == nullptr || !(touched ? from->any_touched : from->any_changed)) continue;
      any = true;
      const auto& source = touched ? from->touched : from->changed;
      const int first = ty < 0 ? kTileSide - kPad : 0, last = ty > 0 ? kPad : kTileSide;
      for (int y = first; y < last; ++y) {
        const std::uint64_t word = source[y];
        bits[y + ty * kTileSide + kPad] |= tx < 0   ? word >> (kTileSide - kPad)
                                           : tx > 0 ? word << (kTileSide + kPad)
                                                    : word << kPad;
      }
    }
  }
  if (!any) return;
  for (int y = 0; y < kTileSide; ++y) {
    std::uint64_t stale = 0;
    for (int dy = -reach; dy <= reach; ++dy) stale |= bits[y + kPad + dy];
    for (int dx = reach; dx > 0; --dx) stale |= stale << 1 | stale >> 1;
    auto rows = all ? ~std::uint32_t{0} : static_cast<std::uint32_t>(stale >> kPad);
    for (; rows != 0; rows &= rows - 1) fill_row(tile, std::countr_zero(rows), y);
  }
}

}  // namespace lasius
