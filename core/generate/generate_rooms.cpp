// Rooms: rectangles split again and again by walls with doors.
#include <algorithm>
#include <vector>

#include "core/base/poller.h"
#include "core/generate/generate_kinds.h"

namespace lasius {
namespace {

struct Sizes {
  int wall;
  int room;  // the side of a room, about
};

// A lattice of walls `wall` thick every `pitch` cells leaves free (1 - wall / pitch)^2.
Sizes sizes_for(BlockedShare share, int width, int height) {
  const std::uint32_t side_free = integer_sqrt((std::uint64_t{1} << 32) - share);  // in 2^-16
  const int side_blocked = std::max(1, 65536 - static_cast<int>(side_free));
  constexpr int kLeastRoom = 10;
  const int usual = std::min(width, height) < 200 ? 1 : 2;
  const int free = static_cast<int>(side_free);
  // Rounded up, for walls that are thick enough between the smallest rooms.
  const int wall = std::max(usual, (kLeastRoom * side_blocked + free - 1) / free);
  const std::int64_t pitch = std::int64_t{wall} * 65536 / side_blocked;
  return {wall, static_cast<int>(std::clamp<std::int64_t>(pitch - wall, kLeastRoom, 65536))};
}

// The cells [x0, x1) x [y0, y1), free.
struct Room {
  int x0, y0, x1, y1;
};

class Rooms {
 public:
  Rooms(Grid& grid, Sizes sizes, MapDraws draws) : grid_(grid), sizes_(sizes), draws_(draws) {}

  void make(Poller& poller) {
    std::vector<Room> left = {{0, 0, grid_.width(), grid_.height()}};
    while (!left.empty()) {
      const Room room = left.back();
      left.pop_back();
      const int sides = room.x1 - room.x0 + room.y1 - room.y0;
      if (poller.stop_after(std::int64_t{sides} * sizes_.wall)) return;
      Room parts[2];
      if (!split(room, parts)) continue;
      left.push_back(parts[0]);
      left.push_back(parts[1]);
    }
  }

 private:
  // A wall may not end at a door of the wall that it meets.
  bool meets_doors(const Room& room, bool upright, int at) const {
    for (int k = at; k < at + sizes_.wall; ++k) {
      const Cell ends[2] = {upright ? Cell{k, room.y0 - 1} : Cell{room.x0 - 1, k},
                            upright ? Cell{k, room.y1} : Cell{room.x1, k}};
      if (grid_.free(ends[0]) || grid_.free(ends[1])) return true;
    }
    return false;
  }

  // Where a wall across a room of `side` may start, -1 for nowhere.
  int wall_place(const Room& room, bool upright, int side) {
    const int least = std::max(2, sizes_.room * 2 / 3);
    const int from = (upright ? room.x0 : room.y0) + least;
    const int places = side - 2 * least - sizes_.wall + 1;
    if (places <= 0) return -1;
    const int first = draws_.below(places);
    for (int i = 0; i < places; ++i) {
      const int at = from + (first + i) % places;
      if (!meets_doors(room, upright, at)) return at;
    }
    return -1;
  }

  bool split(const Room& room, Room parts[2]) {
    const int width = room.x1 - room.x0;
    const int height = room.y1 - room.y0;
    const int longer = std::max(width, height);
    if (longer < 2 * sizes_.room && draws_.chance(100)) return false;
    const bool upright = 4 * width > 5 * height || (4 * height <= 5 * width && draws_.chance(128));
    const int at = wall_place(room, upright, upright ? width : height);
    if (at < 0) return false;
    parts[0] = parts[1] = room;
    (upright ? parts[0].x1 : parts[0].y1) = at;
    (upright ? parts[1].x0 : parts[1].y0) = at + sizes_.wall;
    grid_.fill(upright ? Rectangle{at, room.y0, sizes_.wall, height}
                       : Rectangle{room.x0, at, width, sizes_.wall},
               true);
    cut_doors(room, upright, at);
    return true;
  }

  void cut_doors(const Room& room, bool upright, int at) {
    const int from = upright ? room.y0 : room.x0;
    const int length = (upright ? room.y1 : room.x1) - from;
    const int doors = 1 + length / (2 * sizes_.room);
    for (int k = 0; k < doors; ++k) {
      const int low = from + length * k / doors;
      const int high = from + length * (k + 1) / doors;
      const int width = std::min(draws_.between(2, 2 + sizes_.room / 8), high - low);
      const int start = low + draws_.below(high - low - width + 1);
      grid_.fill(upright ? Rectangle{at, start, sizes_.wall, width}
                         : Rectangle{start, at, width, sizes_.wall},
                 false);
    }
  }

  Grid& grid_;
  Sizes sizes_;
  MapDraws draws_;
};

}  // namespace

void make_rooms(Grid& grid, BlockedShare share, const MapRandom& random, Poller& poller) {
  if (share == 0) return;
  Rooms(grid, sizes_for(share, grid.width(), grid.height()), MapDraws(random, MapStream::rooms))
      .make(poller);
}

}  // namespace lasius
