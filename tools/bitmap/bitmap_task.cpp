#include "tools/bitmap/bitmap_task.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tools/bitmap/bitmap_report.h"
#include "tools/bitmap/map_record.h"
#include "tools/bitmap/picture.h"
#include "tools/console/parameters.h"
#include "tools/console/streams.h"
#include "tools/console/values.h"
#include "tools/options/commands.h"
#include "tools/record/outputs.h"

namespace lasius::tool {
namespace {

/// False where the answer is known before any search, and a visibility graph a waste.
bool is_search(const LoadedMap& map, const RunOptions& run, Cell start, Cell goal,
               const std::stop_token& token) {
  const Route route = route_of(map, run);
  if (!map.planner || start == goal || !map.planner->label(route.corners, {.token = token}))
    return false;
  const bool led_out = map.grown() && map.as_read().free(start) && !map.planner->clear(start);
  return run.goal_tolerance > 0 || led_out || route.joined(*map.planner, start, goal);
}

}  // namespace

BitmapTask::BitmapTask(PlanCommand command, SharedMap map)
    : command_(std::move(command)), map_(std::move(map)) {}

void BitmapTask::load(const std::stop_token& token) {
  const RunOptions& run = options();
  const bool given = map_ != nullptr;
  MapOptions first = run.map;
  first.prepare = false;
  if (!given)
    map_ = std::make_shared<LoadedMap>(load_map(first, run.frame, run.params.corners, token));
  check_radius(*map_, run);
  answer_.start = to_place(*map_, command_.start, run.frame);
  answer_.goal = to_place(*map_, command_.goal, run.frame);
  map_->prepare = run.map.prepare;
  if (!given && map_->prepare &&
      is_search(*map_, run, answer_.start.cell, answer_.goal.cell, token))
    prepare(*map_, run.map.threads, token);
}

void BitmapTask::announce() const {
  Task::announce();
  const LoadedMap& map = *map_;
  const Preparation prepared = map.planner ? map.planner->preparation() : Preparation{};
  if (prepared.state == Preparation::State::too_large)
    message("--prepare has no effect: it would take more than " +
            std::to_string(PrepareOptions{}.max_bytes >> 20) + " MB for this map");
  if (!options().messages.verbose) return;
  message(map.file + printed(": %d x %d cells, hash %s, read in %.1f ms, %s %.1f ms", map.width,
                             map.height, hash_text(map.hash).c_str(), map.read_ms,
                             map.planner ? "ready after" : "interrupted after", map.ready_ms));
  if (prepared.state == Preparation::State::ready)
    message(printed("--prepare: %lld vertices, %lld edges, %.1f MB, %.1f ms",
                    static_cast<long long>(prepared.vertices),
                    static_cast<long long>(prepared.edges),
                    1e-6 * static_cast<double>(prepared.bytes), 1e3 * prepared.seconds));
  announce_algorithm(true);
}

void BitmapTask::plan(const StopCondition& stop, const Watch& watch) {
  const RunOptions& run = options();
  if (algorithm().kind == Algorithm::Kind::colony && std::ranges::any_of(run.outputs, is_picture))
    recorder_.emplace(map_->grid(), run.track_iterations, run.params);
  if (std::ranges::any_of(run.outputs, is_page)) frames_.emplace(map_->grid(), run.params);
  Observer observer;
  if (watch || recorder_ || frames_)
    observer = [&](const GridProgress& progress) {
      if (watch) watch(progress);
      if (recorder_) recorder_->observe(progress);
      if (frames_) frames_->observe(progress);
    };
  answer_ = answer(*map_, run, answer_.start, answer_.goal, stop, observer);
  set_remedy(*map_, run, stop.token, answer_);
}

std::vector<std::string> BitmapTask::input_files() const {
  return {options().map.file, map_ ? map_->image : std::string(), options().preset_file};
}

/// What --gap found.
void BitmapTask::remark() const {
  MapTask::remark();
  const auto& [any_angle, by_moves] = std::pair(answer_.optimum, answer_.grid_optimum);
  if (options().json || (!any_angle && !by_moves)) return;
  const auto against = [&](const char* name, double optimum) {
    const auto part =
        std::string(name) + " " + decimal_text(shown(optimum), 6) + (in_metres() ? " m" : "");
    if (!has_path() || !(optimum > 0)) return part;
    return part + printed(" (the path: %+.3f%%)", 100 * *gap_to(optimum, result().length));
  };
  std::string text = any_angle ? against("optimum", *any_angle) : "optimum unknown";
  if (by_moves) {
    const auto gap = grid_gap(answer_, command_.run.params);
    text += ", by its own moves " + decimal_text(shown(*by_moves), 6) + (in_metres() ? " m" : "");
    if (gap) text += printed(" (the shortest walk: %+.3f%%)", 100 * *gap);
  }
  message(text);
}

void BitmapTask::write_path(std::ostream& out, const char* between) const {
  write_points(out, between, in_metres() ? map_->to_world(result().path) : result().path);
}

void BitmapTask::write_picture(const std::string& file) const {
  write_plan_picture(file, *map_, options(), answer_, recorder_ ? &*recorder_ : nullptr);
}

void BitmapTask::write_report(std::ostream& out) const {
  write_bitmap_report(out, *this, *map_, options(), {answer_.start.cell, answer_.goal.cell},
                      result().path, frames_ ? &*frames_ : nullptr);
}

std::vector<std::string> BitmapTask::end_texts() const {
  const auto text = in_metres() ? to_text : whole_text;
  const Point start = answer_.start.asked, goal = answer_.goal.asked;
  return {text(start.x), text(start.y), text(goal.x), text(goal.y)};
}

Json BitmapTask::inputs() const { return {{"map", map_json(*map_)}}; }

/// Points, and between the two where one begins and ends, arcs. `frame`: in its metres, y up.
Json BitmapTask::curve_json(const LoadedMap* frame) const {
  const auto at = [&](Point p) { return point(frame != nullptr ? frame->to_world(p) : p); };
  Json json = Json::array({at(result().path.front())});
  for (const CurvePiece& piece : result().curve) {
    if (piece.turn != 0)
      json.push_back(
          {{"centre", at(piece.centre)},
           {"radius", number(frame != nullptr ? frame->metres(piece.radius) : piece.radius)},
           {"turn", frame != nullptr ? -piece.turn : piece.turn}});
    json.push_back(at(piece.to));
  }
  return json;
}

void BitmapTask::add_path(Json& json) const {
  add_goal_reached(json);
  const auto& out = way_out();
  if (map().radius > 0) json["way_out"] = out ? point(*out) : Json(nullptr);
  if (map().radius > 0 && in_metres())
    json["way_out_world"] = out ? point(map().to_world(*out)) : Json(nullptr);
  json["path"] = points(result().path);
  const bool has_curve = curved() && has_path();
  if (curved()) json["curve"] = has_curve ? curve_json(nullptr) : Json(nullptr);
  if (curved() && in_metres()) json["curve_world"] = has_curve ? curve_json(&map()) : Json(nullptr);
  if (!in_metres()) return;
  json["start_world"] = point(answer_.start.asked);
  json["goal_world"] = point(answer_.goal.asked);
  json["length_m"] = number(map_->metres(result().length));
  json["path_world"] = points(map_->to_world(result().path));
}

void BitmapTask::add_findings(Json& json) const {
  MapTask::add_findings(json);
  if (!options().with_optimum) return;
  json["grid_optimum"] = optional_number(answer_.grid_optimum);
  if (moves_on_cells(command_.run.params))
    json["grid_gap"] = optional_number(grid_gap(answer_, command_.run.params));
}

std::unique_ptr<Task> recorded_bitmap(const Recorded& from, SharedMap& last) {
  PlanCommand command = recorded_plan(from);
  const RunOptions& run = command.run;
  const bool same = last && last->file == run.map.file && last->radius == run.map.radius &&
                    last->unknown_is_free == run.map.unknown_is_free &&
                    last->prepare == run.map.prepare;
  if (!same)
    last = std::make_shared<LoadedMap>(load_map(run.map, run.frame, run.params.corners, {}));
  return std::make_unique<BitmapTask>(std::move(command), last);
}

int run_command(const PlanCommand& command) {
  BitmapTask task(command);
  return run(task);
}

}  // namespace lasius::tool
