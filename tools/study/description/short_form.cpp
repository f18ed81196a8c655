#include "tools/study/description/short_form.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/io/json_values.h"
#include "tools/console/exit_code.h"
#include "tools/console/values.h"
#include "tools/study/map_source.h"
#include "tools/yaml/document.h"

namespace lasius::study {
namespace {

namespace fs = std::filesystem;
using json::Json;

/// A file's absolute path: found from the study's folder, too.
std::string absolute(const std::string& file) {
  return fs::absolute(file).lexically_normal().string();
}

Json contender_json(const tool::ShortStudy& run, const std::string& algorithm) {
  Json contender = {{"name", algorithm}, {"algorithm", algorithm}};
  if (!run.preset.empty())
    contender["preset"] = tool::is_document(run.preset) ? absolute(run.preset) : run.preset;
  return contender;
}

/// Of the file, which is UTF-8 throughout. @throws UsageError for a name that is not.
std::string text_of(const Json& value) {
  std::string text = json::dumped(value);
  if (json::read(text, "") != value)
    throw tool::UsageError("study run: " + text +
                           " is not UTF-8, as a study's file has to be; "
                           "rename the file");
  return text;
}

}  // namespace

std::string study_text(const tool::ShortStudy& run, const Seeds& seeds) {
  const bool file = !is_generated(run.map);
  const auto line = [](const std::string& key, const Json& value) {
    return key + ": " + text_of(value) + "\n";
  };
  std::string text = line("name", file ? fs::path(run.map).stem().string() : run.map);
  if (seeds.count > 0)
    text += line("seeds", std::to_string(seeds.first) + ".." +
                              std::to_string(seeds.first + seeds.count - 1));
  text += "contenders:\n";
  for (const std::string& algorithm : run.algorithms)
    text += "  - " + text_of(contender_json(run, algorithm)) + "\n";
  if (!run.factors.empty()) text += "sweep:\n  design: grid\n  factors:\n";
  for (const auto& [name, values] : run.factors) text += line("    " + name, values);
  if (run.steps || run.seconds) text += "budget:\n";
  if (run.steps) text += line("  steps", *run.steps);
  if (run.seconds) text += line("  seconds", *run.seconds);
  const bool cells = run.frame == tool::Frame::cell;
  const auto end = [cells](Point p) {
    return cells ? Json{static_cast<int>(p.x), static_cast<int>(p.y)} : Json{p.x, p.y};
  };
  Json question = {{"map", file ? absolute(run.map) : run.map},
                   {"start", end(run.start)},
                   {"goal", end(run.goal)}};
  if (!cells) question["frame"] = tool::kFrames[1];
  if (run.radius > 0) question["radius"] = run.radius;
  for (const auto& [layer, factor] : run.costs.layers)
    question["cost"].push_back(absolute(layer) + '*' + tool::to_text(factor));
  if (run.costs.inflation) question["inflation"] = *run.costs.inflation;
  return text + "questions:\n  - " + text_of(question) + "\n";
}

}  // namespace lasius::study
