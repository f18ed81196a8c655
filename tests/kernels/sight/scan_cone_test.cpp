#include "kernels/sight/scan_cone.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <utility>

#include "core/grid/grid_view.h"
#include "kernels/sight/scan_line.h"
#include "kernels/sight/sight.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

using kernels::BitmapView;
using kernels::HalfPoint;
using Places = std::set<std::pair<int, int>>;  // lattice points

struct Collector {
  int right, down, line0;
  kernels::ConeLimits all;
  Places seen = {};
  std::int64_t words = 0;

  double corner(int u, int line, kernels::Turn) {
    seen.insert({right * u, line0 + down * line});
    return -1;
  }
  bool beaten(const kernels::Rival&, kernels::Fixed, int) const { return false; }
  const kernels::ConeLimits& limits() const { return all; }
  bool go_on(std::int64_t n) {
    words += n;
    return true;
  }
};

kernels::ConeFrame frame(const BitmapView& map, HalfPoint root, int right, int down) {
  kernels::ConeFrame f{};
  f.map = map;
  f.down = down;
  f.line0 = down > 0 ? (root.y + 1) / 2 : root.y / 2;
  f.depth0 = 0.5 * (root.y % 2);
  f.root = right * root.x * (kernels::kOne / 2);
  return f;
}

kernels::ConeLimits whole(const BitmapView& map, int line0, int right, int down) {
  constexpr int kFar = 1 << 18;
  return {.last_line = down > 0 ? map.height - line0 : line0,
          .last_column = right > 0 ? map.width + 1 : 1,
          .left0 = -kernels::fixed(kFar),
          .right0 = kernels::fixed(kFar),
          .slope = 0};
}

/// Scans from the root within the collector's limits; true when they cut the scan off.
template <int S>
bool scan(const kernels::ConeFrame& f, HalfPoint root, Collector& found) {
  std::vector<kernels::Interval> stack;
  kernels::ConeScan<S, Collector> cone(f, stack, found);
  return root.x % 2 != 0 ? cone.from_centre(S > 0 ? f.map.width : 0)
                         : cone.from_corner(0, kernels::kLevelSlope);
}

template <int S>
Places scan_quadrant(const BitmapView& map, HalfPoint root, int down) {
  const auto f = frame(map, root, S, down);
  Collector found{S, down, f.line0, whole(map, f.line0, S, down)};
  EXPECT_FALSE(scan<S>(f, root, found));
  return found.seen;
}

// Is (x, y), seen from the root in the open quadrant (right, down), a corner that a path can turn
// at: one blocked cell, which the ray passes beside?
bool turns_at(const BitmapView& map, int x, int y, int right, int down) {
  int blocked = 0;
  bool beside = false;
  for (const int bx : {-1, 1}) {
    for (const int by : {-1, 1}) {
      if (!map.blocked(bx < 0 ? x - 1 : x, by < 0 ? y - 1 : y)) continue;
      ++blocked;
      beside = bx * right != by * down;
    }
  }
  return blocked == 1 && beside;
}

bool passes_a_corner(const Places& corners, HalfPoint root, int x, int y) {
  const std::int64_t dx = 2 * x - root.x;
  const std::int64_t dy = 2 * y - root.y;
  for (const auto& [cx, cy] : corners) {
    const std::int64_t ex = 2 * cx - root.x;
    const std::int64_t ey = 2 * cy - root.y;
    if (ex * dy == ey * dx && ex * dx + ey * dy > 0 && std::abs(ey) < std::abs(dy)) return true;
  }
  return false;
}

void expect_all_seen(const BitmapView& map, HalfPoint root, int right, int down) {
  const Places seen =
      right > 0 ? scan_quadrant<1>(map, root, down) : scan_quadrant<-1>(map, root, down);
  for (const auto& [x, y] : seen) {
    EXPECT_TRUE(kernels::sees(map, root, {2 * x, 2 * y}))
        << x << ' ' << y << " from " << root.x << ' ' << root.y;
  }
  for (int y = 0; y <= map.height; ++y) {
    for (int x = 0; x <= map.width; ++x) {
      const bool in_quadrant = right * (2 * x - root.x) > 0 && down * (2 * y - root.y) > 0;
      if (!in_quadrant || !turns_at(map, x, y, right, down)) continue;
      if (!kernels::sees(map, root, {2 * x, 2 * y}) || seen.contains({x, y})) continue;
      EXPECT_TRUE(passes_a_corner(seen, root, x, y))
          << x << ' ' << y << " missed from " << root.x << ' ' << root.y;
    }
  }
}

