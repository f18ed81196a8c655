#include "field.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "kernels/power.h"

namespace lasius {
namespace {

using kernels::kTileCells;
using kernels::kTileShift;
using kernels::kTileSide;

constexpr double kSmallest = 0x1p-60;      // of a weight's parts, largest 1
constexpr double kRescaleBelow = 0x1p-40;  // of the evaporation scale
constexpr double kHeuristicFloor = 0.5;    // cells; distance to the goal in inverse_distance

bool same_exponents(const StepWeights& a, const StepWeights& b) noexcept {
  return a.alpha == b.alpha && a.beta == b.beta;
}

/// ratio^alpha; by multiplication for the small integers that schedules end at.
double raise(double ratio, double alpha) noexcept {
  if (alpha == 1) return ratio;
  if (alpha == 2) return ratio * ratio;
  if (alpha == 4) return (ratio * ratio) * (ratio * ratio);
  return kernels::power(std::max(ratio, 0x1p-1000), alpha);
}

}  // namespace

struct Field::Tile {
  int index = 0;
  int x0 = 0, y0 = 0;                            // cell (0, 0) of the tile
  std::array<std::uint32_t, kTileSide> changed;  // cells with a deposit since the last refresh
  std::array<std::uint32_t, kTileSide> touched;  // cells with a deposit since the reset
  bool any_changed = false;
  bool any_touched = false;
  std::vector<float> storage;  // rows, heuristic, tau
  float* rows = nullptr;       // 64-byte aligned
  float* heuristic = nullptr;  // B of each cell and move
  float* tau = nullptr;        // stored tau of each cell, or cell and move
};

Field::Field() = default;
Field::~Field() = default;

void Field::reset(const Grid& grid, const kernels::Moves& moves, Cell goal, const Params& params) {
  const bool was_mixture = mixture_;
  const int lanes_before = lanes_;
  const auto trail_before = params_.trail;

  grid_ = &grid;
  moves_ = moves;
  goal_ = goal;
  params_ = params;
  lanes_ = moves.count;
  mixture_ = params.pheromone_rule_first > 0 || params.pheromone_rule > 0 ||
             params.distance_rule_first > 0 || params.distance_rule > 0;
  weights_ = schedule(params, 0);
  scale_ = params.initial_pheromone;
  untouched_ = 1;

  for (Tile* tile : used_) {
    rows_[tile->index] = nullptr;
    directory_[tile->index] = nullptr;
    unused_.push_back(tile);
  }
  used_.clear();
  if (mixture_ != was_mixture || lanes_ != lanes_before || params.trail != trail_before) {
    unused_.clear();
    pool_.clear();
  }
  tiles_x_ = (grid.width() + kTileSide - 1) / kTileSide;
  tiles_y_ = (grid.height() + kTileSide - 1) / kTileSide;
  const auto tiles = static_cast<std::size_t>(tiles_x_) * tiles_y_;
  if (directory_.size() < tiles) {
    rows_.resize(tiles, nullptr);
    directory_.resize(tiles, nullptr);
  }
}

Field::Tile* Field::find(int x, int y) const noexcept {
  if (x < 0 || y < 0 || x >= grid_->width() || y >= grid_->height()) return nullptr;
  return directory_[(y >> kTileShift) * tiles_x_ + (x >> kTileShift)];
}

float* Field::make_tile(void* field, int index) {
  return static_cast<Field*>(field)->obtain(index).rows;
}

Field::Tile& Field::obtain(int index) {
  const std::scoped_lock lock(making_);
  if (Tile* known = directory_[index]) return *known;
  if (unused_.empty()) {
    auto made = std::make_unique<Tile>();
    const std::size_t row = mixture_ ? 2 * lanes_ : lanes_;
    const std::size_t trail = params_.trail == Trail::arcs ? lanes_ : 1;
    made->storage.resize(kTileCells * (row + lanes_ + trail) + 16);
    const auto address = reinterpret_cast<std::uintptr_t>(made->storage.data());
    made->rows = made->storage.data() + (-address % 64) / sizeof(float);
    made->heuristic = made->rows + kTileCells * row;
    made->tau = made->heuristic + kTileCells * lanes_;
    unused_.push_back(made.get());
    pool_.push_back(std::move(made));
  }
  Tile& tile = *unused_.back();
  unused_.pop_back();
  tile.index = index;
  tile.x0 = index % tiles_x_ * kTileSide;
  tile.y0 = index / tiles_x_ * kTileSide;
  tile.changed.fill(0);
  tile.touched.fill(0);
  tile.any_changed = tile.any_touched = false;
  std::fill_n(tile.tau, kTileCells * (params_.trail == Trail::arcs ? lanes_ : 1), untouched_);
  directory_[index] = &tile;
  used_.push_back(&tile);
  fill_heuristic(tile);
  for (int y = 0; y < kTileSide; ++y) {
    for (int x = 0; x < kTileSide; ++x) fill_row(tile, x, y);
  }
  __atomic_store_n(&rows_[index], tile.rows, __ATOMIC_RELEASE);
  return tile;
}

void Field::fill_heuristic(Tile& tile) const {
  // Distances of the tile's cells and one more all around, each computed once.
  constexpr int kSide = kTileSide + 2;
  std::array<double, kSide * kSide> distance;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const double dx = tile.x0 + x - 1 - goal_.x, dy = tile.y0 + y - 1 - goal_.y;
      distance[y * kSide + x] = std::sqrt(dx * dx + dy * dy);
    }
  }
  for (int y = 0; y < kTileSide; ++y) {
    for (int x = 0; x < kTileSide; ++x) {
      float* b = tile.heuristic + (y * kTileSide + x) * lanes_;
      std::fill_n(b, lanes_, 0.0f);
      const Cell here{tile.x0 + x, tile.y0 + y};
      if (grid_->blocked(here)) continue;

      const auto at = [&](int dx, int dy) { return distance[(y + 1 + dy) * kSide + x + 1 + dx]; };
      double farthest = 0;
      std::array<bool, kernels::kMaxMoves> legal{};
      for (int k = 0; k < lanes_; ++k) {
        const int dx = moves_.dx[k], dy = moves_.dy[k];
        if (grid_->blocked({here.x + dx, here.y + dy})) continue;
        farthest = std::max(farthest, at(dx, dy));
        const int sides = grid_->free({here.x + dx, here.y}) + grid_->free({here.x, here.y + dy});
        const bool straight = dx == 0 || dy == 0;
        const int needed = params_.corners == Corners::forbid     ? 2
                           : params_.corners == Corners::one_side ? 1
                                                                  : 0;
        legal[k] = straight || sides >= needed;
      }
      std::array<double, kernels::kMaxMoves> value{};
      double largest = 0;
      for (int k = 0; k < lanes_; ++k) {
        if (!legal[k]) continue;
        const double d = at(moves_.dx[k], moves_.dy[k]);
        switch (params_.heuristic) {
          case Heuristic::uniform:
            value[k] = 1;
            break;
          case Heuristic::rescaled_distance:
            value[k] = raise((farthest - d) * params_.omega + params_.mu, params_.lambda);
            break;
          case Heuristic::inverse_distance:
            value[k] = kernels::power(std::max(d, kHeuristicFloor), -weights_.beta);
            break;
        }
        largest = std::max(largest, value[k]);
      }
      for (int k = 0; k < lanes_; ++k) {
        if (legal[k]) b[k] = static_cast<float>(std::max(value[k] / largest, kSmallest));
      }
    }
  }
}

