// Paths among polygons, judged by GEOS.
#include "bench/hunt/drawing.h"
#include "tests/oracle/polygon/polygon_judge.h"
#include "tests/worlds/random_world.h"

namespace lasius::bench {

void judge_polygon(const HuntCase& problem, HuntDraw& draw, HuntVerdict& verdict) {
  // Walls grow by so little that what touches is closed, and no verdict hangs on rounding.
  constexpr double kTouching = 1e-6, kSlack = 1e-4;
  const int count = draw.between(1, 9);
  const polygon::World world =
      polygon::random_world(problem.seed, count, draw.one_in(3) ? draw.between(2, 12) : 0);
  const polygon::Planner planner(world);
  polygon::PolygonJudge judge(world.boundary.outer, world.obstacles, kTouching);
  const polygon::Referee walls(world.obstacles);
  const auto place = [&] {
    const double x = draw.real(1, 199);
    return Point{x, draw.real(1, 199)};
  };
  for (int i = 0; i < 3; ++i) {
    const Point start = place(), goal = place();
    const auto roomy = [&](Point p) {
      return judge.free(p) && walls.distance({p, {p.x + 1e-9, p.y}}) > 0.01;
    };
    if (!roomy(start) || !roomy(goal)) continue;
    const double best = judge.shortest(start, goal);
    for (const char* algorithm : {"exact", "maklink-acs"}) {
      polygon::Params params{algorithm};
      if (i > 0 && params.algorithm() != "exact") continue;
      if (params.algorithm() != "exact") params.iterations = 5;
      const polygon::Result got = planner.plan({.start = start, .goal = goal}, params);
      const bool exact = params.algorithm() == "exact";
      const bool right = std::isinf(best)
                             ? got.status == Status::unreachable
                             : got.status == Status::solved && walls.clear(got.path, kTouching) &&
                                   got.length >= best - kSlack &&
                                   (!exact || got.length <= best + kSlack) &&
                                   got.lower_bound.value_or(0) <= best + kSlack;
      verdict.expect(right, [&] {
        return sentence(algorithm, " from ", told(start), " to ", told(goal), ": ",
                        to_string(got.status), ' ', got.length, " in place of ", best);
      });
    }
  }
}

}  // namespace lasius::bench
