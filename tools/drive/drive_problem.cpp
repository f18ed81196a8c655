#include <algorithm>
#include <chrono>

#include "lasius/base/error.h"
#include "lasius/path/shortest_walk.h"
#include "tools/bitmap/answer.h"
#include "tools/bitmap/bitmap_problem.h"
#include "tools/bitmap/bitmap_report.h"
#include "tools/bitmap/map_ends.h"
#include "tools/bitmap/sheet.h"
#include "tools/console/elapsed.h"
#include "tools/console/parameters.h"
#include "tools/console/values.h"
#include "tools/drive/drive_answer.h"
#include "tools/drive/drive_frames.h"
#include "tools/drive/drive_kind.h"
#include "tools/drive/drive_picture.h"
#include "tools/drive/film.h"
#include "tools/drive/gif.h"
#include "tools/options/commands.h"
#include "tools/record/problem.h"
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

/// A sense that was given in metres, in cells. @throws UsageError where it is out of range.
double sense_in_cells(double metres, double resolution) {
  const double cells = metres / resolution;
  if (cells >= DriveCommand::kLeastSense && cells <= DriveCommand::kMostSense) return cells;
  throw UsageError("--sense " + to_text(metres) + " m is " + to_text(cells) + " cells: give " +
                   to_text(DriveCommand::kLeastSense * resolution) + " to " +
                   to_text(DriveCommand::kMostSense * resolution) + " m");
}

/// `lasius drive`. Its SearchResult has the length travelled, also of a drive that did not arrive.
class DriveProblem : public ProblemOf<DriveCommand> {
 public:
  explicit DriveProblem(DriveCommand command, std::optional<Json> recorded = {})
      : ProblemOf(std::move(command)), recorded_(std::move(recorded)) {}

