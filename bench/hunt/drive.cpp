// Drives through worlds that change.
#include "bench/hunt/drawing.h"
#include "tests/oracle/drive/drive_checker.h"
#include "tests/worlds/changing_world.h"

namespace lasius::bench {

void judge_drive(const HuntCase& problem, HuntDraw&, HuntVerdict& verdict) {
  const bool calm = problem.seed % 2 == 0;
  const RandomWorld world = draw_world(problem.seed, calm);
  const DriveResult got = drive(world.map, world.truth, world.start, world.goal, world.changes,
                                world.options, world.navigator);
  if (got.status == Status::invalid) return;
  DriveChecker checker(world.truth, world.changes, world.navigator.radius);
  const std::string fault = checker.fault(got.track);
  verdict.expect(fault.empty(), [&] { return fault; });
  if (got.status == Status::solved) {
    verdict.expect(got.track.back() == world.goal,
                   [] { return std::string("solved, and not at the goal"); });
  } else if (calm) {
    verdict.expect(
        got.status == Status::unreachable && !checker.joined(got.track.back(), world.goal),
        [&] { return sentence(to_string(got.status), ", where a way is left"); });
  }
}

}  // namespace lasius::bench
