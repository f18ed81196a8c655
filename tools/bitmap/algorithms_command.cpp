#include <nlohmann/json.hpp>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "lasius/params.h"
#include "tools/bitmap/report.h"
#include "tools/commands.h"
#include "tools/console/exit_code.h"
#include "tools/console/parameters.h"
#include "tools/console/streams.h"
#ifdef LASIUS_WITH_ARM
#include "lasius/arm_plan.h"
#endif
#ifdef LASIUS_WITH_POLYGON
#include "lasius/polygon_plan.h"
#endif

namespace lasius::tool {
namespace {

/// The planners of one kind of world.
struct Group {
  std::string_view key;    ///< in the JSON
  std::string_view title;  ///< in the text, empty for maps
  std::span<const Algorithm> algorithms;
  std::string (*default_text)(const Algorithm&, std::string_view parameter);
};

std::vector<Group> groups() {
  std::vector<Group> all = {
      {"algorithms", "", algorithms(), [](const Algorithm& a, std::string_view parameter) {
         return get_parameter(defaults(a.name), parameter);
       }}};
#ifdef LASIUS_WITH_ARM
  all.push_back({"arm_algorithms", "Arms, see `lasius arm --help`", arm::algorithms(),
                 [](const Algorithm&, std::string_view parameter) {
                   return arm::get_parameter(arm::Params{}, parameter);
                 }});
#endif
#ifdef LASIUS_WITH_POLYGON
  all.push_back({"polygon_algorithms", "Polygon worlds, by `lasius plan WORLD.geojson`",
                 polygon::algorithms(), [](const Algorithm& a, std::string_view parameter) {
                   return polygon::get_parameter(polygon::defaults(a.name), parameter);
                 }});
#endif
  return all;
}

Json algorithm_json(const Group& group, const Algorithm& algorithm) {
  Json list = Json::array();
  for (const auto& parameter : algorithm.parameters) {
    Json entry = {{"name", parameter.name},
                  {"summary", parameter.summary},
                  {"default", parameter_json(group.default_text(algorithm, parameter.name))}};
    entry.update(range_json(parameter));
    list.push_back(entry);
  }
  return {{"name", algorithm.name},
          {"summary", algorithm.summary},
          {"source", algorithm.source},
          {"parameters", list}};
}

std::string algorithm_text(const Group& group, const Algorithm& algorithm) {
  constexpr std::size_t kColumn = 46;
  std::ostringstream text;
  text << algorithm.name << ": " << algorithm.summary << "\n  " << algorithm.source << "\n";
  for (const auto& parameter : algorithm.parameters) {
    std::ostringstream left;
    left << "  " << parameter.name << "=" << group.default_text(algorithm, parameter.name) << "  ["
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
  for (const Group& group : groups()) {
    if (!group.title.empty()) text.append("\n").append(group.title).append("\n");
    Json& list = json[std::string(group.key)] = Json::array();
    for (const Algorithm& algorithm : group.algorithms) {
      list.push_back(algorithm_json(group, algorithm));
      if (!text.empty()) text += '\n';
      text += algorithm_text(group, algorithm);
    }
  }
  print(command.json ? line(json) : text);
  return kFound;
}

}  // namespace lasius::tool