TEST(ScanCone, SeesTheCornersThatAreVisible) {
  std::mt19937 random(1);
  for (int i = 0; i < 300; ++i) {
    const Grid grid = random_grid(random_in(1, 90, random), random_in(1, 20, random),
                                  random_in(0, 50, random), random);
    const BitmapView map = view_of(grid);
    for (int k = 0; k < 20; ++k) {
      const Cell c = random_cell(grid, random);
      const int right = random() % 2 == 0 ? 1 : -1;
      const int down = random() % 2 == 0 ? 1 : -1;
      if (grid.free(c)) expect_all_seen(map, {2 * c.x + 1, 2 * c.y + 1}, right, down);
      // From a lattice point whose cell in the quadrant is free.
      const int x = right > 0 ? c.x : c.x + 1;
      const int y = down > 0 ? c.y : c.y + 1;
      if (grid.free(c)) expect_all_seen(map, {2 * x, 2 * y}, right, down);
    }
    if (HasFailure()) return;
  }
}

// Scans the quadrant within a strip and a box: all that is seen must be visible, and what lies
// inside by more than the columns to spare must be seen.
template <int S>
void expect_strip_seen(const BitmapView& map, HalfPoint root, int down, std::mt19937& random) {
  const auto f = frame(map, root, S, down);
  Collector all{S, down, f.line0, whole(map, f.line0, S, down)};
  Collector some = all;
  const double slope = random_in(-300, 300, random) / 100.0;
  const double half = random_in(2, 40, random) / 4.0;
  const double middle = slope * f.depth0;
  const auto one = static_cast<double>(kernels::kOne);
  some.all.slope = static_cast<kernels::Fixed>(slope * one);
  some.all.left0 = f.root + static_cast<kernels::Fixed>((middle - half) * one);
  some.all.right0 = f.root + static_cast<kernels::Fixed>((middle + half) * one);
  some.all.last_line = random_in(0, some.all.last_line, random);
  EXPECT_FALSE(scan<S>(f, root, all));
  const bool cut_off = scan<S>(f, root, some);
  for (const auto& place : some.seen) EXPECT_TRUE(all.seen.contains(place));
  for (const auto& [x, y] : all.seen) {
    const double depth = down * (y - 0.5 * root.y);
    const double off = S * (x - 0.5 * root.x) - slope * depth;
    const bool inside = std::abs(off) < half - 1.5 && down * (y - f.line0) < some.all.last_line;
    EXPECT_TRUE(!inside || some.seen.contains({x, y})) << x << ' ' << y;
    EXPECT_TRUE(cut_off || some.seen.contains({x, y})) << x << ' ' << y;
  }
}

TEST(ScanCone, KeepsWithinItsLimits) {
  std::mt19937 random(2);
  for (int i = 0; i < 3000 && !testing::Test::HasFailure(); ++i) {
    const Grid grid = random_grid(random_in(1, 150, random), random_in(1, 60, random),
                                  random_in(0, 12, random), random);
    const Cell c = random_cell(grid, random);
    if (grid.blocked(c)) continue;
    const int down = random() % 2 == 0 ? 1 : -1;
    const bool centre = random() % 2 == 0;
    const int y = centre ? 2 * c.y + 1 : down > 0 ? 2 * c.y : 2 * c.y + 2;
    SCOPED_TRACE(i);
    expect_strip_seen<1>(view_of(grid), {centre ? 2 * c.x + 1 : 2 * c.x, y}, down, random);
    expect_strip_seen<-1>(view_of(grid), {centre ? 2 * c.x + 1 : 2 * c.x + 2, y}, down, random);
  }
}

TEST(ScanCone, CrossesTheLargestMap) {
  // Two blocks at the far end of 32768 rows; the second is hidden by one column of the first.
  constexpr int kSide = 32768;
  const Grid grid = with_blocked(256, kSide, {{100, kSide - 10}});
  const BitmapView map = view_of(grid);
  const HalfPoint root{1, 1};
  const Places seen = scan_quadrant<1>(map, root, 1);
  EXPECT_EQ(seen, (Places{{100, kSide - 9}, {101, kSide - 10}}));
}

TEST(ScanLine, ReportsEndsOfBlocksAndStopsBetweenTwo) {
  const Grid grid = drawn({"##..###.", "....#...", "..#.#..."});
  Places seen;
  const auto report = [&](int u, bool above) { seen.insert({u, above}); };
  const auto upto = [](int column) { return [column] { return column; }; };
  EXPECT_FALSE(kernels::scan_line<1>(view_of(grid), 1, 1, upto(9), report));
  EXPECT_EQ(seen, (Places{{2, 1}}));  // column 4 is blocked on both sides
  const Grid open(300, 2);
  EXPECT_TRUE(kernels::scan_line<1>(view_of(open), 1, 1, upto(100), report));
  seen.clear();
  EXPECT_FALSE(kernels::scan_line<-1>(view_of(grid), 2, -4, upto(1), report));
  EXPECT_EQ(seen, (Places{{-2, 0}}));
}

}  // namespace
}  // namespace lasius
