#include "tools/drive/drive_answer.h"

#include <algorithm>
#include <string>

#include "lasius/base/error.h"
#include "tools/console/values.h"

namespace lasius::tool {

constexpr const char* kSamePlace = "give both for the same place, in cells of the same size";

LoadedMap read_world(MapOptions options, const std::string& file, const LoadedMap& map) {
  options.file = file;
  LoadedMap world = read_map(options, Frame::cell);
  if (world.width != map.width || world.height != map.height)
    throw Error(ErrorCode::file_broken, {.file = file},
                printed("is %d x %d cells, the map %d x %d", world.width, world.height, map.width,
                        map.height),
                kSamePlace);
  const auto differ = [&](const char* what, double of_world, double of_map) {
    if (of_world == of_map) return;
    throw Error(
        ErrorCode::file_broken, {.file = file},
        std::string(what) + " is " + to_text(of_world) + ", that of the map " + to_text(of_map),
        kSamePlace);
  };
  if (world.frame && map.frame) {
    differ("resolution", world.frame->resolution, map.frame->resolution);
    differ("x of the origin", world.frame->origin_x, map.frame->origin_x);
    differ("y of the origin", world.frame->origin_y, map.frame->origin_y);
    differ("yaw of the origin", world.frame->yaw, map.frame->yaw);
  }
  return world;
}

Grid world_at(const DriveAnswer& answer, std::int64_t tick) {
  auto changes = answer.changes.cells;
  std::ranges::stable_sort(changes, {}, &Change::tick);
  Grid grid = answer.truth().grid();
  for (const Change& change : changes)
    if (change.tick <= tick) grid.fill(change.part, change.blocked);
  return grid;
}

}  // namespace lasius::tool
