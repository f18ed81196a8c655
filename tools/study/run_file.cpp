#include "tools/study/run_file.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/io/json_values.h"
#include "lasius/version.h"
#include "tools/study/files.h"

namespace lasius::study {
namespace {

using json::Json;
using json::number;

struct NamedCurve {
  const char* name;
  std::vector<double> Run::*curve;
};
constexpr NamedCurve kCurves[] = {
    {"best", &Run::best},         {"mean", &Run::mean},
    {"raw_best", &Run::raw_best}, {"cut_mean", &Run::cut_mean},
    {"cut_best", &Run::cut_best}, {"iteration_best", &Run::iteration_best},
    {"steps_by", &Run::steps_by}, {"band", &Run::band}};

const std::string kVersion = "lasius " LASIUS_VERSION " ";

/// A curve as its size and its steps, [index, value] where the value changes: most of it is flat.
void put_curve(Json& json, const std::string& name, const std::vector<double>& curve) {
  json[name + "_size"] = curve.size();
  Json& steps = json[name] = Json::array();
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const bool starts = i == 0 || std::isfinite(curve[i]) != std::isfinite(curve[i - 1]);
    if (starts || (std::isfinite(curve[i]) && curve[i] != curve[i - 1]))
      steps.push_back({i, number(curve[i])});
  }
}

double known(const Json& json) { return json.is_null() ? kUnknown : json.get<double>(); }

std::vector<double> curve_of(const Json& json, const std::string& name) {
  constexpr std::size_t kMost = 1 << 20;  // far more iterations than any study's
  const auto size = json.at(name + "_size").get<std::size_t>();
  if (size > kMost) throw std::runtime_error("a curve that is too long");
  std::vector<double> curve(size, kUnknown);
  for (const Json& step : json.at(name)) {
    const auto from = step.at(0).get<std::size_t>();
    if (from >= size) throw std::runtime_error("a step behind its curve");
    std::fill(curve.begin() + static_cast<std::ptrdiff_t>(from), curve.end(), known(step.at(1)));
  }
  return curve;
}

Status status_of(const std::string& text) {
  for (const Status s : {Status::solved, Status::limit, Status::interrupted, Status::unreachable,
                         Status::no_path, Status::invalid})
    if (to_string(s) == text) return s;
  throw std::runtime_error("unknown status");
}

Run run_of(const Json& json) {
  Run run;
  run.seed = json.at("seed").get<std::uint64_t>();
  run.status = status_of(json.at("status").get<std::string>());
  run.length = known(json.at("length"));
  run.iterations = json.at("iterations").get<int>();
  run.seconds = json.at("seconds").get<double>();
  for (const auto& [name, curve] : kCurves) run.*curve = curve_of(json, name);
  run.limit = known(json.at("limit"));
  run.reference = known(json.at("reference"));
  run.steps = json.at("steps").get<std::int64_t>();
  run.checks = json.at("checks").get<std::int64_t>();
  for (const Json& p : json.at("path")) run.path.push_back({p.at(0), p.at(1)});
  return run;
}

}  // namespace

std::optional<Run> read_run(const std::filesystem::path& file, const std::string& key,
                            std::uint64_t seed) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return std::nullopt;
  return parse_run({std::istreambuf_iterator<char>(in), {}}, key, seed);
}

std::optional<Run> parse_run(const std::string& text, const std::string& key, std::uint64_t seed) {
  try {
    const Json json = json::read(text, "a run");
    if (json.at("key") != kVersion + key) return std::nullopt;
    Run run = run_of(json);
    if (run.seed != seed) return std::nullopt;
    return run;
  } catch (const std::exception&) {
    return std::nullopt;  // torn or foreign: the run is done again
  }
}

void write_run(const std::filesystem::path& file, const std::string& key, const Run& run) {
  write_text(file, run_text(key, run));
}

std::string run_text(const std::string& key, const Run& run) {
  Json json;
  json["key"] = kVersion + key;
  json["seed"] = run.seed;
  json["status"] = to_string(run.status);
  json["length"] = number(run.length);
  json["iterations"] = run.iterations;
  json["seconds"] = run.seconds;
  for (const auto& [name, curve] : kCurves) put_curve(json, name, run.*curve);
  json["limit"] = number(run.limit);
  json["reference"] = number(run.reference);
  json["steps"] = run.steps;
  json["checks"] = run.checks;
  json["path"] = Json::array();
  for (const Point p : run.path) json["path"].push_back({p.x, p.y});
  return json::dumped(json) + '\n';
}

}  // namespace lasius::study
