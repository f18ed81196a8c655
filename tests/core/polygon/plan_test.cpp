#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "lasius/base/error.h"
#include "lasius/grid/generate.h"
#include "lasius/plan/planner.h"
#include "tests/core/base/counting_time.h"
#include "tests/core/base/refusal.h"
#include "tests/core/polygon/known_world.h"
#include "tests/oracle/dense_dijkstra.h"
#include "tests/worlds/random_world.h"

namespace lasius::polygon {
namespace {

double turn(Point a, Point b, Point c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
double area(const Ring& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    sum += turn(ring[0], ring[i], ring[(i + 1) % ring.size()]);
  }
  return sum / 2;
}

/// Free lines part free space into convex regions, none of which could be joined to another.
void expect_maklink(const Planner& planner, const std::string& which) {
  const Maklink& graph = planner.maklink();
  double regions = 0, free = 0;
  for (const auto& region : graph.regions) {
    regions += area(region);
    for (std::size_t i = 0; i < region.size(); ++i) {
      const std::size_t n = region.size();
      EXPECT_GE(turn(region[i], region[(i + 1) % n], region[(i + 2) % n]), -1e-9) << which;
    }
  }
  for (const Polygon& piece : graph.free_space) {
    free += std::abs(area(piece.outer));
    for (const Ring& hole : piece.holes) free -= std::abs(area(hole));
  }
  EXPECT_NEAR(regions, free, 1e-6) << which;
  const auto neighbour = [&](int region, Point at, int step) {
    const auto& ring = graph.regions[region];
    const auto found = std::find(ring.begin(), ring.end(), at) - ring.begin();
    return ring[(found + step + ring.size()) % ring.size()];
  };
  for (const Line& line : graph.lines) {
    ASSERT_NE(line.left, line.right) << which;
    // Without the line, the corner at one of its ends would be hollow.
    const bool hollow_a =
        turn(neighbour(line.left, line.a, -1), line.a, neighbour(line.right, line.a, 1)) < 0;
    const bool hollow_b =
        turn(neighbour(line.right, line.b, -1), line.b, neighbour(line.left, line.b, 1)) < 0;
    EXPECT_TRUE(hollow_a || hollow_b) << which;
  }
}

/// Shortest path over corners that see each other, pair by pair, as GEOS says.
double brute_force(const Planner& planner, Point start, Point goal) {
  const Referee referee(planner.grown_obstacles());
  std::vector<Point> nodes{start, goal};
  for (const Polygon& p : planner.grown_obstacles()) {
    nodes.insert(nodes.end(), p.outer.begin(), p.outer.end());
    for (const Ring& hole : p.holes) nodes.insert(nodes.end(), hole.begin(), hole.end());
  }
  std::vector<double> known(nodes.size(), oracle::kUnreached);
  known[0] = 0;
  const auto between = [&](std::size_t a, std::size_t b) {
    return std::hypot(nodes[b].x - nodes[a].x, nodes[b].y - nodes[a].y);
  };
  const auto joined = [&](std::size_t a, std::size_t b) {
    return referee.sees(nodes[a], nodes[b]);
  };
  return oracle::shortest_distances(std::move(known), between, joined)[1];
}

TEST(KnownWorld, ShortestPathOfTheWorld) {
  const Result result = Planner(known_world()).plan();
  EXPECT_EQ(result.status, Status::solved);
  EXPECT_NEAR(result.length, 168.371941370, 5e-10);
  EXPECT_TRUE(result.optimal);
  EXPECT_EQ(result.path, (std::vector<Point>{{20, 180}, {100, 140}, {140, 100}, {160, 90}}));
}

TEST(KnownWorld, AntsReachTheOptimumOfTheirLinesWithEverySeed) {
  const Planner planner(known_world());
  expect_maklink(planner, "known world");
  Params parameters("maklink-acs");
  for (int seed = 1; seed <= 100; ++seed) {
    parameters.seed = static_cast<std::uint64_t>(seed);
    const Result result = planner.plan({}, parameters);
    EXPECT_NEAR(result.length, result.discrete_optimum->length, 1e-9) << "seed " << seed;
    expect_order(result, "seed " + std::to_string(seed));
  }
}

TEST(KnownWorld, DiscreteOptimumByTrial) {
  const Planner planner(known_world());
  Params parameters("maklink-acs");
  parameters.values = 3;
  const Result result = planner.plan({}, parameters);
  const auto& lines = result.crossing.lines;
  double best = std::numeric_limits<double>::infinity();
  for (int code = 0; code < std::pow(3, lines.size()); ++code) {
    Point at{20, 180};
    double length = 0;
    for (std::size_t i = 0, rest = static_cast<std::size_t>(code); i < lines.size(); ++i) {
      const Line& line = planner.maklink().lines[lines[i]];
      const double h = static_cast<double>(rest % 3) / 2;
      rest /= 3;
      const Point p{line.a.x + h * (line.b.x - line.a.x), line.a.y + h * (line.b.y - line.a.y)};
      length += std::hypot(p.x - at.x, p.y - at.y);
      at = p;
    }
    best = std::min(best, length + std::hypot(160 - at.x, 90 - at.y));
  }
  EXPECT_NEAR(result.discrete_optimum->length, best, 1e-9);
}

TEST(Maklink200, IsWhatItsReadmeSays) {
  const Planner planner(read_world(LASIUS_MAPS_DIR "/maklink200.geojson"));
  expect_maklink(planner, "maklink200");
  const Result result = planner.plan({}, Params("maklink-acs"));
  EXPECT_EQ(result.crossing.lines.size(), 9u);
  EXPECT_NEAR(result.dijkstra->length, 509.689, 5e-4);
  EXPECT_NEAR(*result.lower_bound, 432.686, 5e-4);
  EXPECT_NEAR(result.length, result.discrete_optimum->length, 1e-9);
}

TEST(RandomWorlds, MaklinkAndPathsAreValid) {
  int planned = 0;
  for (int i = 0; i < 40; ++i) {
    const std::string which = "world " + std::to_string(i);
    const int count = i == 0 ? 200 : 5 + 95 * (i % 10) * (i % 10) / 81;
    World world = random_world(static_cast<std::uint64_t>(i), count, i % 3 == 0 ? 5 : 0);
    world.margin = i % 2 == 0 ? 0 : 0.1 * (i % 7);
    const Planner planner(world);
    expect_maklink(planner, which);
    const Request request = random_request(planner, 1000 + i);
    const Result exact = planner.plan(request);
    if (exact.status == Status::unreachable) continue;
    const Referee referee(planner.grown_obstacles());
    EXPECT_TRUE(referee.clear(exact.path, 200 * 1e-9)) << which;
    for (const char* algorithm : {"maklink-acs", "real-ga"}) {
      Params parameters(algorithm);
      parameters.iterations = 50;
      const Result result = planner.plan(request, parameters);
      expect_order(result, which);
      EXPECT_EQ(*result.lower_bound, std::min(exact.length, result.length)) << which;
      EXPECT_TRUE(referee.clear(result.path, 200 * 1e-9)) << which;
      EXPECT_TRUE(referee.clear(result.sequence_optimum->path, 200 * 1e-9)) << which;
      ++planned;
    }
  }
  EXPECT_GT(planned, 40);
}

TEST(RandomWorlds, ExactAgreesWithBruteForce) {
  int reached = 0;
  for (int i = 0; i < 12; ++i) {
    const Planner planner(random_world(50 + i, 4 + i));
    const Request request = random_request(planner, i);
    const Result result = planner.plan(request);
    const double expected = brute_force(planner, *request.start, *request.goal);
    if (std::isinf(expected)) {
      EXPECT_EQ(result.status, Status::unreachable) << i;
    } else {
      EXPECT_NEAR(result.length, expected, 1e-6) << i;
      ++reached;
    }
  }
  EXPECT_GT(reached, 6);
}

World slalom() {
  World world = empty_world(40, 20, Point{1, 1}, Point{39, 1});
  for (int i = 0; i < 3; ++i) {
    const double x = 10 + 10 * i, low = i % 2 == 0 ? 0 : 8, high = i % 2 == 0 ? 12 : 20;
    world.obstacles.push_back({{{x, low}, {x + 1, low}, {x + 1, high}, {x, high}}, {}});
  }
  return world;
}

TEST(Slalom, FunnelIsTheShortestPathWhereThereIsOneWay) {
  const Planner planner(slalom());
  const Result result = planner.plan({}, Params("maklink-acs"));
  const double by_hand =
      std::hypot(9, 11) + 1 + std::hypot(9, 4) + 1 + std::hypot(9, 4) + 1 + std::hypot(8, 11);
  EXPECT_NEAR(planner.plan().length, by_hand, 1e-9);
  EXPECT_NEAR(result.sequence_optimum->length, by_hand, 1e-9);
}

TEST(Degenerate, ObstaclesThatTouchAreAWall) {
  World world = empty_world(20, 10, Point{1, 5}, Point{19, 5});
  // Corner to corner from wall to wall.
  world.obstacles = {{{{10, 0}, {12, 2.5}, {10, 5}, {8, 2.5}}, {}},
                     {{{10, 5}, {12, 7.5}, {10, 10}, {8, 7.5}}, {}}};
  const Planner planner(world);
  EXPECT_EQ(planner.components(), 2);
  const Result result = planner.plan();
  EXPECT_EQ(result.status, Status::unreachable);
  expect_says(result.error, "different pieces");
  world.obstacles[1].outer[2] = {10, 9};  // now there is a gap above
  EXPECT_EQ(Planner(world).plan().status, Status::solved);
}

TEST(Degenerate, StartOnALineOnACornerOnAnEdge) {
  const Planner planner(known_world());
  for (const Line& line : planner.maklink().lines) {
    for (const double h : {0.0, 0.25, 1.0}) {
      const Point p{line.a.x + h * (line.b.x - line.a.x), line.a.y + h * (line.b.y - line.a.y)};
      const Request request{.start = p, .goal = Point{160, 90}};
      const Result result = planner.plan(request, Params("maklink-acs"));
      ASSERT_EQ(result.status, Status::solved);
      expect_order(result, "on a line");
      EXPECT_EQ(result.path.front(), p);
    }
  }
  // In the middle of an edge that no binary number hits.
  const Result edge = planner.plan({.start = Point{60 - 20 * 0.3, 160 - 20 * 0.3}, .goal = {}});
  EXPECT_EQ(edge.status, Status::solved);
}

TEST(Degenerate, CollinearCornersAndStripes) {
  World world;
  world.boundary.outer = {{0, 0}, {10, 0}, {20, 0}, {30, 0}, {30, 30}, {15, 30}, {0, 30}};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      const double x = 3 + 9 * column, y = 3 + 9 * row;
      world.obstacles.push_back(
          {{{x, y}, {x + 3, y}, {x + 6, y}, {x + 6, y + 6}, {x, y + 6}, {x, y + 3}}, {}});
    }
  }
  const Planner planner(world);
  expect_maklink(planner, "blocks");
  const Result result = planner.plan({.start = Point{0, 0}, .goal = Point{30, 30}});
  // Right along the lowest street to its end, then up: or any other way round the blocks' corners.
  EXPECT_NEAR(result.length, brute_force(planner, {0, 0}, {30, 30}), 1e-9);
}

