// CornerLabels in a file.
#include "core/base/stored_arrays.h"
#include "core/exact/labels/corner_labels.h"

namespace lasius::exact {

namespace {

/// All of them, in the order of the file.
template <class Arrays, class Act>
void for_each_array(Arrays& a, const Act& act) {
  act(a.corners);
  act(a.groups);
  act(a.hubs);
  act(a.lengths);
  act(a.steps);
  act(a.tiles);
  act(a.live);
  act(a.dead);
  act(a.masks);
}

/// @throws Error(file_broken) unless these are labels of `count` corners.
void check_labels(const LabelArrays& a, std::uint32_t count, ArrayReader& from) {
  const std::size_t entries = a.hubs.size();
  from.require(a.corners.size() == count && !a.groups.empty() && a.lengths.size() == entries &&
               a.steps.size() == entries && a.groups.back().first == entries);
  std::uint32_t before = 0;
  for (const LabelCorner& c : a.corners) {
    from.require(c.first == before && c.first <= c.middle && c.middle <= c.last && c.rank < count);
    before = c.last;
  }
  from.require(before + std::size_t{1} == a.groups.size());
  for (std::size_t i = 1; i < a.groups.size(); ++i)
    from.require(a.groups[i - 1].first <= a.groups[i].first);
  for (std::size_t e = 0; e < entries; ++e) {
    const LabelStep step = a.steps[e];
    from.require(a.hubs[e] < count && step.corner < count && a.lengths[e] > 0);
    // Ways get shorter: none goes round for ever.
    from.require(step.entry == CornerLabels::kArrived ||
                 (step.entry < entries && a.lengths[step.entry] < a.lengths[e]));
  }
}

/// @throws Error(file_broken) unless these are what so many tiles see of `count` corners.
void check_tiles(const LabelArrays& a, std::size_t tiles, std::uint32_t count, ArrayReader& from) {
  from.require(a.tiles.size() == tiles + 1);
  for (std::size_t t = 0; t < tiles; ++t) {
    const Tile &tile = a.tiles[t], &next = a.tiles[t + 1];
    from.require(tile.live_full <= tile.live_partial && tile.live_partial <= next.live_full &&
                 tile.dead_full <= tile.dead_partial && tile.dead_partial <= next.dead_full &&
                 next.masks - tile.masks ==
                     next.live_full - tile.live_partial + next.dead_full - tile.dead_partial);
  }
  from.require(a.tiles.back().live_full == a.live.size() &&
               a.tiles.back().dead_full == a.dead.size() &&
               a.tiles.back().masks == a.masks.size() && a.tiles.front().live_full == 0 &&
               a.tiles.front().dead_full == 0 && a.tiles.front().masks == 0);
  for (const TileCorner& c : a.live) from.require(c.number < count);
  for (const std::uint32_t v : a.dead) from.require(v < count);
}

}  // namespace

void CornerLabels::save(ArrayWriter& to) const {
  for_each_array(arrays_, [&](const auto& list) { to.array(list); });
}

std::shared_ptr<const CornerLabels> CornerLabels::load(const Grid& grid, const CornerGraph& graph,
                                                       ArrayReader& from) {
  auto made = std::make_shared<CornerLabels>();
  LabelArrays& a = made->arrays_;
  made->tiles_across_ = static_cast<std::size_t>((grid.width() + 7) >> kTileBits);
  for_each_array(a, [&]<class Value>(std::vector<Value>& list) { list = from.array<Value>(); });
  check_labels(a, graph.size(), from);
  const std::size_t tiles =
      made->tiles_across_ * static_cast<std::size_t>((grid.height() + 7) >> kTileBits);
  check_tiles(a, tiles, graph.size(), from);
  return made;
}

}  // namespace lasius::exact
