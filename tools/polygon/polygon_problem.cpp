#include <algorithm>
#include <cmath>
#include <utility>

#include "tools/console/exit_code.h"
#include "tools/console/parameters.h"
#include "tools/console/signals.h"
#include "tools/console/values.h"
#include "tools/options/commands.h"
#include "tools/polygon/polygon_answer.h"
#include "tools/polygon/polygon_kind.h"
#include "tools/polygon/polygon_picture.h"
#include "tools/polygon/polygon_report.h"
#include "tools/record/batch.h"
#include "tools/record/outputs.h"
#include "tools/record/problem.h"
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

using SharedWorld = std::shared_ptr<const LoadedWorld>;

std::int64_t iterations_in(const polygon::Params& params) {
  return std::int64_t{iterations_of(params)} * params.routes;
}

/// What the graph gave: sizes, the lines crossed, and the optima that bound the path.
Json findings_of(const LoadedWorld& world, const polygon::Result& found) {
  const polygon::Maklink& graph = world.planner.maklink();
  return {{"maklink",
           {{"lines", graph.lines.size()},
            {"regions", graph.regions.size()},
            {"crossed", found.crossing.lines},
            {"values", numbers(found.crossing.values)},
            {"dijkstra_length", crossing_length(found.dijkstra)},
            {"dijkstra_path", found.dijkstra ? points(found.dijkstra->path) : Json(nullptr)},
            {"discrete_optimum", crossing_length(found.discrete_optimum)},
            {"sequence_optimum", crossing_length(found.sequence_optimum)}}},
          {"note", text_or_null(found.note)}};
}

/// An answer as its result tells it.
Record polygon_record(const LoadedWorld& world, const SearchOptions& options,
                      const PolygonAnswer& answer) {
  const polygon::Params& params = answer.parameters;
  const polygon::Result& found = answer.result;
  const Algorithm& algorithm = polygon::find_algorithm(params.algorithm());
  Record record{.options = options,
                .algorithm = algorithm,
                .most_iterations = most_iterations(algorithm, iterations_in(params)),
                .inputs = inputs_json(world),
                .start = point(answer.start),
                .goal = point(answer.goal),
                .parameters = parameters_of(world, options, algorithm),
                .result = found,
                .optimum = found.optimum,
                .elapsed_ms = answer.elapsed_ms,
                .path = coordinates(found.path)};
  Json path = Json::object();
  const auto& end = found.goal_reached;
  if (options.goal_tolerance > 0) path["goal_reached"] = end ? point(*end) : Json();
  path["path"] = points(found.path);
  record.answer = answer_json(record, std::move(path), Json::object(), findings_of(world, found));
  if (!found.note.empty()) record.remarks.push_back(found.note);
  if (!options.json && end && *end != answer.goal)
    record.remarks.push_back("the path ends at (" + to_text(end->x) + ", " + to_text(end->y) +
                             "), " +
                             to_text(std::hypot(end->x - answer.goal.x, end->y - answer.goal.y)) +
                             " from the goal, which cannot be reached");
  return record;
}

/// `plan` on a polygon world.
class PolygonProblem : public ProblemOf<PolygonCommand> {
 public:
  /// `world` may be given, made of what the command says; else it is read.
  explicit PolygonProblem(PolygonCommand command, SharedWorld world = {})
      : ProblemOf(std::move(command)), world_(std::move(world)) {}

  std::optional<std::int64_t> read(const std::stop_token&) override {
    const EndAtOnce unpolled;
    answer_.parameters = make_params<polygon::Params>(command_, polygon_kind());
    if (!world_) world_ = std::make_shared<LoadedWorld>(load_world(command_.world));
    check_ends(command_, world_->planner.world());
    const Algorithm& algorithm = polygon::find_algorithm(answer_.parameters.algorithm());
    note_world(*world_, algorithm, command_);
    return most_iterations(algorithm, iterations_in(answer_.parameters));
  }
  void plan(const StopCondition& stop, const Watch& watch) override {
    if (std::ranges::any_of(command_.outputs, is_page)) frames_.emplace();
    polygon::Observer observer;
    if (watch || frames_)
      observer = [&](const polygon::PlanProgress& progress) {
        if (watch) watch(progress.iteration + 1, best_text(progress.best_length, ""));
        if (frames_) frames_->observe(progress);
      };
    answer_ = polygon_answer(*world_, command_, answer_.parameters, stop, observer);
  }
  Record record() const override { return polygon_record(*world_, command_, answer_); }
  Forms show(const Record& run) const override {
    return {.picture = [&](auto& file) { write_polygon_picture(file, *world_, answer_); },
            .page =
                [&](auto& out) {
                  write_polygon_report(out, run, *world_, answer_, frames_ ? &*frames_ : nullptr);
                }};
  }

