#include "core/grid/components.h"

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>
#include <utility>

#include "core/base/poller.h"
#include "core/grid/components_tile.h"

namespace lasius {
namespace {

// Union-find over the border components of all tiles; the smallest index of a set is its root.
class Sets {
 public:
  explicit Sets(std::size_t most) { parents_.reserve(most); }
  /// Adds sets of one, up to index `size` - 1.
  void grow(std::uint32_t size) {
    for (auto i = static_cast<std::uint32_t>(parents_.size()); i < size; ++i) parents_.push_back(i);
  }
  std::uint32_t find(std::uint32_t i) noexcept {
    while (parents_[i] != i) {
      parents_[i] = parents_[parents_[i]];
      i = parents_[i];
    }
    return i;
  }
  void unite(std::uint32_t a, std::uint32_t b) noexcept {
    a = find(a);
    b = find(b);
    parents_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parents_;
};

constexpr std::uint32_t kNone = 0xffffffff;
constexpr int kSide = Components::kTile;
using Side = std::array<std::uint32_t, kSide>;

// What a tile counts as, read whole or along its border: four times its words, since in noise the
// runs of a word cost more than the word. One more never is too much between two polls.
constexpr std::int64_t kTileWork = std::int64_t{4} * kSide * TileBox::kWords;
constexpr std::int64_t kInterval = Poller::kWords - kTileWork;

// Joins the components of cells that face each other along a line; cells past `length` are kNone.
void join_lines(Sets& sets, const std::uint32_t* one, const std::uint32_t* two, int length) {
  for (int i = 0; i < length; ++i) {
    if (one[i] != kNone && two[i] != kNone) sets.unite(one[i], two[i]);
  }
}

}  // namespace

std::uint32_t Components::id(std::uint32_t index) const noexcept {
  const std::uint8_t* bytes = ids_.data() + std::size_t{3} * index;
  return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8 |
         static_cast<std::uint32_t>(bytes[2]) << 16;
}

Components::Components(const Grid& grid, Connectivity connectivity)
    : Components(*make(grid, connectivity, {})) {}

std::optional<Components> Components::make(const Grid& grid, Connectivity connectivity,
                                           const StopCondition& stop) {
  std::optional<Components> made(Components{});
  made->connectivity_ = connectivity;
  made->tiles_x_ = (grid.width() + kTile - 1) / kTile;
  made->tiles_y_ = (grid.height() + kTile - 1) / kTile;
  auto& tiles = made->tiles_;
  auto& marks = made->marks_;
  Poller poller(stop, kInterval);
  TileLabels labels;
  std::uint32_t ids = 0;
  for (int y = 0; y < made->tiles_y_; ++y) {
    for (int x = 0; x < made->tiles_x_; ++x) {
      labels.label(grid, TileBox::at(grid, x, y), connectivity == Connectivity::eight);
      tiles.push_back({ids, static_cast<std::uint32_t>(marks.size()),
                       static_cast<std::uint32_t>(labels.inside_components()), 0});
      marks.insert(marks.end(), labels.marks().begin(), labels.marks().end());
      ids += static_cast<std::uint32_t>(labels.border_components());
      if (poller.stop_after(kTileWork)) return std::nullopt;
    }
  }
  tiles.push_back({ids, static_cast<std::uint32_t>(marks.size()), 0, 0});
  if (!made->join(grid, poller)) made.reset();
  return made;
}

// Finds the ids, all tiles' border components being known; false when stopped.
bool Components::join(const Grid& grid, Poller& poller) {
  const std::uint32_t size = tiles_.back().first_id;
  Sets sets(size);
  // Components along the bottom of the tiles above, and right of the tile before; both with a
  // cell of none at either end, for diagonal steps.
  std::vector<std::uint32_t> above(tiles_x_ * kSide + 2, kNone);
  std::vector<std::uint32_t> bottom = above;
  std::vector<std::uint32_t> before(kSide + 2, kNone);
  const bool eight = connectivity_ == Connectivity::eight;
  std::array<std::uint32_t, 1024> around;
  for (int ty = 0; ty < tiles_y_; ++ty) {
    std::fill(before.begin(), before.end(), kNone);
    for (int tx = 0; tx < tiles_x_; ++tx) {
      const TileBox box = TileBox::at(grid, tx, ty);
      const Tile& tile = tiles_[ty * tiles_x_ + tx];
      sets.grow(tiles_[ty * tiles_x_ + tx + 1].first_id);
      around.fill(kNone);
      for_each_run(border_of(grid, box), marks_.data() + tile.first_mark,
                   [&](int first, int last, int component) {
                     std::fill(around.begin() + first, around.begin() + last + 1,
                               tile.first_id + static_cast<std::uint32_t>(component));
                     return true;
                   });
      Side left;
      for (int y = 0; y < box.height; ++y) left[y] = around[box.border_position(0, y)];
      for (int d = eight ? -1 : 0; d <= (eight ? 1 : 0); ++d) {
        join_lines(sets, around.data(), above.data() + 1 + box.x + d, box.width);
        join_lines(sets, left.data(), before.data() + 1 + d, box.height);
      }
      std::fill(before.begin(), before.end(), kNone);
      for (int y = 0; y < box.height; ++y) {
        before[1 + y] = around[box.border_position(box.width - 1, y)];
      }
      for (int x = 0; x < box.width; ++x) {
        bottom[1 + box.x + x] = around[box.border_position(x, box.height - 1)];
      }
      if (poller.stop_after(kTileWork)) return false;
    }
    above.swap(bottom);
  }
  ids_.clear();
  ids_.reserve(std::size_t{3} * size);
  count_ = 0;
  for (std::size_t i = 0; i + 1 < tiles_.size(); ++i) {
    Tile& tile = tiles_[i];
    count_ += tile.inside;
    tile.alike = 1;
    for (std::uint32_t j = tile.first_id; j < tiles_[i + 1].first_id; ++j) {
      const std::uint32_t root = sets.find(j);
      count_ += root == j;
      for (int byte = 0; byte < 3; ++byte) ids_.push_back((root >> (8 * byte)) & 0xff);
      if (id(j) != id(tile.first_id)) tile.alike = 0;
    }
    if (poller.stop_after(kTileWork)) return false;
  }
  marks_.shrink_to_fit();
  tiles_.shrink_to_fit();
  return true;
}

struct Components::Home {
  std::uint32_t id;  // kNone: shut in its tile
  bool met_other;
};

Components::Home Components::home(const Grid& grid, Cell c, Cell other) const noexcept {
  const int tile_x = c.x / kTile;
  const int tile_y = c.y / kTile;
  const std::size_t index = static_cast<std::size_t>(tile_y) * tiles_x_ + tile_x;
  const Tile& tile = tiles_[index];
  if (tile.inside == 0 && tile.alike != 0) return {id(tile.first_id), false};
  const TileBox box = TileBox::at(grid, tile_x, tile_y);
  const FloodEnd end = flood(grid, box, connectivity_ == Connectivity::eight, c, other);
  if (end.met != FloodEnd::Met::border) return {kNone, end.met == FloodEnd::Met::other};
  if (tile.alike != 0) return {id(tile.first_id), false};
  std::uint32_t found = kNone;
  for_each_run(border_of(grid, box), marks_.data() + tile.first_mark,
               [&](int, int last, int component) {
                 if (last < end.position) return true;
                 found = id(tile.first_id + static_cast<std::uint32_t>(component));
                 return false;
               });
  return {found, false};
}

bool Components::connected(const Grid& grid, Cell a, Cell b) const noexcept {
  if (grid.blocked(a) || grid.blocked(b)) return false;
  const Home home_a = home(grid, a, b);
  if (home_a.met_other || home_a.id == kNone) return home_a.met_other;
  const Home home_b = home(grid, b, a);
  return home_b.met_other || home_b.id == home_a.id;
}

Components Components::updated(const Grid& edited, std::span<const Cell> changed) const {
  return *updated(edited, changed, {});
}

std::optional<Components> Components::updated(const Grid& edited, std::span<const Cell> changed,
                                              const StopCondition& stop) const {
  std::vector<char> dirty(tiles_.size(), 0);
  bool same_borders = true;
  for (const Cell c : changed) {
    const int tile_x = c.x / kTile;
    const int tile_y = c.y / kTile;
    const TileBox box = TileBox::at(edited, tile_x, tile_y);
    dirty[tile_y * tiles_x_ + tile_x] = 1;
    same_borders = same_borders && c.x > box.x && c.x < box.x + box.width - 1 && c.y > box.y &&
                   c.y < box.y + box.height - 1;
  }
  Components result;
  result.connectivity_ = connectivity_;
  result.tiles_x_ = tiles_x_;
  result.tiles_y_ = tiles_y_;
  result.count_ = count_;
  result.tiles_ = tiles_;
  Poller poller(stop, kInterval);
  TileLabels labels;
  std::uint32_t ids = 0;
  for (int i = 0; i < tiles_x_ * tiles_y_; ++i) {
    const Tile& old = tiles_[i];
    Tile& tile = result.tiles_[i];
    auto marks =
        std::span(marks_).subspan(old.first_mark, tiles_[i + 1].first_mark - old.first_mark);
    std::uint32_t count = tiles_[i + 1].first_id - old.first_id;
    tile.first_id = ids;
    tile.first_mark = static_cast<std::uint32_t>(result.marks_.size());
    if (dirty[i] != 0) {
      labels.label(edited, TileBox::at(edited, i % tiles_x_, i / tiles_x_),
                   connectivity_ == Connectivity::eight);
      same_borders = same_borders && std::ranges::equal(marks, labels.marks());
      marks = labels.marks();
      count = static_cast<std::uint32_t>(labels.border_components());
      tile.inside = static_cast<std::uint32_t>(labels.inside_components());
      result.count_ += static_cast<std::int64_t>(tile.inside) - old.inside;
    }
    result.marks_.insert(result.marks_.end(), marks.begin(), marks.end());
    ids += count;
    if (poller.stop_after(dirty[i] != 0 ? kTileWork : std::ssize(marks))) return std::nullopt;
  }
  result.tiles_.back() = {ids, static_cast<std::uint32_t>(result.marks_.size()), 0, 0};
  if (same_borders) {
    result.ids_ = ids_;
    result.marks_.shrink_to_fit();
  } else if (!result.join(edited, poller)) {
    return std::nullopt;
  }
  return result;
}

std::int64_t Components::bytes() const noexcept {
  return static_cast<std::int64_t>(sizeof(*this) + tiles_.capacity() * sizeof(Tile) +
                                   ids_.capacity() + marks_.capacity() * sizeof(std::uint64_t));
}

}  // namespace lasius
