#include "tools/drive/drive_task.h"

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "lasius/error.h"
#include "lasius/shortest_walk.h"
#include "tools/bitmap/answer.h"
#include "tools/bitmap/bitmap_report.h"
#include "tools/bitmap/map_record.h"
#include "tools/bitmap/map_task.h"
#include "tools/bitmap/sheet.h"
#include "tools/console/elapsed.h"
#include "tools/console/parameters.h"
#include "tools/console/streams.h"
#include "tools/console/values.h"
#include "tools/drive/drive_answer.h"
#include "tools/drive/drive_frames.h"
#include "tools/drive/drive_picture.h"
#include "tools/drive/film.h"
#include "tools/drive/gif.h"
#include "tools/options/commands.h"
#include "tools/record/outputs.h"
#include "tools/record/recorded.h"
#include "tools/report/report.h"

namespace lasius::tool {
namespace {

/// The time of a drive: it stands still while the drive is watched or drawn.
class DrivingTime final : public TimeSource {
 public:
  Clock::time_point now() const noexcept override { return Clock::now() - paused_; }
  void pause() noexcept { since_ = Clock::now(); }
  void go_on() noexcept { paused_ += Clock::now() - since_; }

 private:
  Clock::time_point since_{};
  Clock::duration paused_{};
};

constexpr const char* kSamePlace = "give both for the same place, in cells of the same size";

/// @throws Error(file_broken) unless it is as large as the map, and lies where that does.
LoadedMap read_world(MapOptions options, const std::string& file, const LoadedMap& map) {
  options.file = file;
  LoadedMap world = read_map(options, Frame::cell);
  if (world.width != map.width || world.height != map.height)
    throw Error(ErrorCode::file_broken, {.file = file},
                printed("is %d x %d cells, the map %d x %d", world.width, world.height, map.width,
                        map.height),
                kSamePlace);
  const auto differ = [&](const char* what, double of_world, double of_map) {
    if (of_world == of_map) return;
    throw Error(
        ErrorCode::file_broken, {.file = file},
        std::string(what) + " is " + to_text(of_world) + ", that of the map " + to_text(of_map),
        kSamePlace);
  };
  if (world.frame && map.frame) {
    differ("resolution", world.frame->resolution, map.frame->resolution);
    differ("x of the origin", world.frame->origin_x, map.frame->origin_x);
    differ("y of the origin", world.frame->origin_y, map.frame->origin_y);
    differ("yaw of the origin", world.frame->yaw, map.frame->yaw);
  }
  return world;
}

/// A sense that was given in metres, in cells. @throws UsageError where it is out of range.
double sense_in_cells(double metres, double resolution) {
  const double cells = metres / resolution;
  if (cells >= DriveCommand::kLeastSense && cells <= DriveCommand::kMostSense) return cells;
  throw UsageError("--sense " + to_text(metres) + " m is " + to_text(cells) + " cells: give " +
                   to_text(DriveCommand::kLeastSense * resolution) + " to " +
                   to_text(DriveCommand::kMostSense * resolution) + " m");
}

Progress progress_of(const DriveTick& tick) {
  Progress progress;
  progress.iteration = static_cast<int>(tick.tick);
  if (tick.way != nullptr) progress.best_length = tick.way->length;
  return progress;
}

/// `lasius drive`. Its SearchResult has the length travelled, also of a drive that did not arrive.
class DriveTask : public MapTask {
 public:
  explicit DriveTask(DriveCommand command) : command_(std::move(command)) {}

