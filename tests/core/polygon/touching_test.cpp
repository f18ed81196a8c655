// What touches is closed, wherever the world lies and however its rings are written.
// LASIUS_POLYGON_WORLDS sets how many random worlds are judged (default 40).
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

#include "core/polygon/world/repair.h"
#include "tests/oracle/polygon/polygon_judge.h"
#include "tests/worlds/touching_world.h"

namespace lasius::polygon {
namespace {

constexpr double kTouching = 1e-6;
constexpr double kSlack = 1e-4;  // what bends around corners that have grown by it add up to

struct Verdicts {
  int through = 0, too_long = 0, too_short = 0, wrongly_closed = 0, wrongly_open = 0;
  int paths = 0, unreachable = 0;
};

/// A point with some room around it.
Point roomy_point(const Referee& walls, const PolygonJudge& judge, Dice& dice) {
  for (int i = 0; i < 1000; ++i) {
    const Point p{dice.real(230, 370), dice.real(230, 370)};
    if (judge.free(p) && walls.distance({p, {p.x + 1e-9, p.y}}) > 0.01) return p;
  }
  return {};
}

void judge_world(std::uint64_t number, Verdicts& count) {
  const TouchingWorld world = TouchingWorlds::make(number);
  const Planner planner(parse_wkt(world.wkt, "w", {.repair = true}), {.margin = world.margin});
  const double margin = world.margin;
  PolygonJudge least(world.boundary, world.walls, kTouching);
  std::optional<PolygonJudge> most;
  std::optional<PolygonJudge> kept;
  if (margin > 0) {
    kept.emplace(margin * (1 - 1e-6), world.boundary, world.walls);
    // Round joins reach 0.5% farther than the arc, the judge's chords 2% less.
    most.emplace(margin * 1.026, world.boundary, world.walls);
  }
  PolygonJudge& low = kept ? *kept : least;
  PolygonJudge& high = most ? *most : least;
  const Referee walls(world.walls);
  Dice dice(number);
  for (int k = 0; k < 3; ++k) {
    const Point start = roomy_point(walls, high, dice), goal = roomy_point(walls, high, dice);
    if (start == Point{} || goal == Point{}) continue;
    const auto there = [&](Point p) { return Point{p.x + world.origin.x, p.y + world.origin.y}; };
    const Point from{there(start)}, to{there(goal)};
    const auto local = [&](Point p) { return Point{p.x - world.origin.x, p.y - world.origin.y}; };
    const Result result = planner.plan({.start = from, .goal = to});
    const double at_least = low.shortest(local(from), local(to)),
                 at_most = high.shortest(local(from), local(to));
    const std::string which = "world " + std::to_string(number) + ", question " +
                              std::to_string(k) + ": " + std::to_string(result.length) +
                              ", judged " + std::to_string(at_least) + " to " +
                              std::to_string(at_most) + " " + result.error;
    if (result.path.empty()) {
      ++count.unreachable;
      EXPECT_EQ(result.status, Status::unreachable) << which;
      EXPECT_TRUE(std::isinf(at_most)) << which << "\n" << world.wkt;
      count.wrongly_closed += std::isfinite(at_most) ? 1 : 0;
      continue;
    }
    ++count.paths;
    std::vector<Point> path;
    for (const Point p : result.path) path.push_back(local(p));
    const bool clear = walls.clear(path, kTouching) &&
                       (margin == 0 || walls.distance(path) >= margin * (1 - 1e-6));
    EXPECT_TRUE(clear) << which;
    EXPECT_GE(result.length, at_least - kSlack) << which;
    EXPECT_LE(result.length, at_most + kSlack) << which << "\n" << world.wkt;
    count.through += clear ? 0 : 1;
    count.wrongly_open += std::isinf(at_least) ? 1 : 0;
    count.too_short += std::isfinite(at_least) && result.length < at_least - kSlack ? 1 : 0;
    count.too_long += result.length > at_most + kSlack ? 1 : 0;
  }
}

// What is meant is the outer ring less its holes.
TEST(Repair, LosesNoHole) {
  const std::string outer = "POLYGON ((0 0, 20 0, 20 12, 0 12, 0 0), ";
  const std::string low = " POINT (1 1) POINT (19 1)", middle = " POINT (1 6) POINT (19 6)";
  const std::string block = "(8 2, 12 2, 12 10, 8 10, 8 2)";
  const double over = 2 * std::hypot(7, 7) + 4, around = 2 * std::hypot(7, 4) + 4;
  const std::pair<std::string, double> cases[] = {
      {outer + "(8 0, 12 0, 12 8, 8 8, 8 0))" + low, over},
      {outer + "(8 0, 12 0, 12 12, 8 12, 8 0))" + low, 0},
      {outer + "(10 0, 12 6, 10 12, 8 6, 10 0))" + low, 0},
      {outer + "(8 -4, 12 -4, 12 8, 8 8, 8 -4))" + low, over},
      {outer + block + ", " + block + ")" + middle, around},
      {outer + block + ", (9 4, 11 4, 11 8, 9 8, 9 4))" + middle, around},
      {outer + block + ", (9 2, 9 2, 11 2, 11 2, 11 10, 9 10, 9 2))" + middle, around},
      {outer + "(8 2, 12 10, 12 2, 8 10, 8 2))" + middle, around},
      {outer + "(8 2, 12 2, 12 10, 8 10, 8 2, 12 2, 12 10, 8 10, 8 2))" + middle, around},
      {outer + "(8 0, 12 0, 12 6, 8 6, 8 0), (8 6, 12 6, 12 12, 8 12, 8 6))" + low, 0},
      {outer + "(10 0, 12 3, 10 6, 8 3, 10 0), (10 6, 12 9, 10 12, 8 9, 10 6))" + low, 0},
      // Of an obstacle: a bay that opens to the left.
      {"POLYGON ((0 0, 20 0, 20 12, 0 12, 0 0)) POLYGON (" + block +
           ", (8 4, 10 4, 10 8, 8 8, 8 4)) POINT (9 6) POINT (1 6)",
       8}};
  for (const auto& [text, length] : cases) {
    const World world = parse_wkt(text, "w", {.repair = true});
    const Result result = Planner(world).plan();
    if (length == 0) {
      EXPECT_EQ(result.status, Status::unreachable) << text;
    } else {
      EXPECT_NEAR(result.length, length, 1e-9) << text;
    }
    EXPECT_EQ(Planner(parse_geojson(to_geojson(world), "w", {})).plan().path, result.path) << text;
  }
}

// A wall without width would be lost; a bridge to a hole is none.
TEST(Repair, TellsWhatHasNoWidth) {
  const Ring square{{2, 2}, {8, 2}, {8, 8}, {2, 8}};
  const auto with = [&](Ring more) {
    more.insert(more.begin(), square.begin(), square.end());
    return Polygon{more, {}};
  };
  const Geos geos;
  const Ring out{{2, 9}, {2, 8}}, in{{5, 5}, {2, 8}};
  const Ring keyhole{{4, 6}, {6, 6}, {6, 4}, {4, 4}, {4, 6}, {2, 8}};
  EXPECT_EQ(repaired(geos, with(out), false).lines.size(), 1u);
  EXPECT_EQ(repaired(geos, with(out), true).lines.size(), 0u);
  EXPECT_EQ(repaired(geos, with(in), false).lines.size(), 0u);
  EXPECT_EQ(repaired(geos, with(in), true).lines.size(), 1u);
  for (const bool is_boundary : {false, true}) {
    const Repair repair = repaired(geos, with(keyhole), is_boundary);
    EXPECT_TRUE(repair.lines.empty());
    ASSERT_EQ(repair.areas.size(), 1u);
    EXPECT_EQ(repair.areas[0].holes.size(), 1u);
  }
  const Polygon flat{square, {{{3, 3}, {5, 5}}, {{4, 3}}}};
  EXPECT_EQ(repaired(geos, flat, true).lines.size(), 2u);
  EXPECT_EQ(repaired(geos, {{{3, 3}, {5, 5}, {3, 3}}, {}}, false).lines.size(), 1u);
}

// Of the same area their order and where they begin: recorded results depend on it.
TEST(Repair, TakesTheRingsOfGeosWhereTheyMeanTheSame) {
  const Geos geos;
  const Polygon bow{{{0, 0}, {4, 4}, {4, 0}, {0, 4}}, {}};
  const auto valid = geos.own(GEOSMakeValid_r(geos.context(), geos.polygon(bow).get()));
  EXPECT_EQ(repaired(geos, bow, false).areas, geos.polygons(valid.get()));
}

TEST(Touching, RandomWorldsAreJudgedWhereverTheyLie) {
  const char* const asked = std::getenv("LASIUS_POLYGON_WORLDS");
  const std::uint64_t worlds = asked == nullptr ? 40 : std::strtoull(asked, nullptr, 10);
  Verdicts count;
  for (std::uint64_t number = 0; number < worlds; ++number) {
    ASSERT_NO_THROW(judge_world(number, count)) << TouchingWorlds::make(number).wkt;
  }
  std::printf(
      "%d paths, %d unreachable; wrong: %d through walls, %d too long, %d too short, %d closed, %d "
      "open\n",
      count.paths, count.unreachable, count.through, count.too_long, count.too_short,
      count.wrongly_closed, count.wrongly_open);
  EXPECT_GT(count.paths, static_cast<int>(worlds));
  EXPECT_GT(count.unreachable, static_cast<int>(worlds) / 5);
}

}  // namespace
}  // namespace lasius::polygon
