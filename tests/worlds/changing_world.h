// Worlds that change, drawn at random.
#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>
#include <random>

#include "lasius/drive/drive.h"
#include "lasius/grid/generate.h"

namespace lasius {

/// How many worlds to drive through: LASIUS_DRIVES times as many as usual.
inline std::uint64_t worlds(std::uint64_t usual) {
  const char* const times = std::getenv("LASIUS_DRIVES");
  return times == nullptr ? usual : usual * std::strtoull(times, nullptr, 10);
}

/// A map that is wrong, the truth, what happens, and a drive through it.
struct RandomWorld {
  Grid map, truth;
  Cell start, goal;
  Changes changes;
  DriveOptions options;
  NavigatorOptions navigator;
};

/// Numbers that are the same everywhere; the distributions of <random> are not.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  int below(int limit) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(limit)); }
  bool one_in(int chances) { return below(chances) == 0; }

 private:
  std::mt19937_64 engine_;
};

inline Cell draw_free(Draw& draw, const Grid& grid) {
  Cell cell;
  do {
    cell = {draw.below(grid.width()), draw.below(grid.height())};
  } while (grid.blocked(cell));
  return cell;
}

/// A small rectangle inside a map.
inline Rectangle draw_part(Draw& draw, const Grid& grid, int longest) {
  const int width = 1 + draw.below(std::min(longest, grid.width()));
  const int height = 1 + draw.below(std::min(longest, grid.height()));
  return {draw.below(grid.width() - width + 1), draw.below(grid.height() - height + 1), width,
          height};
}

inline Grid draw_map(Draw& draw, int width, int height) {
  constexpr std::array kKinds{MapKind::random, MapKind::blobs, MapKind::rooms, MapKind::maze};
  const auto kind = kKinds[static_cast<std::size_t>(draw.below(4))];
  return generate(
      kind,
      {.width = width, .height = height, .seed = static_cast<std::uint64_t>(draw.below(1 << 20))});
}

/// `calm`: nothing moves, and nothing changes after tick 200.
inline RandomWorld draw_world(std::uint64_t seed, bool calm) {
  Draw draw(seed);
  const int width = 16 + draw.below(40), height = 16 + draw.below(40);
  Grid truth = draw_map(draw, width, height);
  Grid map = truth;
  for (int i = draw.below(12); i > 0; --i) map.fill(draw_part(draw, map, 8), draw.one_in(2));
  if (draw.one_in(4)) map.fill(false);
  RandomWorld world{map, truth, draw_free(draw, truth), draw_free(draw, truth), {}, {}, {}};
  for (int i = draw.below(30); i > 0; --i) {
    world.changes.cells.push_back(
        {draw.below(200), draw_part(draw, truth, 1 + draw.below(8)), draw.one_in(2)});
  }
  for (int i = calm ? 0 : draw.below(5); i > 0; --i) {
    MovingObstacle obstacle{.tick = draw.below(50),
                            .width = 1 + draw.below(3),
                            .height = 1 + draw.below(3),
                            .speed = draw.below(9) / 4.0,
                            .track = {}};
    for (int points = 1 + draw.below(4); points > 0; --points) {
      obstacle.track.push_back({draw.below(width - 3), draw.below(height - 3)});
    }
    world.changes.obstacles.push_back(obstacle);
  }
  world.options.sense = 1 + draw.below(12);
  world.navigator.radius = draw.one_in(3) ? draw.below(5) / 2.0 : 0;
  world.options.max_ticks = calm ? 100'000 : 2000;
  return world;
}

}  // namespace lasius
