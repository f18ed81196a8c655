// What touches is closed, wherever the world lies and however its rings are written.
// LASIUS_POLYGON_WORLDS sets how many random worlds are judged (default 60).
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "tests/core/base/refusal.h"
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

TEST(Touching, RandomWorldsAreJudgedWhereverTheyLie) {
  const char* const asked = std::getenv("LASIUS_POLYGON_WORLDS");
  const std::uint64_t worlds = asked == nullptr ? 60 : std::strtoull(asked, nullptr, 10);
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
