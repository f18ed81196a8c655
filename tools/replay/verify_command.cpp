#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>

#include "core/base/json_depth.h"
#include "lasius/error.h"
#include "lasius/version.h"
#include "tools/arm/arm_task.h"
#include "tools/bitmap/bitmap_task.h"
#include "tools/console/exit_code.h"
#include "tools/console/signals.h"
#include "tools/console/streams.h"
#include "tools/console/worlds.h"
#include "tools/options/commands.h"
#include "tools/polygon/polygon_task.h"
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

/// Where a result says that a file is, or there seen from the result's folder; --map says
/// otherwise.
std::string found(const VerifyCommand& command, const std::string& file) {
  namespace fs = std::filesystem;
  if (!command.map.empty()) return command.map;
  std::error_code ignored;
  const fs::path beside = fs::path(command.result).parent_path() / file;
  return !fs::exists(file, ignored) && fs::exists(beside, ignored) ? beside.string() : file;
}

/// A text of a result; empty where it has none.
std::string text_of(const Json& recorded, const char* key) {
  const bool there = recorded.is_object() && recorded.contains(key) && recorded[key].is_string();
  return there ? recorded[key].get<std::string>() : std::string();
}

std::unique_ptr<Task> task_of(const Recorded& recorded, SharedMap& last_map) {
  if (text_of(recorded.result, "format") == kArmFormat) return recorded_arm(recorded);
  const bool world = is_world(tool::recorded<std::string>(recorded.result, "map/file"));
  return world ? recorded_polygon(recorded) : recorded_bitmap(recorded, last_map);
}

/// Plans again; whatever is wrong with the recorded inputs is named by the result's place.
Json replay_of(const Error::Place& place, const Recorded& recorded, SharedMap& last_map) {
  try {
    return replay(*task_of(recorded, last_map), recorded);
  } catch (const UsageError& fault) {
    throw broken(place, std::string("cannot be replayed: ") + fault.what());
  } catch (const Error& fault) {
    if (fault.code() != ErrorCode::invalid_parameter) throw;
    throw broken(place, std::string("cannot be replayed: ") + fault.what());
  }
}

/// Replays one result and says what is wrong. Its exit code.
int verify(const VerifyCommand& command, const Saved& saved, const std::string& name,
           SharedMap& last_map, const std::stop_token& token) {
  const Json& result = saved.json;
  const Error::Place place{.file = name, .offset = saved.offset};
  const std::string format = text_of(result, "format");
  if (format != kPlanFormat && format != kArmFormat)
    throw broken(place, std::string("is not of format ") + kPlanFormat + " or " + kArmFormat);
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
  const Json replay = replay_of(place,
                                {.result = result,
                                 .found = [&](const auto& file) { return found(command, file); },
                                 .threads = command.threads,
                                 .token = token},
                                last_map);
  if (token.stop_requested()) return kInterrupted;
  const std::string key = difference(result, replay);
  if (key.empty()) return kFound;
  message(std::string(name).append(": differs from its replay in '").append(key).append("'"));
  return kInternal;
}

}  // namespace

int run_verify(const VerifyCommand& command) {
  SignalWatcher signals;
  SharedMap last_map;
  int code = kFound;
  std::size_t equal = 0;
  const auto results = read_results(command.result);
  for (std::size_t i = 0; i < results.size(); ++i) {
    const std::string name =
        results.size() > 1 ? command.result + ", result " + std::to_string(i + 1) : command.result;
    const int one = verify(command, results[i], name, last_map, signals.token());
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