  std::optional<std::int64_t> read(const std::stop_token&) override {
    RunOptions& run = command_.run;
    if (std::ranges::any_of(run.outputs, is_film)) check_films();
    answer_.map = read_map(run.map, run.frame);
    MapOptions alike = run.map;
    alike.radius_metres = false;  // the world's file need not tell of metres
    if (!command_.world.empty()) answer_.world = read_world(alike, command_.world, answer_.map);
    if (command_.vehicle) answer_.vehicle = read_driven_vehicle(command_, answer_.map, recorded_);
    if (run.map.costs.asked()) read_costs();
    if (!command_.changes.empty()) {
      answer_.changes = read_changes_file(command_.changes, answer_.map.width, answer_.map.height);
      answer_.changes_hash = file_hash(command_.changes);
    }
    if (answer_.vehicle) {
      answer_.start = answer_.vehicle->start.place;
      answer_.goal = answer_.vehicle->goal().place;
    } else {
      answer_.start = to_place(answer_.map, command_.start, run.frame);
      answer_.goal = to_place(answer_.map, command_.goal, run.frame);
    }
    answer_.sense = command_.sense.value_or(DriveOptions{}.sense);
    if (command_.sense && run.map.radius_metres)
      answer_.sense = sense_in_cells(answer_.sense, answer_.map.frame->resolution);
    for (const LoadedMap* map : {&answer_.map, answer_.world ? &*answer_.world : nullptr}) {
      if (map == nullptr) continue;
      run.inputs.push_back(map->image);
      if (run.messages.verbose)
        run.notes.push_back(map->file + printed(": %d x %d cells, hash %s, read in %.1f ms",
                                                map->width, map->height,
                                                hash_text(map->hash).c_str(), map->read_ms));
    }
    if (run.messages.verbose && !command_.vehicle)
      run.notes.push_back(algorithm_text(run, find_algorithm(run.params.algorithm()), true));
    return std::nullopt;
  }
  void plan(const StopCondition& stop, const Watch& watch) override {
    const auto asked = [&](const auto& kind) {
      return std::ranges::any_of(command_.run.outputs, kind);
    };
    const bool filmed = asked(is_film), played = asked(is_page);
    if (filmed || played || asked(is_picture)) recorder_.emplace(answer_.map.grid(), answer_.sense);
    if (filmed) film_.emplace(answer_.map.grid(), answer_.goal.cell);
    std::optional<Grid> at_start;  // the world without moving obstacles
    if (played) frames_.emplace(answer_.map.grid(), answer_.map.radius);
    DrivingTime time;
    const auto look = [&](const DriveTick& tick) {
      time.pause();
      if (tick.tick == 0) at_start.emplace(*tick.still);
      if (watch) watch(tick.tick + 1, note_on(tick));
      if (recorder_) recorder_->observe(tick);
      if (film_) film_->observe(tick, *recorder_);
      if (frames_) frames_->observe(tick, *recorder_);
      time.go_on();
    };
    const auto begin = time.now();
    std::optional<Navigator> navigator;
    if (!answer_.vehicle)
      navigator.emplace(answer_.map.grid(), answer_.goal.cell, navigator_options(stop));
    // Time counts from when the map is prepared.
    StopCondition until = again(stop, command_.run.time_limit);
    until.time = &time;
    const DriveOptions how{.sense = answer_.sense,
                           .max_ticks = command_.max_ticks,
                           .seed = command_.run.params.seed,
                           .stop = until,
                           .observer = look};
    const Grid& truth = answer_.truth().grid();
    answer_.result = answer_.vehicle
                         ? drive_vehicle(*answer_.vehicle, answer_.map, command_.run.frame, truth,
                                         answer_.changes, how)
                         : drive(*navigator, truth, answer_.start.cell, answer_.changes, how);
    if (answer_.vehicle) answer_.goal = answer_.vehicle->goal().place;
    const DriveResult& driven = answer_.result;
    answer_.elapsed_ms = std::chrono::duration<double, std::milli>(time.now() - begin).count();
    result_.status = driven.status;
    result_.limit = driven.limit;
    result_.fault = driven.fault;
    result_.error = driven.error;
    if (result_.status == Status::invalid) return;
    result_.length = driven.length;
    if (at_start && answer_.vehicle)
      look_for_bound(*answer_.vehicle, *at_start, again(stop, command_.run.time_limit));
    else if (at_start)
      look_for_optimum(*at_start, again(stop, command_.run.time_limit));
  }
  Record record() const override {
    const DriveResult& driven = answer_.result;
    const bool metres = in_metres();
    MapEnds ends(answer_.map, command_.run, answer_.start, answer_.goal, driven);
    if (answer_.vehicle) {  // its error says all
      ends.status = Status::no_path;
      ends.fault = Fault::none;
    }
    Record record = answer_.vehicle ? map_record(ends, result_, lattice_algorithm())
                                    : map_record(ends, result_);
    if (answer_.vehicle) record_vehicle(record, *answer_.vehicle, command_, answer_.map);
    record.format = kDriveFormat;
    record.inputs = inputs();
    record.parameters["sense"] = number(answer_.sense);
    record.parameters["max_ticks"] = command_.max_ticks;
    record.optimum = answer_.optimum;
    record.elapsed_ms = answer_.elapsed_ms;
    record.arrived = result_.status == Status::solved;
    Json costs = Json::object();
    if (answer_.layers) record_costs(*answer_.map.costs, costs, record.parameters);
    if (record.has_path() && !answer_.vehicle) record.path = coordinates(track(metres));
    if (!driven.track.empty()) {
      const Cell at = driven.track.back();
      record.reached = " after " + counted(driven.ticks, "tick") +
                       printed(", with the robot at (%d, %d)", at.x, at.y);
    }
    if (!command_.run.json && record.has_path()) record.remarks.push_back(summary(record));
    if (wants_json(command_.run)) {
      record.answer = answer_of(ends, record);
      record.answer.update(costs);
    }
    return record;
  }
  Forms show(const Record& run) const override {
    return {.csv =
                [&](auto& out) {
                  if (answer_.vehicle)
                    write_poses(out, *answer_.vehicle, command_, answer_.map, run.has_path());
                  else
                    write_csv(out, run);
                },
            .picture =
                [&](auto& file) { write_drive_picture(file, command_.run, answer_, *recorder_); },
            .film = [&](auto& out) { film_->write(out); },
            .page = [&](auto& out) { write_page(out, run); }};
  }

