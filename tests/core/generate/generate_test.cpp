#include "lasius/grid/generate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "lasius/base/error.h"
#include "tests/core/base/counting_time.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

constexpr MapKind kKinds[] = {MapKind::blobs, MapKind::maze,   MapKind::rooms,
                              MapKind::city,  MapKind::random, MapKind::open};

double blocked_share(const Grid& grid) {
  return 1 - static_cast<double>(grid.count_free()) /
                 (static_cast<double>(grid.width()) * static_cast<double>(grid.height()));
}

// Cells of the largest 4-connected free region.
std::int64_t largest_region(const Grid& grid) {
  Grid left = grid;
  std::int64_t largest = 0;
  for (const Cell seed : cells_of(grid)) {
    std::int64_t count = 0;
    const auto take = [&](Cell c) {
      if (left.blocked(c)) return false;
      left.set_blocked(c);
      ++count;
      return true;
    };
    if (take(seed)) flood(seed, false, [&](Cell, Cell to) { return take(to); });
    largest = std::max(largest, count);
  }
  return largest;
}

TEST(Generate, NamesTheKindsInOrder) {
  const std::vector<std::string_view> names = {"blobs", "maze", "rooms", "city", "random", "open"};
  EXPECT_EQ(std::vector<std::string_view>(map_kind_names().begin(), map_kind_names().end()), names);
}

// The bits are promised to be the same on every machine and, for one release series, over time:
// maps/ and other people's commands name them by kind and seed.
TEST(Generate, MakesTheSameBitsEverywhere) {
  struct Golden {
    MapKind kind;
    GenerateOptions options;
    std::uint64_t hash;
  };
  const Golden goldens[] = {
      {MapKind::blobs, {200, 150}, 0x7e673bb3eb666ca1},
      {MapKind::blobs, {1037, 64, 0.2, 0x123456789abcdef}, 0x05a45701d9e71fd8},
      {MapKind::maze, {200, 150}, 0xbf1d98e1b7fb9740},
      {MapKind::maze, {333, 301, 0.4, 7}, 0xa69e39a8edf6ff83},
      {MapKind::rooms, {200, 150}, 0x31101e7d0b283981},
      {MapKind::rooms, {500, 333, 0.3, 7}, 0xb784852bb7f41a51},
      {MapKind::city, {200, 150}, 0x2aa21cf8bee7fa22},
      {MapKind::city, {3000, 2000, 0.2, 7}, 0x6fc0a271294b6465},
      {MapKind::city, {65, 2}, 0xef462f6dc3b52d0d},
      {MapKind::random, {200, 150}, 0x6912833ccaa0da40},
      {MapKind::random, {65, 3, 0.5, 7}, 0xe35d6cf4a1d60106},
      {MapKind::open, {200, 150}, 0xdb49e6793e212af4},
      {MapKind::open, {2100, 1500, 0.25, 7}, 0x581ff84869f7866f},
  };
  for (const Golden& golden : goldens) {
    const Grid grid = generate(golden.kind, golden.options);
    EXPECT_EQ(grid.hash(), golden.hash) << to_string(golden.kind) << ' ' << grid.width();
  }
}

TEST(Generate, SeedsDiffer) {
  for (const MapKind kind : kKinds) {
    const Grid one = generate(kind, {128, 128, -1, 1});
    EXPECT_EQ(one, generate(kind, {128, 128, -1, 1})) << to_string(kind);
    for (const std::uint64_t seed : {std::uint64_t{2}, std::uint64_t{1} << 32, ~std::uint64_t{0}}) {
      EXPECT_NE(one, generate(kind, {128, 128, -1, seed})) << to_string(kind) << ' ' << seed;
    }
  }
}

TEST(Generate, MostFreeCellsHangTogether) {
  for (const MapKind kind : kKinds) {
    for (const auto& [width, height] : {std::pair{64, 64}, {400, 200}, {700, 1000}}) {
      for (const std::uint64_t seed : {1, 2, 3, 4}) {
        const Grid grid = generate(kind, {width, height, -1, seed});
        const auto share =
            static_cast<double>(largest_region(grid)) / static_cast<double>(grid.count_free());
        EXPECT_GE(share, width == 64 ? 0.8 : 0.95)
            << to_string(kind) << ' ' << width << " seed " << seed;
      }
    }
  }
}

