// Shortest curves of discs.

#include "bench/hunt/drawing.h"
#include "lasius/plan/planner.h"
#include "tests/oracle/disc_paths.h"
#include "tests/oracle/near_clearance.h"

namespace lasius::bench {

void judge_disc(const HuntCase& problem, HuntDraw& draw, HuntVerdict& verdict) {
  // Not those that just fit: there both sides decide by rounding.
  const double radius = draw.real(0.1, 2.5) + 1e-4;
  const Planner plain(Grid(problem.grid), Disc{radius});
  const Planner graph(Grid(problem.grid), {.threads = 1}, Disc{radius});
  oracle::DiscPaths oracle(problem.grid, radius);
  const auto& places = problem.places;
  for (std::size_t a = 0; a < places.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      const Point start = centre(places[a]), goal = centre(places[b]);
      if (!oracle.clear(start) || !oracle.clear(goal)) continue;
      const auto best = oracle.shortest(start, goal);
      for (const Planner* planner : {&plain, &graph}) {
        const Result got = planner->plan({.start = places[a], .goal = places[b]});
        verdict.expect(best ? got.status == Status::solved && got.optimal &&
                                  std::abs(got.length - *best) <= 1e-7 * (1 + *best)
                            : got.status == Status::unreachable,
                       [&] {
                         return sentence(planner == &plain ? "scan" : "graph", " for radius ",
                                         radius, " from ", told(start), " to ", told(goal), ": ",
                                         to_string(got.status), ' ', got.length, " in place of ",
                                         best.value_or(-1));
                       });
        for (std::size_t i = 1; i < got.path.size(); ++i)
          verdict.expect(oracle::near_clearance(problem.grid, got.path[i - 1], got.path[i],
                                                radius + 1) >= radius - 1e-7,
                         [&] { return "nearer than the radius at " + told(got.path[i]); });
      }
    }
}

}  // namespace lasius::bench
