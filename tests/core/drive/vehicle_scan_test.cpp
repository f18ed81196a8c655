// Scans and points in metres as cells: worked by hand, and against rays followed in small steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "lasius/base/error.h"
#include "lasius/vehicle/scan.h"

namespace lasius::vehicle {
namespace {

bool holds(const std::vector<Cell>& cells, Cell c) {
  return std::find(cells.begin(), cells.end(), c) != cells.end();
}

TEST(Scan, OneRayWorkedByHand) {
  // Cells of half a metre, the map's lower left corner at (1, 2), 6 x 4 cells: y up to rows down.
  const WorldFrame frame{.resolution = 0.5, .origin_x = 1, .origin_y = 2, .yaw = 0};
  const std::vector<double> ranges{1.5};
  const Scan scan{.sensor = {1.25, 2.25, 0}, .step = 0.1, .most = 5, .ranges = ranges};
  const SeenCells seen = seen_cells(scan, frame, 6, 4);
  // From the middle of cell (0, 3) 3 cells to the right: the middle of (3, 3).
  EXPECT_EQ(seen.blocked, (std::vector<Cell>{{3, 3}}));
  EXPECT_EQ(seen.free, (std::vector<Cell>{{0, 3}, {1, 3}, {2, 3}}));
}

TEST(Scan, AWallIsMetFromEitherSide) {
  const WorldFrame frame{};
  for (const double yaw : {0.0, std::numbers::pi}) {
    const std::vector<double> ranges{
        3};  // to x = 5, the left face of column 5; or x = 6, its right
    const Point from{yaw == 0 ? 2.0 : 9.0, 5.5};
    const Scan scan{.sensor = {from.x, from.y, yaw}, .step = 1, .most = 8, .ranges = ranges};
    EXPECT_EQ(seen_cells(scan, frame, 20, 10).blocked, (std::vector<Cell>{{5, 4}}));
  }
}

TEST(Scan, WhatMeansNothingIsLeftOut) {
  const WorldFrame frame{};
  constexpr double kInf = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> ranges{nan, 0.2, kInf, 4};
  const Scan scan{.sensor = {5.5, 5.5, 0}, .step = 0, .least = 0.5, .most = 4, .ranges = ranges};
  const SeenCells seen = seen_cells(scan, frame, 30, 11);
  EXPECT_TRUE(seen.blocked.empty());
  ASSERT_EQ(seen.free.size(), 5u);  // to where nothing was met
  EXPECT_EQ(seen.free.back(), (Cell{9, 5}));
}

TEST(Scan, RaysCrossTheCellsThatSmallStepsCross) {
  const WorldFrame frame{.resolution = 0.05, .origin_x = -1, .origin_y = 0.5, .yaw = 0.3};
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 50; ++i) {
    std::vector<double> ranges;
    for (int k = 0; k < 20; ++k) ranges.push_back(0.1 + 1.5 * unit(random));
    const Point middle = frame.to_world({20 + 20 * unit(random), 20 + 20 * unit(random)}, 60);
    const Scan scan{.sensor = {middle.x, middle.y, 6 * unit(random)},
                    .first_angle = -1,
                    .step = 0.1,
                    .most = 2,
                    .ranges = ranges};
    const SeenCells seen = seen_cells(scan, frame, 60, 60);
    for (std::size_t k = 0; k < ranges.size(); ++k) {
      const double yaw = scan.sensor.yaw - 1 + 0.1 * static_cast<double>(k);
      for (double at = 0; at < ranges[k]; at += 0.001) {
        const Point p =
            frame.to_cells({middle.x + at * std::cos(yaw), middle.y + at * std::sin(yaw)}, 60);
        const Cell cell{static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y))};
        if (cell.x < 0 || cell.y < 0 || cell.x >= 60 || cell.y >= 60) continue;
        ASSERT_TRUE(holds(seen.free, cell) || holds(seen.blocked, cell)) << cell.x << " " << cell.y;
      }
    }
    for (const Cell c : seen.free) ASSERT_FALSE(holds(seen.blocked, c));
    ASSERT_LE(seen.blocked.size(), ranges.size());
  }
}

TEST(Scan, PointsAreRays) {
  const WorldFrame frame{};
  const std::vector<Point> points{{4.5, 0.5}, {0.5, 9.5}, {std::nan(""), 1}};
  const SeenCells seen = seen_cells(Point{0.5, 0.5}, points, 5, frame, 12, 12);
  EXPECT_EQ(seen.blocked, (std::vector<Cell>{{4, 11}}));
  EXPECT_EQ(seen.free.size(), 4u + 5u);  // the second is farther than 5
}

TEST(Scan, RefusesNumbersOutOfRange) {
  const std::vector<double> ranges(10, 1);
  const Scan good{.step = 0.1, .most = 5, .ranges = ranges};
  Scan bad = good;
  bad.most = 0;
  EXPECT_THROW((void)seen_cells(bad, {}, 9, 9), Error);
  bad = good;
  bad.step = 1e9;
  EXPECT_THROW((void)seen_cells(bad, {}, 9, 9), Error);
  bad = good;
  bad.sensor.yaw = std::nan("");
  EXPECT_THROW((void)seen_cells(bad, {}, 9, 9), Error);
  EXPECT_THROW((void)seen_cells(Point{}, {}, std::nan(""), {}, 9, 9), Error);
}

}  // namespace
}  // namespace lasius::vehicle
