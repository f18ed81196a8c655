#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tools/command_line/option_table.h"
#include "tools/console/exit_code.h"
#include "tools/console/kinds.h"
#include "tools/console/streams.h"
#include "tools/console/values.h"
#include "tools/record/json_values.h"

namespace lasius::tool {
namespace {

/// Names and values of the textbook's parameters that are not the usual ones; empty where the
/// algorithm has none.
std::vector<std::pair<std::string_view, std::string>> book_values(const ProblemKind& kind,
                                                                  const Algorithm& algorithm) {
  std::vector<std::pair<std::string_view, std::string>> values;
  for (const auto& parameter : algorithm.parameters) {
    auto value = kind.default_text(algorithm, parameter.name, Preset::book);
    if (value != kind.default_text(algorithm, parameter.name, Preset::usual))
      values.emplace_back(parameter.name, std::move(value));
  }
  return values;
}

Json algorithm_json(const ProblemKind& kind, const Algorithm& algorithm) {
  Json list = Json::array();
  for (const auto& parameter : algorithm.parameters) {
    Json entry = {
        {"name", parameter.name},
        {"summary", parameter.summary},
        {"default", json::parameter(kind.default_text(algorithm, parameter.name, Preset::usual))}};
    entry.update(range_json(parameter));
    if (!parameter.only_with.empty()) entry["only_with"] = parameter.only_with;
    list.push_back(entry);
  }
  Json json = {{"name", algorithm.name},
               {"summary", algorithm.summary},
               {"source", algorithm.source},
               {"formulas", kind.formulas(algorithm)},
               {"parameters", list}};
  for (const auto& [name, value] : book_values(kind, algorithm))
    json["presets"]["book"][std::string(name)] = json::parameter(value);
  return json;
}

std::string algorithm_text(const ProblemKind& kind, const Algorithm& algorithm) {
  constexpr std::size_t kColumn = 46;
  std::ostringstream text;
  text << algorithm.name << ": " << algorithm.summary << "\n  " << algorithm.source << "\n";
  for (const std::string& formula : kind.formulas(algorithm)) text << "  " << formula << "\n";
  if (const auto book = book_values(kind, algorithm); !book.empty()) {
    text << "  --preset book:";
    for (const auto& [name, value] : book) text << ' ' << name << '=' << value;
    text << "\n";
  }
  for (const auto& parameter : algorithm.parameters) {
    std::ostringstream left;
    left << "  " << parameter.name << "="
         << kind.default_text(algorithm, parameter.name, Preset::usual) << "  ["
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
  for (const ProblemKind* kind : kinds())
    for (const Algorithm& algorithm : kind->algorithms)
      if (std::ranges::find(known, algorithm.name) == known.end()) known.push_back(algorithm.name);
  choice_value("algorithms", name, known);
}

/// Lists the one of a name, or all.
int list_algorithms(const std::string& name, bool as_json) {
  Json json = {{"format", "lasius-algorithms/1"}};
  std::string text;
  if (!name.empty()) check_known(name);
  for (const ProblemKind* kind : kinds()) {
    const auto asked = [&](const Algorithm& a) { return name.empty() || a.name == name; };
    if (std::ranges::none_of(kind->algorithms, asked)) continue;
    if (!kind->title.empty())
      text.append(text.empty() ? "" : "\n").append(kind->title).append("\n");
    Json& list = json[std::string(kind->key)] = Json::array();
    for (const Algorithm& algorithm : kind->algorithms) {
      if (!asked(algorithm)) continue;
      list.push_back(algorithm_json(*kind, algorithm));
      if (!text.empty()) text += '\n';
      text += algorithm_text(*kind, algorithm);
    }
  }
  print(as_json ? line(json) : text);
  return kFound;
}

}  // namespace

Subcommand add_algorithms(CLI::App& app) {
  struct Asked {
    std::string name;
    bool json = false;
  };
  auto to = std::make_shared<Asked>();
  OptionTable table(app, "algorithms", "List the algorithms, their formulas and parameters");
  table.shell(table.text("NAME", to->name, "Only this one", "NAME"),
              {.names = Values::Names::algorithms});
  table.flag("--json", to->json, "Print one JSON object");
  return table.command(
      {.examples = {{"lasius algorithms mmas", "formulas and parameters of one algorithm"}}},
      [to](const Call&) { return list_algorithms(to->name, to->json); });
}

}  // namespace lasius::tool
