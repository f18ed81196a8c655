#include "tools/bitmap/bitmap_problem.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "lasius/io/json.h"
#include "tools/bitmap/bitmap_report.h"
#include "tools/bitmap/cost_ground.h"
#include "tools/bitmap/map_ends.h"
#include "tools/bitmap/picture.h"
#include "tools/bitmap/poses_file.h"
#include "tools/console/parameters.h"
#include "tools/console/values.h"
#include "tools/record/recorded.h"

namespace lasius::tool {
namespace {

/// False where the answer is known before any search, and a visibility graph a waste.
bool is_search(const LoadedMap& map, const RunOptions& run, Cell start, Cell goal,
               const std::stop_token& token) {
  const Route route = route_of(map, run);
  if (map.planner && !run.via.empty()) return true;
  if (!map.planner || start == goal || !map.planner->label(route.corners, {.token = token}))
    return false;
  const bool led_out = map.grown() && map.as_read().free(start) && !map.planner->clear(start);
  return run.goal_tolerance > 0 || led_out || route.joined(*map.planner, start, goal);
}

/// What --gap found.
std::string optima_text(const Record& record, const Answer& answer, const Params& params) {
  const char* unit = record.unit.empty() ? "" : " m";
  const auto length = [&](double cells) { return decimal_text(record.scale * cells, 6) + unit; };
  const auto& [any_angle, by_moves] = std::pair(answer.optimum, answer.grid_optimum);
  std::string text = any_angle ? "optimum " + length(*any_angle) : "optimum unknown";
  if (any_angle && record.has_path() && *any_angle > 0)
    text += printed(" (the path: %+.3f%%)", 100 * *gap_to(any_angle, record.result.length));
  if (!by_moves) return text;
  text += "; of walks by its own moves " + length(*by_moves);
  const auto gap = grid_gap(answer, params);
  return gap ? text + printed(" (its shortest walk: %+.3f%%)", 100 * *gap) : text;
}

/// Points, and between the two where one begins and ends, arcs; `at(point)`: in metres where a
/// map's frame is given, y up.
template <class At>
Json curve_json(const Result& result, const LoadedMap* frame, const At& at) {
  Json json = Json::array({point(at(result.path.front()))});
  if (result.curve.empty())  // straight pieces alone, as paths over costs have them
    for (std::size_t i = 1; i < result.path.size(); ++i) json.push_back(point(at(result.path[i])));
  for (const CurvePiece& piece : result.curve) {
    if (piece.turn != 0)
      json.push_back(
          {{"centre", point(at(piece.centre))},
           {"radius", number(frame != nullptr ? frame->metres(piece.radius) : piece.radius)},
           {"turn", frame != nullptr ? -piece.turn : piece.turn}});
    json.push_back(point(at(piece.to)));
  }
  return json;
}

/// In metres.
std::vector<Point> world_path(const LoadedMap& map, const RunOptions& run, const Answer& answer,
                              const std::vector<Point>& cells) {
  std::vector<Point> path;
  for (const Point p : cells) path.push_back(in_metres(map, run, answer, p));
  return path;
}

Json alternatives_json(const MapEnds& ends, const Answer& answer) {
  Json json = Json::array();
  for (const Alternative& other : answer.result.alternatives) {
    Json one = {{"length", number(other.length)}, {"path", points(other.path)}};
    if (ends.in_metres()) {
      one["length_m"] = number(ends.map.metres(other.length));
      one["path_world"] = points(world_path(ends.map, ends.run, answer, other.path));
    }
    json.push_back(one);
  }
  return json;
}

Json path_json(const MapEnds& ends, const Answer& answer, bool has_path) {
  const Result& result = answer.result;
  Json json = json::roomy_object();
  if (ends.map.costs) {
    const auto& costs = answer.over_costs;
    json["cost"] = costs && has_path ? number(costs->cost) : Json(nullptr);
  }
  add_goal_reached(json, ends);
  if (const auto& out = ends.way_out; ends.map.radius > 0) {
    json["way_out"] = out ? point(*out) : Json();
    if (ends.in_metres()) json["way_out_world"] = out ? point(ends.map.to_world(*out)) : Json();
  }
  if (!ends.run.via.empty()) {
    Json via = Json::array(), given = Json::array();
    for (const End& end : ends.run.via) {
      const Place place = end_place(ends.map, end, ends.run.frame);
      via.push_back(cell_json(place, ends.in_metres()));
      given.push_back(point(place.asked));
    }
    json["via"] = via;
    if (ends.in_metres()) json["via_world"] = given;
  }
  json["path"] = points(result.path);
  if (ends.run.alternatives > 0) json["alternatives"] = alternatives_json(ends, answer);
  const auto metres = [&](Point p) { return in_metres(ends.map, ends.run, answer, p); };
  const auto add_curve = [&](const char* key, const LoadedMap* frame, const auto& at) {
    if (ends.curved()) json[key] = has_path ? curve_json(result, frame, at) : Json(nullptr);
  };
  add_curve("curve", nullptr, [](Point p) { return p; });
  if (ends.in_metres()) add_curve("curve_world", &ends.map, metres);
  const auto add_poses = [&](const char* key, bool in_world) {
    if (ends.run.spacing) json[key] = poses_json(poses_of(ends.map, ends.run, answer, in_world));
  };
  add_poses("poses", false);
  if (!ends.in_metres()) return json;
  add_poses("poses_world", true);
  json["start_world"] = point(answer.start.asked);
  json["goal_world"] = point(answer.goal.asked);
  json["length_m"] = number(ends.map.metres(result.length));
  json["path_world"] = points(world_path(ends.map, ends.run, answer, result.path));
  return json;
}

/// What plans over costs tell beside.
void add_costs(Record& record, Json& findings, const LoadedCosts& costs, const Answer& answer) {
  record.gap = answer.over_costs ? answer.over_costs->gap() : std::nullopt;
  record.cost = answer.over_costs ? answer.over_costs->cost : std::nan("");
  record_costs(costs, findings, record.parameters);
}

/// Where the weights of a proof come from.
Json weights_json(const Record& run) {
  return {{"layers", run.answer["layers"]},
          {"inflation", run.parameters.value("inflation", Json(nullptr))}};
}

std::unique_ptr<Problem> bitmap_again(const Recorded& from, const Problem* last) {
  PlanCommand command = recorded_plan(from);
  const RunOptions& run = command.run;
  const auto* before = dynamic_cast<const BitmapProblem*>(last);
  std::shared_ptr<LoadedMap> map = before != nullptr ? before->map() : nullptr;
  const bool same = map && map->file == run.map.file && map->radius == run.map.radius &&
                    map->unknown_is_free == run.map.unknown_is_free &&
                    (map->costs ? map->costs->asked : CostLayers()) == run.map.costs &&
                    map->prepare == run.map.prepare && map->labels == run.map.labels;
  if (!same)
    map =
        std::make_shared<LoadedMap>(load_map(run.map, run.frame, run.params.corners, run.threads));
  if (map->costs) check_layers(*map->costs, from.result);
  return std::make_unique<BitmapProblem>(std::move(command), std::move(map));
}

std::string unlike(const Json& result) {
  const Json set = result.value("parameters", Json::object());
  if (set.value("exchange", "") == to_string(Exchange::asynchronous) && set.value("islands", 1) > 1)
    return "its islands learned by tours as they arrived, which another run may not repeat; what "
           "is planned with --exchange scheduled can be";
  return unlike_radius(result);
}

}  // namespace

const ProblemKind& bitmap_kind() {
  static const ProblemKind kKind{
      .key = "algorithms",
      .plans = "on bitmaps",
      .commands = {"plan", "drive", "batch", "study"},
      .takes = [](std::string_view file) { return !is_polygon_file(file); },
      .algorithms = algorithms(),
      .default_text = default_text<Params>,
      .formulas = formulas_of<Params>,
      .format = kPlanFormat,
      .wrote =
          [](const Json& json) {
            return !is_polygon_file(recorded<std::string>(json, "map/file")) && !of_vehicle(json);
          },
      .again = bitmap_again,
      .unlike = unlike};
  return kKind;
}

std::string unlike_radius(const Json& result) {
  const std::string version = recorded<std::string>(result, "version");
  const Json radius = result.value(Json::json_pointer("/parameters/radius"), Json());
  if (!version.starts_with("0.3.") || !radius.is_number() || radius == 0) return {};
  return "version " + version +
         " kept a radius by half a cell's diagonal less; plan it anew, the radius asked is now the "
         "radius kept";
}

void note_files(const LoadedMap& map, SearchOptions& options) {
  options.inputs.push_back(map.image);
  if (map.costs)
    options.inputs.insert(options.inputs.end(), map.costs->images.begin(), map.costs->images.end());
}

void note_map(const LoadedMap& map, RunOptions& run, const std::stop_token& token) {
  if (token.stop_requested() && !map.prepared.empty() && !std::filesystem::exists(map.prepared))
    run.notes.push_back(map.prepared + " is not written: its preparation was interrupted");
  const Preparation prepared = map.planner ? map.planner->preparation() : Preparation{};
  const std::string option = map.prepared.empty() ? "--prepare" : "--prepared";
  if (prepared.state == Preparation::State::too_large)
    run.notes.push_back(option + " has no effect: it would take more than " +
                        std::to_string(PrepareOptions{}.max_bytes >> 20) + " MB for this map");
  if (map.costs)
    run.notes.insert(run.notes.end(), map.costs->notes.begin(), map.costs->notes.end());
  if (prepared.labels.state == Preparation::State::too_large)
    run.notes.push_back(option + (map.prepared.empty() ? " labels" : "") +
                        " has no effect beyond that of graph: there would be more than " +
                        std::to_string(PrepareOptions{}.max_label_entries) +
                        " entries a vertex, or " +
                        std::to_string(PrepareOptions{}.max_label_bytes >> 20) + " MB of them");
  if (!run.messages.verbose) return;
  run.notes.push_back(map.file +
                      printed(": %d x %d cells, hash %s, read in %.1f ms, %s %.1f ms", map.width,
                              map.height, hash_text(map.hash).c_str(), map.read_ms,
                              map.planner ? "ready after" : "interrupted after", map.ready_ms));
  if (prepared.state == Preparation::State::ready)
    run.notes.push_back(
        printed("--prepare: %lld vertices, %lld edges, %.1f MB, %.1f ms",
                static_cast<long long>(prepared.vertices), static_cast<long long>(prepared.edges),
                1e-6 * static_cast<double>(prepared.bytes), 1e3 * prepared.seconds));
  if (prepared.labels.state == Preparation::State::ready)
    run.notes.push_back(printed("--prepare labels: %lld entries, %.1f MB, %.1f ms",
                                static_cast<long long>(prepared.labels.entries),
                                1e-6 * static_cast<double>(prepared.labels.bytes),
                                1e3 * prepared.labels.seconds));
  run.notes.push_back(algorithm_text(run, find_algorithm(run.params.algorithm()), true));
}

Record record_of(const LoadedMap& map, const RunOptions& run, const Answer& answer) {
  const Result& result = answer.result;
  const MapEnds ends(map, run, answer.start, answer.goal, result,
                     answer.remedy ? &*answer.remedy : nullptr);
  Record record = map_record(ends, result);
  record.most_iterations = most_iterations(record.algorithm, run.params.iterations);
  record.inputs = {{"map", map_json(map)}};
  record.optimum = answer.optimum;
  record.elapsed_ms = answer.elapsed_ms;
  record.path =
      coordinates(ends.in_metres() ? world_path(map, run, answer, result.path) : result.path);
  for (const Alternative& other : result.alternatives)
    record.others.push_back(
        {other.length,
         coordinates(ends.in_metres() ? world_path(map, run, answer, other.path) : other.path)});
  const auto wanted = static_cast<std::size_t>(run.alternatives);
  if (!run.json && record.has_path() && result.alternatives.size() < wanted)
    record.remarks.push_back("--alternatives " + std::to_string(wanted) + ": " +
                             counted(result.alternatives.size(), "way") +
                             (result.status == Status::solved
                                  ? " short enough and different enough found, and no more"
                                  : " found before the search for them was ended"));
  if (!run.json && !map.costs && (answer.optimum || answer.grid_optimum))
    record.remarks.push_back(optima_text(record, answer, run.params));
  Json findings = end_findings(ends);
  if (run.with_optimum && !map.costs) {
    findings["grid_optimum"] = optional_number(answer.grid_optimum);
    if (moves_on_cells(run.params))
      findings["grid_gap"] = optional_number(grid_gap(answer, run.params));
  }
  if (map.costs) {
    add_costs(record, findings, *map.costs, answer);
    if (!run.json && record.has_path()) record.remarks.push_back(cost_text(*answer.over_costs));
  }
  record.answer = answer_json(record, path_json(ends, answer, record.has_path()), Json::object(),
                              std::move(findings));
  return record;
}

std::optional<std::int64_t> BitmapProblem::read(const std::stop_token& token) {
  RunOptions& run = command_.run;
  const bool given = map_ != nullptr;
  MapOptions first = run.map;
  first.prepare = false;
  if (!given)
    map_ = std::make_shared<LoadedMap>(
        load_map(first, run.frame, run.params.corners, run.threads, token));
  note_files(*map_, run);
  check_radius(*map_, run);
  answer_.start = end_place(*map_, command_.start, run.frame);
  answer_.goal = end_place(*map_, command_.goal, run.frame);
  map_->prepare = run.map.prepare;
  // A file is looked at even where the answer needs no search: it may be of another map.
  const bool kept = !map_->prepared.empty() && std::filesystem::exists(map_->prepared);
  if (!given && map_->prepare && map_->planner &&
      (kept || is_search(*map_, run, answer_.start.cell, answer_.goal.cell, token)))
    prepare(*map_, run.threads, token);
  note_map(*map_, run, token);
  return most_iterations(find_algorithm(run.params.algorithm()), run.params.iterations);
}

void BitmapProblem::plan(const StopCondition& stop, const Watch& watch) {
  const RunOptions& run = command_.run;
  const bool colony = find_algorithm(run.params.algorithm()).kind == Algorithm::Kind::colony;
  const bool one_run = run.via.empty();  // what is shown of ants is of one run of theirs
  if (colony && one_run && std::ranges::any_of(run.outputs, is_picture))
    recorder_.emplace(map_->grid(), run.track_iterations, run.params);
  if (one_run && std::ranges::any_of(run.outputs, is_page))
    frames_.emplace(map_->grid(), run.params);
  const double scale = map_->length_in(run.frame, 1);
  Observer observer;
  if (watch || recorder_ || frames_)
    observer = [&](const GridProgress& progress) {
      if (watch)
        watch(progress.iteration + 1,
              best_text(scale * progress.best_length, run.frame == Frame::world ? "m" : ""));
      if (recorder_) recorder_->observe(progress);
      if (frames_) frames_->observe(progress);
    };
  answer_ = answer(*map_, run, answer_.start, answer_.goal, stop, observer);
  if (std::ranges::any_of(run.outputs, [](auto& o) { return is_picture(o) || is_page(o); }))
    answer_.shown_proof = shown_proof(*map_, run, answer_, stop);
  set_remedy(*map_, run, stop.token, answer_);
}

Forms BitmapProblem::show(const Record& run) const {
  const bool proven = answer_.over_costs && answer_.over_costs->proof;
  const auto write_proof = [&](std::ostream& out, bool binary) {
    out << (binary ? proof_to_cbor : proof_to_json)(*answer_.over_costs->proof,
                                                    dumped(weights_json(run)));
  };
  const auto poses = [this](bool metres) { return poses_of(*map_, command_.run, answer_, metres); };
  Forms::Write table;  // empty: as of all kinds
  if (command_.run.spacing && !run.most_iterations)
    table = [poses, metres = command_.run.frame == Frame::world](std::ostream& out) {
      write_pose_table(out, poses(metres), metres);
    };
  return {.csv = table,
          .picture =
              [&](const std::string& file) {
                write_plan_picture(file, *map_, command_.run, answer_,
                                   recorder_ ? &*recorder_ : nullptr);
              },
          .yaml = [this, poses](
                      std::ostream& out) { write_ros_path(out, poses(map_->frame.has_value())); },
          .page =
              [&](std::ostream& out) {
                write_bitmap_report(out, run, *map_, command_.run, answer_,
                                    frames_ ? &*frames_ : nullptr);
              },
          .proof = proven ? Forms::WriteProof(write_proof) : nullptr};
}

}  // namespace lasius::tool
