#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <random>
#include <utility>

#include "core/exact/exact_corner_table.h"

namespace lasius::exact {
namespace {

// More than one segment holds, some of them close together and some anywhere.
TEST(CornerTable, FindsWhatWasAddedAndNothingElse) {
  constexpr int kSide = 32768, kCorners = 200'000;
  CornerTable table;
  std::int64_t bytes = 0;
  for (int round = 0; round < 2; ++round) {
    std::mt19937 random(5);
    const auto point = [&]() -> std::pair<int, int> {
      const int side = random() % 2 == 0 ? 400 : kSide;
      return {static_cast<int>(random() % side), static_cast<int>(random() % side)};
    };
    table.reset(kSide, {});
    std::map<std::pair<int, int>, std::uint32_t> known;
    while (static_cast<int>(known.size()) < kCorners) {
      const auto [x, y] = point();
      std::uint64_t* const slot = table.slot(x, y);
      if (known.contains({x, y})) {
        ASSERT_EQ(CornerTable::at(slot), (known[{x, y}]));
      } else {
        ASSERT_EQ(CornerTable::at(slot), CornerTable::kStart);
        known[{x, y}] = table.add(slot, x, y);
      }
    }
    for (const auto& [at, index] : known) {
      ASSERT_EQ(CornerTable::at(table.slot(at.first, at.second)), index);
      ASSERT_EQ(table[index].x, 2 * at.first);
      ASSERT_EQ(table[index].y, 2 * at.second);
    }
    EXPECT_EQ(table.size(), known.size() + 1);
    if (round > 0) {
      EXPECT_EQ(table.bytes(), bytes);
    }
    bytes = table.bytes();
  }
}

}  // namespace
}  // namespace lasius::exact
