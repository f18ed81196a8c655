// Tours.
#include "lasius/tour/tour.h"

#include "lasius/tour/cover.h"
#include "lasius/vehicle/tour.h"
#include "python/extension/arrays.h"
#include "python/extension/call.h"
#include "python/extension/modules.h"
#include "python/extension/vehicle_class.h"

namespace lasius::python {
namespace {

/// The fields of lasius.TourResult.
py::tuple fields(const TourResult& tour) {
  std::vector<double> lengths, costs;
  std::vector<Point> points;
  std::vector<std::int64_t> offsets{0};
  for (const TourLeg& leg : tour.legs) {
    lengths.push_back(leg.length);
    if (tour.cost) costs.push_back(leg.cost);
    points.insert(points.end(), leg.path.begin(), leg.path.end());
    offsets.push_back(static_cast<std::int64_t>(points.size()));
  }
  py::dict left_out;
  for (const LeftOut& out : tour.left_out) left_out[py::int_(out.stop)] = out.why;
  py::list tours;
  for (const RobotTour& robot : tour.tours)
    tours.append(py::make_tuple(robot.start, to_array(robot.order),
                                py::make_tuple(robot.first_leg, robot.first_leg + robot.legs),
                                robot.length, tour.cost ? robot.cost : NAN));
  const double length = tour.order.empty() ? NAN : tour.length;
  return py::make_tuple(text(to_string(tour.status)), tour.error, to_array(tour.order), length,
                        tour.lower_bound, tour.gap(), tour.optimal, left_out, tour.priced,
                        to_array(lengths), to_array(std::span<const Point>(points)),
                        to_array(offsets), tour.cost.value_or(NAN), to_array(costs), tours);
}

/// The fields of lasius.VehicleTourResult: those of a tour, then its own.
py::tuple fields(const vehicle::TourResult& tour) {
  py::list plans;
  for (const vehicle::Result& plan : tour.plans) plans.append(vehicle_fields(plan));
  const lasius::TourResult& told = tour;
  return fields(told) + py::make_tuple(pose_rows(tour.poses), plans);
}

TourObserver observer_of(Call& call, const py::object& callback) {
  if (callback.is_none()) return {};
  return [&](std::span<const int> order, double length) {
    return call.ask([&] {
      const std::vector<int> told(order.begin(), order.end());
      const bool more = !callback(to_array(told), length).equal(py::bool_(false));
      return more ? Go::on : Go::stop;
    });
  };
}

/// The fields of a lasius.CoverResult: those of its tour, then its own.
py::tuple cover(const Planner& planner, double width, bool open,
                std::optional<std::pair<double, double>> start, std::uint64_t seed, int generations,
                int threads, std::optional<double> time_limit, const py::object& callback) {
  Call call(time_limit);
  CoverRequest request{.width = width,
                       .open = open,
                       .seed = seed,
                       .generations = generations,
                       .threads = threads,
                       .stop = call.condition()};
  if (start) request.start = Point{start->first, start->second};
  const TourObserver observer = observer_of(call, callback);
  const CoverResult found = call.run([&] { return plan_cover(planner, request, observer); });
  return py::make_tuple(call.error(), fields(found.tour),
                        py::make_tuple(to_array(std::span<const Point>(found.stops)),
                                       found.swaths(), found.angle, found.swept, found.covered,
                                       found.overlap, found.unreachable, found.resolution));
}

/// On a map, over costs, or of a vehicle, which alone has yaws.
template <class World>
py::tuple tour(const World& world, const IntRows& cells, const Rows& points,
               std::vector<std::optional<double>> yaws, bool open, std::optional<int> start,
               std::optional<int> goal, std::vector<std::vector<int>> after, std::vector<int> load,
               std::optional<std::int64_t> capacity, std::vector<int> group,
               std::vector<int> robots, int most_stops, const std::string& algorithm,
               const std::vector<std::pair<std::string, std::string>>& settings, std::uint64_t seed,
               int generations, double target_gap, int threads, std::optional<double> time_limit,
               const py::object& callback) {
  Call call(time_limit);
  vehicle::TourRequest request;
  request.stops = cells_from(cells, "stops");
  request.points = points_from(points, "stops");
  request.yaws = std::move(yaws);
  request.open = open;
  request.start = start;
  request.goal = goal;
  request.after = std::move(after);
  request.load = std::move(load);
  request.capacity = capacity;
  request.group = std::move(group);
  request.robots = std::move(robots);
  request.most_stops = most_stops;
  request.ants = tour::AntParams(algorithm);
  for (const auto& [name, value] : settings) tour::set_parameter(request.ants, name, value);
  request.seed = seed;
  request.generations = generations;
  request.target_gap = target_gap;
  request.threads = threads;
  request.stop = call.condition();
  const TourObserver observer = observer_of(call, callback);
  const auto found = call.run([&] { return plan_tour(world, request, observer); });
  return py::make_tuple(call.error(), fields(found));
}

}  // namespace

void bind_tour(py::module_& module) {
  module.def("tour", &tour<Planner>);
  module.def("tour", &tour<CostPlanner>);
  module.def("tour", &tour<vehicle::Planner>);
  module.def("cover", &cover);
}

}  // namespace lasius::python
