#include "tools/polygon/polygon_task.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>

#include "core/base/output.h"
#include "tools/console/exit_code.h"
#include "tools/console/signals.h"
#include "tools/console/streams.h"
#include "tools/console/values.h"
#include "tools/console/worlds.h"
#include "tools/options/commands.h"
#include "tools/polygon/polygon_answer.h"
#include "tools/polygon/polygon_picture.h"
#include "tools/polygon/polygon_report.h"
#include "tools/record/batch.h"
#include "tools/record/outputs.h"
#include "tools/record/queries.h"
#include "tools/record/recorded.h"

namespace lasius::tool {
namespace {

Json crossing_length(const std::optional<polygon::Crossing>& crossing) {
  return crossing ? number(crossing->length) : Json(nullptr);
}

/// @throws UsageError where neither the command nor the world says where to start or end.
void check_ends(const PolygonCommand& command, const polygon::World& world) {
  const auto check = [&](const std::string& role, const char* place, bool given) {
    if (!given)
      throw UsageError("--" + role + " is required: " + command.world.file +
                       " has none (GeoJSON: a feature with the role " + role + "; WKT: the " +
                       place + " POINT)");
  };
  check("start", "first", command.start || world.start);
  check("goal", "second", command.goal || world.goal);
}

/// `plan` on a polygon world, and each query of `batch`.
class PolygonTask : public Task {
 public:
  /// `world` may be given, made of what the command says; else `open` makes it.
  explicit PolygonTask(PolygonCommand command, SharedWorld world = {})
      : command_(std::move(command)), world_(std::move(world)) {}

  void open() override {
    answer_.parameters = polygon_parameters(command_, command_.notes);
    if (!world_) world_ = std::make_shared<LoadedWorld>(load_world(command_.world));
    const polygon::World& world = world_->planner.world();
    check_ends(command_, world);
  }
  void announce() const override {
    Task::announce();
    for (const auto& note : world_->planner.world().notes)
      message(world_->options.file + ": " + note);
    if (!options().messages.verbose) return;
    const polygon::Maklink& graph = world_->planner.maklink();
    message(world_->options.file + ": " +
            counted(world_->planner.world().obstacles.size(), "obstacle") + ", " +
            counted(graph.lines.size(), "line") + ", " + counted(graph.regions.size(), "region") +
            printed(", hash %s, read in %.1f ms, ready after %.1f ms",
                    hash_text(world_->hash).c_str(), world_->read_ms, world_->ready_ms));
    announce_algorithm(false);
  }
  void plan(const StopCondition& stop, const Watch& watch) override {
    if (std::ranges::any_of(options().outputs, is_page)) frames_.emplace();
    polygon::Observer observer;
    if (watch || frames_)
      observer = [&](const polygon::PlanProgress& progress) {
        if (watch) watch(progress);
        if (frames_) frames_->observe(progress);
      };
    take(polygon_answer(*world_, command_, answer_.parameters, stop, observer));
  }
  void set_seed(std::uint64_t seed) { command_.seed = seed; }
  /// Takes an answer that was found elsewhere, or only its parameters.
  void take(PolygonAnswer answer) { answer_ = std::move(answer); }

  const SearchOptions& options() const override { return command_; }
  std::vector<std::string> input_files() const override { return {command_.world.file}; }
  const Algorithm& algorithm() const override {
    return polygon::find_algorithm(answer_.parameters.algorithm());
  }
  std::string parameter(std::string_view name) const override {
    return get_parameter(answer_.parameters, name);
  }
  std::int64_t iterations() const override {
    return std::int64_t{iterations_of(answer_.parameters)} * answer_.parameters.routes;
  }

  const SearchResult& result() const override { return answer_.result; }
  const std::vector<Point>& path() const { return answer_.result.path; }
  std::optional<double> optimum() const override { return answer_.result.optimum; }
  double elapsed_ms() const override { return answer_.elapsed_ms; }

  void remark() const override {
    if (!answer_.result.note.empty()) message(answer_.result.note);
    const auto& end = answer_.result.goal_reached;
    if (options().json || !end || *end == answer_.goal) return;
    message("the path ends at (" + to_text(end->x) + ", " + to_text(end->y) + "), " +
            to_text(std::hypot(end->x - answer_.goal.x, end->y - answer_.goal.y)) +
            " from the goal, which cannot be reached");
  }

  void write_path(std::ostream& out, const char* between) const override {
    write_points(out, between, path());
  }
  void write_picture(const std::string& file) const override {
    write_polygon_picture(file, *world_, answer_);
  }
  void write_report(std::ostream& out) const override {
    write_polygon_report(out, *this, *world_, answer_, frames_ ? &*frames_ : nullptr);
  }

