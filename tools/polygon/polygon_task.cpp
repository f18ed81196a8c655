#include "tools/polygon/polygon_task.h"

#include <nlohmann/json.hpp>
#include <ostream>

#include "tools/console/exit_code.h"
#include "tools/console/streams.h"
#include "tools/console/values.h"
#include "tools/console/worlds.h"
#include "tools/options/commands.h"
#include "tools/polygon/polygon_answer.h"
#include "tools/polygon/polygon_picture.h"
#include "tools/record/recorded.h"

namespace lasius::tool {
namespace {

Json crossing_length(const std::optional<polygon::Crossing>& crossing) {
  return crossing ? number(crossing->length) : Json(nullptr);
}

/// `plan` on a polygon world.
class PolygonTask : public Task {
 public:
  explicit PolygonTask(PolygonCommand command) : command_(std::move(command)) {}

  void open() override {
    answer_.parameters = polygon_parameters(command_, command_.notes);
    world_ = load_world(command_.world);
    const polygon::World& world = world_->planner.world();
    check_end("start", command_.start || world.start);
    check_end("goal", command_.goal || world.goal);
  }
  void announce() const override {
    Task::announce();
    if (!options().messages.verbose) return;
    const polygon::Maklink& graph = world_->planner.maklink();
    message(world_->file +
            printed(": %zu obstacles, %zu lines, %zu regions, hash %s, read in %.1f ms, ready "
                    "after %.1f ms",
                    world_->planner.world().obstacles.size(), graph.lines.size(),
                    graph.regions.size(), hash_text(world_->hash).c_str(), world_->read_ms,
                    world_->ready_ms));
    announce_algorithm(false);
  }
  void plan(const StopCondition& stop, const Watch& watch) override {
    answer_ = polygon_answer(*world_, command_, answer_.parameters, stop, watch);
  }

  const SearchOptions& options() const override { return command_; }
  std::vector<std::string> input_files() const override { return {command_.world.file}; }
  const Algorithm& algorithm() const override {
    return polygon::find_algorithm(answer_.parameters.algorithm());
  }
  std::string parameter(std::string_view name) const override {
    return get_parameter(answer_.parameters, name);
  }
  std::int64_t iterations() const override {
    return std::int64_t{answer_.parameters.iterations} * answer_.parameters.routes;
  }

  const SearchResult& result() const override { return answer_.result; }
  std::optional<double> optimum() const override { return answer_.optimum; }
  double elapsed_ms() const override { return answer_.elapsed_ms; }

  void write_path(std::ostream& out, const char* between) const override {
    for (const Point p : answer_.result.path)
      out << to_text(p.x) << between << to_text(p.y) << "\n";
  }
  void write_picture(const std::string& file) const override {
    write_polygon_picture(file, *world_, answer_);
  }

  Json inputs() const override {
    const Point low = world_->low(), high = world_->high();
    return {{"map",
             {{"file", world_->file},
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
    json["join"] = kJoins[static_cast<std::size_t>(world_->planner.join())];
    json["repair"] = world_->repair;
  }
  void add_path(Json& json) const override { json["path"] = points(answer_.result.path); }
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
  }

 private:
  void check_end(const std::string& role, bool given) const {
    if (!given)
      throw UsageError("--" + role + " is required: " + world_->file +
                       " has no feature with the role " + role);
  }

  PolygonCommand command_;
  std::optional<LoadedWorld> world_;
  PolygonAnswer answer_;
};

}  // namespace

std::unique_ptr<Task> recorded_polygon(const Recorded& from) {
  const Json& result = from.result;
  PolygonCommand command;
  const auto name = recorded<std::string>(result, "algorithm");
  const auto known = algorithm_of(World::Kind::polygon, name);
  read_recorded(from, polygon::find_algorithm(known), command);
  command.world.file = from.found(recorded<std::string>(result, "map/file"));
  command.world.repair = recorded<bool>(result, "parameters/repair");
  command.world.margin = recorded<double>(result, "parameters/margin");
  command.world.join = static_cast<int>(
      choice_value("join", recorded<std::string>(result, "parameters/join"), kJoins));
  command.start = recorded_point(result, "start");
  command.goal = recorded_point(result, "goal");
  return std::make_unique<PolygonTask>(std::move(command));
}

int run_polygon(const PolygonCommand& command) {
  PolygonTask task(command);
  return run(task);
}

}  // namespace lasius::tool