  void load(const std::stop_token&) override {
    const RunOptions& run = options();
    if (std::ranges::any_of(run.outputs, is_film)) check_films();
    answer_.map = read_map(run.map, run.frame);
    MapOptions alike = run.map;
    alike.radius_metres = false;  // the world's file need not tell of metres
    if (!command_.world.empty()) answer_.world = read_world(alike, command_.world, answer_.map);
    if (!command_.changes.empty()) {
      answer_.changes = read_changes_file(command_.changes, answer_.map.width, answer_.map.height);
      answer_.changes_hash = file_hash(command_.changes);
    }
    answer_.start = to_place(answer_.map, command_.start, run.frame);
    answer_.goal = to_place(answer_.map, command_.goal, run.frame);
    answer_.sense = command_.sense.value_or(DriveOptions{}.sense);
    if (command_.sense && run.map.radius_metres)
      answer_.sense = sense_in_cells(answer_.sense, answer_.map.frame->resolution);
  }
  void announce() const override {
    Task::announce();
    if (!options().messages.verbose) return;
    const auto read = [](const LoadedMap& map) {
      message(map.file + printed(": %d x %d cells, hash %s, read in %.1f ms", map.width, map.height,
                                 hash_text(map.hash).c_str(), map.read_ms));
    };
    read(answer_.map);
    if (answer_.world) read(*answer_.world);
    announce_algorithm(true);
  }
  void plan(const StopCondition& stop, const Watch& watch) override {
    const auto asked = [&](const auto& kind) {
      return std::ranges::any_of(options().outputs, kind);
    };
    const bool filmed = asked(is_film), played = asked(is_page);
    if (filmed || played || asked(is_picture)) recorder_.emplace(map().grid(), answer_.sense);
    if (filmed) film_.emplace(map().grid(), goal().cell);
    std::optional<Grid> at_start;  // the world without moving obstacles
    if (played) frames_.emplace(map().grid(), map().radius);
    DriveObserver observer;
    if (watch || recorder_)
      observer = [&](const DriveTick& tick) {
        if (watch) watch(progress_of(tick));
        if (recorder_) recorder_->observe(tick);
        if (film_) film_->observe(tick, *recorder_);
        if (frames_) frames_->observe(tick, *recorder_);
      };
    DrivingTime time;
    const DriveObserver untimed = [&](const DriveTick& tick) {
      time.pause();
      if (tick.tick == 0) at_start.emplace(*tick.still);
      if (observer) observer(tick);
      time.go_on();
    };
    const auto begin = time.now();
    Navigator navigator(map().grid(), goal().cell, navigator_options(stop));
    // Time counts from when the map is prepared.
    StopCondition until = again(stop, options().time_limit);
    until.time = &time;
    const DriveOptions how{
        .sense = answer_.sense, .max_ticks = command_.max_ticks, .seed = options().params.seed};
    const DriveResult& driven = answer_.result = drive(
        navigator, answer_.truth().grid(), start().cell, answer_.changes, how, until, untimed);
    answer_.elapsed_ms = std::chrono::duration<double, std::milli>(time.now() - begin).count();
    result_.status = driven.status;
    result_.limit = driven.limit;
    result_.fault = driven.fault;
    result_.error = driven.error;
    if (result_.status == Status::invalid) return;
    result_.length = driven.length;
    if (at_start) look_for_optimum(*at_start, again(stop, options().time_limit));
  }

  const RunOptions& options() const override { return command_.run; }
  std::vector<std::string> input_files() const override {
    std::vector<std::string> files{options().map.file, answer_.map.image, command_.world,
                                   command_.changes, options().preset_file};
    if (answer_.world) files.push_back(answer_.world->image);
    return files;
  }
  std::int64_t iterations() const override { return 0; }
  bool iterates() const override { return false; }

  const SearchResult& result() const override { return result_; }
  std::optional<double> optimum() const override { return answer_.optimum; }
  double elapsed_ms() const override { return answer_.elapsed_ms; }
  bool found() const override { return result_.status == Status::solved; }
  std::string reached() const override {
    const Cell at = answer_.result.track.back();
    return " after " + counted(answer_.result.ticks, "tick") +
           printed(", with the robot at (%d, %d)", at.x, at.y);
  }

  std::string progress_note(const Progress& progress) const override {
    std::string text = "tick " + std::to_string(progress.iteration);
    if (progress.best_length == progress.best_length)
      text += ", " + decimal_text(shown(progress.best_length), 1) + " " +
              (in_metres() ? "m" : "cells") + " to go";
    return text;
  }
  void remark() const override {
    MapTask::remark();
    if (options().json || !has_path()) return;
    const DriveResult& result = answer_.result;
    std::string text = counted(result.ticks, "tick") + ", " +
                       counted(result.replans.size(), "plan") + ", " +
                       counted(result.seen, "cell") + " learned, " + counted(result.waits, "wait");
    if (const auto ratio = answer_.ratio())
      text += "; " + decimal_text(*ratio, 4) + " of the optimum of 8 moves, " +
              decimal_text(shown(*answer_.optimum), 3) + (in_metres() ? " m" : "");
    message(text);
  }
  void write_path(std::ostream& out, const char* between) const override {
    if (in_metres()) {
      write_points(out, between, centres_in_metres());
    } else {
      for (const Cell c : answer_.result.track) out << c.x << between << c.y << "\n";
    }
  }
  void write_csv(std::ostream& out) const override {
    out << (in_metres() ? "x_m,y_m\n" : "x,y\n");
    if (has_path()) write_path(out, ",");
  }
  void write_picture(const std::string& file) const override {
    write_drive_picture(file, options(), answer_, *recorder_);
  }
  void write_film(std::ostream& out) const override { film_->write(out); }
  void write_report(std::ostream& out) const override {
    Json content = run_json(*this, "drive", "drive, " + map_title(map(), options()));
    content["map"] = map_view_json(map(), shown_of(map(), {start().cell, goal().cell}));
    content["sense"] = answer_.sense;
    content["frames"] = frames_->json();
    write_report_page(out, content);
  }

