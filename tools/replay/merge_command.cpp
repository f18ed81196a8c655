// lasius merge: the parts of a batch or of a study become the whole.
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/output.h"
#include "lasius/base/error.h"
#include "tools/command_line/search_options.h"
#include "tools/console/exit_code.h"
#include "tools/console/threads.h"
#include "tools/console/values.h"
#include "tools/options/commands.h"
#include "tools/record/outputs.h"
#include "tools/record/saved.h"
#include "tools/study/files.h"
#include "tools/study/part_file.h"

namespace lasius::tool {
namespace {

namespace fs = std::filesystem;
using json::Json;

constexpr std::string_view kLines[] = {".json", ".jsonl", ".ndjson"};

struct MergeCommand {
  std::vector<std::string> parts;
  std::string output;
  int threads = 0;
  bool quiet = false;
  std::string called = {};
};

Error not_of_one(const std::string& file, const std::string& problem) {
  return Error(ErrorCode::file_broken, {.file = file}, problem, "give each part of one run once");
}

/// "2 of 4", "1, 3 of 4": what is missing of parts from 1 to `of`.
std::string missing_parts(const std::set<int>& there, int of) {
  constexpr std::size_t kMost = 8;
  std::vector<int> missing;
  for (int number = 1; number <= of && missing.size() < kMost; ++number)
    if (!there.contains(number)) missing.push_back(number);
  std::string text;
  for (const int number : missing)
    text.append(text.empty() ? "" : ", ").append(std::to_string(number));
  return text.empty() ? text : text + " of " + std::to_string(of);
}

/// The answers of a batch's parts, those of each query together.
class Answers {
 public:
  void take(const std::string& file, std::size_t i, Json answer) {
    const auto wrong = [&](const std::string& problem) {
      return not_of_one(nth_result(file, i), problem);
    };
    if (!answer.is_object() || !answer.contains("part") ||
        !answer.value("index", Json()).is_number_unsigned() || !answer.contains("status"))
      throw wrong("is no answer that `lasius batch --part I/N` printed");
    try {
      const Json part = answer.at("part");
      const auto index = answer.at("index").get<std::size_t>();
      const int number = part.at("number").get<int>();
      answer.erase("part");
      Json run = part;
      run.erase("number");
      run["gap"] = answer.contains("optimum");
      for (const char* key : {"format", "version", "map", "algorithm", "parameters"})
        run[key] = answer.at(key);
      for (const char* key : {"via", "layers"}) run[key] = answer.value(key, Json());
      if (run_.is_null()) run_ = run;
      for (const auto& [key, value] : run.items())
        if (run_[key] != value) throw wrong("differs from the first answer in '" + key + "'");
      if (const auto known = files_.emplace(number, file).first; known->second != file)
        throw wrong("is of part " + std::to_string(number) + ", as is " + known->second);
      if (index >= run.at("queries").get<std::size_t>() ||
          index % run.at("of").get<std::size_t>() != static_cast<std::size_t>(number - 1))
        throw wrong("query " + std::to_string(index) + " is none of its part");
      if (answer.at("status") == "interrupted")
        throw wrong("was interrupted: part " + std::to_string(number) + " is not whole");
      if (!seen_.emplace(index, answer.value("seed", std::uint64_t{0})).second)
        throw wrong("answers query " + std::to_string(index) + " once more");
      answers_[index].push_back(json::line(answer));
    } catch (const nlohmann::json::exception& fault) {
      throw wrong(fault.what());
    }
  }

  /// The lines of the whole run. @throws Error where some are missing.
  std::string lines() const {
    if (run_.is_null())
      throw Error(ErrorCode::file_missing, {}, "no part holds an answer",
                  "give those that do, too; without queries there is nothing to join");
    const auto of = run_["of"].get<std::size_t>(), queries = run_["queries"].get<std::size_t>();
    std::size_t seeds = 0;
    for (const auto& [index, lines] : answers_) seeds = std::max(seeds, lines.size());
    std::string text;
    std::optional<std::size_t> missing;
    for (std::size_t i = 0; i < queries && !missing; ++i) {
      const auto found = answers_.find(i);
      if (found == answers_.end() || found->second.size() != seeds) missing = i;
      if (!missing)
        for (const std::string& line : found->second) text += line;
    }
    if (!missing) return text;
    throw Error(
        ErrorCode::file_missing, {},
        "query " + std::to_string(*missing) + " of " + std::to_string(queries) + " lacks answers",
        "give the whole output of part " + std::to_string(*missing % of + 1) + "/" +
            std::to_string(of));
  }