TEST(Generate, ComesNearTheDensity) {
  for (const MapKind kind : kKinds) {
    const bool by_threshold =
        kind == MapKind::blobs || kind == MapKind::open || kind == MapKind::random;
    for (const double density : {0.1, 0.2, 0.3, 0.35, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9}) {
      if (density > max_density(kind)) continue;
      const double share = blocked_share(generate(kind, {800, 800, density, 3}));
      EXPECT_NEAR(share, density, by_threshold ? 0.005 : 0.2 * density)
          << to_string(kind) << ' ' << density;
    }
  }
}

TEST(Generate, MoreDensityBlocksMore) {
  for (const auto& [width, height] : {std::pair{64, 48}, {200, 150}, {512, 512}}) {
    for (const MapKind kind : kKinds) {
      double before = -1;
      for (int tenth = 0; tenth <= 10 * max_density(kind); ++tenth) {
        const double share = blocked_share(generate(kind, {width, height, 0.1 * tenth, 1}));
        EXPECT_GE(share, before) << to_string(kind) << ' ' << width << " at 0." << tenth;
        before = share;
      }
    }
  }
}

TEST(Generate, DensityZeroIsFree) {
  for (const MapKind kind : kKinds) {
    EXPECT_EQ(generate(kind, {100, 70, 0}).count_free(), 7000) << to_string(kind);
  }
}

TEST(Generate, MakesMapsOfEverySize) {
  const std::pair<int, int> sizes[] = {{1, 1},   {2, 1},     {1, 9},    {5, 5},
                                       {9, 200}, {32768, 3}, {2, 32768}};
  for (const MapKind kind : kKinds) {
    for (const auto& [width, height] : sizes) {
      for (const double density : {-1.0, 0.02, 0.3, max_density(kind)}) {
        const Grid grid = generate(kind, {width, height, density, 5});
        EXPECT_EQ(grid.width(), width) << to_string(kind);
        EXPECT_EQ(grid.height(), height) << to_string(kind);
      }
    }
  }
}

TEST(Generate, IsCutShortWhereverTimeRunsOut) {
  for (const MapKind kind : kKinds) {
    const GenerateOptions options{.width = 700, .height = 600};
    const CountingTime counted(1 << 30);
    EXPECT_EQ(generate(kind, options, counted.is_up()), generate(kind, options)) << to_string(kind);
    for (int looks = 0; looks < counted.polls(); ++looks) {
      const CountingTime time(looks);
      EXPECT_FALSE(generate(kind, options, time.is_up())) << to_string(kind) << " " << looks;
      EXPECT_EQ(time.polls(), looks + 1);
    }
    // On 24 times as many cells it looks about so many times as often.
    const GenerateOptions large{.width = 3400, .height = 3000};
    const CountingTime more(1 << 30);
    EXPECT_TRUE(generate(kind, large, more.is_up()));
    EXPECT_GT(more.polls(), 10 * counted.polls()) << to_string(kind);
    EXPECT_GT(more.polls(), 20) << to_string(kind);
  }
}

TEST(Generate, RefusesBadSizesAndDensities) {
  for (const double density : {1.0, 2.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW((void)generate(MapKind::blobs, {10, 10, density}), Error) << density;
  }
  for (const MapKind kind : kKinds) {
    EXPECT_THROW((void)generate(kind, {10, 10, max_density(kind) + 1e-9}), Error)
        << to_string(kind);
  }
  EXPECT_THROW((void)generate(static_cast<MapKind>(6), {}), Error);
  EXPECT_THROW((void)generate(MapKind::blobs, {0, 10}), Error);
  EXPECT_THROW((void)generate(MapKind::blobs, {10, 32769}), Error);
}

}  // namespace
}  // namespace lasius
