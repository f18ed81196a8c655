#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <stop_token>

#include "answer.h"
#include "arm_verify.h"
#include "commands.h"
#include "exit_code.h"
#include "lasius/error.h"
#include "lasius/version.h"
#include "map_file.h"
#include "parameters.h"
#include "polygon_text.h"
#include "polygon_verify.h"
#include "report.h"
#include "signals.h"
#include "streams.h"
#include "values.h"

namespace lasius::tool {
namespace {

Error broken(const std::string& file, const std::string& problem) {
  return Error(
      ErrorCode::file_broken, {.file = file}, problem,
      "give a result that `lasius plan --json`, `lasius batch` or `lasius arm --json` printed");
}

/// The objects of a file: one result, or one a line.
std::vector<Json> read_results(const std::string& file) {
  std::error_code ignored;
  std::ifstream in;
  if (!std::filesystem::is_directory(file, ignored)) in.open(file, std::ios::binary);
  if (!in.is_open())
    throw Error(ErrorCode::file_missing, {.file = file}, "cannot be opened", "name a saved result");
  std::vector<Json> results;
  try {
    while (in >> std::ws && in.peek() != std::ifstream::traits_type::eof())
      in >> results.emplace_back();
  } catch (const Json::exception& fault) {
    throw broken(file,
                 "result " + std::to_string(results.size() - 1) + " is not JSON: " + fault.what());
  }
  if (results.empty()) throw broken(file, "holds no result");
  return results;
}

/// The recorded inputs of one result.
struct Recorded {
  RunOptions run;
  std::string hash;
  Cell start, goal;
  std::optional<std::size_t> index;
};

int coordinate(const Json& json) {
  const auto value = json.get<double>();
  if (value != std::floor(value) || std::abs(value) > std::numeric_limits<int>::max())
    throw UsageError(json.dump() + " is no coordinate of a cell");
  return static_cast<int>(value);
}

Cell cell(const Json& json) { return {coordinate(json.at(0)), coordinate(json.at(1))}; }

Recorded recorded_inputs(const Json& json) {
  Recorded inputs;
  RunOptions& run = inputs.run;
  run.map.file = json.at("map").at("file").get<std::string>();
  inputs.hash = json.at("map").at("hash").get<std::string>();
  inputs.start = cell(json.at("start"));
  inputs.goal = cell(json.at("goal"));
  if (json.contains("index")) inputs.index = json.at("index").get<std::size_t>();
  run.with_optimum = json.contains("optimum");

  run.params = default_params(json.at("algorithm").get<std::string>());
  run.params.seed = json.at("seed").get<std::uint64_t>();
  const Json& parameters = json.at("parameters");
  for (const auto& parameter : find_algorithm(run.params.algorithm).parameters)
    set_parameter(run.params, parameter.name,
                  parameter_text(parameters.at(std::string(parameter.name))));
  run.target_gap = parameters.at("target_gap").get<double>();
  if (!parameters.at("time_limit").is_null())
    run.time_limit = parameters.at("time_limit").get<double>();
  run.map.radius = parameters.at("radius").get<double>();
  run.map.unknown_is_free = parameters.at("unknown").get<std::string>() == "free";
  if (parameters.contains("prepare")) run.map.prepare = parameters.at("prepare").get<bool>();
  if (parameters.at("frame").get<std::string>() == "world") run.frame = Frame::world;
  return inputs;
}

/// The first difference between a result and its replay, or nothing. What may differ is left out.
std::string difference(Json recorded, Json replay) {
  for (const char* free : {"threads", "elapsed_ms", "version"}) {
    recorded.erase(free);
    replay.erase(free);
  }
  for (const char* input : {"map", "robot", "scene"}) {
    if (recorded.contains(input)) recorded[input].erase("file");
    if (replay.contains(input)) replay[input].erase("file");
  }
  for (const auto& [key, value] : replay.items())
    if (!recorded.contains(key) || recorded[key] != value) return key;
  for (const auto& [key, value] : recorded.items())
    if (!replay.contains(key)) return key;
  return {};
}

/// Where the result says, or there seen from the result's folder.
std::string found(const VerifyCommand& command, const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path beside = fs::path(command.result).parent_path() / file;
  return !fs::exists(file, ignored) && fs::exists(beside, ignored) ? beside.string() : file;
}

/// The same, unless --map says otherwise.
std::string found_map(const VerifyCommand& command, const std::string& file) {
  return command.map.empty() ? found(command, file) : command.map;
}

/// Keeps the map of the last result: the lines of a batch share one.
class Maps {
 public:
  explicit Maps(const VerifyCommand& command) : command_(command) {}

