#include "tools/polygon/polygon_answer.h"

#include <algorithm>

#include "lasius/base/error.h"
#include "tools/console/elapsed.h"
#include "tools/console/parameters.h"
#include "tools/console/values.h"
#include "tools/record/recorded.h"

namespace lasius::tool {
namespace {

static_assert(WorldOptions::kMostMargin == polygon::GrowOptions::kMostMargin);
static_assert(kJoins == polygon::kJoinNames && kBoundaries == polygon::kBoundaryNames);

}  // namespace

Point LoadedWorld::low() const {
  Point p = planner.world().boundary.outer.front();
  for (const Point q : planner.world().boundary.outer) p = {std::min(p.x, q.x), std::min(p.y, q.y)};
  return p;
}

Point LoadedWorld::high() const {
  Point p = planner.world().boundary.outer.front();
  for (const Point q : planner.world().boundary.outer) p = {std::max(p.x, q.x), std::max(p.y, q.y)};
  return p;
}

LoadedWorld load_world(const WorldOptions& options) {
  const auto start = Clock::now();
  const polygon::World world = polygon::read_world(options.file, {.repair = options.repair});
  const double read_ms = ms_since(start);
  const auto ready_start = Clock::now();
  const auto make = [&] {
    try {
      return polygon::Planner(world,
                              {.margin = options.margin,
                               .join = static_cast<polygon::Join>(options.join),
                               .boundary = static_cast<polygon::Boundary>(options.boundary)});
    } catch (const Error& fault) {
      throw Error(ErrorCode::file_broken, {.file = options.file}, fault.problem(), fault.remedy());
    }
  };
  polygon::Planner planner = make();
  return {.options = options,
          .hash = polygon::hash(world),
          .planner = std::move(planner),
          .read_ms = read_ms,
          .ready_ms = ms_since(ready_start)};
}

std::string polygon_title(const LoadedWorld& world, const polygon::Params& parameters) {
  return parameters.algorithm() + " on " + file_name(world.options.file) + ", seed " +
         std::to_string(parameters.seed);
}

PolygonAnswer to_answer(const polygon::Params& parameters, const polygon::Request& asked,
                        polygon::Result result, std::chrono::duration<double, std::milli> elapsed) {
  const std::chrono::duration<double, std::milli> beside = result.optimum_time;
  return {.parameters = parameters,
          .start = *asked.start,
          .goal = *asked.goal,
          .result = std::move(result),
          .elapsed_ms = std::max(0.0, (elapsed - beside).count())};
}

PolygonAnswer polygon_answer(const LoadedWorld& world, const PolygonCommand& command,
                             const polygon::Params& parameters, const StopCondition& stop,
                             const polygon::Observer& observer) {
  const polygon::Request asked{.start = command.start ? command.start : world.planner.world().start,
                               .goal = command.goal ? command.goal : world.planner.world().goal,
                               .stop = stop,
                               .target_gap = command.target_gap,
                               .goal_tolerance = command.goal_tolerance};
  const auto begin = Clock::now();
  polygon::Result result = world.planner.plan(asked, parameters, observer);
  return to_answer(parameters, asked, std::move(result), Clock::now() - begin);
}

void note_world(const LoadedWorld& world, const Algorithm& algorithm, SearchOptions& options) {
  const std::string& file = world.options.file;
  for (const auto& note : world.planner.world().notes) options.notes.push_back(file + ": " + note);
  if (!options.messages.verbose) return;
  const polygon::Maklink& graph = world.planner.maklink();
  options.notes.push_back(
      file + ": " + counted(world.planner.world().obstacles.size(), "obstacle") + ", " +
      counted(graph.lines.size(), "line") + ", " + counted(graph.regions.size(), "region") +
      printed(", hash %s, read in %.1f ms, ready after %.1f ms", hash_text(world.hash).c_str(),
              world.read_ms, world.ready_ms));
  options.notes.push_back(algorithm_text(options, algorithm, false));
}

Json inputs_json(const LoadedWorld& world) {
  const Point low = world.low(), high = world.high();
  return {{"map",
           {{"file", world.options.file},
            {"hash", hash_text(world.hash)},
            {"width", number(high.x - low.x)},
            {"height", number(high.y - low.y)}}}};
}

Json parameters_of(const LoadedWorld& world, const SearchOptions& options,
                   const Algorithm& algorithm) {
  Json json = parameters_json(algorithm, options);
  add_limits(json, options);
  json["margin"] = number(world.planner.margin());
  const WorldOptions& made = world.options;
  json["join"] = kJoins[made.join];
  json["boundary"] = kBoundaries[made.boundary];
  json["repair"] = made.repair;
  if (options.goal_tolerance > 0) json["goal_tolerance"] = number(options.goal_tolerance);
  return json;
}

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
  world.boundary = choice("boundary", kBoundaries);
  return world;
}

}  // namespace lasius::tool
