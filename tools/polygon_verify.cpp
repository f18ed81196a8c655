#include "polygon_verify.h"

#include <nlohmann/json.hpp>

#include "parameters.h"
#include "polygon_report.h"
#include "values.h"

namespace lasius::tool {
namespace {

Point point_of(const Json& json) { return {json.at(0).get<double>(), json.at(1).get<double>()}; }

}  // namespace

Json polygon_replay(const Json& recorded, const std::string& file, int threads,
                    const std::stop_token& token) {
  const Json& settings = recorded.at("parameters");
  PolygonCommand command;
  command.world.file = file;
  command.world.repair = settings.at("repair").get<bool>();
  command.world.margin = settings.at("margin").get<double>();
  command.world.join =
      static_cast<int>(choice_value("join", settings.at("join").get<std::string>(), kJoins));
  command.start = point_of(recorded.at("start"));
  command.goal = point_of(recorded.at("goal"));
  command.algorithm = recorded.at("algorithm").get<std::string>();
  command.seed = recorded.at("seed").get<std::uint64_t>();
  command.threads = threads;
  command.target_gap = settings.at("target_gap").get<double>();
  if (!settings.at("time_limit").is_null())
    command.time_limit = settings.at("time_limit").get<double>();
  command.with_optimum = recorded.contains("optimum");
  for (const auto& algorithm : polygon::algorithms()) {
    if (algorithm.name != command.algorithm) continue;
    for (const auto& parameter : algorithm.parameters) {
      const std::string name(parameter.name);
      command.settings.push_back(name + "=" + parameter_text(settings.at(name)));
    }
  }
  std::vector<std::string> notes;
  const auto parameters = polygon_parameters(command, notes);
  const PreparedWorld world = prepare_world(command.world);
  check_hash(file, world.hash, recorded.at("map").at("hash").get<std::string>(),
             "name the world of that time with --map");
  return polygon_json(world, command, polygon_answer(world, command, parameters, {.token = token}));
}

}  // namespace lasius::tool
