#include "tools/record/record.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "lasius/version.h"
#include "tools/console/exit_code.h"
#include "tools/console/values.h"
#include "tools/record/outputs.h"

namespace lasius::tool {
namespace {

const char* limit_name(Limit limit) {
  return limit == Limit::questions ? "--max-questions"
         : limit == Limit::ticks   ? "--max-ticks"
                                   : "the time limit";
}

std::string after(const Record& run) {
  return run.most_iterations ? " after " + counted(run.result.curves.iterations, "iteration") : "";
}

std::string reached(const Record& run) {
  if (!run.reached.empty()) return run.reached;
  return after(run) + (run.has_path() ? ", the best path so far is kept" : ", no path yet");
}

/// What may help where no path was found.
std::string advice(const Record& run) {
  std::string text = "; try more --iterations, ";
  if (run.algorithm.has("ants")) text += "more --ants ";
  text += "or another --seed";
  if (run.algorithm.has("dead_end") && run.parameters["dead_end"] == "kill")
    text += ", or --set dead_end=backtrack: its ants die where they are stuck";
  return text;
}

/// `parts`: vertices before which an empty line stands.
void write_path(std::ostream& out, const std::vector<double>& path, std::size_t axes,
                const char* between, std::span<const std::size_t> parts = {}) {
  auto part = parts.begin();
  for (std::size_t i = 0; i < path.size(); ++i) {
    for (; part != parts.end() && *part * axes == i; ++part) out << "\n";
    out << to_text(path[i]) << ((i + 1) % axes == 0 ? "\n" : between);
  }
}

}  // namespace

bool Record::has_path() const { return !std::isnan(result.length); }

std::optional<std::int64_t> most_iterations(const Algorithm& algorithm, std::int64_t asked) {
  return algorithm.has("iterations") ? std::optional(asked) : std::nullopt;
}

std::vector<double> coordinates(const std::vector<Point>& points) {
  std::vector<double> numbers;
  for (const Point p : points) numbers.insert(numbers.end(), {p.x, p.y});
  return numbers;
}

Json parameters_json(const Algorithm& algorithm, const SearchOptions& options) {
  return parameters(algorithm, [&](auto name) { return options.asked.at(std::string(name)); });
}

void add_limits(Json& json, const SearchOptions& options) {
  json["target_gap"] = number(options.target_gap);
  json["time_limit"] = optional_number(options.time_limit);
}

bool wants_json(const SearchOptions& options) {
  return options.json || std::ranges::any_of(options.outputs, [](const std::string& file) {
           return !is_table(file) && !is_yaml(file) && !is_picture(file) && !is_film(file);
         });
}

Json answer_json(const Record& run, Json path, Json effort, Json findings) {
  Json json = json::roomy_object();
  json["length"] = number(run.result.length);
  json::append(json, std::move(path));
  add_convergence(json, run.result.curves);
  json::append(json, std::move(effort));
  add_proof(json, run.result);
  json["gap"] = optional_number(run.gap);
  if (run.options.with_optimum) {
    json["optimum"] = optional_number(run.optimum);
    json["optimum_gap"] =
        optional_number(gap_to(run.optimum, run.cost.value_or(run.result.length)));
  }
  json::append(json, std::move(findings));
  return json;
}

Json result_json(Record run) {
  Json json = json::roomy_object();
  json["format"] = run.format;
  json["version"] = LASIUS_VERSION;
  if (run.index) json["index"] = *run.index;
  if (const Part& part = run.options.part; part.divided())
    json["part"] = {{"number", part.number},
                    {"of", part.of},
                    {"queries", part.whole},
                    {"hash", part.queries},
                    {"seeds", {run.options.seed, run.options.seeds}}};
  json::append(json, std::move(run.inputs));
  json["algorithm"] = run.algorithm.name;
  json["start"] = std::move(run.start);
  json["goal"] = std::move(run.goal);
  json["seed"] = run.seed;
  json["threads"] = run.options.threads;
  json["parameters"] = std::move(run.parameters);
  json["status"] = to_string(run.result.status);
  json["error"] = text_or_null(run.error);
  json::append(json, std::move(run.answer));
  json["elapsed_ms"] = number(run.elapsed_ms);
  return json;
}

std::string json_line(Record run) { return line(result_json(std::move(run))); }

std::string plain_text(const Record& run) {
  std::ostringstream out;
  out << to_string(run.result.status) << "\n";
  if (!run.has_path()) return out.str();
  out << to_text(run.scale * run.result.length) << "\n";
  write_path(out, run.path, run.axes, " ", run.parts);
  for (const Record::Other& other : run.others) {
    out << "\n" << to_text(run.scale * other.length) << "\n";
    write_path(out, other.path, run.axes, " ");
  }
  return out.str();
}

void write_csv(std::ostream& out, const Record& run) {
  const std::string m = run.unit.empty() ? "" : "_" + run.unit;
  if (!run.most_iterations) {
    out << "x" << m << ",y" << m << "\n";
    return write_path(out, run.path, run.axes, ",", run.parts);
  }
  const SearchResult& result = run.result;
  out << "iteration,best" << m << ",mean" << m << ",arrived\n";
  for (std::size_t i = 0; i < result.curves.best.size(); ++i)
    out << i + 1 << "," << finite_text(run.scale * result.curves.best[i]) << ","
        << finite_text(run.scale * result.curves.mean[i]) << "," << result.curves.arrived[i]
        << "\n";
}

int exit_code(const Record& run) {
  switch (run.result.status) {
    case Status::invalid:
      return kInvalidQuery;
    case Status::unreachable:
      return kUnreachable;
    case Status::interrupted:
      return kInterrupted;
    case Status::solved:
    case Status::limit:
    case Status::no_path:
      break;
  }
  return run.found() ? kFound : kNoPath;
}

std::string explain(const Record& run) {
  switch (run.result.status) {
    case Status::solved:
      return {};
    case Status::limit:
      return limit_name(run.result.limit) + (" ended the run" + reached(run));
    case Status::interrupted:
      return "interrupted" + reached(run);
    case Status::no_path:
      return run.error.empty() ? "no path" + after(run) + advice(run) : run.error;
    case Status::unreachable:
    case Status::invalid:
      return run.error;
  }
  return {};
}

std::string best_text(double length, const std::string& unit) {
  if (!std::isfinite(length)) return "no path yet";
  const std::string text = "best " + decimal_text(length, 3);
  return unit.empty() ? text : text + " " + unit;
}

std::string algorithm_text(const SearchOptions& options, const Algorithm& algorithm,
                           bool with_threads) {
  std::string text(algorithm.name);
  text += ", seed " + std::to_string(options.seed);
  return with_threads ? text + ", " + counted(options.threads, "thread") : text;
}

}  // namespace lasius::tool
