#include "core/grid/components.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/held_bytes.h"
#include "core/base/poller.h"
#include "core/grid/components_tile.h"

namespace lasius {
namespace {

// What a tile counts as, read whole or along its border: four times its words, since in noise the
// runs of a word cost more than the word. A block counts as its pieces, at most 2^16; one more of
// either never is too much between two polls.
constexpr std::int64_t kTileWork = std::int64_t{4} * Components::kTile * TileBox::kWords;
constexpr std::int64_t kInterval = Poller::kWords / 2;

// Of a rectangle of cells, the tiles, and of each the sides that it touches as bits of
// Outline::Direction.
template <typename Visit>
void for_each_tile(const Grid& grid, const Rectangle& part, const Visit& visit) {
  if (part.width == 0 || part.height == 0) return;
  const int right = part.x + part.width - 1;
  const int bottom = part.y + part.height - 1;
  for (int y = part.y / Components::kTile; y <= bottom / Components::kTile; ++y) {
    for (int x = part.x / Components::kTile; x <= right / Components::kTile; ++x) {
      const TileBox box = TileBox::at(grid, x, y);
      const bool sides[] = {part.y <= box.y, right >= box.x + box.width - 1,
                            bottom >= box.y + box.height - 1, part.x <= box.x};
      unsigned touched = 0;
      for (int i = 0; i < 4; ++i) touched |= static_cast<unsigned>(sides[i]) << i;
      visit(Cell{x, y}, touched);
    }
  }
}

}  // namespace

// An update under way.
struct Components::Work {
  Work(const StopCondition& stop, bool begun) : poller(stop, kInterval), all(begun) {}
  Poller poller;
  bool all;  // an update was stopped: what outlines were before is not known
  std::vector<std::uint32_t> stale;  // blocks of the level that is next
  TileLabels labels;
  BlockJoin join;
  std::array<Outline, 4> outlines;  // of tiles
};

Components::Components(const Grid& grid, Connectivity connectivity)
    : Components(*make(grid, connectivity, {})) {}

std::optional<Components> Components::make(const Grid& grid, Connectivity connectivity,
                                           const StopCondition& stop) {
  std::optional<Components> made(Components{});
  made->connectivity_ = connectivity;
  made->tiles_x_ = (grid.width() + kTile - 1) / kTile;
  made->tiles_y_ = (grid.height() + kTile - 1) / kTile;
  made->tiles_.resize(static_cast<std::size_t>(made->tiles_x_) * made->tiles_y_);
  int x = made->tiles_x_;
  int y = made->tiles_y_;
  do {
    x = (x + 1) / 2;
    y = (y + 1) / 2;
    made->blocks_.emplace_back(static_cast<std::size_t>(x) * y);
  } while (x > 1 || y > 1);
  made->pending_.push_back({0, 0, grid.width(), grid.height()});
  if (!made->update(grid, {}, stop)) made.reset();
  return made;
}

int Components::columns(std::size_t level) const noexcept {
  return ((tiles_x_ - 1) >> (level + 1)) + 1;
}

bool Components::update(const Grid& edited, std::span<const Rectangle> changed,
                        const StopCondition& stop) {
  Work work(stop, !pending_.empty());
  pending_.insert(pending_.end(), changed.begin(), changed.end());
  relabel(edited, work);
  for (std::size_t level = 0; level < blocks_.size(); ++level) rejoin(edited, level, work);
  if (work.poller.stopped()) return false;
  pending_.clear();
  return true;
}

// Labels the tiles that hold pending rectangles; the blocks around those with other borders, and
// around their neighbours where facing cells changed, are stale.
void Components::relabel(const Grid& grid, Work& work) {
  std::vector<std::pair<std::uint32_t, unsigned>> touched;
  for (const Rectangle& part : pending_) {
    for_each_tile(grid, part, [&](Cell at, unsigned sides) {
      touched.emplace_back(at.y * tiles_x_ + at.x, sides);
    });
  }
  std::ranges::sort(touched);
  const auto is_stale = [&](Cell tile) {
    if (tile.x < 0 || tile.y < 0 || tile.x >= tiles_x_ || tile.y >= tiles_y_) return;
    work.stale.push_back(tile.y / 2 * columns(0) + tile.x / 2);
  };
  for (std::size_t i = 0; i < touched.size() && !work.poller.stopped();) {
    const std::uint32_t index = touched[i].first;
    unsigned sides = 0;
    for (; i < touched.size() && touched[i].first == index; ++i) sides |= touched[i].second;
    const Cell at{static_cast<int>(index) % tiles_x_, static_cast<int>(index) / tiles_x_};
    work.labels.label(grid, TileBox::at(grid, at.x, at.y), connectivity_ == Connectivity::eight);
    Tile& tile = tiles_[index];
    const auto inside = static_cast<std::uint32_t>(work.labels.inside_components());
    count_ += std::int64_t{inside} - tile.inside;
    tile.inside = inside;
    tile.main = work.labels.main();
    const auto marks = work.labels.marks();
    if (work.all || sides != 0 || !std::ranges::equal(tile.marks, marks)) {
      tile.marks.assign(marks.begin(), marks.end());
      is_stale(at);
    }
    constexpr Cell kBeside[] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
    for (int side = 0; side < 4; ++side) {
      const Cell step = kBeside[side];
      if ((sides >> side & 1) != 0) is_stale({at.x + step.x, at.y + step.y});
    }
    work.poller.stop_after(kTileWork);
  }
}

// The index of a block's part, a tile or a smaller block; outside the map -1.
std::ptrdiff_t Components::part(std::size_t level, Cell at) const noexcept {
  const int across = level == 0 ? tiles_x_ : columns(level - 1);
  const auto size = level == 0 ? std::ssize(tiles_) : std::ssize(blocks_[level - 1]);
  const auto index = static_cast<std::ptrdiff_t>(at.y) * across + at.x;
  return at.x < across && index < size ? index : -1;
}

// Joins the stale blocks of a level; those around the ones whose outlines change are stale then.
void Components::rejoin(const Grid& grid, std::size_t level, Work& work) {
  const bool eight = connectivity_ == Connectivity::eight;
  std::vector<std::uint32_t> stale;
  stale.swap(work.stale);
  std::ranges::sort(stale);
  stale.erase(std::unique(stale.begin(), stale.end()), stale.end());
  for (const std::uint32_t index : stale) {
    if (work.poller.stopped()) return;
    const int x = static_cast<int>(index) % columns(level);
    const int y = static_cast<int>(index) / columns(level);
    std::array<std::ptrdiff_t, 4> parts;
    BlockJoin::Parts outlines;
    for (int i = 0; i < 4; ++i) {
      const Cell at{2 * x + i % 2, 2 * y + i / 2};
      parts[i] = part(level, at);
      outlines[i] = &work.outlines[i];
      if (parts[i] < 0) {
        work.outlines[i].clear();
      } else if (level == 0) {
        outline_tile(grid, TileBox::at(grid, at.x, at.y), tiles_[parts[i]].marks, eight,
                     work.outlines[i]);
      } else {
        outlines[i] = &blocks_[level - 1][parts[i]].outline;
      }
    }
    work.join.join(outlines, eight);
    for (int i = 0; i < 4; ++i) {
      if (parts[i] < 0) continue;
      const auto up = work.join.up(i);
      (level == 0 ? tiles_[parts[i]].up : blocks_[level - 1][parts[i]].up)
          .assign(up.begin(), up.end());
    }
    Block& block = blocks_[level][index];
    count_ += std::int64_t{work.join.closed()} - block.closed;
    block.closed = work.join.closed();
    if (work.all || block.outline != work.join.outline()) {
      block.outline = work.join.outline();
      if (level + 1 < blocks_.size()) work.stale.push_back(y / 2 * columns(level + 1) + x / 2);
    }
    work.poller.stop_after(level == 0 ? 4 * kTileWork : work.join.pieces());
  }
}

// Where a cell belongs: to a piece of a block around its tile, unless it is shut in the tile.
struct Components::Membership {
  enum class Met { piece, nothing, other } met;
  std::size_t level;
  Piece piece;
};

const Components::Block& Components::block(std::size_t level, Cell tile) const noexcept {
  return blocks_[level][(tile.y >> (level + 1)) * columns(level) + (tile.x >> (level + 1))];
}

Components::Membership Components::membership(const Grid& grid, Cell c, Cell other) const noexcept {
  using Met = Membership::Met;
  const Cell at{c.x / kTile, c.y / kTile};
  const Tile& tile = tiles_[part(0, at)];
  const auto is_main = [&](Cell cell) {
    return cell.x / kTile == at.x && cell.y / kTile == at.y &&
           tile.main.is_alone(cell.x % kTile, cell.y % kTile);
  };
  if (is_main(c)) {
    if (tile.main.piece != Side::kNone) return {Met::piece, 0, tile.up[tile.main.piece]};
    if (is_main(other)) return {Met::other, 0, 0};
  }
  const TileBox box = TileBox::at(grid, at.x, at.y);
  const FloodEnd end = flood(grid, box, connectivity_ == Connectivity::eight, c, other);
  if (end.met != FloodEnd::Met::border)
    return {end.met == FloodEnd::Met::other ? Met::other : Met::nothing, 0, 0};
  int found = 0;
  for_each_run(border_of(grid, box), tile.marks.data(), [&](int, int last, int piece) {
    found = piece;
    return last < end.position;
  });
  return {Met::piece, 0, tile.up[found]};
}

bool Components::connected(const Grid& grid, Cell a, Cell b) const noexcept {
  if (grid.blocked(a) || grid.blocked(b)) return false;
  if (count_ == 1) return true;
  Membership of_a = membership(grid, a, b);
  if (of_a.met != Membership::Met::piece) return of_a.met == Membership::Met::other;
  Membership of_b = membership(grid, b, a);
  if (of_b.met != Membership::Met::piece) return of_b.met == Membership::Met::other;
  const Cell tile_a{a.x / kTile, a.y / kTile};
  const Cell tile_b{b.x / kTile, b.y / kTile};
  // Climbs one level; false if nothing of the piece is beyond.
  const auto climb = [this](Membership& of_cell, Cell tile) {
    const Block& around = block(of_cell.level++, tile);
    if (of_cell.piece >= around.outline.open) return false;
    of_cell.piece = around.up[of_cell.piece];
    return true;
  };
  for (;;) {
    if (of_a.level == of_b.level && of_a.piece == of_b.piece &&
        &block(of_a.level, tile_a) == &block(of_b.level, tile_b)) {
      return true;
    }
    if (!(of_a.level <= of_b.level ? climb(of_a, tile_a) : climb(of_b, tile_b))) return false;
  }
}

std::optional<Components> Components::updated(const Grid& edited, std::span<const Cell> changed,
                                              const StopCondition& stop) const {
  std::vector<Rectangle> parts;
  for (const Cell c : changed) parts.push_back({c.x, c.y, 1, 1});
  std::optional<Components> next(*this);
  if (!next->update(edited, parts, stop)) next.reset();
  return next;
}

std::int64_t Components::bytes() const noexcept {
  std::int64_t sum = sizeof *this + held_bytes(tiles_, blocks_, pending_);
  for (const Tile& tile : tiles_) sum += held_bytes(tile.marks, tile.up);
  for (const auto& level : blocks_) {
    sum += held_bytes(level);
    for (const Block& block : level) {
      sum += held_bytes(block.up);
      for (const Side& side : block.outline.sides) sum += side.bytes();
    }
  }
  return sum;
}

}  // namespace lasius
