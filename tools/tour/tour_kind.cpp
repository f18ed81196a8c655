#include "tools/tour/tour_kind.h"

#include <algorithm>
#include <utility>

#include "tools/bitmap/bitmap_problem.h"
#include "tools/bitmap/map_ends.h"
#include "tools/console/elapsed.h"
#include "tools/console/parameters.h"
#include "tools/options/commands.h"
#include "tools/record/problem.h"
#include "tools/record/recorded.h"
#include "tools/tour/cover_problem.h"
#include "tools/tour/tour_problem.h"

namespace lasius::tool {
namespace {

std::unique_ptr<Problem> tour_again(const Recorded& from, const Problem*) {
  const Json& result = from.result;
  TourCommand command;
  command.open = recorded<bool>(result, "parameters/open");
  command.generations = static_cast<int>(
      recorded_integer(result, "parameters/generations", 0, TourCommand::kMostGenerations));
  const Algorithm& algorithm = *std::ranges::find(
      tour::algorithms(), algorithm_of(tour_kind(), recorded<std::string>(result, "algorithm")),
      &Algorithm::name);
  RunOptions asked;
  read_recorded(from, algorithm, asked);
  const bool tsplib = is_tsplib(recorded<std::string>(result, "map/file"));
  const bool polygons = is_polygon_file(recorded<std::string>(result, "map/file"));
  if (tsplib || polygons) {
    command.run = asked;
    command.run.map.file = from.map_file();
  } else {
    command.run = recorded_run(from, find_algorithm(kLegAlgorithm));
    static_cast<SearchOptions&>(command.run) = asked;
  }
  choose_ants(command);
  if (tsplib) return tsplib_problem(std::move(command));
#ifdef LASIUS_WITH_POLYGON
  if (polygons) read_recorded_world(from, command);
#endif
  for (const auto& [key, end] : {std::pair("start", &command.start), {"goal", &command.goal}})
    if (!value_at(result, key).is_null() && !of_vehicle(result))
      *end = PoseEnd{recorded_end(result, key)};
  if (result.contains("cover")) {
    read_recorded_cover(result, command);
    return cover_problem(std::move(command));
  }
  const Json& list = value_at(result, "stops");
  if (!list.is_array() || list.empty()) throw UsageError("\"stops\" is no list of stops");
  command.stops.points = recorded_ends(result, "stops");
  const auto given = [&](const char* key, auto& value) {
    if (result.contains(key))
      value = recorded<std::remove_reference_t<decltype(value)>>(result, key);
  };
  given("names", command.stops.names);
  given("after", command.stops.after);
  given("loads", command.stops.loads);
  given("groups", command.stops.groups);
  if (result["parameters"].contains("capacity"))
    command.capacity = static_cast<int>(
        recorded_integer(result, "parameters/capacity", 0, TourCommand::kMostLoad));
  if (result["parameters"].contains("most_stops"))
    command.most_stops = static_cast<int>(
        recorded_integer(result, "parameters/most_stops", 1, TourCommand::kMostLoad));
  if (result.contains("starts")) command.robots = recorded_ends(result, "starts");
  return of_vehicle(result) ? vehicle_tour(std::move(command), &result)
                            : tour_problem(std::move(command));
}

}  // namespace

const ProblemKind& tour_kind() {
  static const ProblemKind kKind{
      .key = "tour_algorithms",
      .title = "Stops, by `lasius tour MAP`, `WORLD.geojson` or `PROBLEM.tsp`",
      .plans = "over stops",
      .advice = "; ask it with lasius tour",
      .commands = {"tour"},
      .algorithms = tour::algorithms(),
      .default_text = default_text<tour::AntParams>,
      .formulas = formulas_of<tour::AntParams>,
      .format = kTourFormat,
      .again = tour_again};
  return kKind;
}

bool is_tsplib(std::string_view file) { return file.ends_with(".tsp") || file.ends_with(".sop"); }

TourRequest request_of(const TourCommand& command, const StopCondition& stop) {
  TourRequest request;
  request.open = command.open || command.goal;
  request.seed = command.run.seed;
  request.ants = command.ants;
  request.generations = command.generations;
  request.capacity = command.capacity;
  request.most_stops = command.most_stops.value_or(0);
  request.target_gap = command.run.target_gap;
  request.threads = command.run.threads;
  request.stop = again(stop, command.run.time_limit);
  return request;
}

void choose_ants(TourCommand& command) {
  RunOptions& run = command.run;
  command.ants = make_params<tour::AntParams>(run, tour_kind());
  SearchOptions legs;
  legs.algorithm = kLegAlgorithm;
  legs.seed = run.seed;
  legs.threads = run.threads;
  run.params = make_params<Params>(legs, bitmaps());
}

void add_course(Json& json, const Record& record) {
  if (record.algorithm.kind == Algorithm::Kind::colony)
    json::add_convergence(json, record.result.curves);
}

TourObserver told_to(const Problem::Watch& watch, double scale, const std::string& unit) {
  if (!watch) return {};
  return [=, told = std::int64_t{0}](std::span<const int>, double length) mutable {
    watch(++told, best_text(scale * length, unit));
  };
}

SearchResult search_result(const TourResult& tour) {
  SearchResult result;
  result.curves = tour.curves;
  result.status = tour.status;
  if (tour.status == Status::limit) result.limit = Limit::time;
  result.error = tour.error;
  if (tour.order.empty()) return result;
  result.length = tour.length;
  result.lower_bound = tour.lower_bound;
  result.optimal = tour.optimal;
  return result;
}

void add_parameters(Json& json, const TourCommand& command) {
  json["open"] = command.open;
  json["generations"] = command.generations;
  if (command.capacity) json["capacity"] = *command.capacity;
  if (command.most_stops) json["most_stops"] = *command.most_stops;
}

Json order_json(const TourResult& tour) {
  return {{"order", tour.order.empty() ? Json() : Json(tour.order)}};
}

int run_command(const TourCommand& command) {
  if (is_tsplib(command.run.map.file)) return run(*tsplib_problem(command));
  return run(command.cover ? *cover_problem(command) : *tour_problem(command));
}

}  // namespace lasius::tool