 private:
  Json run_;                          ///< what all answers have in common
  std::map<int, std::string> files_;  ///< by the number of the part
  std::map<std::size_t, std::vector<std::string>> answers_;
  std::set<std::pair<std::size_t, std::uint64_t>> seen_;  ///< query and seed
};

int merge_batch(const MergeCommand& command) {
  if (!command.output.empty()) check_ending(command.output, kLines);
  const std::vector<std::string> files(command.output.empty() ? 0 : 1, command.output);
  check_outputs(files, command.parts);
  Answers answers;
  for (const std::string& file : command.parts) {
    auto results = read_results(file);
    for (std::size_t i = 0; i < results.size(); ++i)
      answers.take(file, i, std::move(results[i].json));
  }
  const std::string lines = answers.lines();
  Delivery delivery(files);
  delivery.print(lines);
  delivery.write([&](const std::string& file) {
    write_output(file, {.json = [&](auto& out) { out << lines; }});
  });
  return kFound;
}

/// Copies the runs of a part, of one study or of several.
void copy_runs(const fs::path& from, const fs::path& to) {
  if (fs::weakly_canonical(from) == fs::weakly_canonical(to)) return;
  for (const auto& entry : fs::recursive_directory_iterator(from)) {
    const fs::path inside = fs::relative(entry.path(), from);
    const bool is_run = std::ranges::find(inside, fs::path("runs")) != inside.end();
    if (!entry.is_regular_file() || (!is_run && inside != study::kShortStudy)) continue;
    study::make_folder((to / inside).parent_path());
    fs::copy_file(entry.path(), to / inside, fs::copy_options::overwrite_existing);
  }
}

int merge_study(const MergeCommand& command) {
  const fs::path folder = command.output.empty() ? command.parts.front() : command.output;
  std::optional<StudyCommand> whole;
  std::string hash;
  std::set<int> there;
  for (const std::string& part : command.parts) {
    for (const study::StudyPart& found : study::read_parts(part)) {
      const StudyCommand& one = found.command;
      if (!whole) {
        whole = one;
        hash = found.hash;
      }
      if (found.hash != hash || one.name != whole->name || one.part.of != whole->part.of ||
          one.first_seed != whole->first_seed || one.seeds != whole->seeds ||
          one.maps != whole->maps)
        throw not_of_one(part, "is part of another run than " + command.parts.front());
      if (!there.insert(one.part.number).second)
        throw not_of_one(part, "is part " + std::to_string(one.part.number) + " once more");
    }
  }
  if (const auto missing = missing_parts(there, whole->part.of); !missing.empty())
    throw Error(ErrorCode::file_missing, {}, "part " + missing + " is missing",
                "run it by --part, and give its folder too");
  try {
    for (const std::string& part : command.parts) copy_runs(part, folder);
  } catch (const fs::filesystem_error& fault) {
    throw Error(ErrorCode::output_failed, {.file = folder.string()}, fault.what(),
                "make room for the runs, or give another folder by -o");
  }
  if (whole->name == "run") whole->name = (folder / study::kShortStudy).string();
  whole->part = {};
  whole->joined = true;
  whole->folder = folder.string();
  whole->threads = command.threads;
  whole->messages.quiet = command.quiet;
  whole->called = command.called;
  return run_command(*whole);
}

int merge(const MergeCommand& command) {
  for (const std::string& part : command.parts)
    if (std::ranges::count(command.parts, part) > 1)
      throw UsageError("merge: " + part + " is given twice");
  std::error_code ignored;
  const auto is_folder = [&](const std::string& part) { return fs::is_directory(part, ignored); };
  const auto folders = std::ranges::count_if(command.parts, is_folder);
  if (folders == 0) return merge_batch(command);
  if (folders == std::ssize(command.parts)) return merge_study(command);
  throw UsageError("merge: folders are parts of a study, files of a batch; give one kind");
}

}  // namespace

Subcommand add_merge(CLI::App& app) {
  auto to = std::make_shared<MergeCommand>();
  OptionTable table(app, "merge", "Join the parts of a batch or of a study");
  table
      .shell(table.repeatable("PART", to->parts,
                              "What `lasius batch --part I/N` printed, in any order; or folders of "
                              "`lasius study --part I/N`",
                              "FILE|DIR"),
             {.files = true, .endings = texts(kLines)})
      ->allow_extra_args()
      ->expected(-1)
      ->required();
  table.text("-o,--output", to->output,
             "Of a batch: FILE.json, the lines; of a study: the folder of the whole (default: the "
             "first)",
             "FILE|DIR");
  table.add("--threads", "Threads for what is left to do", "N",
            [to](const auto& text) { to->threads = thread_count(text); });
  table.flag("-q,--quiet", to->quiet, "Print errors only");
  return table.command(
      {.detail = "Prints what the undivided run prints: the lines of a batch in the order of its "
                 "queries, "
                 "or the name of a study's report, which is made of the runs in all of the "
                 "folders. Parts that are missing or "
                 "not whole, of another run or given twice are refused.",
       .examples = {{"lasius merge part1.jsonl part2.jsonl",
                     "the lines of `lasius batch`, each part of which was answered elsewhere"}},
       .exits = {{kFound, "joined"},
                 {kBadFile, "a part is missing, broken, not whole, or of another run"},
                 kOutput}},
      [to](const Call& call) {
        if (to->threads == 0) to->threads = thread_count("");
        to->called = call.line;
        return merge(*to);
      });
}

}  // namespace lasius::tool