  const SharedWorld& world() const { return world_; }

 private:
  SharedWorld world_;
  std::optional<PolygonFrames> frames_;
  PolygonAnswer answer_;
};

/// The command's queries: a file's, or its own one.
QueryFile queries_of(const PolygonCommand& command, const polygon::World& world) {
  if (!command.queries.empty()) return read_table(command.queries);
  check_ends(command, world);
  return {.queries = {{.start = {command.start ? *command.start : *world.start},
                       .goal = {command.goal ? *command.goal : *world.goal}}}};
}

std::unique_ptr<Problem> polygon_again(const Recorded& from, const Problem* last) {
  const Json& result = from.result;
  PolygonCommand command;
  const auto known = algorithm_of(polygon_kind(), recorded<std::string>(result, "algorithm"));
  read_recorded(from, polygon::find_algorithm(known), command);
  command.world = recorded_world(from);
  command.start = recorded_point(result, "start");
  command.goal = recorded_point(result, "goal");
  const auto* before = dynamic_cast<const PolygonProblem*>(last);
  const bool same = before != nullptr && before->world()->options == command.world;
  return std::make_unique<PolygonProblem>(std::move(command), same ? before->world() : nullptr);
}

/// `batch`, and `plan` with several seeds.
int run_polygon_batch(PolygonCommand plan) {
  check_files(plan);
  SignalWatcher signals;
  Delivery delivery(plan.outputs);
  auto parameters = make_params<polygon::Params>(plan, polygon_kind());
  const LoadedWorld world = load_world(plan.world);
  note_world(world, polygon::find_algorithm(parameters.algorithm()), plan);
  std::vector<polygon::Request> queries;
  QueryFile file = queries_of(plan, world.planner.world());
  note_yaws(file.yaws, plan.queries, plan);
  keep_part(file.queries, plan.queries, plan.part);
  for (const auto& [start, goal] : file.queries)
    queries.push_back({.start = start,
                       .goal = goal,
                       .target_gap = plan.target_gap,
                       .goal_tolerance = plan.goal_tolerance});
  const auto answer_all = [&](const Batch::Part& part, const BatchOptions& how,
                              const Batch::Take& take) {
    const auto asked = std::span<const polygon::Request>(queries).subspan(part.first, part.count);
    parameters.seed = part.seed;
    const auto receive = [&](const polygon::BatchAnswer& found) {
      const auto one = to_answer(parameters, asked[found.index], found.result, found.elapsed);
      Record record = polygon_record(world, plan, one);
      record.index = plan.part.among_all(part.first + found.index);
      record.seed = found.seed;
      const auto [start, goal] = std::pair(one.start, one.goal);
      take(std::move(record),
           {to_text(start.x), to_text(start.y), to_text(goal.x), to_text(goal.y)}, one.result.path);
    };
    polygon::plan_batch(world.planner, asked, parameters, how, receive);
  };
  const auto draw = [&](const auto& picture, const auto& paths, const auto& caption) {
    write_paths_picture(picture, world, paths, caption);
  };
  return run_batch({.options = plan,
                    .unit = "",
                    .queries = queries.size(),
                    .is_plan = plan.queries.empty(),
                    .answer = answer_all,
                    .draw = draw},
                   signals, delivery);
}

}  // namespace

const ProblemKind& polygon_kind() {
  static const ProblemKind kKind{
      .key = "polygon_algorithms",
      .title = "Polygon worlds, by `lasius plan WORLD.geojson`",
      .plans = "among polygons",
      .detail = " (.geojson, .json, .wkt)",
      .commands = {"plan", "batch"},
      .takes = is_polygon_file,
      .algorithms = polygon::algorithms(),
      .default_text = default_text<polygon::Params>,
      .formulas = formulas_of<polygon::Params>,
      .format = kPlanFormat,
      .wrote =
          [](const Json& json) { return is_polygon_file(recorded<std::string>(json, "map/file")); },
      .again = polygon_again};
  return kKind;
}

int run_command(const PolygonCommand& command) {
  if (command.ranged || !command.queries.empty()) return run_polygon_batch(command);
  PolygonProblem problem(command);
  return run(problem);
}

}  // namespace lasius::tool
