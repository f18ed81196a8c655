#include "tools/polygon/polygon_verify.h"

#include "tools/console/parameters.h"
#include "tools/console/values.h"
#include "tools/polygon/polygon_report.h"
#include "tools/record/recorded.h"

namespace lasius::tool {
Json polygon_replay(const Json& result, const std::string& file, int threads,
                    const std::stop_token& token) {
  PolygonCommand command;
  command.world.file = file;
  command.world.repair = recorded<bool>(result, "parameters/repair");
  command.world.margin = recorded<double>(result, "parameters/margin");
  command.world.join = static_cast<int>(
      choice_value("join", recorded<std::string>(result, "parameters/join"), kJoins));
  command.start = recorded_point(result, "start");
  command.goal = recorded_point(result, "goal");
  command.algorithm = recorded<std::string>(result, "algorithm");
  command.seed = recorded_seed(result);
  command.threads = threads;
  command.target_gap = recorded<double>(result, "parameters/target_gap");
  command.time_limit = recorded_optional<double>(result, "parameters/time_limit");
  command.with_optimum = result.contains("optimum");
  for (const auto& algorithm : polygon::algorithms()) {
    if (algorithm.name != command.algorithm) continue;
    command.named = recorded_parameters(result, algorithm);
  }
  std::vector<std::string> notes;
  const auto parameters = polygon_parameters(command, notes);
  const PreparedWorld world = prepare_world(command.world);
  check_hash(file, world.hash, recorded<std::string>(result, "map/hash"),
             "name the world of that time with --map");
  return polygon_json(world, command, polygon_answer(world, command, parameters, {.token = token}));
}

}  // namespace lasius::tool
