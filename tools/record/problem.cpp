#include "tools/record/problem.h"

#include <algorithm>
#include <utility>

#include "lasius/base/error.h"
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

/// Prints and writes what was asked for.
void deliver(const Problem& problem, const Record& run, Delivery& delivery) {
  const SearchOptions& options = run.options;
  try {
    delivery.print(options.json ? json_line(run) : plain_text(run));
  } catch (const ClosedOutput&) {
    return;  // the exit code still says how the run ended
  }
  Forms forms = problem.show(run);
  forms.json = [&](auto& out) { out << json_line(run); };
  if (!forms.csv) forms.csv = [&](auto& out) { write_csv(out, run); };
  delivery.write([&](const std::string& file) { write_output(file, forms); },
                 options.messages.verbose);
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

Problem::~Problem() = default;

int run(Problem& problem) {
  const SearchOptions& options = problem.options();
  const auto say = [&](const std::vector<std::string>& texts) {
    for (const auto& text : texts)
      if (!options.messages.quiet) message(text);
  };
  check_files(options);
  SignalWatcher signals;
  Delivery delivery(options.outputs);
  const auto iterations = problem.read(signals.token());
  // Again: by now maps, robots and scenes have named more files.
  check_files(options);
  say(options.notes);
  {
    const bool shown = wants_progress(options.messages);
    ProgressLine bar(shown, iterations.value_or(0), options.time_limit.value_or(0));
    const auto update = [&](std::int64_t done, const std::string& note) { bar.update(done, note); };
    problem.plan({.token = signals.token(), .deadline = deadline_after(options.time_limit)},
                 shown ? Problem::Watch(update) : Problem::Watch());
  }
  const Record run = problem.record();
  const std::string why = explain(run);
  if (!why.empty() && (!run.found() || !options.messages.quiet)) message(why);
  const int done = run.result.curves.iterations;
  if (options.messages.verbose && run.result.status == Status::solved && done < iterations)
    message("ended by its own rule after " + counted(done, "iteration") + " of " +
            std::to_string(*iterations));
  say(run.remarks);
  deliver(problem, run, delivery);
  return signals.interrupted() ? kInterrupted : exit_code(run);  // --gap may be what was cut off
}

std::string Recorded::map_file() const {
  return map.empty() ? found(recorded<std::string>(result, "map/file")) : map;
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
  if (recorded_optional<double>(from.result, "parameters/time_limit"))
    options.time_limit = recorded_real(from.result, "parameters/time_limit", 0, kNoLimit);
  if (values.contains("goal_tolerance"))
    options.goal_tolerance = recorded_real(from.result, "parameters/goal_tolerance", 0, kNoLimit);
  options.with_optimum = from.result.contains("optimum");
  options.json = true;
}

Json replay(Problem& problem, const Recorded& from) {
  (void)problem.read({});
  check_inputs(problem.record().inputs, from.result);
  problem.plan({}, {});
  Record run = problem.record();
  if (from.result.contains("index")) run.index = recorded<std::size_t>(from.result, "index");
  return result_json(std::move(run));
}

}  // namespace lasius::tool