float Field::stored(int x, int y) const noexcept {
  const Tile* tile = find(x, y);
  return tile == nullptr ? untouched_ : tile->tau[(y % kTileSide) * kTileSide + x % kTileSide];
}

void Field::fill_row(Tile& tile, int x, int y) const {
  const int cell = y * kTileSide + x;
  const float* b = tile.heuristic + cell * lanes_;
  float* row = tile.rows + cell * (mixture_ ? 2 * lanes_ : lanes_);
  const bool inside = x > 0 && y > 0 && x < kTileSide - 1 && y < kTileSide - 1;

  std::array<float, kernels::kMaxMoves> tau{};
  float largest = 0;
  for (int k = 0; k < lanes_; ++k) {
    if (b[k] == 0) continue;
    const int dx = moves_.dx[k], dy = moves_.dy[k];
    tau[k] = params_.trail == Trail::arcs ? tile.tau[cell * lanes_ + k]
             : inside                     ? tile.tau[cell + dy * kTileSide + dx]
                                          : stored(tile.x0 + x + dx, tile.y0 + y + dy);
    largest = std::max(largest, tau[k]);
  }
  for (int k = 0; k < lanes_; ++k) {
    float a = 0;
    if (b[k] != 0) {
      a = tau[k] == largest
              ? 1.0f
              : static_cast<float>(std::max(
                    raise(static_cast<double>(tau[k]) / largest, weights_.alpha), kSmallest));
    }
    if (mixture_) {
      row[k] = a;
      row[lanes_ + k] = b[k];
    } else {
      row[k] = a * b[k];
    }
  }
}