 private:
  bool in_metres() const { return command_.run.frame == Frame::world; }

  std::string note_on(const DriveTick& tick) const {
    const std::string text = "tick " + std::to_string(tick.tick);
    if (tick.way == nullptr) return text;
    const double left = answer_.map.length_in(command_.run.frame, tick.way->length);
    return text + ", " + decimal_text(left, 1) + (in_metres() ? " m" : " cells") + " to go";
  }
  std::string summary(const Record& record) const {
    const DriveResult& driven = answer_.result;
    const std::string text =
        counted(driven.ticks, "tick") + ", " + counted(driven.replans.size(), "plan") + ", " +
        counted(driven.seen, "cell") + " learned, " + counted(driven.waits, "wait") +
        (answer_.layers ? ", cost " + decimal_text(driven.cost, 3) : "");
    if (answer_.vehicle && answer_.vehicle->lower_bound)
      return text + "; on what is there no way of this vehicle is below " +
             decimal_text(record.scale * *answer_.vehicle->lower_bound, 3) +
             (in_metres() ? " m" : "");
    const auto ratio = answer_.ratio();
    if (!ratio) return text;
    const double scale = answer_.layers ? 1 : record.scale;
    return text + "; " + decimal_text(*ratio, 4) + " of the optimum of 8 moves, " +
           decimal_text(scale * *answer_.optimum, 3) + (in_metres() && !answer_.layers ? " m" : "");
  }
  void write_page(std::ostream& out, const Record& run) const {
    const LoadedMap& map = answer_.map;
    Json content = run_json(run, "drive", drive_title(answer_, command_.run));
    content["map"] = map_view_json(map, shown_of(map, {answer_.start.cell, answer_.goal.cell}));
    content["sense"] = answer_.sense;
    content["frames"] = frames_->json();
    write_report_page(out, content);
  }
  Json inputs() const {
    Json changes;
    if (!command_.changes.empty())
      changes = {{"file", command_.changes}, {"hash", hash_text(answer_.changes_hash)}};
    return {{"map", map_json(answer_.map)},
            {"world", answer_.world ? map_json(*answer_.world) : Json()},
            {"changes", std::move(changes)}};
  }
  Json answer_of(const MapEnds& ends, const Record& record) const {
    const DriveResult& driven = answer_.result;
    Json json = Json::object();
    if (answer_.vehicle) {
      add_track(json, *answer_.vehicle, command_, answer_.map, record.has_path());
    } else {
      add_goal_reached(json, ends);
      Json& cells = json["track"];
      if (record.has_path())
        for (const Cell c : driven.track) cells.push_back({c.x, c.y});
      if (in_metres()) {
        json["start_world"] = point(answer_.start.asked);
        json["goal_world"] = point(answer_.goal.asked);
        json["track_world"] = record.has_path() ? points(track(true)) : Json();
      }
    }
    json["ticks"] = driven.ticks;
    json["replans"] = Json::array();
    for (const Replan& replan : driven.replans) {
      Json& one = json["replans"].emplace_back(Json{
          {"tick", replan.tick}, {"ms", number(replan.ms)}, {"length", number(replan.length)}});
      if (answer_.layers) one["cost"] = number(replan.cost);
    }
    json["seen"] = driven.seen;
    json["length"] = number(result_.length);
    if (answer_.layers) json["cost"] = record.has_path() ? number(driven.cost) : Json();
    if (in_metres()) json["length_m"] = number(record.scale * result_.length);
    if (answer_.vehicle) json["lower_bound"] = optional_number(answer_.vehicle->lower_bound);
    json["optimum"] = optional_number(answer_.optimum);
    json["ratio"] = optional_number(answer_.ratio());
    json["waits"] = driven.waits;
    json["deferred"] = driven.deferred_changes;
    if (!answer_.vehicle) json.update(end_findings(ends));
    return json;
  }
  /// The robot's cells; in metres their centres.
  std::vector<Point> track(bool metres) const {
    std::vector<Point> points;
    for (const Cell c : answer_.result.track)
      points.push_back(metres ? answer_.map.to_world(centre(c)) : Point{1.0 * c.x, 1.0 * c.y});
    return points;
  }
  /// Inflation is kept apart: it follows what the robot sees. Cells that a layer blocks are blocked
  /// in truth as well.
  void read_costs() {
    LoadedMap& map = answer_.map;
    const CostLayers& asked = command_.run.map.costs;
    CostLayers layers = asked;
    layers.inflation.reset();
    const bool metres = command_.run.map.radius_metres;
    const double radius =
        answer_.vehicle ? vehicle::inscribed_radius(answer_.vehicle->vehicle.vehicle) : map.radius;
    LoadedCosts& costs =
        map.costs.emplace(load_costs(*map.grid_alone, map.frame, layers, metres, radius));
    if (answer_.world)
      (void)load_costs(*answer_.world->grid_alone, map.frame, layers, metres, radius);
    answer_.layers = costs.field;
    costs.asked = asked;
    inflate(costs, *map.grid_alone, map.frame, metres, radius);
    if (answer_.vehicle) {
      answer_.vehicle->how.costs = answer_.layers;
      answer_.vehicle->how.inflation = costs.inflation;
    }
    auto& notes = command_.run.notes;
    notes.insert(notes.end(), costs.notes.begin(), costs.notes.end());
    command_.run.inputs.insert(command_.run.inputs.end(), costs.images.begin(), costs.images.end());
    if (recorded_) check_layers(costs, *recorded_);
  }
  NavigatorOptions navigator_options(const StopCondition& stop) const {
    NavigatorOptions navigator{.params = command_.run.params, .radius = answer_.map.radius};
    navigator.costs = answer_.layers;
    if (answer_.layers) navigator.inflation = answer_.map.costs->inflation;
    if (answer_.map.prepare)
      navigator.prepare = PrepareOptions{.threads = command_.run.threads,
                                         .stop = {.token = stop.token},
                                         .labels = answer_.map.labels};
    const Request request = request_of(answer_.map, command_.run, answer_.start, answer_.goal);
    navigator.target_gap = request.target_gap;
    navigator.goal_tolerance = request.goal_tolerance;
    return navigator;
  }
  /// By the corners that the robot's moves may pass, whatever its paths are made of.
  void look_for_optimum(const Grid& world, const StopCondition& stop) {
    const Cell goal = answer_.result.goal_reached.value_or(answer_.goal.cell);
    NavigatorOptions how{.radius = answer_.map.radius, .costs = answer_.layers};
    if (answer_.layers) how.inflation = answer_.map.costs->inflation;
    Navigator robot(Grid(world), goal, how);
    if (answer_.layers) {
      const Way& way = robot.step(answer_.start.cell, stop);
      if (!way.path.empty() && !way.way_out) answer_.optimum = way.walk_cost;
      return;
    }
    const bool all = squeezes(command_.run.params) || robot.corners() == Corners::allow;
    answer_.optimum = shortest_walk(robot.passable(), answer_.start.cell, goal, Neighbours::eight,
                                    all ? Corners::allow : Corners::forbid, stop);
  }

  std::optional<Json> recorded_;  ///< the result that is replayed
  DriveAnswer answer_{};
  std::optional<DriveRecorder> recorder_;
  std::optional<Film> film_;
  std::optional<DriveFrames> frames_;
  SearchResult result_;
};

std::unique_ptr<Problem> drive_again(const Recorded& from, const Problem*) {
  DriveCommand command =
      of_vehicle(from.result) ? recorded_drive_of_vehicle(from) : DriveCommand{recorded_plan(from)};
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
  return std::make_unique<DriveProblem>(std::move(command), from.result);
}

}  // namespace

const ProblemKind& drive_kind() {
  static const ProblemKind kKind{.format = kDriveFormat,
                                 .again = drive_again,
                                 .unlike = unlike_radius,
                                 .counted = [](const Json& result) {
                                   return value_at(result, "ticks") ==
                                          value_at(result, "parameters/max_ticks");
                                 }};
  return kKind;
}

int run_command(const DriveCommand& command) {
  DriveProblem problem(command);
  return run(problem);
}

}  // namespace lasius::tool
