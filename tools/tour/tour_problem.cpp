#include "tools/tour/tour_problem.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "tools/bitmap/answer.h"
#include "tools/bitmap/bitmap_problem.h"
#include "tools/console/elapsed.h"
#include "tools/console/parameters.h"
#include "tools/console/values.h"
#include "tools/options/commands.h"
#include "tools/record/problem.h"
#include "tools/record/queries.h"
#include "tools/record/recorded.h"
#include "tools/tour/stops_file.h"
#include "tools/tour/tour_files.h"
#include "tools/tour/tour_kind.h"
#include "tools/tour/tour_picture.h"

namespace lasius::tool {

std::optional<std::int64_t> TourProblem::read(const std::stop_token& token) {
  read_world(token);
  for (const std::string& note : command_.stops.notes) command_.run.notes.push_back(note);
  if (command_.capacity && command_.stops.loads.empty())
    throw UsageError("--capacity " + std::to_string(*command_.capacity) +
                     ": no stop has a load; give the stops a \"load\", or leave it out");
  for (const End& stop : command_.stops.points) answer_.stops.push_back(to_place(stop));
  answer_.names = command_.stops.names;
  answer_.start = index_of(command_.start);
  answer_.goal = index_of(command_.goal);
  for (const End& robot : command_.robots) answer_.robots.push_back(*index_of(PoseEnd{robot}));
  check_ends_of_groups();
  return std::nullopt;
}

void TourProblem::read_world(const std::stop_token& token) {
  RunOptions& run = command_.run;
  answer_.map = load_map(run.map, run.frame, run.params.corners, run.threads, token);
  note_files(answer_.map, run);
  check_radius(answer_.map, run);
  if (!command_.stops_file.empty()) command_.stops = read_stops(command_.stops_file, run.frame);
  note_map(answer_.map, run, token);
}

Place TourProblem::to_place(const End& end) const {
  return lasius::tool::end_place(answer_.map, end, command_.run.frame);
}

void TourProblem::plan(const StopCondition& stop, const Watch& watch) {
  TourResult& tour = answer_.tour;
  tour.status = Status::interrupted;
  TourRequest request = request_of(command_, stop);
  for (const Place& place : answer_.stops) request.points.push_back(place.at());
  request.start = answer_.start;
  request.goal = answer_.goal;
  request.after = command_.stops.after;
  request.load = command_.stops.loads;
  if (!request.after.empty()) request.after.resize(request.points.size());
  if (!request.load.empty()) request.load.resize(request.points.size());
  request.group = groups();
  request.robots = answer_.robots;
  if (request.goal && request.goal == request.start) {  // there and back
    request.open = false;
    request.goal.reset();
  }
  const auto begin = Clock::now();
  tour = tour_of(request, watch);
  answer_.elapsed_ms = ms_since(begin);
  for (LeftOut& out : tour.left_out) {
    const std::string said = std::exchange(out.why, why_left_out(out));
    if (tour.error == said) tour.error = out.why;
  }
  if (tour.status == Status::invalid) look_at_ends();
}

TourResult TourProblem::tour_of(const TourRequest& request, const Watch& watch) {
  TourResult tour;
  tour.status = Status::interrupted;
  if (!answer_.map.planner) return tour;
  const RunOptions& run = command_.run;
  const CostPlanner* const over = answer_.map.costs ? &*answer_.map.costs->planner : nullptr;
  const double scale = over != nullptr ? 1 : answer_.map.length_in(run.frame, 1);
  const TourObserver observer = told_to(watch, scale, over != nullptr ? "" : unit());
  in_metres_asked(answer_.map, run, [&] {
    tour = over != nullptr ? plan_tour(*over, request, observer)
                           : plan_tour(*answer_.map.planner, request, observer);
  });
  return tour;
}

void TourProblem::look_at_ends() {
  std::vector<std::pair<std::optional<int>, bool>> ends{{answer_.start, true},
                                                        {answer_.goal, false}};
  for (const int robot : answer_.robots) ends.emplace_back(robot, true);
  for (const auto& [end, key] : ends)
    if (end && answer_.ends.fault == Fault::none) look_at_end(*end, key);
}

Record TourProblem::head(Json& findings) const {
  const TourResult& tour = answer_.tour;
  const MapEnds ends(answer_.map, command_.run, end_place(bad_start_ ? bad_start_ : answer_.start),
                     end_place(answer_.goal), answer_.ends);
  Record record =
      map_record(ends, search_result(tour), tour::find_algorithm(command_.ants.algorithm()));
  record.inputs = {{"map", map_json(answer_.map)}};
  if (answer_.map.costs) {
    record.cost = tour.cost.value_or(std::nan(""));
    record.gap = tour.gap();
    record_costs(*answer_.map.costs, findings, record.parameters);
  }
  if (answer_.ends.fault != Fault::none) findings.update(end_findings(ends));
  return record;
}

Record TourProblem::record() const {
  const TourResult& tour = answer_.tour;
  Json findings = Json::object();
  Record record = head(findings);
  record.format = kTourFormat;
  if (answer_.ends.fault == Fault::none) record.error = tour.error;
  if (!answer_.start) record.start = Json();
  if (!answer_.goal) record.goal = Json();
  add_parameters(record.parameters, command_);
  record.elapsed_ms = answer_.elapsed_ms;
  for (const std::vector<Point>& path : tour_paths(answer_, in_metres())) {
    if (!record.path.empty()) record.parts.push_back(record.path.size() / record.axes);
    const std::vector<double> told = coordinates(path);
    record.path.insert(record.path.end(), told.begin(), told.end());
  }
  if (!command_.run.json)
    for (const LeftOut& out : tour.left_out)
      if (!is_end(out.stop))  // of which the error tells
        record.remarks.push_back(out.why + ": left out");
  if (!command_.run.json && record.has_path()) {
    record.remarks.push_back(summary(record));
    if (!command_.cover) std::ranges::move(orders(), std::back_inserter(record.remarks));
  }
  if (wants_json(command_.run)) record.answer = answer_of(record, findings);
  return record;
}

Forms TourProblem::show(const Record& run) const {
  Forms::Write table;  // empty: as of all kinds
  if (!answer_.robots.empty())
    table = [&](std::ostream& out) { write_robot_table(out, answer_, in_metres()); };
  return {
      .csv = table,
      .picture =
          [&](auto& file) { write_tour_picture(file, run.algorithm.name, command_.run, answer_); },
      .yaml = [&](std::ostream& out) { write_tour_poses(out, answer_, command_.run); },
      .page = [&](std::ostream& out) { write_tour_page(out, run, answer_, command_.run); }};
}

bool TourProblem::is_end(int stop) const {
  return stop == answer_.start || stop == answer_.goal ||
         std::ranges::count(answer_.robots, stop) > 0;
}

// Of a stop at the same place, at which no robot begins yet; it is added where there is none.
std::optional<int> TourProblem::index_of(const std::optional<PoseEnd>& end) {
  if (!end) return std::nullopt;
  const Place place = to_place(*end);
  const int count = static_cast<int>(answer_.stops.size());
  std::vector<std::optional<double>>& yaws = command_.stops.yaws;
  if (command_.vehicle) yaws.resize(answer_.stops.size());
  const auto looks_elsewhere = [&](int stop) {
    const auto i = static_cast<std::size_t>(stop);
    return command_.vehicle && yaws[i] && *yaws[i] != end->yaw;
  };
  int index = 0;
  while (index < count && (looks_elsewhere(index) || place_at(index).at() != place.at() ||
                           std::ranges::count(answer_.robots, index) > 0))
    ++index;
  if (index == count) answer_.stops.push_back(place);
  if (command_.vehicle) {
    yaws.resize(answer_.stops.size());
    yaws[static_cast<std::size_t>(index)] = end->yaw;
  }
  return index;
}

// To each stop its group's number, or -1; nothing without groups.
std::vector<int> TourProblem::groups() const {
  std::vector<int> numbers;
  if (command_.stops.groups.empty()) return numbers;
  std::map<std::string_view, int> known;
  for (const std::string& name : command_.stops.groups) {
    const int next = static_cast<int>(known.size());
    numbers.push_back(name.empty() ? -1 : known.try_emplace(name, next).first->second);
  }
  numbers.resize(answer_.stops.size(), -1);
  return numbers;
}

// The library knows groups by their numbers only.
void TourProblem::check_ends_of_groups() const {
  std::map<std::string_view, int> known;
  std::vector<int> ends = answer_.robots;
  for (const auto& end : {answer_.start, answer_.goal})
    if (end) ends.push_back(*end);
  for (const int end : ends) {
    if (end >= static_cast<int>(command_.stops.groups.size())) continue;
    const std::string& group = command_.stops.groups[static_cast<std::size_t>(end)];
    const auto [at, is_new] = known.try_emplace(group, end);
    if (!group.empty() && !is_new && at->second != end)
      throw UsageError("stops " + std::to_string(at->second) + " and " + std::to_string(end) +
                       " are both ends of the tour and of group " + group +
                       ", of which one stop is visited; give them groups of their own");
  }
}

std::string TourProblem::why_left_out(const LeftOut& out) const {
  std::string name = "stop " + std::to_string(out.stop) + " at ";
  if (is_end(out.stop)) name = out.stop == answer_.goal ? "goal " : "start ";
  if (out.group >= 0) name = "no stop of group " + group_name(out) + " can be visited: " + name;
  return why_not(place_at(out.stop), name);
}

std::string TourProblem::why_not(const Place& place, const std::string& name) const {
  const Frame frame = command_.run.frame;
  const std::string text = name + place_text(place, frame);
  if (answer_.map.planner->clear_at(place.at())) return text + " cannot be reached from the others";
  const bool curved = route_of(answer_.map, command_.run).curved;
  return text + obstruction_text(answer_.map, frame, obstruction_of(answer_.map, place, curved)) +
         metres_hint(answer_.map, frame, place);
}

// Asks for what `plan` says of an invalid end; nothing where it is none.
void TourProblem::look_at_end(int stop, bool start) {
  const Planner& planner = *answer_.map.planner;
  const Place& end = place_at(stop);
  if (planner.clear_at(end.at())) return;
  const Request ends = lasius::tool::request_of(answer_.map, command_.run, end, end);
  Result said = planner.plan(ends, command_.run.params);
  if (said.status != Status::invalid) return;
  if (start) bad_start_ = stop;
  answer_.ends = of_tour(std::move(said), start);
}

std::string TourProblem::summary(const Record& record) const {
  const TourResult& tour = answer_.tour;
  std::string text = counted(static_cast<std::int64_t>(tour.order.size()), "stop") + ", " +
                     robots_text(tour) + counted(tour.priced, "leg") + " priced";
  if (tour.cost) text += "; cost " + decimal_text(*tour.cost, 3);
  if (tour.optimal)
    return text + (tour.cost ? "; proven cheapest" : "; proven shortest") +
           (tour.left_out.empty() ? "" : " without what is left out");
  if (!tour.lower_bound) return text;
  const double scale = tour.cost ? 1 : record.scale;
  text += "; no order is below " + decimal_text(scale * *tour.lower_bound, 3);
  if (in_metres() && !tour.cost) text += " m";
  const auto gap = tour.gap();
  return gap ? text + printed(", a gap of %.3f%%", 100 * *gap) : text;
}

// By its name, its number in the file, or what it is where it stands in none.
std::string TourProblem::stop_text(int stop) const {
  const auto i = static_cast<std::size_t>(stop);
  if (i >= command_.stops.points.size()) return answer_.goal == stop ? "goal" : "start";
  if (i >= answer_.names.size() || answer_.names[i].empty()) return std::to_string(stop);
  const std::string& name = answer_.names[i];
  const bool bare = name.find_first_of(",\"") == name.npos && !parse_real(name) &&
                    name != "start" && name != "goal";
  return bare ? name : "\"" + name + "\"";
}

std::vector<std::string> TourProblem::orders() const {
  constexpr std::size_t kMost = 30;  // that a line shows
  const TourResult& tour = answer_.tour;
  if (tour.order.size() > kMost) return {};
  const auto text = [&](std::string words, const std::vector<int>& order) {
    for (const int& stop : order) {
      words.append(&stop == order.data() ? " " : ", ").append(stop_text(stop));
    }
    return words;
  };
  if (tour.tours.empty()) return {text("in the order", tour.order)};
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < tour.tours.size(); ++i)
    texts.push_back(text("robot " + std::to_string(i) + ":", tour.tours[i].order));
  return texts;
}

