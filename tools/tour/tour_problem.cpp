#include <algorithm>
#include <cmath>
#include <utility>

#include "tools/bitmap/answer.h"
#include "tools/bitmap/bitmap_problem.h"
#include "tools/bitmap/map_ends.h"
#include "tools/console/elapsed.h"
#include "tools/console/parameters.h"
#include "tools/console/values.h"
#include "tools/options/commands.h"
#include "tools/record/problem.h"
#include "tools/record/recorded.h"
#include "tools/tour/cover_problem.h"
#include "tools/tour/stops_file.h"
#include "tools/tour/tour_answer.h"
#include "tools/tour/tour_kind.h"
#include "tools/tour/tour_legs.h"
#include "tools/tour/tour_picture.h"
#include "tools/tour/tsplib_problem.h"

namespace lasius::tool {
namespace {

/// `lasius tour` on a map.
class TourProblem : public Problem {
 public:
  explicit TourProblem(TourCommand command) : command_(std::move(command)) {}

  std::optional<std::int64_t> read(const std::stop_token& token) override {
    RunOptions& run = command_.run;
    answer_.map = load_map(run.map, run.frame, run.params.corners, run.threads, token);
    run.inputs.push_back(answer_.map.image);
    if (const auto& costs = answer_.map.costs)
      run.inputs.insert(run.inputs.end(), costs->images.begin(), costs->images.end());
    check_radius(answer_.map, run);
    if (!command_.stops_file.empty()) command_.stops = read_stops(command_.stops_file, run.frame);
    if (command_.capacity && command_.stops.loads.empty())
      throw UsageError("--capacity " + std::to_string(*command_.capacity) +
                       ": no stop has a load; give the stops a \"load\", or leave it out");
    for (const End& stop : command_.stops.points)
      answer_.stops.push_back(lasius::tool::end_place(answer_.map, stop, run.frame));
    answer_.start = index_of(command_.start);
    answer_.goal = index_of(command_.goal);
    note_map(answer_.map, run);
    return std::nullopt;
  }
  void plan(const StopCondition& stop, const Watch& watch) override {
    const RunOptions& run = command_.run;
    TourResult& tour = answer_.tour;
    tour.status = Status::interrupted;
    if (!answer_.map.planner) return;
    const Planner& planner = *answer_.map.planner;
    TourRequest request = request_of(command_, stop);
    for (const Place& place : answer_.stops) request.points.push_back(place.at());
    request.start = answer_.start;
    request.goal = answer_.goal;
    request.after = command_.stops.after;
    request.load = command_.stops.loads;
    if (!request.after.empty()) request.after.resize(request.points.size());
    if (!request.load.empty()) request.load.resize(request.points.size());
    if (request.goal && request.goal == request.start) {  // there and back
      request.open = false;
      request.goal.reset();
    }
    const CostPlanner* const over = answer_.map.costs ? &*answer_.map.costs->planner : nullptr;
    const double scale = over != nullptr ? 1 : answer_.map.length_in(run.frame, 1);
    TourObserver observer;
    if (watch)
      observer = [&, told = std::int64_t{0}](std::span<const int>, double length) mutable {
        watch(++told, best_text(scale * length, over != nullptr ? "" : unit()));
        return true;
      };
    in_metres_asked(answer_.map, run, [&] {
      const auto begin = Clock::now();
      tour = over != nullptr ? plan_tour(*over, request, observer)
                             : plan_tour(planner, request, observer);
      answer_.elapsed_ms = ms_since(begin);
    });
    for (LeftOut& out : tour.left_out) {
      const std::string said = std::exchange(out.why, why_left_out(out.stop));
      if (tour.error == said) tour.error = out.why;
    }
    for (const auto& [end, key] : {std::pair(answer_.start, true), {answer_.goal, false}})
      if (end && tour.status == Status::invalid && answer_.ends.fault == Fault::none)
        look_at_end(place_at(*end), key);
  }
  Record record() const override {
    const TourResult& tour = answer_.tour;
    const MapEnds ends(answer_.map, command_.run, end_place(answer_.start), end_place(answer_.goal),
                       answer_.ends);
    Record record =
        map_record(ends, search_result(tour), tour::find_algorithm(command_.ants.algorithm()));
    record.format = kTourFormat;
    if (answer_.ends.fault == Fault::none) record.error = tour.error;
    record.inputs = {{"map", map_json(answer_.map)}};
    if (!answer_.start) record.start = Json();
    if (!answer_.goal) record.goal = Json();
    add_parameters(record.parameters, command_);
    record.elapsed_ms = answer_.elapsed_ms;
    record.path = coordinates(tour_path(answer_, in_metres()));
    if (!command_.run.json)
      for (const LeftOut& out : tour.left_out)
        if (out.stop != answer_.start && out.stop != answer_.goal)  // of which the error tells
          record.remarks.push_back(out.why + ": left out");
    if (!command_.run.json && record.has_path()) record.remarks.push_back(summary(record));
    Json findings = Json::object();
    if (answer_.map.costs) {
      record.cost = tour.cost.value_or(std::nan(""));
      record.gap = tour.gap();
      record_costs(*answer_.map.costs, findings, record.parameters);
    }
    if (wants_json(command_.run)) record.answer = answer_of(ends, record, findings);
    return record;
  }
  Forms show(const Record&) const override {
    return {.picture = [&](auto& file) { write_tour_picture(file, command_.run, answer_); }};
  }
  SearchOptions& options() override { return command_.run; }

