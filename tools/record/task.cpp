#include "tools/record/task.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/number_text.h"
#include "core/base/output.h"
#include "lasius/error.h"
#include "lasius/version.h"
#include "tools/console/elapsed.h"
#include "tools/console/exit_code.h"
#include "tools/console/progress.h"
#include "tools/console/signals.h"
#include "tools/console/streams.h"
#include "tools/console/values.h"
#include "tools/record/outputs.h"
#include "tools/record/recorded.h"

namespace lasius::tool {
namespace {

const char* limit_name(Limit limit) {
  return limit == Limit::questions ? "--max-questions"
         : limit == Limit::ticks   ? "--max-ticks"
                                   : "the time limit";
}

std::string after(const Task& task) {
  return task.iterates() ? " after " + counted(task.result().iterations, "iteration") : "";
}

/// Plans, with a progress line where it is wanted.
void watched_plan(Task& task, const std::stop_token& token) {
  const SearchOptions& options = task.options();
  const bool shown = wants_progress(options.messages);
  ProgressLine bar(shown, task.iterates() ? task.iterations() : 0, options.time_limit.value_or(0));
  Task::Watch watch;
  if (shown)
    watch = [&](const Progress& progress) {
      bar.update(progress.iteration + 1, task.progress_note(progress));
    };
  task.plan({.token = token, .deadline = deadline_after(options.time_limit)}, watch);
}

/// Status, length and path.
std::string text(const Task& task) {
  std::ostringstream out;
  out << to_string(task.result().status) << "\n";
  if (!task.has_path()) return out.str();
  out << to_text(task.shown(task.result().length)) << "\n";
  task.write_path(out, " ");
  return out.str();
}

/// Prints and writes what was asked for.
void deliver(const Task& task) {
  const SearchOptions& options = task.options();
  Delivery delivery(options.outputs);
  try {
    delivery.print(options.json ? json_line(task) : text(task));
  } catch (const ClosedOutput&) {
    return;  // the exit code still says how the run ended
  }
  delivery.write([&](const std::string& file) {
    write_output(file, {.json = [&](auto& out) { out << json_line(task); },
                        .csv = [&](auto& out) { task.write_csv(out); },
                        .picture = [&] { task.write_picture(file); },
                        .yaml = [&](auto& out) { task.write_yaml(out); },
                        .film = [&](auto& out) { task.write_film(out); },
                        .page = [&](auto& out) { task.write_report(out); }});
    if (options.messages.verbose) message("wrote " + file);
  });
}

/// @throws Error(file_broken) where a file's hash is not the one that the result records.
void check_hash(const std::string& role, const Json& input, const std::string& made_on) {
  const auto hash = input["hash"].get<std::string>();
  if (hash != made_on)
    throw Error(ErrorCode::file_broken, {.file = input["file"].get<std::string>()},
                "has hash " + hash + ", the result was made on " + made_on,
                role == "map" ? "name the map of that time with --map"
                              : "put the file of that time in its place");
}

/// The same of all inputs, and of the files that they name, as far as those are recorded.
void check_inputs(const Json& inputs, const Json& result) {
  for (const auto& [role, input] : inputs.items()) {
    if (input.is_null()) continue;
    check_hash(role, input, recorded<std::string>(result, role + "/hash"));
    if (!input.contains("files") || !result[role].contains("files")) continue;
    const Json& files = result[role]["files"];
    for (std::size_t i = 0; i < std::min(input["files"].size(), files.size()); ++i)
      check_hash(role, input["files"][i], recorded<std::string>(files[i], "hash"));
  }
}

}  // namespace

int exit_code(const Task& task) {
  switch (task.result().status) {
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
  return task.found() ? kFound : kNoPath;
}

std::string explain(const Task& task) {
  switch (task.result().status) {
    case Status::solved:
      return {};
    case Status::limit:
      return limit_name(task.result().limit) + (" ended the run" + task.reached());
    case Status::interrupted:
      return "interrupted" + task.reached();
    case Status::no_path:
      if (!task.error().empty()) return task.error();
      return "no path" + after(task) + "; try more --iterations, " +
             (task.algorithm().has("ants") ? "more --ants " : "") + "or another --seed" +
             (task.algorithm().has("dead_end") && task.parameter("dead_end") == "kill"
                  ? ", or --set dead_end=backtrack: its ants die where they are stuck"
                  : "");
    case Status::unreachable:
    case Status::invalid:
      return task.error();
  }
  return {};
}

Task::~Task() = default;

void Task::announce() const {
  for (const auto& note : options().notes) message(note);
}

bool Task::has_path() const { return !std::isnan(result().length); }

std::string Task::reached() const {
  return after(*this) + (has_path() ? ", the best path so far is kept" : ", no path yet");
}

std::string Task::progress_note(const Progress& progress) const {
  if (!std::isfinite(progress.best_length)) return "no path yet";
  const std::string text = "best " + decimal_text(shown(progress.best_length), 3);
  return unit().empty() ? text : text + " " + unit();
}

void Task::write_csv(std::ostream& out) const {
  const std::string m = unit().empty() ? "" : "_" + unit();
  if (!iterates()) {
    out << "x" << m << ",y" << m << "\n";
    return write_path(out, ",");
  }
  const SearchResult& run = result();
  out << "iteration,best" << m << ",mean" << m << ",arrived\n";
  for (std::size_t i = 0; i < run.best.size(); ++i)
    out << i + 1 << "," << finite_text(shown(run.best[i])) << "," << finite_text(shown(run.mean[i]))
        << "," << run.arrived[i] << "\n";
}

void Task::announce_algorithm(bool with_threads) const {
  std::string text(algorithm().name);
  text += ", seed " + std::to_string(options().seed);
  if (with_threads) text += ", " + counted(options().threads, "thread");
  message(text);
}

void Task::add_limits(Json& json) const {
  json["target_gap"] = number(options().target_gap);
  json["time_limit"] = optional_number(options().time_limit);
}

int run(Task& task) {
  const SearchOptions& options = task.options();
  check_outputs(options.outputs, task.input_files());
  task.open();
  SignalWatcher signals;
  task.load(signals.token());
  // Again: by now maps, robots and scenes have named more files.
  check_outputs(options.outputs, task.input_files());
  if (!options.messages.quiet) task.announce();
  watched_plan(task, signals.token());
  const std::string why = explain(task);
  if (!why.empty() && (!task.found() || !options.messages.quiet)) message(why);
  const int done = task.result().iterations;
  if (options.messages.verbose && task.result().status == Status::solved && task.iterates() &&
      done < task.iterations())
    message("ended by its own rule after " + counted(done, "iteration") + " of " +
            std::to_string(task.iterations()));
  if (!options.messages.quiet) task.remark();
  deliver(task);
  return signals.interrupted() ? kInterrupted : exit_code(task);  // --gap may be what was cut off
}

void Task::add_answer(Json& json) const {
  json["length"] = number(result().length);
  add_path(json);
  add_convergence(json, result());
  add_effort(json);
  add_proof(json, result());
  if (options().with_optimum) {
    json["optimum"] = optional_number(optimum());
    json["optimum_gap"] = optional_number(gap_to(optimum(), result().length));
  }
  add_findings(json);
}

std::string Recorded::map_file() const {
  return map.empty() ? found(recorded<std::string>(result, "map/file")) : map;
}

std::string json_line(const Task& task) { return line(result_json(task)); }

Json result_json(const Task& task) {
  const SearchOptions& options = task.options();
  Json json = {{"format", task.format()}, {"version", LASIUS_VERSION}};
  if (const auto index = task.index()) json["index"] = *index;
  json.update(task.inputs());
  json["algorithm"] = task.algorithm().name;
  auto [start, goal] = task.ends();
  json["start"] = std::move(start);
  json["goal"] = std::move(goal);
  json["seed"] = options.seed;
  json["threads"] = options.threads;
  json["parameters"] =
      parameters(task.algorithm(), [&](std::string_view name) { return task.parameter(name); });
  task.add_settings(json["parameters"]);
  json["status"] = to_string(task.result().status);
  json["error"] = text_or_null(task.error());
  task.add_answer(json);
  json["elapsed_ms"] = number(task.elapsed_ms());
  return json;
}

void read_recorded(const Recorded& from, const Algorithm& algorithm, SearchOptions& options) {
  options.algorithm = algorithm.name;
  options.seed = recorded_seed(from.result);
  options.threads = from.threads;
  const Json& values = value_at(from.result, "parameters");
  for (const Parameter& parameter : algorithm.parameters) {
    const std::string name(parameter.name);
    const bool later = !parameter.earlier.empty() && !values.contains(name);
    options.named.emplace_back(name,
                               later ? std::string(parameter.earlier)
                                     : parameter_text(value_at(from.result, "parameters/" + name)));
  }
  options.target_gap = recorded_real(from.result, "parameters/target_gap", 0, kNoLimit);
  options.time_limit = recorded_optional<double>(from.result, "parameters/time_limit");
  options.with_optimum = from.result.contains("optimum");
}

void write_points(std::ostream& out, const char* between, const std::vector<Point>& points) {
  for (const Point p : points) out << to_text(p.x) << between << to_text(p.y) << "\n";
}

Json replay(Task& task, const Recorded& from) {
  if (from.result.contains("index")) task.set_index(recorded<std::size_t>(from.result, "index"));
  task.open();
  task.load({});
  check_inputs(task.inputs(), from.result);
  task.plan({}, {});
  return result_json(task);
}

}  // namespace lasius::tool
