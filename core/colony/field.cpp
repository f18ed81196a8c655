#include "core/colony/field.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <limits>

#include "core/base/kernel_choice.h"
#include "core/colony/field_tile.h"

namespace lasius {
namespace {

using kernels::kTileCells;
using kernels::kTileShift;
using kernels::kTileSide;

constexpr double kRescaleBelow = 0x1p-40;  // of the evaporation scale
constexpr double kRescaleAbove = 0x1p80;   // of stored values
constexpr double kMostScale = 0x1p800;
constexpr float kTiny = 0x1p-100f;  // stored values stay above: ratios stay defined
constexpr int kInTile = kTileSide - 1;

int in_tile(Cell c) noexcept { return (c.y & kInTile) * kTileSide + (c.x & kInTile); }

}  // namespace

Field::Field() = default;
Field::~Field() = default;

void Field::reset(const Grid& grid, const kernels::Moves& moves, Cell goal, const Params& params,
                  double untouched, const StopCondition& stop) {
  grid_ = &grid;
  stop_ = stop;
  moves_ = moves;
  raise_ = kernels::raise_row(chosen_isa());
  params_ = params;
  mixture_ = mixes_rules(params);
  learned_ = params.heuristic == Heuristic::learned;
  reach_ = 1;
  for (int k = 0; k < moves.count; ++k) reach_ = std::max<int>(reach_, std::abs(moves[k].to.dx));
  heuristic_.reset(grid, moves, goal, params, stop);
  weights_ = schedule(params, 0);
  set_scale(untouched);
  untouched_ = 1;
  all_stale_ = false;
  bound(0, std::numeric_limits<double>::infinity());

  for (Tile* tile : used_) {
    rows_[tile->index] = nullptr;
    directory_[tile->index] = nullptr;
  }
  unused_.insert(unused_.end(), used_.begin(), used_.end());
  used_.clear();
  const std::tuple shape(mixture_, learned_, moves_.count, taus());
  if (shape != pool_shape_) {
    unused_.clear();
    pool_.clear();
    pool_shape_ = shape;
  }
  tiles_x_ = (grid.width() + kTileSide - 1) / kTileSide;
  const auto tiles =
      static_cast<std::size_t>(tiles_x_) * ((grid.height() + kTileSide - 1) / kTileSide);
  if (directory_.size() < tiles) {
    rows_.resize(tiles, nullptr);
    directory_.resize(tiles, nullptr);
  }
}

Field::Tile* Field::find(Cell c) const noexcept {
  return grid_->contains(c) ? directory_[index_of(c)] : nullptr;
}

float* Field::make_tile(void* field, int index) {
  return static_cast<Field*>(field)->obtain(index).rows;
}

Field::Tile& Field::obtain(int index) {
  const std::scoped_lock lock(making_);
  if (Tile* known = directory_[index]) return *known;
  const std::size_t row = mixture_ ? 2 * moves_.count : moves_.count;
  if (unused_.empty()) {
    auto made = std::make_unique<Tile>();
    made->storage.resize(kTileCells * (row + moves_.count + taus() + learned_) + 16);
    const auto address = reinterpret_cast<std::uintptr_t>(made->storage.data());
    made->rows = made->storage.data() + (-address % 64) / sizeof(float);
    constexpr std::ptrdiff_t kCells = kTileCells;
    made->heuristic = made->rows + kCells * row;
    made->tau = made->heuristic + kCells * moves_.count;
    made->eta = made->tau + kCells * taus();
    pool_.push_back(std::move(made));
    unused_.reserve(pool_.capacity());  // for all of them, when the next plan starts
    unused_.push_back(pool_.back().get());
  }
  Tile& tile = *unused_.back();
  unused_.pop_back();
  tile.index = index;
  tile.x0 = index % tiles_x_ * kTileSide;
  tile.y0 = index / tiles_x_ * kTileSide;
  tile.changed.fill(0);
  tile.touched.fill(0);
  tile.any_changed = tile.any_touched = false;
  std::fill_n(tile.tau, kTileCells * taus(), untouched_);
  if (learned_) std::fill_n(tile.eta, kTileCells, 1.0f);
  used_.push_back(&tile);
  directory_[index] = &tile;
  fill_heuristic(tile);
  fill_every_row(tile);
  __atomic_store_n(&rows_[index], tile.rows, __ATOMIC_RELEASE);
  return tile;
}

Field::Tile& Field::touch(Cell c) {
  const int index = index_of(c);
  Tile& tile = directory_[index] != nullptr ? *directory_[index] : obtain(index);
  const std::uint32_t bit = std::uint32_t{1} << (c.x & kInTile);
  tile.changed[c.y & kInTile] |= bit;
  tile.touched[c.y & kInTile] |= bit;
  tile.any_changed = tile.any_touched = true;
  return tile;
}

double Field::tau(Cell c, int move) const {
  const Tile* tile = find(c);
  const int at = in_tile(c) * taus() + (taus() > 1 ? move : 0);
  const float stored = tile == nullptr ? untouched_ : tile->tau[at];
  return std::clamp(stored * scale_, least_, most_);
}

void Field::set_tau(Cell c, int move, double value) {
  store(touch(c).tau[in_tile(c) * taus() + (taus() > 1 ? move : 0)], value);
}

void Field::deposit(Cell c, int move, double amount) {
  float& stored = touch(c).tau[in_tile(c) * taus() + (taus() > 1 ? move : 0)];
  store(stored, std::clamp(stored * scale_, least_, most_) + amount);
}

void Field::store(float& stored, double value) {
  double scaled = value * per_scale_;
  while (scaled > kRescaleAbove) {
    scaled *= kRescaleBelow;
    shrink_stored();
    if (scale_ < kMostScale) set_scale(scale_ / kRescaleBelow);
  }
  stored = std::max(static_cast<float>(scaled), kTiny);
}

void Field::raise_untouched(double value) {
  untouched_ = static_cast<float>(value * per_scale_);
  for_all_tiles(1, [&](Tile& tile) {
    for (std::ptrdiff_t cell = 0; cell < kTileCells; ++cell) {
      const bool touched = (tile.touched[cell / kTileSide] >> cell % kTileSide & 1) != 0;
      if (!touched) std::fill_n(tile.tau + cell * taus(), taus(), untouched_);
    }
  });
  all_stale_ = true;
}

bool Field::exists(Cell c, int move) {
  const int index = index_of(c);
  const Tile& tile = directory_[index] != nullptr ? *directory_[index] : obtain(index);
  return tile.heuristic[in_tile(c) * moves_.count + move] > 0;
}

double Field::eta(Cell c) const {
  const Tile* tile = find(c);
  return tile == nullptr || !learned_ ? 1 : tile->eta[in_tile(c)];
}

void Field::set_eta(Cell c, double value) {
  touch(c).eta[in_tile(c)] =
      std::clamp(static_cast<float>(value), kTiny, std::numeric_limits<float>::max());
}

double Field::pheromone(Cell c) const {
  double most = 0;
  for (int k = 0; k < taus(); ++k) most = std::max(most, tau(c, k));
  return most;
}

void Field::evaporate(double persistence) {
  set_scale(scale_ * std::max(persistence, HeuristicRows::kSmallest));
  keep_scale_in_range();
}

void Field::keep_scale_in_range() {
  assert(scale_ > 0);
  while (scale_ < kRescaleBelow) {
    set_scale(scale_ / kRescaleBelow);
    shrink_stored();
  }
}

void Field::shrink_stored() {
  // A power of two keeps every ratio exact; values too small to matter in any draw stay positive.
  const auto shrink = [](float& v) { v = std::max(v * static_cast<float>(kRescaleBelow), kTiny); };
  shrink(untouched_);
  for_all_tiles(1, [&](Tile& tile) { std::for_each_n(tile.tau, kTileCells * taus(), shrink); });
}

void Field::bound(double least, double most) noexcept {
  least_ = least;
  most_ = most;
}

std::int64_t Field::bytes() const noexcept {
  auto total = static_cast<std::int64_t>(directory_.size() * 2 * sizeof(void*));
  for (const auto& tile : pool_) {
    total += static_cast<std::int64_t>(tile->storage.size() * sizeof(float) + sizeof(Tile));
  }
  return total;
}

void Field::fill(kernels::WalkWorld& world) {
  world.tiles = rows_.data();
  world.tiles_x = tiles_x_;
  world.make_tile = &Field::make_tile;
  world.context = this;
}

}  // namespace lasius