 private:
  bool in_metres() const { return command_.run.frame == Frame::world; }
  std::string unit() const { return in_metres() ? "m" : ""; }
  const Place& place_at(int stop) const { return answer_.stops[static_cast<std::size_t>(stop)]; }
  const Place& end_place(const std::optional<int>& end) const {
    return end ? place_at(*end) : answer_.stops.front();
  }
  /// Of the stop at the same place, which is added where there is none.
  std::optional<int> index_of(const std::optional<End>& end) {
    if (!end) return std::nullopt;
    const Place place = lasius::tool::end_place(answer_.map, *end, command_.run.frame);
    const auto same = [&](const Place& stop) { return stop.at() == place.at(); };
    const auto found = std::ranges::find_if(answer_.stops, same);
    const auto index = static_cast<int>(found - answer_.stops.begin());
    if (found == answer_.stops.end()) answer_.stops.push_back(place);
    return index;
  }
  std::string why_left_out(int stop) const {
    const Frame frame = command_.run.frame;
    const Place& place = place_at(stop);
    const std::string text = "stop " + std::to_string(stop) + " at " + place_text(place, frame);
    if (answer_.map.planner->clear_at(place.at()))
      return text + " cannot be reached from the others";
    const bool curved = route_of(answer_.map, command_.run).curved;
    return text + obstruction_text(answer_.map, frame, obstruction_of(answer_.map, place, curved));
  }
  /// Asks for what `plan` says of an invalid end; nothing where it is none.
  void look_at_end(const Place& end, bool start) {
    const Planner& planner = *answer_.map.planner;
    if (planner.clear_at(end.at())) return;
    Place other = end;
    for (const Place& stop : answer_.stops)
      if (!start && planner.clear_at(stop.at())) other = stop;
    const Request ends = lasius::tool::request_of(answer_.map, command_.run, other, end);
    Result said = planner.plan(ends, command_.run.params);
    if (said.status == Status::invalid) answer_.ends = std::move(said);
  }
  std::string summary(const Record& record) const {
    const TourResult& tour = answer_.tour;
    std::string text = counted(static_cast<std::int64_t>(tour.order.size()), "stop") + ", " +
                       counted(tour.priced, "leg") + " priced";
    if (tour.cost) text += "; cost " + decimal_text(*tour.cost, 3);
    if (tour.optimal) return text + (tour.cost ? "; proven cheapest" : "; proven shortest");
    if (!tour.lower_bound) return text;
    const double scale = tour.cost ? 1 : record.scale;
    text += "; no order is below " + decimal_text(scale * *tour.lower_bound, 3);
    if (in_metres() && !tour.cost) text += " m";
    const auto gap = tour.gap();
    return gap ? text + printed(", a gap of %.3f%%", 100 * *gap) : text;
  }
  Json answer_of(const MapEnds& ends, const Record& record, const Json& findings) const {
    const TourResult& tour = answer_.tour;
    const bool found = record.has_path();
    Json json = Json::object(), world;
    for (const Place& stop : answer_.stops) {
      json["stops"].push_back(cell_json(stop, in_metres()));
      world.push_back(point(stop.asked));
    }
    if (in_metres()) {
      json["stops_world"] = std::move(world);
      json["start_world"] = answer_.start ? point(ends.start.asked) : Json();
      json["goal_world"] = answer_.goal ? point(ends.goal.asked) : Json();
    }
    const TourStops& given = command_.stops;
    if (!given.names.empty()) json["names"] = given.names;
    if (!given.after.empty()) json["after"] = given.after;
    if (!given.loads.empty()) json["loads"] = given.loads;
    json.update(order_json(tour));
    json["legs"] = found ? legs_json(answer_, in_metres()) : Json();
    json["length"] = number(record.result.length);
    if (in_metres()) json["length_m"] = number(record.scale * record.result.length);
    if (answer_.map.costs) json["cost"] = optional_number(tour.cost);
    add_proof(json, record.result);
    if (answer_.map.costs) json["gap"] = optional_number(tour.gap());
    json["left_out"] = Json::array();
    for (const LeftOut& out : tour.left_out)
      json["left_out"].push_back({{"stop", out.stop}, {"why", out.why}});
    json["priced"] = tour.priced;
    add_course(json, record);
    json.update(findings);
    if (answer_.ends.fault != Fault::none) json.update(end_findings(ends));
    return json;
  }