  const PreparedMap& find(const Recorded& inputs, const std::stop_token& token) {
    MapOptions options = inputs.run.map;
    options.file = found_map(command_, options.file);
    options.threads = command_.threads;
    const bool same = map_ && map_->file == options.file && map_->radius == options.radius &&
                      map_->unknown_is_free == options.unknown_is_free &&
                      map_->prepare == options.prepare;
    if (!same) map_ = prepare_map(options, inputs.run.frame, inputs.run.params.corners, token);
    check_hash(options.file, map_->hash, inputs.hash, "name the map of that time with --map");
    return *map_;
  }

 private:
  const VerifyCommand& command_;
  std::optional<PreparedMap> map_;
};

/// Reads inputs of one result, whatever is wrong with them named by file.
template <class Read>
auto checked_inputs(const std::string& name, const Read& read) {
  try {
    return read();
  } catch (const Json::exception& fault) {
    throw broken(name, std::string("lacks an input of its run: ") + fault.what());
  } catch (const UsageError& fault) {
    throw broken(name, std::string("holds a bad input: ") + fault.what());
  } catch (const Error& fault) {
    if (fault.code() != ErrorCode::invalid_parameter) throw;
    throw broken(name, std::string("holds a bad input: ") + fault.what());
  }
}

/// A text of a result; empty where it has none.
std::string text_of(const Json& recorded, const char* key) {
  const bool there = recorded.is_object() && recorded.contains(key) && recorded[key].is_string();
  return there ? recorded[key].get<std::string>() : std::string();
}

Json grid_replay(const VerifyCommand& command, const Json& recorded, const std::string& name,
                 Maps& maps, const std::stop_token& token) {
  Recorded inputs = checked_inputs(name, [&] { return recorded_inputs(recorded); });
  inputs.run.params.threads = command.threads;
  const PreparedMap& map = maps.find(inputs, token);
  Answer replay = answer(map, inputs.run, inputs.start, inputs.goal, {.token = token});
  replay.index = inputs.index;
  return result_json(map, inputs.run, replay);
}

Json replay_of(const VerifyCommand& command, const Json& recorded, const std::string& name,
               Maps& maps, const std::stop_token& token) {
  if (text_of(recorded, "format") == kArmFormat) {
    if (!command.map.empty()) throw UsageError("--map: " + name + " is of an arm, it has no map");
    return checked_inputs(name, [&] {
      const auto robot = recorded.at("robot").at("file").get<std::string>();
      const auto scene = recorded.at("scene").at("file").get<std::string>();
      return arm_replay(recorded, found(command, robot), found(command, scene), command.threads,
                        token);
    });
  }
  const std::string file =
      recorded.contains("map") ? text_of(recorded["map"], "file") : std::string();
  if (!is_world(file)) return grid_replay(command, recorded, name, maps, token);
  return checked_inputs(name, [&] {
    return polygon_replay(recorded, found_map(command, file), command.threads, token);
  });
}

/// Replays one result and says what is wrong. Its exit code.
int verify(const VerifyCommand& command, const Json& recorded, const std::string& name, Maps& maps,
           const std::stop_token& token) {
  const std::string format = text_of(recorded, "format");
  if (format != kFormat && format != kArmFormat)
    throw broken(name, std::string("is not of format ") + kFormat + " or " + kArmFormat);
  const std::string status = text_of(recorded, "status");
  if (status == "limit" || status == "interrupted") {
    message(name + ": cannot be replayed: " + (status == "limit" ? "a time limit" : "a signal") +
            " ended it, and no clock runs twice the same");
    return kUsage;
  }
  const std::string version = text_of(recorded, "version");
  if (version != LASIUS_VERSION && !command.quiet)
    message(name + ": made by version " + version + ", replayed by " + LASIUS_VERSION);
  const Json replay = replay_of(command, recorded, name, maps, token);
  if (token.stop_requested()) return kInterrupted;
  const std::string key = difference(recorded, replay);
  if (key.empty()) return kFound;
  message(std::string(name).append(": differs from its replay in '").append(key).append("'"));
  return kInternal;
}

}  // namespace

int run_verify(const VerifyCommand& command) {
  SignalWatcher signals;
  Maps maps(command);
  int code = kFound;
  std::size_t equal = 0;
  const auto results = read_results(command.result);
  for (std::size_t i = 0; i < results.size(); ++i) {
    const std::string name =
        results.size() > 1 ? command.result + ", result " + std::to_string(i) : command.result;
    const int one = verify(command, results[i], name, maps, signals.token());
    if (one == kInterrupted) return one;
    if (one == kFound) ++equal;
    // A difference weighs more than a result that cannot be replayed.
    if (code != kInternal && one != kFound) code = one;
  }
  if (!command.quiet)
    print(std::to_string(equal) + " of " + std::to_string(results.size()) +
          (results.size() == 1 ? " result is" : " results are") + " equal to the replay\n");
  return code;
}

}  // namespace lasius::tool
