// What a shell may write for an option or an argument.
#include <algorithm>
#include <cctype>
#include <map>
#include <span>
#include <utility>

#include "tools/command_line/notes.h"
#include "tools/command_line/run_text.h"
#include "tools/console/kinds.h"
#include "tools/console/values.h"

namespace lasius::tool {
namespace {

std::vector<std::string> texts(std::span<const std::string_view> words) {
  return {words.begin(), words.end()};
}

Values files(std::vector<std::string> endings) {
  return {.files = true, .endings = std::move(endings)};
}

/// Files that a bitmap is read from, and those of polygon worlds.
std::vector<std::string> map_endings(bool with_worlds) {
  std::vector<std::string> all{".map", ".pbm", ".pgm", ".png", ".yaml", ".yml"};
  if (with_worlds) all.insert(all.end(), kWorldEndings.begin(), kWorldEndings.end());
  return all;
}

using OptionKey = std::pair<std::string_view, std::string_view>;

std::map<OptionKey, Values> make_values() {
  using enum Values::Names;
  std::map<OptionKey, Values> values;
  for (const auto* command : {"plan", "batch", "info"})
    values[{command, "MAP"}] = files(map_endings(true));
  for (const auto* option : {"MAP", "--world"})
    values[{"drive", option}] = files(map_endings(false));
  values[{"plan", "--output"}] = files(texts(kPlanEndings));
  values[{"batch", "--output"}] = files(texts(kResultEndings));
  values[{"drive", "--output"}] = files(texts(kDriveEndings));
  values[{"arm", "--output"}] = files(texts(kArmEndings));
  values[{"generate", "--output"}] = files(texts(kMapOutputEndings));
  values[{"batch", "QUERIES"}] = files({".scen", ".tsv", ".txt"});
  values[{"verify", "RESULT"}] = files({".json", ".jsonl", ".ndjson"});
  values[{"verify", "--map"}] = files(map_endings(true));
  values[{"arm", "ROBOT"}] = files({".urdf", ".json"});
  values[{"arm", "--scene"}] = files({".json"});
  values[{"arm", "--srdf"}] = files({".srdf"});
  values[{"arm", "--joint-limits"}] = files({".yaml", ".yml"});
  values[{"algorithms", "NAME"}] = {.names = algorithms};
  const std::vector<std::string> documents{".yaml", ".yml", ".json"};
  values[{"study", "NAME"}] = {
      .choices = {"list", "all", "run"}, .files = true, .endings = documents, .names = studies};
  values[{"tune", "FILE"}] = files(documents);
  for (const auto* command : {"plan", "batch", "drive", "study"})
    values[{command, "--preset"}] = {
        .choices = texts(kPresetNames), .files = true, .endings = documents};
  values[{"help", "TOPIC"}] = {.names = topics};
  return values;
}

bool is_choice(std::string_view word) {
  return !word.empty() && std::ranges::none_of(word, [](unsigned char c) {
    return std::isupper(c) != 0 || c == ',' || c == '.';
  });
}

}  // namespace

Values values_of(std::string_view command, std::string_view name, std::string_view value) {
  static const auto kValues = make_values();
  if (const auto known = kValues.find({command, name}); known != kValues.end())
    return known->second;
  if (name == "--algorithm")
    return {.names = Values::Names::algorithms, .list = value.find(',') != value.npos};
  if (name == "--set") return {.names = Values::Names::parameters};
  Values values;
  for (const auto word : split(value, '|')) {
    if (word == "FILE") values.files = true;
    if (word == "DIR") values.folders = true;
    if (is_choice(word)) values.choices.emplace_back(word);
  }
  return values;
}

}  // namespace lasius::tool