  TourCommand command_;
  TourAnswer answer_{};
};

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
  if (tsplib) {
    command.run = asked;
    command.run.map.file = from.map_file();
  } else {
    command.run = recorded_run(from, find_algorithm(kLegAlgorithm));
    static_cast<SearchOptions&>(command.run) = asked;
  }
  choose_ants(command);
  if (tsplib) return tsplib_problem(std::move(command));
  if (!value_at(result, "start").is_null()) command.start = recorded_end(result, "start");
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
  if (result.contains("parameters") && result["parameters"].contains("capacity"))
    command.capacity = static_cast<int>(
        recorded_integer(result, "parameters/capacity", 0, TourCommand::kMostLoad));
  if (!value_at(result, "goal").is_null()) command.goal = recorded_end(result, "goal");
  return std::make_unique<TourProblem>(std::move(command));
}

}  // namespace

const ProblemKind& tour_kind() {
  static const ProblemKind kKind{
      .key = "tour_algorithms",
      .title = "Stops, by `lasius tour MAP` and `lasius tour PROBLEM.tsp`",
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
  if (record.algorithm.kind == Algorithm::Kind::colony) json::add_convergence(json, record.result);
}

SearchResult search_result(const TourResult& tour) {
  SearchResult result;
  static_cast<lasius::Convergence&>(result) = tour.run;
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
}

Json order_json(const TourResult& tour) {
  return {{"order", tour.order.empty() ? Json() : Json(tour.order)}};
}

int run_command(const TourCommand& command) {
  if (is_tsplib(command.run.map.file)) return run(*tsplib_problem(command));
  if (command.cover) return run(*cover_problem(command));
  TourProblem problem(command);
  return run(problem);
}

}  // namespace lasius::tool
