#include "tools/drive/ground.h"

#include <gtest/gtest.h>

#include "tests/worlds/changing_world.h"

namespace lasius::tool {
namespace {

TEST(Ground, ATickIsWhatItIsFromScratch) {
  int ticks = 0, changed = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    RandomWorld world = draw_world(seed, false);
    world.options.max_ticks = 120;
    const int columns = 7 + static_cast<int>(seed) * 3, rows = 9 + static_cast<int>(seed) * 2;
    DriveRecorder recorder(world.map, world.options.sense);
    tick_codes::Ground kept(world.map, columns, rows);
    std::vector<std::uint8_t> before;
    const auto observe = [&](const DriveTick& tick) {
      recorder.observe(tick);
      if (tick.tick % (1 + seed % 3) != 0) return;
      tick_codes::Ground fresh(world.map, columns, rows);
      const auto& codes = kept.codes(tick, recorder).values;
      ASSERT_EQ(codes, fresh.codes(tick, recorder).values) << seed << ", tick " << tick.tick;
      ++ticks;
      changed += codes != before;
      before = codes;
    };
    world.options.observer = observe;
    drive(world.map, world.truth, world.start, world.goal, world.changes, world.options,
          world.navigator);
  }
  EXPECT_GT(ticks, 300);
  EXPECT_GT(changed, 100);
}

}  // namespace
}  // namespace lasius::tool
