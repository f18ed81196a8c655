#include <nlohmann/json.hpp>
#include <sstream>

#include "commands.h"
#include "exit_code.h"
#include "lasius/params.h"
#include "parameters.h"
#include "report.h"
#include "streams.h"

namespace lasius::tool {
namespace {

Json algorithm_json(const Algorithm& algorithm) {
  const Params params = defaults(algorithm.name);
  Json list = Json::array();
  for (const auto& parameter : algorithm.parameters) {
    Json entry = {{"name", parameter.name},
                  {"summary", parameter.summary},
                  {"default", parameter_json(get_parameter(params, parameter.name))}};
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
  const Params params = defaults(algorithm.name);
  std::ostringstream text;
  text << algorithm.name << ": " << algorithm.summary << "\n  " << algorithm.source << "\n";
  for (const auto& parameter : algorithm.parameters) {
    std::ostringstream left;
    left << "  " << parameter.name << "=" << get_parameter(params, parameter.name) << "  ["
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
    for (const auto& algorithm : algorithms()) list.push_back(algorithm_json(algorithm));
    print(line({{"format", "lasius-algorithms/1"}, {"algorithms", list}}));
    return kFound;
  }
  std::string text;
  for (const auto& algorithm : algorithms()) {
    if (!text.empty()) text += '\n';
    text += algorithm_text(algorithm);
  }
  print(text);
  return kFound;
}

}  // namespace lasius::tool