void Field::refresh(const StepWeights& weights, int threads) {
  const bool exponents = !same_exponents(weights, weights_);
  const bool heuristic =
      weights.beta != weights_.beta && params_.heuristic == Heuristic::inverse_distance;
  weights_ = weights;
  const int tiles = static_cast<int>(used_.size());
#pragma omp parallel for schedule(dynamic) num_threads(threads) if (threads > 1)
  for (int i = 0; i < tiles; ++i) {
    if (heuristic) fill_heuristic(*used_[i]);
    refresh_tile(*used_[i], exponents, heuristic);
  }
  for (Tile* tile : used_) {
    if (!tile->any_changed) continue;
    tile->changed.fill(0);
    tile->any_changed = false;
  }
}

void Field::refresh_tile(Tile& tile, bool touched, bool all) const {
  // A row reads the tau of its own cell's neighbours: bits of cells one beyond the tile count too.
  const bool cells = params_.trail == Trail::cells;
  std::array<std::uint64_t, kTileSide + 2> bits{};  // bit x + 1 of entry y + 1 is cell (x, y)
  bool any = all;
  for (int ty = cells ? -1 : 0; ty <= (cells ? 1 : 0); ++ty) {
    for (int tx = cells ? -1 : 0; tx <= (cells ? 1 : 0); ++tx) {
      const Tile* from = find(tile.x0 + tx * kTileSide, tile.y0 + ty * kTileSide);
      if (from == nullptr || !(touched ? from->any_touched : from->any_changed)) continue;
      any = true;
      const auto& source = touched ? from->touched : from->changed;
      const int first = ty < 0 ? kTileSide - 1 : 0, last = ty > 0 ? 0 : kTileSide - 1;
      for (int y = first; y <= last; ++y) {
        const std::uint64_t word = source[y];
        bits[y + ty * kTileSide + 1] |= tx < 0   ? word >> (kTileSide - 1)
                                        : tx > 0 ? (word & 1) << (kTileSide + 1)
                                                 : word << 1;
      }
    }
  }
  if (!any) return;
  for (int y = 0; y < kTileSide; ++y) {
    std::uint64_t stale = bits[y + 1];
    if (cells) {
      const std::uint64_t near = bits[y] | bits[y + 1] | bits[y + 2];
      stale = near << 1 | near | near >> 1;
    }
    std::uint64_t rows = all ? ~std::uint32_t{0} : static_cast<std::uint32_t>(stale >> 1);
    for (; rows != 0; rows &= rows - 1) fill_row(tile, std::countr_zero(rows), y);
  }
}

void Field::fill(kernels::WalkWorld& world) {
  world.tiles = rows_.data();
  world.tiles_x = tiles_x_;
  world.make_tile = &Field::make_tile;
  world.context = this;
}

void Field::evaporate(double persistence) {
  scale_ *= std::max(persistence, kSmallest);
  // A power of two keeps every ratio exact; values too small to matter in any draw stay positive.
  while (scale_ < kRescaleBelow * params_.initial_pheromone) {
    scale_ /= kRescaleBelow;
    const auto shrink = [](float& v) {
      v = std::max(v * static_cast<float>(kRescaleBelow), 0x1p-100f);
    };
    shrink(untouched_);
    for (Tile* tile : used_) {
      std::for_each_n(tile->tau, kTileCells * (params_.trail == Trail::arcs ? lanes_ : 1), shrink);
    }
  }
}

void Field::deposit(Cell c, int move, double amount) {
  const int index = (c.y >> kTileShift) * tiles_x_ + (c.x >> kTileShift);
  Tile& tile = directory_[index] != nullptr ? *directory_[index] : obtain(index);
  const int x = c.x % kTileSide, y = c.y % kTileSide;
  const int at =
      params_.trail == Trail::arcs ? (y * kTileSide + x) * lanes_ + move : y * kTileSide + x;
  tile.tau[at] += static_cast<float>(amount / scale_);
  tile.changed[y] |= std::uint32_t{1} << x;
  tile.touched[y] |= std::uint32_t{1} << x;
  tile.any_changed = tile.any_touched = true;
}

double Field::pheromone(Cell c) const {
  const Tile* tile = find(c.x, c.y);
  if (tile == nullptr) return untouched_ * scale_;
  const int cell = (c.y % kTileSide) * kTileSide + c.x % kTileSide;
  if (params_.trail == Trail::cells) return tile->tau[cell] * scale_;
  const float* arcs = tile->tau + cell * lanes_;
  return *std::max_element(arcs, arcs + lanes_) * scale_;
}

std::int64_t Field::bytes() const noexcept {
  std::int64_t total = static_cast<std::int64_t>(directory_.size()) * 2 * sizeof(void*);
  for (const auto& tile : pool_) {
    total += static_cast<std::int64_t>(tile->storage.size() * sizeof(float) + sizeof(Tile));
  }
  return total;
}

}  // namespace lasius
