#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tools/console/exit_code.h"
#include "tools/console/streams.h"
#include "tools/console/values.h"
#include "tools/console/worlds.h"
#include "tools/options/commands.h"
#include "tools/record/json_values.h"

namespace lasius::tool {
namespace {

/// Names and values of the textbook's parameters that are not the usual ones; empty where the
/// algorithm has none.
std::vector<std::pair<std::string_view, std::string>> book_values(const World& world,
                                                                  const Algorithm& algorithm) {
  std::vector<std::pair<std::string_view, std::string>> values;
  if (world.kind != World::Kind::bitmap || !has_preset(algorithm.name, Preset::book)) return values;
  const Params usual(algorithm.name), book(algorithm.name, Preset::book);
  for (const auto& parameter : algorithm.parameters) {
    auto value = get_parameter(book, parameter.name);
    if (value != get_parameter(usual, parameter.name))
      values.emplace_back(parameter.name, std::move(value));
  }
  return values;
}

Json algorithm_json(const World& world, const Algorithm& algorithm) {
  Json list = Json::array();
  for (const auto& parameter : algorithm.parameters) {
    Json entry = {{"name", parameter.name},
                  {"summary", parameter.summary},
                  {"default", json::parameter(world.default_text(algorithm, parameter.name))}};
    entry.update(range_json(parameter));
    if (!parameter.only_with.empty()) entry["only_with"] = parameter.only_with;
    list.push_back(entry);
  }
  Json json = {{"name", algorithm.name},
               {"summary", algorithm.summary},
               {"source", algorithm.source},
               {"formulas", world.formulas(algorithm)},
               {"parameters", list}};
  for (const auto& [name, value] : book_values(world, algorithm))
    json["presets"]["book"][std::string(name)] = json::parameter(value);
  return json;
}

std::string algorithm_text(const World& world, const Algorithm& algorithm) {
  constexpr std::size_t kColumn = 46;
  std::ostringstream text;
  text << algorithm.name << ": " << algorithm.summary << "\n  " << algorithm.source << "\n";
  for (const std::string& formula : world.formulas(algorithm)) text << "  " << formula << "\n";
  if (const auto book = book_values(world, algorithm); !book.empty()) {
    text << "  --preset book:";
    for (const auto& [name, value] : book) text << ' ' << name << '=' << value;
    text << "\n";
  }
  for (const auto& parameter : algorithm.parameters) {
    std::ostringstream left;
    left << "  " << parameter.name << "=" << world.default_text(algorithm, parameter.name) << "  ["
         << parameter.range() << "]";
    const auto width = left.str().size();
    text << left.str() << std::string(width + 2 > kColumn ? 2 : kColumn - width, ' ')
         << parameter.summary;
    if (!parameter.only_with.empty()) text << " (" << parameter.only_with << ")";
    text << "\n";
  }
  return text.str();
}

/// @throws UsageError with the nearest name.
void check_known(const std::string& name) {
  std::vector<std::string_view> known;
  for (const World& world : worlds())
    for (const Algorithm& algorithm : world.algorithms)
      if (std::ranges::find(known, algorithm.name) == known.end()) known.push_back(algorithm.name);
  choice_value("algorithms", name, known);
}

}  // namespace

int run_command(const AlgorithmsCommand& command) {
  Json json = {{"format", "lasius-algorithms/1"}};
  std::string text;
  if (!command.name.empty()) check_known(command.name);
  for (const World& world : worlds()) {
    const auto asked = [&](const Algorithm& a) {
      return command.name.empty() || a.name == command.name;
    };
    if (std::ranges::none_of(world.algorithms, asked)) continue;
    if (!world.title.empty())
      text.append(text.empty() ? "" : "\n").append(world.title).append("\n");
    Json& list = json[std::string(world.key)] = Json::array();
    for (const Algorithm& algorithm : world.algorithms) {
      if (!asked(algorithm)) continue;
      list.push_back(algorithm_json(world, algorithm));
      if (!text.empty()) text += '\n';
      text += algorithm_text(world, algorithm);
    }
  }
  print(command.json ? line(json) : text);
  return kFound;
}

}  // namespace lasius::tool