  const char* format() const override { return kDriveFormat; }
  Json inputs() const override {
    Json changes;
    if (!command_.changes.empty())
      changes = {{"file", command_.changes}, {"hash", hash_text(answer_.changes_hash)}};
    return {{"map", map_json(map())},
            {"world", answer_.world ? map_json(*answer_.world) : Json()},
            {"changes", std::move(changes)}};
  }
  void add_settings(Json& json) const override {
    MapTask::add_settings(json);
    json["sense"] = number(answer_.sense);
    json["max_ticks"] = command_.max_ticks;
  }
  void add_answer(Json& json) const override {
    const DriveResult& result = answer_.result;
    add_path(json);
    json["ticks"] = result.ticks;
    json["replans"] = Json::array();
    for (const Replan& replan : result.replans)
      json["replans"].push_back(
          {{"tick", replan.tick}, {"ms", number(replan.ms)}, {"length", number(replan.length)}});
    json["seen"] = result.seen;
    json["length"] = number(result_.length);
    if (in_metres()) json["length_m"] = number(shown(result_.length));
    json["optimum"] = optional_number(answer_.optimum);
    json["ratio"] = optional_number(answer_.ratio());
    json["waits"] = result.waits;
    json["deferred"] = result.deferred_changes;
    add_findings(json);
  }
  void add_path(Json& json) const override {
    add_goal_reached(json);
    Json& track = json["track"];
    if (has_path())
      for (const Cell c : answer_.result.track) track.push_back({c.x, c.y});
    if (!in_metres()) return;
    json["start_world"] = point(start().asked);
    json["goal_world"] = point(goal().asked);
    json["track_world"] = has_path() ? points(centres_in_metres()) : Json();
  }

 private:
  const LoadedMap& map() const override { return answer_.map; }
  const Place& start() const override { return answer_.start; }
  const Place& goal() const override { return answer_.goal; }
  const std::optional<Cell>& nearest_free() const override { return answer_.result.nearest_free; }
  const std::optional<Cell>& nearest_reachable() const override {
    return answer_.result.nearest_reachable;
  }
  const std::optional<Cell>& goal_reached() const override { return answer_.result.goal_reached; }

  NavigatorOptions navigator_options(const StopCondition& stop) const {
    NavigatorOptions navigator{.params = as_read(options().params), .radius = map().radius};
    if (map().prepare)
      navigator.prepare =
          PrepareOptions{.threads = options().map.threads, .stop = {.token = stop.token}};
    const Request request = request_of(map(), options(), start().cell, goal().cell);
    navigator.target_gap = request.target_gap;
    navigator.goal_tolerance = request.goal_tolerance;
    return navigator;
  }
  /// By the corners that the robot's moves may pass, whatever its paths are made of.
  void look_for_optimum(const Grid& world, const StopCondition& stop) {
    const Navigator robot(Grid(world), goal().cell, {.radius = map().radius});
    const bool all = squeezes(options().params) || robot.corners() == Corners::allow;
    answer_.optimum =
        shortest_walk(robot.passable(), start().cell, goal_reached().value_or(goal().cell),
                      Neighbours::eight, all ? Corners::allow : Corners::forbid, stop);
  }
  std::vector<Point> centres_in_metres() const {
    std::vector<Point> points;
    for (const Cell c : answer_.result.track) points.push_back(map().to_world(centre(c)));
    return points;
  }

  DriveCommand command_;
  DriveAnswer answer_{};
  std::optional<DriveRecorder> recorder_;
  std::optional<Film> film_;
  std::optional<DriveFrames> frames_;
  SearchResult result_;
};

}  // namespace

Grid world_at(const DriveAnswer& answer, std::int64_t tick) {
  auto changes = answer.changes.cells;
  std::ranges::stable_sort(changes, {}, &Change::tick);
  Grid grid = answer.truth().grid();
  for (const Change& change : changes)
    if (change.tick <= tick) grid.fill(change.part, change.blocked);
  return grid;
}

std::unique_ptr<Task> recorded_drive(const Recorded& from) {
  DriveCommand command{recorded_plan(from)};
  const auto file = [&](const char* role) -> std::string {
    if (value_at(from.result, role).is_null()) return {};
    return from.found(recorded<std::string>(from.result, role + std::string("/file")));
  };
  command.world = file("world");
  command.changes = file("changes");
  command.sense = recorded_real(from.result, "parameters/sense", DriveCommand::kLeastSense,
                                DriveCommand::kMostSense);
  command.max_ticks =
      recorded_integer(from.result, "parameters/max_ticks", 0, DriveCommand::kMostTicks);
  return std::make_unique<DriveTask>(std::move(command));
}

int run_command(const DriveCommand& command) {
  DriveTask task(command);
  return run(task);
}

}  // namespace lasius::tool
