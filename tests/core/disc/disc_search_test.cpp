#include "core/disc/disc_search.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <random>

#include "core/disc/disc_graph.h"
#include "core/disc/scan_limits.h"
#include "core/grid/grid_view.h"
#include "tests/core/disc/disc_worlds.h"
#include "tests/oracle/disc_paths.h"

namespace lasius::disc {
namespace {

DiscAnswer solve(DiscSearch& search, const DiscSpace& space, const DiscGraph* graph, Point start,
                 Point goal, const ExactOptions& options = {}, const StopCondition& stop = {}) {
  DiscAnswer answer;
  search.search(space, graph, start, goal, options, stop, answer);
  return answer;
}

std::shared_ptr<DiscGraph> graph_of(const DiscSpace& space, int threads = 1) {
  Preparation report;
  auto graph = DiscGraph::make(space, {.threads = threads}, report);
  EXPECT_EQ(report.state, Preparation::State::ready);
  EXPECT_EQ(report.edges, graph->edge_count());
  return graph;
}

// Pieces that follow each other, tangents and arcs, all of it and its polyline clear.
void expect_curve(const DiscAnswer& answer, const DiscSpace& space, Point start, Point goal,
                  const std::function<double(Point, Point)>& clearance) {
  const double radius = space.radius();
  ASSERT_FALSE(answer.curve.empty());
  EXPECT_EQ(answer.curve.back().to, goal);
  EXPECT_EQ(answer.length, curve_length(answer.curve));
  for (std::size_t i = 0; i < answer.curve.size(); ++i) {
    const CurvePiece& piece = answer.curve[i];
    EXPECT_EQ(piece.from, i > 0 ? answer.curve[i - 1].to : start);
    if (piece.turn == 0) {
      EXPECT_GE(clearance(piece.from, piece.to), radius - 2e-9);
      continue;
    }
    const double from = std::atan2(piece.from.y - piece.centre.y, piece.from.x - piece.centre.x);
    Point last = piece.from;
    for (int k = 1; k <= 16; ++k) {
      const double angle = from + piece.turn * piece.angle * k / 16;
      const Point p{piece.centre.x + radius * std::cos(angle),
                    piece.centre.y + radius * std::sin(angle)};
      EXPECT_GE(clearance(p, p), radius - 2e-9);
      last = p;
    }
    EXPECT_NEAR(last.x, piece.to.x, 1e-9);
    EXPECT_NEAR(last.y, piece.to.y, 1e-9);
  }
  double length = 0;
  for (std::size_t i = 1; i < answer.path.size(); ++i) {
    const Point a = answer.path[i - 1], b = answer.path[i];
    EXPECT_GE(clearance(a, b), radius - 2e-9);
    length += std::hypot(a.x - b.x, a.y - b.y);
  }
  EXPECT_EQ(answer.path.front(), start);
  EXPECT_EQ(answer.path.back(), goal);
  EXPECT_GE(length, answer.length * (1 - 1e-12));
  EXPECT_LE(length, answer.length * 1.001);
}

/// As a goal's tolerance has it: the clear point nearest to any, mostly at a wall or an arc.
std::optional<Point> random_border(const DiscSpace& space, std::mt19937& random) {
  const Grid& map = space.map();
  const auto below = [&](int cells) { return static_cast<double>(random() % (2u * cells)) / 2; };
  const StopCondition never;
  Poller poller(never);
  return space.way_out({below(map.width()), below(map.height())}, poller);
}

// Where the other end is nearly level its edges would pass all numbers: then there is none.
TEST(DiscSearch, LooksInNoStripThatDoesNotFit) {
  const Grid grid(40, 12);
  const kernels::ConeLimits limits =
      limits_around<1>(view_of(grid), {2.5, 5.5}, {30.5, 5.5 + 1e-12}, 40, 1, 6);
  EXPECT_EQ(limits.slope, 0);
  EXPECT_EQ(limits.left0, -kernels::fixed(kernels::kAllColumns));
  EXPECT_EQ(limits.right0, kernels::fixed(kernels::kAllColumns));
}

// There and back are as long, by scan and by graph.
TEST(DiscSearch, MeetsGoalsAtWalls) {
  Grid block(34, 24);
  block.set_blocked({16, 17});
  std::mt19937 random(4);
  DiscSearch search;
  int bent = 0;
  for (const double radius : {0.7, 0.9, 1.0, 1.2024523065002852, 1.3, 2.0, 2.5, 4.4}) {
    for (int round = 0; round < 6; ++round) {
      const auto space = DiscSpace::make(round == 0 ? block : random_map(radius, random), radius);
      const auto graph = graph_of(*space);
      for (int i = 0; i < 8; ++i) {
        const auto start = random_clear(*space, random), goal = random_border(*space, random);
        if (!start || !goal) continue;
        const double back = solve(search, *space, nullptr, *goal, *start).length;
        for (const DiscGraph* with : std::array<const DiscGraph*, 2>{nullptr, graph.get()}) {
          const DiscAnswer answer = solve(search, *space, with, *start, *goal);
          bent += answer.curve.size() > 1;
          ASSERT_EQ(std::isnan(answer.length), std::isnan(back)) << radius << ' ' << i;
          if (!std::isnan(back)) {
            EXPECT_NEAR(answer.length, back, 2e-9) << radius << ' ' << i;
          }
        }
      }
    }
  }
  EXPECT_GT(bent, 100);
}

TEST(DiscSearch, EqualsBruteForceOnSmallMaps) {
  std::mt19937 random(1);
  DiscSearch search;
  int found = 0, closed = 0, bent = 0;
  for (int round = 0; round < scaled(24); ++round) {
    const double radius = random_radius(round % 32 == 31 ? 20 : round % 4 == 0 ? 5 : 2, random);
    const Grid grid = random_map(radius, random);
    const auto space = DiscSpace::make(grid, radius);
    const auto graph = graph_of(*space);
    oracle::DiscPaths paths(grid, radius);
    for (int i = 0; i < 6; ++i) {
      const auto start = random_clear(*space, random);
      const auto goal = i % 2 == 0 ? random_clear(*space, random) : random_border(*space, random);
      if (!start || !goal || !paths.clear(*goal)) continue;
      ASSERT_TRUE(paths.clear(*start));
      const auto expected = paths.shortest(*start, *goal);
      for (const DiscGraph* with :
           {static_cast<const DiscGraph*>(nullptr), static_cast<const DiscGraph*>(graph.get())}) {
        const DiscAnswer answer = solve(search, *space, with, *start, *goal);
        SCOPED_TRACE(testing::Message()
                     << "round " << round << " radius " << radius << " from " << start->x << ' '
                     << start->y << " to " << goal->x << ' ' << goal->y << " graph " << with);
        if (!expected) {
          ++closed;
          EXPECT_EQ(answer.end, ExactEnd::unreachable);
          EXPECT_TRUE(answer.curve.empty());
          continue;
        }
        ++found;
        bent += answer.curve.size() > 1;
        ASSERT_EQ(answer.end, ExactEnd::proven);
        EXPECT_NEAR(answer.length, *expected, 1e-9);
        EXPECT_EQ(answer.lower_bound, answer.length);
        expect_curve(answer, *space, *start, *goal,
                     [&](Point a, Point b) { return paths.clearance(a, b); });
      }
    }
  }
  EXPECT_GT(found, 100);
  EXPECT_GT(closed, 10);
  EXPECT_GT(bent, 50);
}

// What taut paths cost with prices at their ends is what the oracle's do; there and back the same,
// and whatever is left out since other ways are shorter.
TEST(DiscSearch, PricesAtEnds) {
  std::mt19937 random(9);
  DiscSearch search;
  int bent = 0, dearer = 0;
  for (int round = 0; round < scaled(40); ++round) {
    const double radius = 1.001 * random_radius(1.2, random);  // no gap is just as wide
    const Grid grid = random_map(radius, random);
    const auto space = DiscSpace::make(grid, radius);
    std::optional<oracle::DiscPaths> paths;  // slow: of every third
    if (round % 3 == 0) paths.emplace(grid, radius);
    for (int i = 0; i < 6; ++i) {
      const auto start = random_clear(*space, random), goal = random_clear(*space, random);
      if (!start || !goal) continue;
      const DiscAnswer shortest = solve(search, *space, nullptr, *start, *goal);
      if (shortest.curve.size() < 2) continue;
      ++bent;
      const auto least = [&](Point from, Point to, const EndPrices& prices) {
        return search.least(*space, from, to, prices, 0, {});
      };
      const auto same = [](Point) { return 1.5; };
      EXPECT_NEAR(least(*start, *goal, {same, same, 3}), shortest.length + 3, 1e-6);
      const auto towards = [](double angle) {
        return [angle](Point p) { return 2 - 2 * std::cos(std::atan2(p.y, p.x) - angle); };
      };
      const double one = 0.1 * random_in(0, 62, random), other = 0.1 * random_in(0, 62, random);
      const EndPrices prices{towards(one), towards(other), 8};
      const double there = least(*start, *goal, prices);
      EXPECT_NEAR(least(*goal, *start, {prices.at_goal, prices.at_start, 8}), there, 1e-6);
      EXPECT_NEAR(least(*start, *goal, {prices.at_start, prices.at_goal, 1e9}), there, 1e-6);
      if (paths) {
        const auto expected = paths->shortest(*start, *goal, prices.at_start, prices.at_goal);
        ASSERT_TRUE(expected);
        EXPECT_NEAR(there, *expected, 1e-6) << round << " radius " << radius;
      }
      const Point first = shortest.curve.front().to, last = shortest.curve.back().from;
      const double own = prices.at_start({first.x - start->x, first.y - start->y}) +
                         prices.at_goal({last.x - goal->x, last.y - goal->y});
      dearer += there > shortest.length + 0.1 && there < shortest.length + own - 0.01;
    }
  }
  EXPECT_GT(bent, 60);
  EXPECT_GT(dearer, 3);
}

}  // namespace
}  // namespace lasius::disc