TEST(Degenerate, NoObstaclesAndNoWay) {
  World world = empty_world(4, 3, Point{0, 0}, Point{4, 3});
  Result result = Planner(world).plan({}, Params("maklink-acs"));
  EXPECT_EQ(result.length, 5);
  EXPECT_EQ(*result.gap(), 0);
  EXPECT_EQ(result.curves.iterations, 0);
  result = Planner(world).plan({.start = Point{1, 1}, .goal = Point{1, 1}});
  EXPECT_EQ(result.length, 0);
  EXPECT_EQ(result.path.size(), 1u);
  // A pocket inside an obstacle's hole.
  world.obstacles = {{{{1, 1}, {3, 1}, {3, 2}, {1, 2}}, {{{1.5, 1.2}, {2.5, 1.2}, {2.5, 1.8}}}}};
  world.start = Point{2.4, 1.3};
  EXPECT_EQ(Planner(world).components(), 2);
  EXPECT_EQ(Planner(world).plan().status, Status::unreachable);
}

TEST(Prepare, IsCutShortWhereverTimeRunsOut) {
  // A star: most of its many corners are reflex and see many others.
  World world;
  for (int i = 0; i < 4000; ++i) {
    const double a = 2 * std::numbers::pi * i / 4000, r = i % 2 == 0 ? 10 : 11 + i % 7;
    world.boundary.outer.push_back({r * std::cos(a), r * std::sin(a)});
  }
  const CountingTime counted(1 << 30);
  const auto whole = Planner::make(world, {}, counted.is_up());
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->maklink().lines.size(), Planner(world).maklink().lines.size());
  ASSERT_GT(counted.polls(), 1);
  for (int looks = 0; looks < counted.polls(); ++looks) {
    const CountingTime time(looks);
    EXPECT_FALSE(Planner::make(world, {}, time.is_up())) << looks;
    EXPECT_EQ(time.polls(), looks + 1);
  }
}