Json TourProblem::answer_of(const Record& record, const Json& findings) const {
  const TourResult& tour = answer_.tour;
  const bool found = record.has_path();
  Json json = {{"stops", Json::array()}}, world = Json::array();
  for (const Place& stop : answer_.stops) {
    json["stops"].push_back(cell_json(stop, in_metres()));
    world.push_back(point(stop.asked));
  }
  if (in_metres()) {
    json["stops_world"] = std::move(world);
    json["start_world"] = answer_.start ? point(place_at(*answer_.start).asked) : Json();
    json["goal_world"] = answer_.goal ? point(place_at(*answer_.goal).asked) : Json();
  }
  for (const int robot : answer_.robots) {
    json["starts"].push_back(cell_json(place_at(robot), in_metres()));
    if (in_metres()) json["starts_world"].push_back(point(place_at(robot).asked));
  }
  const TourStops& given = command_.stops;
  if (!given.names.empty()) json["names"] = given.names;
  if (!given.after.empty()) json["after"] = given.after;
  if (!given.loads.empty()) json["loads"] = given.loads;
  if (!given.groups.empty()) json["groups"] = given.groups;
  json.update(order_json(tour));
  json["legs"] = found ? legs_json(answer_, in_metres()) : Json();
  if (!answer_.robots.empty()) json["tours"] = found ? tours_json(answer_, in_metres()) : Json();
  json["length"] = number(record.result.length);
  if (in_metres()) json["length_m"] = number(record.scale * record.result.length);
  if (answer_.map.costs) json["cost"] = optional_number(tour.cost);
  add_proof(json, record.result);
  if (answer_.map.costs) json["gap"] = optional_number(tour.gap());
  json["left_out"] = Json::array();
  for (const LeftOut& out : tour.left_out) {
    json["left_out"].push_back({{"stop", out.stop}, {"why", out.why}});
    if (out.group >= 0) json["left_out"].back()["group"] = group_name(out);
  }
  json["priced"] = tour.priced;
  add_course(json, record);
  add_answer(json);
  json.update(findings);
  return json;
}

std::unique_ptr<Problem> tour_problem(TourCommand command) {
  if (command.vehicle) return vehicle_tour(std::move(command));
  if (!is_polygon_file(command.run.map.file))
    return std::make_unique<TourProblem>(std::move(command));
#ifdef LASIUS_WITH_POLYGON
  return polygon_tour(std::move(command));
#else
  throw UsageError("this lasius was built without polygon worlds, " + command.run.map.file);
#endif
}

}  // namespace lasius::tool