  Json inputs() const override {
    const Point low = world_->low(), high = world_->high();
    return {{"map",
             {{"file", world_->options.file},
              {"hash", hash_text(world_->hash)},
              {"width", number(high.x - low.x)},
              {"height", number(high.y - low.y)}}}};
  }
  std::pair<Json, Json> ends() const override {
    return {point(answer_.start), point(answer_.goal)};
  }
  void add_settings(Json& json) const override {
    add_limits(json);
    json["margin"] = number(world_->planner.margin());
    const WorldOptions& made = world_->options;
    json["join"] = made.before_round ? recorded_join(made.join) : kJoins[made.join];
    if (!made.before_round) json["boundary"] = kBoundaries[made.boundary];
    json["repair"] = made.repair;
    if (options().goal_tolerance > 0) json["goal_tolerance"] = number(options().goal_tolerance);
  }
  void add_path(Json& json) const override {
    const auto& end = answer_.result.goal_reached;
    if (options().goal_tolerance > 0) json["goal_reached"] = end ? point(*end) : Json();
    json["path"] = points(answer_.result.path);
  }
  /// What the graph gave: sizes, the lines crossed, and the optima that bound the path.
  void add_findings(Json& json) const override {
    const polygon::Maklink& graph = world_->planner.maklink();
    const polygon::Result& found = answer_.result;
    json["maklink"] = {
        {"lines", graph.lines.size()},
        {"regions", graph.regions.size()},
        {"crossed", found.crossing.lines},
        {"values", numbers(found.crossing.values)},
        {"dijkstra_length", crossing_length(found.dijkstra)},
        {"dijkstra_path", found.dijkstra ? points(found.dijkstra->path) : Json(nullptr)},
        {"discrete_optimum", crossing_length(found.discrete_optimum)},
        {"sequence_optimum", crossing_length(found.sequence_optimum)}};
    if (!world_->options.before_round) json["note"] = text_or_null(found.note);
  }

 private:
  /// As it was called when the result was recorded.
  static std::string_view recorded_join(int join) {
    const bool chords = join == static_cast<int>(polygon::Join::chords);
    return to_string(chords ? polygon::Join::round : static_cast<polygon::Join>(join));
  }

  PolygonCommand command_;
  SharedWorld world_;
  std::optional<PolygonFrames> frames_;
  PolygonAnswer answer_;
};

/// The world of a result. One without "boundary" is older than that: `round` meant chords then.
WorldOptions recorded_world(const Recorded& from) {
  const Json& result = from.result;
  WorldOptions world;
  world.file = from.map_file();
  world.repair = recorded<bool>(result, "parameters/repair");
  world.margin = recorded<double>(result, "parameters/margin");
  const auto choice = [&](const char* name, std::span<const std::string_view> names) {
    const auto key = std::string("parameters/") + name;
    return static_cast<int>(choice_value(name, recorded<std::string>(result, key), names));
  };
  world.join = choice("join", kJoins);
  world.before_round = !result["parameters"].contains("boundary");
  if (!world.before_round) {
    world.boundary = choice("boundary", kBoundaries);
  } else {
    world.boundary = static_cast<int>(polygon::Boundary::keep);
    if (world.join == static_cast<int>(polygon::Join::round))
      world.join = static_cast<int>(polygon::Join::chords);
  }
  return world;
}

/// The command's queries: a file's, or its own one.
std::vector<QueryFile::Line> queries_of(const PolygonBatchCommand& command,
                                        const polygon::World& world) {
  if (!command.queries.empty()) return read_table(command.queries).queries;
  const PolygonCommand& plan = command.plan;
  check_ends(plan, world);
  return {{plan.start ? *plan.start : *world.start, plan.goal ? *plan.goal : *world.goal}};
}

}  // namespace

std::unique_ptr<Task> recorded_polygon(const Recorded& from, SharedWorld& last) {
  const Json& result = from.result;
  PolygonCommand command;
  const auto known = algorithm_of(World::Kind::polygon, recorded<std::string>(result, "algorithm"));
  read_recorded(from, polygon::find_algorithm(known), command);
  command.world = recorded_world(from);
  command.start = recorded_point(result, "start");
  command.goal = recorded_point(result, "goal");
  if (result["parameters"].contains("goal_tolerance"))
    command.goal_tolerance = recorded_real(result, "parameters/goal_tolerance", 0, kNoLimit);
  if (!last || last->options != command.world)
    last = std::make_shared<LoadedWorld>(load_world(command.world));
  return std::make_unique<PolygonTask>(std::move(command), last);
}

int run_command(const PolygonCommand& command) {
  PolygonTask task(command);
  return run(task);
}

int run_command(const PolygonBatchCommand& command) {
  PolygonCommand plan = command.plan;
  check_outputs(plan.outputs, {plan.world.file, command.queries});
  SignalWatcher signals;
  const polygon::Params parameters = polygon_parameters(plan, plan.notes);
  const auto world = std::make_shared<LoadedWorld>(load_world(plan.world));
  std::vector<polygon::Request> queries;
  for (const auto& [start, goal] : queries_of(command, world->planner.world()))
    queries.push_back({.start = start,
                       .goal = goal,
                       .target_gap = plan.target_gap,
                       .goal_tolerance = plan.goal_tolerance});
  PolygonTask task(plan, world);
  PolygonAnswer asked;
  asked.parameters = parameters;
  task.take(asked);
  const auto answer_all = [&](const BatchOptions& how, const Batch::Take& take) {
    polygon::Params mine = parameters;
    const auto receive = [&](const polygon::BatchAnswer& found) {
      mine.seed = found.seed;
      PolygonAnswer one = to_answer(mine, queries[found.index], found.result, found.elapsed);
      const Point start = one.start, goal = one.goal;
      task.set_index(found.index);
      task.set_seed(found.seed);
      task.take(std::move(one));
      take({to_text(start.x), to_text(start.y), to_text(goal.x), to_text(goal.y)}, task.path());
    };
    polygon::plan_batch(world->planner, queries, parameters, how, receive);
  };
  const auto draw = [&](const auto& picture, const auto& paths, const auto& caption) {
    write_paths_picture(picture, *world, paths, caption);
  };
  return run_batch({task, queries.size(), command.queries.empty(), answer_all, draw}, signals);
}

}  // namespace lasius::tool