TEST(Ends, BlockedAndOutsideNameTheNearestFreePoint) {
  const Planner planner(known_world());
  const Result blocked = planner.plan({.start = Point{60, 140}, .goal = {}});
  EXPECT_EQ(blocked.status, Status::invalid);
  expect_says(blocked.error, "start (60, 140) is blocked; the nearest free point is (50, 150)");
  const Result outside = planner.plan({.start = {}, .goal = Point{-3, 140}});
  expect_says(outside.error,
              "goal (-3, 140) is outside the boundary; the nearest free point is "
              "(0, 140)");
  EXPECT_EQ(planner.plan({.start = Point{1e300, 0}, .goal = {}}).status, Status::invalid);
  EXPECT_THROW(planner.plan({.start = Point{std::nan(""), 0}, .goal = {}}), Error);
  for (const double gap : {-0.1, std::nan("")}) {
    EXPECT_THROW(planner.plan({.start = {}, .goal = {}, .target_gap = gap}), Error);
  }
  World open = known_world();
  open.start.reset();
  EXPECT_THROW(Planner(open).plan(), Error);
}

// A shelf around a block: what is nearest is walled in.
TEST(Ends, BlockedOnesNameWhatIsJoinedToTheOther) {
  World world = empty_world(10, 10);
  const auto box = [](double left, double low, double right, double high) {
    return Polygon{{{left, low}, {right, low}, {right, high}, {left, high}}, {}};
  };
  world.obstacles = {box(3, 3, 7, 4), box(3, 6, 7, 7), box(3, 3, 4, 7), box(6, 3, 7, 7),
                     box(4.5, 4.5, 5.5, 5.5)};
  const Planner planner(world);
  const Point out{1, 5}, in_block{4.75, 5}, in_shelf{4.25, 5}, in_wall{3.75, 5};
  const auto says = [&](Point start, Point goal) {
    return planner.plan({.start = start, .goal = goal}).error;
  };
  expect_says(says(out, in_block),
              "goal (4.75, 5) is blocked; the nearest free point that can be reached from the "
              "start is (3, 5); (4.5, 5) is nearer, but cannot be reached");
  expect_says(says(in_block, out),
              "start (4.75, 5) is blocked; the nearest free point from which the goal can be "
              "reached is (3, 5); (4.5, 5) is nearer, but does not lead there");
  expect_says(says(in_shelf, in_block), "is blocked; the nearest free point is (4.5, 5)");
  expect_says(says(in_wall, in_block), "is blocked; the nearest free point is (4, 5)");
  const auto reached = [&](Point goal, double tolerance) {
    return planner.plan({.start = out, .goal = goal, .goal_tolerance = tolerance});
  };
  for (const Point goal : {in_block, in_shelf, in_wall}) {
    const double away = goal.x - 3;
    for (const char* algorithm : {"exact", "maklink-acs"}) {
      const Result result =
          planner.plan({.start = out, .goal = goal, .goal_tolerance = away}, Params(algorithm));
      EXPECT_EQ(result.goal_reached, (Point{3, 5}));
      EXPECT_EQ(result.length, 2);
      EXPECT_EQ(result.path.back(), (Point{3, 5}));
    }
    const Result result = reached(goal, 0.9 * away);
    EXPECT_TRUE(result.path.empty() && !result.goal_reached);
    EXPECT_EQ(result.nearest_reachable, (Point{3, 5}));
    expect_says(result.error, "; the nearest point that can be reached, (3, 5), is ");
  }
  expect_says(reached({-1e308, 5}, 1).error,
              "the nearest point that can be reached, (0, 5), is 1e+308 from the goal");
  EXPECT_EQ(reached({-1e308, 5}, 1e308).goal_reached, (Point{0, 5}));
  EXPECT_EQ(reached({1, 6}, 3).goal_reached, (Point{1, 6}));
  EXPECT_EQ(reached(out, 3).goal_reached, out);
  EXPECT_THROW(reached(out, -1), Error);
}

