// Paths of vehicles: whole, within their limits, and touching nothing.
#include <numbers>

#include "bench/hunt/drawing.h"
#include "lasius/vehicle/planner.h"
#include "tests/oracle/vehicle/footprint_judge.h"
#include "tests/oracle/vehicle/motions.h"

namespace lasius::bench {
namespace {

vehicle::Vehicle draw_vehicle(HuntDraw& draw) {
  const double length = draw.real(0.6, 6), width = draw.real(0.4, 3);
  std::vector<Point> shape = vehicle::rectangle(draw.real(0, 1) * length, length, width);
  if (draw.one_in(3)) shape = {{-width, -width}, {length, 0.1}, {-0.5 * width, width}};
  if (draw.one_in(3))
    shape = {{-1, -width}, {length, -width}, {length, 0}, {0.3, 0}, {0.3, width}, {-1, width}};
  const double radius = draw.real(1, 8);
  switch (draw.between(0, 3)) {
    case 0:
      return vehicle::differential(shape);
    case 1:
      return vehicle::omni(shape);
    default:
      break;
  }
  vehicle::Vehicle made = vehicle::car(shape, radius);
  made.reverse = draw.one_in(2);
  made.rotate_in_place = draw.one_in(4);
  made.cusp_cost = draw.one_in(2) ? 0 : draw.real(0, 5);
  made.reverse_cost = draw.real(1, 3);
  return made;
}

std::string fault_of_motions(const vehicle::Vehicle& vehicle, const vehicle::Request& request,
                             const vehicle::Result& got) {
  const auto apart = [](const vehicle::Pose& a, const vehicle::Pose& b) {
    return std::hypot(a.x - b.x, a.y - b.y) > 1e-6 ||
           std::abs(std::remainder(a.yaw - b.yaw, 2 * std::numbers::pi)) > 1e-6;
  };
  vehicle::Pose at = request.start;
  double length = 0;
  for (const vehicle::Segment& s : got.segments) {
    if (apart(at, s.begin)) return "a gap between two motions";
    const double most = vehicle.turning_radius > 0 ? 1 / vehicle.turning_radius : 0;
    if (std::abs(s.curvature) > most * (1 + 1e-9)) return "a turn below the radius";
    if (s.gear == 0 && !vehicle.rotate_in_place) return "a turn in place";
    if (s.gear < 0 && !vehicle.reverse) return "a way backwards";
    at = s.end();
    length += s.length;
  }
  if (apart(at, request.goals[static_cast<std::size_t>(got.goal)])) return "another goal";
  if (!same_length(length, got.length)) return "the length is not that of the motions";
  if (got.lower_bound.value_or(0) > got.length * (1 + 1e-9) + 1e-7) return "a bound above the path";
  return "";
}

}  // namespace

void judge_vehicle(const HuntCase& problem, HuntDraw& draw, HuntVerdict& verdict) {
  const vehicle::Vehicle vehicle = draw_vehicle(draw);
  const vehicle::Planner planner(problem.grid, vehicle);
  oracle::FootprintJudge judge(problem.grid, vehicle.footprint);
  std::vector<vehicle::Pose> poses;
  for (const Cell place : problem.places) {
    const Point p = centre(place);
    poses.push_back({p.x, p.y, draw.real(-4, 4)});
  }
  vehicle::Request request{.start = poses[0], .goals = {poses.begin() + 1, poses.end()}};
  request.max_states = 100'000;
  const vehicle::Result got = planner.plan(request);
  if (got.goal < 0) {
    verdict.expect(got.segments.empty() && got.status != Status::solved,
                   [] { return std::string("a path that is not told"); });
    return;
  }
  const std::string fault = fault_of_motions(vehicle, request, got);
  verdict.expect(fault.empty(), [&] { return fault; });
  const auto touch = judge.first_touch(oracle::motions_of(got.segments));
  verdict.expect(!touch,
                 [&] { return sentence("touches (", touch->cell.x, ", ", touch->cell.y, ')'); });
}

}  // namespace lasius::bench
