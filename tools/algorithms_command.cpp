#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "commands.h"
#include "exit_code.h"
#include "lasius/params.h"
#include "parameters.h"
#include "report.h"
#include "streams.h"
#ifdef LASIUS_WITH_ARM
#include "lasius/arm_plan.h"
#endif

namespace lasius::tool {
namespace {

/// The planners of every kind that this program has.
std::vector<Algorithm> all_algorithms() {
  std::vector<Algorithm> list(algorithms().begin(), algorithms().end());
#ifdef LASIUS_WITH_ARM
  list.insert(list.end(), arm::algorithms().begin(), arm::algorithms().end());
#endif
  return list;
}

std::string default_text(const Algorithm& algorithm, std::string_view parameter) {
#ifdef LASIUS_WITH_ARM
  for (const Algorithm& known : arm::algorithms())
    if (known.name == algorithm.name) return arm::get_parameter(arm::Parameters{}, parameter);
#endif
  return get_parameter(defaults(algorithm.name), parameter);
}

Json algorithm_json(const Algorithm& algorithm) {
  Json list = Json::array();
  for (const auto& parameter : algorithm.parameters) {
    Json entry = {{"name", parameter.name},
                  {"summary", parameter.summary},
                  {"default", parameter_json(default_text(algorithm, parameter.name))}};
    entry.update(range_json(parameter));
    list.push_back(entry);
  }
  return {{"name", algorithm.name},
          {"summary", algorithm.summary},
          {"source", algorithm.source},
          {"parameters", list}};
}

std::string algorithm_text(const Algorithm& algorithm) {
  constexpr std::size_t kColumn = 46;
  std::ostringstream text;
  text << algorithm.name << ": " << algorithm.summary << "\n  " << algorithm.source << "\n";
  for (const auto& parameter : algorithm.parameters) {
    std::ostringstream left;
    left << "  " << parameter.name << "=" << default_text(algorithm, parameter.name) << "  ["
         << parameter.range << "]";
    const auto width = left.str().size();
    text << left.str() << std::string(width + 2 > kColumn ? 2 : kColumn - width, ' ')
         << parameter.summary << "\n";
  }
  return text.str();
}

}  // namespace

int run_algorithms(const AlgorithmsCommand& command) {
  if (command.json) {
    Json list = Json::array();
    for (const auto& algorithm : all_algorithms()) list.push_back(algorithm_json(algorithm));
    print(line({{"format", "lasius-algorithms/1"}, {"algorithms", list}}));
    return kFound;
  }
  std::string text;
  for (const auto& algorithm : all_algorithms()) {
    if (!text.empty()) text += '\n';
    text += algorithm_text(algorithm);
  }
  print(text);
  return kFound;
}

}  // namespace lasius::tool
