#include <algorithm>
#include <array>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/number_text.h"
#include "core/io/json_values.h"
#include "lasius/base/error.h"
#include "lasius/version.h"
#include "tools/command_line/search_options.h"
#include "tools/console/exit_code.h"
#include "tools/console/kinds.h"
#include "tools/console/streams.h"
#include "tools/console/threads.h"
#include "tools/console/values.h"
#include "tools/record/problem.h"
#include "tools/record/recorded.h"
#include "tools/record/saved.h"

namespace lasius::tool {
namespace {

struct VerifyCommand {
  std::string result;
  std::string map;  ///< empty: the one that the result names
  int threads = 0;  ///< 0: as many as usual
  bool quiet = false;
};

Error broken(Error::Place place, const std::string& problem) {
  return Error(ErrorCode::file_broken, std::move(place), problem,
               "give a result that `lasius plan --json`, `lasius batch`, `lasius drive --json`, "
               "`lasius tour "
               "--json` or `lasius arm --json` printed");
}

using Version = std::array<int, 3>;

/// "1.2.3" as numbers; nothing where the text is none such.
std::optional<Version> version_of(std::string_view text) {
  const auto parts = split(text, '.');
  Version version{};
  if (parts.size() != version.size()) return std::nullopt;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto number = number_of<int>(parts[i]);
    if (!number) return std::nullopt;
    version[i] = *number;
  }
  return version;
}

/// The version that wrote a result. @throws Error where it is missing, or none whose results this
/// program knows.
std::string checked_version(const Json& result, const Error::Place& place) {
  constexpr const char* kFirst = "0.3.0";
  if (!result.contains("version")) throw broken(place, "lacks its \"version\"");
  const Json& version = result["version"];
  if (version.is_string()) {
    auto text = version.get<std::string>();
    const auto numbers = version_of(text);
    if (numbers && numbers >= version_of(kFirst) && numbers <= version_of(LASIUS_VERSION))
      return text;
  }
  throw Error(ErrorCode::file_unsupported, place,
              "its version is " + version.dump() + ", none from " + kFirst +
                  " to " LASIUS_VERSION ", which this program can replay",
              "verify it with the version that wrote it");
}

/// Leaves out of a replay what a result of an older version did not tell.
void keep_known(Json& replay, const Json& recorded) {
  for (auto it = replay.begin(); it != replay.end();) {
    const bool known = recorded.contains(it.key());
    if (known && it->is_object() && recorded[it.key()].is_object())
      keep_known(*it, recorded[it.key()]);
    it = known ? std::next(it) : replay.erase(it);
  }
}

/// Leaves out where an input was found.
void forget_places(Json& input) {
  if (input.is_array())
    for (Json& each : input) forget_places(each);
  if (!input.is_object()) return;
  for (const char* key : {"file", "srdf", "joint_limits", "packages"}) input.erase(key);
  if (!input.contains("files")) return;
  for (Json& file : input["files"])
    if (file.is_object()) file.erase("file");
}

/// A number from 0 up becomes 0: its value is not compared, but that it is one.
void compare_kind_alone(Json& of, const char* key) {
  if (!of.is_object() || !of.contains(key)) return;
  if (of[key].is_number() && of[key].get<double>() >= 0) of[key] = 0;
}

/// What no replay repeats: how long it took, and on how many threads.
void forget_effort(Json& result) {
  compare_kind_alone(result, "threads");
  compare_kind_alone(result, "elapsed_ms");
  if (!result.contains("replans") || !result["replans"].is_array()) return;
  for (Json& replan : result["replans"]) compare_kind_alone(replan, "ms");
}

/// The first difference between a result and its replay, or nothing. What may differ is left out;
/// `missing_optimum` becomes the optimum that is null in the result and found by the replay.
std::string difference(Json recorded, Json replay, std::string& missing_optimum) {
  if (recorded.contains("version") && recorded["version"] != replay["version"]) {
    replay["version"] = recorded["version"];
    for (Json* of : {&recorded, &replay})  // FCL said it before 0.4.0
      if (of->contains("recheck")) compare_kind_alone((*of)["recheck"], "nearest");
  }
  recorded.erase("part");
  forget_effort(recorded);
  forget_effort(replay);
  for (const char* input : {"map", "layers", "world", "changes", "robot", "scene", "held"}) {
    for (Json* of : {&recorded, &replay})
      if (of->contains(input)) forget_places((*of)[input]);
  }
  // A limit or a signal may have cut off the search for an optimum.
  using Keys = std::vector<const char*>;
  for (const Keys& keys :
       {Keys{"optimum", "optimum_gap", "ratio"}, Keys{"grid_optimum", "grid_gap"}}) {
    if (!recorded.contains(keys.front()) || !recorded[keys.front()].is_null()) continue;
    if (missing_optimum.empty() && replay.contains(keys.front()) && !replay[keys.front()].is_null())
      missing_optimum = keys.front();
    for (const char* key : keys) {
      if (recorded.contains(key) != replay.contains(key) ||
          (recorded.contains(key) && !recorded[key].is_null()))
        return key;
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

/// Where a result says that a file is, or there seen from the result's folder.
std::string found(const VerifyCommand& command, const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path beside = fs::path(command.result).parent_path() / file;
  return !fs::exists(file, ignored) && fs::exists(beside, ignored) ? beside.string() : file;
}

/// A text of a result; empty where it has none.
std::string text_of(const Json& recorded, const char* key) {
  const bool there = recorded.is_object() && recorded.contains(key) && recorded[key].is_string();
  return there ? recorded[key].get<std::string>() : std::string();
}

/// The kind that a result is of. @throws Error where no kind has its format.
const ProblemKind& kind_of(const Json& result, const Error::Place& place) {
  const std::string format = text_of(result, "format");
  std::vector<std::string_view> known;
  for (const ProblemKind* kind : kinds()) {
    if (kind->format == format && (kind->wrote == nullptr || kind->wrote(result))) return *kind;
    if (std::ranges::find(known, kind->format) == known.end()) known.push_back(kind->format);
  }
  std::string wanted;
  for (const auto name : known)
    wanted.append(wanted.empty() ? "" : name == known.back() ? " or " : ", ").append(name);
  throw broken(place, "is not of format " + wanted);
}

/// Why a result cannot be replayed; empty where it can.
std::string obstacle(const Json& result, const ProblemKind& kind) {
  const std::string status = text_of(result, "status");
  const bool clock = status == "limit" && (kind.counted == nullptr || !kind.counted(result));
  if (clock || status == "interrupted")
    return std::string(clock ? "a time limit" : "a signal") +
           " ended it, and no clock runs twice the same";
  if (const auto own = result.find("own_rules"); own != result.end() && *own == true)
    return "rules of the caller's own took part, which it does not hold";
  return kind.unlike != nullptr ? kind.unlike(result) : "";
}

/// Calls what reads a result; whatever is wrong with it is named by its place.
template <class Read>
decltype(auto) placed(const Error::Place& place, const Read& read) {
  try {
    return read();
  } catch (const UsageError& fault) {
    throw broken(place, std::string("cannot be replayed: ") + fault.what());
  } catch (const Error& fault) {
    if (fault.code() != ErrorCode::invalid_parameter) throw;
    throw broken(place, std::string("cannot be replayed: ") + fault.what());
  } catch (const Json::exception&) {
    throw broken(place, "cannot be replayed: a value is of another kind than in saved results");
  }
}

/// Replays one result and says what is wrong. Its exit code. `last`: the one before, or null.
int verify(const VerifyCommand& command, const Saved& saved, const std::string& name,
           std::unique_ptr<Problem>& last) {
  const Json& result = saved.json;
  const Error::Place place{.file = name, .offset = saved.offset};
  const ProblemKind& kind = placed(
      place, [&]() -> auto& { return kind_of(result, place); });
  const std::string version = checked_version(result, place);
  if (const auto why = placed(place, [&] { return obstacle(result, kind); }); !why.empty()) {
    message(name + ": cannot be replayed: " + why);
    return kUsage;
  }
  if (version != LASIUS_VERSION && !command.quiet)
    message(name + ": made by version " + version + ", replayed by " + LASIUS_VERSION);
  if (!command.map.empty() && !result.contains("map"))
    throw UsageError("--map: " + name + " has no map");
  const Recorded recorded{.result = result,
                          .found = [&](const auto& file) { return found(command, file); },
                          .threads = command.threads,
                          .map = command.map};
  Json replay = placed(place, [&] {
    auto problem = kind.again(recorded, last.get());
    last = std::move(problem);
    return tool::replay(*last, recorded);
  });
  Json told = result;
  if (version != LASIUS_VERSION) {
    if (kind.forget != nullptr) kind.forget(told);
    keep_known(replay, told);
    // Messages are worded anew now and then.
    if (text_of(result, "error").empty() == text_of(replay, "error").empty() &&
        replay.contains("error"))
      replay["error"] = result["error"];
  }
  std::string missing_optimum;
  const std::string key = difference(std::move(told), std::move(replay), missing_optimum);
  if (key.empty() && !missing_optimum.empty() && !command.quiet)
    message(std::string(name)
                .append(": its '")
                .append(missing_optimum)
                .append("' is null, the replay has one; all else is equal"));
  if (key.empty()) return kFound;
  message(std::string(name).append(": differs from its replay in '").append(key).append("'"));
  return kInternal;
}

int verify_all(const VerifyCommand& command) {
  const auto results = read_results(command.result);
  if (results.empty()) throw broken({.file = command.result, .offset = 0}, "holds no result");
  std::unique_ptr<Problem> last;
  int code = kFound;
  std::size_t equal = 0;
  for (std::size_t i = 0; i < results.size(); ++i) {
    const std::string name = results.size() > 1 ? nth_result(command.result, i) : command.result;
    const int one = verify(command, results[i], name, last);
    if (one == kFound) ++equal;
    // A difference weighs more than a result that cannot be replayed.
    if (code != kInternal && one != kFound) code = one;
  }
  if (!command.quiet)
    print_verdict(std::to_string(equal) + " of " + std::to_string(results.size()) +
                  (results.size() == 1 ? " result is" : " results are") + " equal to the replay\n");
  return code;
}

}  // namespace

Subcommand add_verify(CLI::App& app) {
  auto to = std::make_shared<VerifyCommand>();
  OptionTable table(app, "verify", "Replay saved results and compare");
  table
      .file("RESULT", to->result, "A result of plan, drive, tour or arm, or the lines of batch",
            {".json", ".jsonl", ".ndjson"})
      ->required();
  table.file("--map", to->map, "The map, where it is no longer where it was", map_endings(true));
  table.add("--threads", "Threads of the replay", "N",
            [to](const auto& text) { to->threads = thread_count(text); });
  table.flag("-q,--quiet", to->quiet, "Print differences only");
  return table.command(
      {.detail =
           "Results are replayed from their recorded inputs, and all is compared but threads, "
           "times, version and optima of --gap that were not found in time.",
       .examples = {{"lasius verify run.json", "replays what plan -o run.json wrote"}},
       .exits = {{kFound, "every result was replayed and is equal, bit for bit"},
                 {kInternal, "one differs; internal error"},
                 {kUsage,
                  "usage, or a result that cannot be replayed, because a time limit or a signal "
                  "ended it"},
                 {kBadFile,
                  "a result or its map, robot or scene is missing, broken, or not the one "
                  "recorded"}}},
      [to](const Call&) {
        if (to->threads == 0) to->threads = thread_count("");
        return verify_all(*to);
      });
}

}  // namespace lasius::tool
