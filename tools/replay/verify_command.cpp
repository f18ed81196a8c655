#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stop_token>
#include <string>
#include <utility>

#include "core/base/json_depth.h"
#include "lasius/error.h"
#include "lasius/version.h"
#include "tools/arm/arm_verify.h"
#include "tools/bitmap/answer.h"
#include "tools/bitmap/map_file.h"
#include "tools/bitmap/report.h"
#include "tools/command_line/polygon_text.h"
#include "tools/commands.h"
#include "tools/console/exit_code.h"
#include "tools/console/parameters.h"
#include "tools/console/signals.h"
#include "tools/console/streams.h"
#include "tools/console/values.h"
#include "tools/polygon/polygon_verify.h"
#include "tools/record/recorded.h"

namespace lasius::tool {
namespace {

/// A result, and the byte of its file at which it begins.
struct Saved {
  Json json;
  std::int64_t offset;
};

Error broken(Error::Place place, const std::string& problem) {
  return Error(
      ErrorCode::file_broken, std::move(place), problem,
      "give a result that `lasius plan --json`, `lasius batch` or `lasius arm --json` printed");
}

/// The objects of a file: one result, or one a line.
std::vector<Saved> read_results(const std::string& file) {
  std::error_code ignored;
  std::ifstream stream;
  if (!std::filesystem::is_directory(file, ignored)) stream.open(file, std::ios::binary);
  if (!stream.is_open())
    throw Error(ErrorCode::file_missing, {.file = file}, "cannot be opened", "name a saved result");
  std::string text(std::istreambuf_iterator<char>(stream), {});
  if (const auto byte = too_deep(text))
    throw broken({.file = file, .offset = static_cast<std::int64_t>(*byte)}, "nests too deep");
  std::istringstream in(std::move(text));
  std::vector<Saved> results;
  try {
    while (in >> std::ws && in.peek() != std::ifstream::traits_type::eof()) {
      results.push_back({{}, in.tellg()});
      in >> results.back().json;
    }
  } catch (const Json::exception& fault) {
    in.clear();
    const bool syntax = dynamic_cast<const Json::parse_error*>(&fault) != nullptr;
    throw broken({.file = file, .offset = in.tellg()},
                 "result " + std::to_string(results.size()) +
                     (syntax ? " is not JSON up to here" : " holds a number that is too large"));
  }
  if (results.empty()) throw broken({.file = file, .offset = 0}, "holds no result");
  return results;
}

/// The recorded inputs of one result.
struct Recorded {
  RunOptions run;
  std::string hash;
  Point start, goal;  ///< cells, or metres in the world frame
  std::optional<std::size_t> index;
};

Point cell_of(const Json& result, const std::string& key) {
  const Point cell = recorded_point(result, key);
  if (cell.x != std::floor(cell.x) || cell.y != std::floor(cell.y))
    throw UsageError("\"" + key + "\" is no cell");
  return cell;
}

Recorded recorded_inputs(const Json& result) {
  Recorded inputs;
  RunOptions& run = inputs.run;
  run.map.file = recorded<std::string>(result, "map/file");
  inputs.hash = recorded<std::string>(result, "map/hash");
  if (result.contains("index")) inputs.index = recorded<std::size_t>(result, "index");
  run.with_optimum = result.contains("optimum");

  run.params = default_params(recorded<std::string>(result, "algorithm"));
  run.params.seed = recorded_seed(result);
  for (const auto& [name, value] :
       recorded_parameters(result, find_algorithm(run.params.algorithm())))
    set_parameter(run.params, name, value);
  validate(run.params);
  run.target_gap = recorded_real(result, "parameters/target_gap", 0, kNoLimit);
  run.time_limit = recorded_optional<double>(result, "parameters/time_limit");
  run.map.radius = recorded<double>(result, "parameters/radius");
  run.map.unknown_is_free = recorded<std::string>(result, "parameters/unknown") == "free";
  if (result["parameters"].contains("prepare"))
    run.map.prepare = recorded<bool>(result, "parameters/prepare");
  if (recorded<std::string>(result, "parameters/frame") == "world") run.frame = Frame::world;
  const bool world = run.frame == Frame::world;  // the cells are compared with the replay's
  inputs.start = world ? recorded_point(result, "start_world") : cell_of(result, "start");
  inputs.goal = world ? recorded_point(result, "goal_world") : cell_of(result, "goal");
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
  // A limit or a signal may have cut off the search for an optimum.
  for (const auto& [optimum, gap] :
       {std::pair{"optimum", "optimum_gap"}, {"grid_optimum", "grid_optimum"}}) {
    if (!recorded.contains(optimum) || !recorded[optimum].is_null()) continue;
    for (const char* key : {optimum, gap}) {
      recorded.erase(key);
      replay.erase(key);
    }
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

/// Calls `replay`; whatever is wrong with the recorded inputs is named by the result's place.
template <class Replay>
Json checked(const Error::Place& place, const Replay& replay) {
  try {
    return replay();
  } catch (const UsageError& fault) {
    throw broken(place, std::string("cannot be replayed: ") + fault.what());
  } catch (const Error& fault) {
    if (fault.code() != ErrorCode::invalid_parameter) throw;
    throw broken(place, std::string("cannot be replayed: ") + fault.what());
  }
}

/// A text of a result; empty where it has none.
std::string text_of(const Json& recorded, const char* key) {
  const bool there = recorded.is_object() && recorded.contains(key) && recorded[key].is_string();
  return there ? recorded[key].get<std::string>() : std::string();
}

Json grid_replay(const VerifyCommand& command, const Json& result, Maps& maps,
                 const std::stop_token& token) {
  Recorded inputs = recorded_inputs(result);
  inputs.run.params.threads = command.threads;
  const PreparedMap& map = maps.find(inputs, token);
  const Place start = to_place(map, inputs.start, inputs.run.frame);
  const Place goal = to_place(map, inputs.goal, inputs.run.frame);
  Answer replay = answer(map, inputs.run, start, goal, {.token = token});
  replay.index = inputs.index;
  return result_json(map, inputs.run, replay);
}

Json replay_of(const VerifyCommand& command, const Json& result, Maps& maps,
               const std::stop_token& token) {
  if (text_of(result, "format") == kArmFormat) {
    const auto robot = recorded<std::string>(result, "robot/file");
    const auto scene = recorded<std::string>(result, "scene/file");
    return arm_replay(result, found(command, robot), found(command, scene), command.threads, token);
  }
  const auto file = recorded<std::string>(result, "map/file");
  if (!is_world(file)) return grid_replay(command, result, maps, token);
  return polygon_replay(result, found_map(command, file), command.threads, token);
}

/// Replays one result and says what is wrong. Its exit code.
int verify(const VerifyCommand& command, const Saved& saved, const std::string& name, Maps& maps,
           const std::stop_token& token) {
  const Json& result = saved.json;
  const Error::Place place{.file = name, .offset = saved.offset};
  const std::string format = text_of(result, "format");
  if (format != kFormat && format != kArmFormat)
    throw broken(place, std::string("is not of format ") + kFormat + " or " + kArmFormat);
  const std::string status = text_of(result, "status");
  if (status == "limit" || status == "interrupted") {
    message(name + ": cannot be replayed: " + (status == "limit" ? "a time limit" : "a signal") +
            " ended it, and no clock runs twice the same");
    return kUsage;
  }
  const std::string version = text_of(result, "version");
  if (!version.empty() && version != LASIUS_VERSION && !command.quiet)
    message(name + ": made by version " + version + ", replayed by " + LASIUS_VERSION);
  if (format == kArmFormat && !command.map.empty())
    throw UsageError("--map: " + name + " is of an arm, it has no map");
  const Json replay = checked(place, [&] { return replay_of(command, result, maps, token); });
  if (token.stop_requested()) return kInterrupted;
  const std::string key = difference(result, replay);
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
        results.size() > 1 ? command.result + ", result " + std::to_string(i + 1) : command.result;
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