TEST(Ends, AnEdgeOfTheBoundaryIsNotOutside) {
  World world = empty_world(4, 4, Point{0.5, 0.5});
  world.obstacles = {{{{1, 3}, {3, 3}, {3, 5}, {1, 5}}, {}},
                     {{{3, 1}, {5, 1}, {5, 2}, {3, 2}}, {}}};
  for (const Point goal : {Point{2, 4}, Point{4, 1.5}}) {
    const Result result = Planner(world).plan({.start = {}, .goal = goal});
    expect_says(result.error, "is blocked");
  }
}

TEST(Bitmap, ExactPathsOfBothWorldsAreOfOneLength) {
  int reached = 0;
  for (const MapKind kind : {MapKind::rooms, MapKind::blobs, MapKind::random}) {
    const Grid grid = generate(kind, {.width = 48, .height = 40, .seed = 2});
    const lasius::Planner cells(grid);
    const Planner planner(from_grid(grid));
    Dice dice(9);
    for (int i = 0; i < 6; ++i) {
      const Cell a = *cells.nearest_free({dice.whole(0, 47), dice.whole(0, 39)});
      const Cell b = *cells.nearest_free({dice.whole(0, 47), dice.whole(0, 39)});
      const auto up = [](Cell c) { return Point{c.x + 0.5, 39.5 - c.y}; };
      const lasius::Result expected = cells.plan({.start = a, .goal = b});
      const Result result = planner.plan({.start = up(a), .goal = up(b)});
      EXPECT_EQ(result.status, expected.status);
      if (expected.path.empty()) continue;
      EXPECT_NEAR(result.length, expected.length, 1e-9);
      ++reached;
    }
  }
  EXPECT_GT(reached, 9);
}

}  // namespace
}  // namespace lasius::polygon
