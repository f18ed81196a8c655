#include "core/colony/field.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <limits>

#include "core/base/held_bytes.h"
#include "core/base/kernel_choice.h"
#include "core/base/special_values.h"
#include "core/colony/field_tile.h"
#include "core/grid/cell_distance.h"
#include "core/params/grid_parameters.h"

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

constexpr std::int64_t kAligned = 64 / sizeof(float);  // floats that alignment may cost
float* aligned(float* p) noexcept {
  return p + (-reinterpret_cast<std::uintptr_t>(p) % 64) / sizeof(float);
}

int in_tile(Cell c) noexcept { return (c.y & kInTile) * kTileSide + (c.x & kInTile); }

}  // namespace

Field::Field() = default;
Field::~Field() = default;

void Field::reset(const Grid& grid, const kernels::Moves& moves, Cell goal, const Params& params,
                  double untouched, const StopCondition& stop, std::span<const double> heuristic,
                  const cost::Terrain* terrain) {
  grid_ = &grid;
  stop_ = stop;
  moves_ = moves;
  goal_ = goal;
  raise_ = kernels::raise_row(chosen_isa());
  params_ = params;
  mixture_ = mixes_rules(params);
  learned_ = params.heuristic == Heuristic::learned;
  reach_ = 1;
  for (int k = 0; k < moves.count; ++k) reach_ = std::max<int>(reach_, std::abs(moves[k].to.dx));
  heuristic_.reset(grid, moves, goal, params, stop, heuristic, terrain);
  weights_ = schedule(params, 0);
  set_scale(untouched);
  untouched_ = 1;
  all_stale_ = false;
  bound(0, kInfinity);
  was_bounded_ = false;

  for (const int index : not_made_) rows_[index] = nullptr;
  not_made_.clear();
  constexpr int kWordsATile = 64;  // of work
  Poller poller(stop);
  for (; !used_.empty(); used_.pop_back()) {
    if (poller.stop_after(kWordsATile)) return;
    Tile* const tile = used_.back();
    rows_[tile->index] = nullptr;
    directory_[tile->index] = nullptr;
    unused_.push_back(tile);
  }
  tiles_x_ = (grid.width() + kTileSide - 1) / kTileSide;
  const auto tiles = std::int64_t{tiles_x_} * ((grid.height() + kTileSide - 1) / kTileSide);
  if (rows_.size() < tiles) rows_ = ZeroArray<float*>(tiles);
  if (directory_.size() < tiles) directory_ = ZeroArray<Tile*>(tiles);
}

Field::Tile* Field::find(Cell c) const noexcept {
  return grid_->contains(c) ? directory_[index_of(c)] : nullptr;
}

float* Field::make_tile(void* field, int index) {
  Field& f = *static_cast<Field*>(field);
  const std::scoped_lock lock(f.making_);
  if (f.rows_[index] != nullptr) return f.rows_[index];
  return f.stop_.poll() == StopCondition::Cause::none ? f.obtain(index).rows
                                                      : f.blocked_tile(index);
}

/// In the place of a tile that takes its time to be made.
float* Field::blocked_tile(int index) {
  const auto floats = static_cast<std::int64_t>(kTileCells * row_floats());
  if (blocked_rows_.size() < floats + kAligned) {
    blocked_rows_ = ZeroArray<float>(floats + kAligned);
  }
  not_made_.push_back(index);
  float* const rows = aligned(blocked_rows_.at(0));
  __atomic_store_n(&rows_[index], rows, __ATOMIC_RELEASE);
  return rows;
}

/// Room for a tile of this plan's kind, and where what is in it.
void Field::lay_out(Tile& tile) const {
  const std::size_t row = row_floats();
  const std::size_t floats = kTileCells * (row + moves_.count + taus() + learned_);
  if (tile.room < floats) {
    tile.storage = std::make_unique_for_overwrite<float[]>(floats + kAligned);
    tile.room = floats;
  }
  tile.rows = aligned(tile.storage.get());
  constexpr std::ptrdiff_t kCells = kTileCells;
  tile.heuristic = tile.rows + kCells * row;
  tile.tau = tile.heuristic + kCells * moves_.count;
  tile.eta = tile.tau + kCells * taus();
}

/// Makes a tile that there is not. One thread at a time.
Field::Tile& Field::obtain(int index) {
  if (unused_.empty()) {
    pool_.push_back(std::make_unique<Tile>());
    unused_.reserve(pool_.capacity());  // for all of them, when the next plan starts
    used_.reserve(pool_.capacity());
    unused_.push_back(pool_.back().get());
  }
  Tile& tile = *unused_.back();
  lay_out(tile);
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

void Field::equalise(const Rectangle& part, double radius, double share, double level) {
  for_all_tiles(1, {}, [&](Tile& tile) {
    for (int i = 0; i < static_cast<int>(kTileCells); ++i) {
      const Cell c{tile.x0 + i % kTileSide, tile.y0 + i / kTileSide};
      const double g = share * (1 - distance(c, part) / radius);
      if (!(g > 0) || !grid_->contains(c)) continue;
      for (int k = 0; k < taus(); ++k) set_tau(c, k, (1 - g) * tau(c, k) + g * level);
    }
  });
}

void Field::raise_untouched(double value) {
  untouched_ = static_cast<float>(value * per_scale_);
  for_all_tiles(1, {}, [&](Tile& tile) {
    for (std::ptrdiff_t cell = 0; cell < kTileCells; ++cell) {
      const bool touched = (tile.touched[cell / kTileSide] >> cell % kTileSide & 1) != 0;
      if (!touched) std::fill_n(tile.tau + cell * taus(), taus(), untouched_);
    }
  });
  all_stale_ = true;
}

void Field::forget(Cell c) {
  Tile& tile = touch(c);
  std::fill_n(tile.tau + std::ptrdiff_t{in_tile(c)} * taus(), taus(), untouched_);
  tile.touched[c.y & kInTile] &= ~(std::uint32_t{1} << (c.x & kInTile));
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
  for_all_tiles(1, {}, [&](Tile& tile) { std::for_each_n(tile.tau, kTileCells * taus(), shrink); });
}

void Field::bound(double least, double most) noexcept {
  least_ = least;
  most_ = most;
}

std::span<const float> Field::stored(int number, Cell& first) const noexcept {
  const Tile& tile = *used_[number];
  first = {tile.x0, tile.y0};
  return {tile.tau, static_cast<std::size_t>(kTileCells) * taus()};
}

std::int64_t Field::bytes() const noexcept {
  std::int64_t total = rows_.bytes() + directory_.bytes() + blocked_rows_.bytes() +
                       heuristic_.bytes() + held_bytes(not_made_, pool_, unused_, used_);
  for (const auto& tile : pool_) {
    total += static_cast<std::int64_t>((tile->room + kAligned) * sizeof(float) + sizeof(Tile));
  }
  return total;
}

void Field::fill(kernels::WalkWorld& world) {
  world.tiles = rows_.at(0);
  world.tiles_x = tiles_x_;
  world.make_tile = &Field::make_tile;
  world.context = this;
}

}  // namespace lasius
