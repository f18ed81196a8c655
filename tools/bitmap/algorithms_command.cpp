#include <nlohmann/json.hpp>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "tools/console/exit_code.h"
#include "tools/console/streams.h"
#include "tools/console/values.h"
#include "tools/console/worlds.h"
#include "tools/options/commands.h"
#include "tools/record/json_values.h"

namespace lasius::tool {
namespace {

Json algorithm_json(const World& world, const Algorithm& algorithm) {
  Json list = Json::array();
  for (const auto& parameter : algorithm.parameters) {
    Json entry = {{"name", parameter.name},
                  {"summary", parameter.summary},
                  {"default", json::parameter(world.default_text(algorithm, parameter.name))}};
    entry.update(range_json(parameter));
    list.push_back(entry);
  }
  return {{"name", algorithm.name},
          {"summary", algorithm.summary},
          {"source", algorithm.source},
          {"parameters", list}};
}

std::string algorithm_text(const World& world, const Algorithm& algorithm) {
  constexpr std::size_t kColumn = 46;
  std::ostringstream text;
  text << algorithm.name << ": " << algorithm.summary << "\n  " << algorithm.source << "\n";
  for (const auto& parameter : algorithm.parameters) {
    std::ostringstream left;
    left << "  " << parameter.name << "=" << world.default_text(algorithm, parameter.name) << "  ["
         << parameter.range << "]";
    const auto width = left.str().size();
    text << left.str() << std::string(width + 2 > kColumn ? 2 : kColumn - width, ' ')
         << parameter.summary << "\n";
  }
  return text.str();
}

}  // namespace

int run_algorithms(const AlgorithmsCommand& command) {
  Json json = {{"format", "lasius-algorithms/1"}};
  std::string text;
  if (!command.name.empty()) {
    std::vector<std::string_view> names;
    for (const World& world : worlds())
      for (const Algorithm& algorithm : world.algorithms) names.push_back(algorithm.name);
    (void)choice_value("ALGORITHM", command.name, names);
  }
  for (const World& world : worlds()) {
    if (!world.title.empty() && command.name.empty())
      text.append("\n").append(world.title).append("\n");
    Json& list = json[std::string(world.key)] = Json::array();
    for (const Algorithm& algorithm : world.algorithms) {
      if (!command.name.empty() && algorithm.name != command.name) continue;
      list.push_back(algorithm_json(world, algorithm));
      if (!text.empty()) text += '\n';
      text += algorithm_text(world, algorithm);
    }
  }
  print(command.json ? line(json) : text);
  return kFound;
}

}  // namespace lasius::tool
