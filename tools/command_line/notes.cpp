#include "tools/command_line/notes.h"

#include <algorithm>
#include <map>

#include "tools/console/exit_code.h"

namespace lasius::tool {
namespace {

/// The exit codes that every command has, with its own among them.
std::vector<ExitText> exits(std::vector<ExitText> own) {
  const auto add = [&](int code, const char* meaning) {
    if (std::ranges::find(own, code, &ExitText::code) == own.end()) own.push_back({code, meaning});
  };
  add(kFound, "it was done");
  add(kInternal, "internal error");
  add(kUsage, "usage");
  std::ranges::sort(own, {}, &ExitText::code);
  return own;
}

const ExitText kOutput{kNoOutput, "an output cannot be written"};

std::map<std::string_view, Notes> make_notes() {
  return {
      {"plan",
       {.examples = {{"lasius plan maps/fan400x200.map --start 14,14 --goal 380,179",
                      "the shortest path: status, length, vertices"},
                     {"lasius plan maps/fan400x200.map --start 14,14 --goal 380,179 "
                      "--algorithm mmas --iterations 20 --gap -o run.json -o run.png",
                      "a colony, its gap to the optimum, a result to verify and a picture"},
                     {"lasius plan maps/grid20a.map --start 0,0 --goal 19,19 --algorithm as "
                      "--set persistence=0.7 --seed 1-5",
                      "five seeds: a JSON object each"},
                     {"lasius plan maps/maklink200.geojson --algorithm maklink-acs",
                      "among polygons, whose file names start and goal"}},
        .exits = exits({{kFound, "a path was returned"},
                        {kBadFile, "a map is missing or broken"},
                        {kInvalidQuery, "start or goal outside or blocked"},
                        {kUnreachable, "proven unreachable"},
                        {kNoPath, "no path: limit or iterations spent"},
                        kOutput,
                        {kInterrupted, "interrupted, best so far written"}}),
        .json = "program/JSON of a plan"}},
      {"drive",
       {.examples =
            {{"lasius drive maps/grid30a.map --start 0,0 --goal 29,29 --sense 3 -o run.png",
              "a robot that sees three cells far, and a picture of its way"},
             {"lasius drive maps/free-space-simple.map --start 0,0 --goal 9,9 --sense 2 --world "
              "maps/free-space-average.map --json",
              "a world that is not as the map has it"}},
        .exits = exits({{kFound, "the robot arrived"},
                        {kBadFile, "map, world or changes are missing or broken"},
                        {kInvalidQuery, "start or goal outside or blocked"},
                        {kUnreachable, "proven unreachable on what is known at last"},
                        {kNoPath, "not arrived: trapped, or a limit spent"},
                        kOutput,
                        {kInterrupted, "interrupted, the drive so far written"}}),
        .json = "driving/JSON of a drive"}},
      {"batch",
       {.examples = {{"lasius batch maps/fan400x200.map queries.tsv --prepare",
                      "a JSON object for each line of queries.tsv, which begins with sx sy gx gy"}},
        .exits = exits(
            {{kFound, "every query was answered, be it by status invalid, unreachable or no_path"},
             {kBadFile, "map or queries are missing or broken, nothing printed"},
             kOutput,
             {kInterrupted, "interrupted, whole lines only"}}),
        .json = "program/JSON of a plan"}},
      {"info",
       {.examples = {{"lasius info maps/fan400x200.map --prepare",
                      "size, components, and what the visibility graph costs"},
                     {"lasius info maps/fan400x200.map --start 14,14 --goal 380,179",
                      "how wide a robot may be that is to go there"}},
        .exits = exits({{kBadFile, "the map is missing or broken"}})}},
      {"algorithms",
       {.examples = {{"lasius algorithms mmas", "formulas and parameters of one algorithm"}}}},
      {"generate",
       {.examples = {{"lasius generate rooms --size 256x256 --seed 7 -o rooms.map",
                      "the same map on every machine"}},
        .exits = exits({kOutput})}},
      {"verify",
       {.detail =
            "Results are replayed from their recorded inputs, and all is compared but threads, "
            "times, version and optima of --gap that were not found in time.",
        .examples = {{"lasius verify run.json", "replays what plan -o run.json wrote"}},
        .exits =
            exits({{kFound, "every result was replayed and is equal, bit for bit"},
                   {kInternal, "one differs; internal error"},
                   {kUsage,
                    "usage, or a result that cannot be replayed, because a time limit or a signal "
                    "ended it"},
                   {kBadFile,
                    "a result or its map, robot or scene is missing, broken, or not the one "
                    "recorded"}})}},
      {"study",
       {.detail =
            "A source's experiments are run again and set beside its figures. A file describes "
            "maps, questions, algorithms, a sweep of parameters, seeds, budget and claims: see "
            "`lasius help studies`. run asks one question of every algorithm at every combination "
            "of "
            "the values of --set, and writes the file that says the same, study.yaml. A study "
            "goes on where an earlier call stopped.",
        .examples = {{"lasius study list", "the studies that there are"},
                     {"lasius study fan2004 -o fan", "the report fan/report.md, with all runs"},
                     {"lasius study run maps/grid20a.map --start 0,0 --goal 19,19 --algorithm "
                      "as,mmas --set persistence=0.5,0.9 --seeds 1..5 -o sweep",
                      "two algorithms, two values each, five seeds"}},
        .exits = exits(
            {{kBadFile, "a map or a study's file is missing or broken"},
             {kInvalidQuery, "run's start or goal outside or blocked"},
             kOutput,
             {kInterrupted, "interrupted: the report is partial and the same command goes on"}})}},
      {"tune",
       {.detail = "The result is judged on maps that were not used to find it, and written as a "
                  "preset for --preset. See `lasius help studies`.",
        .exits = exits({{kBadFile, "a map or the file is missing or broken"},
                        kOutput,
                        {kInterrupted,
                         "interrupted: the best so far is in preset.yaml, and the same command "
                         "goes on"}})}},
      {"arm",
       {.examples = {{"lasius arm maps/arms/industrial6.json --scene maps/arms/cell.json "
                      "--start -0.9,0.3,0.4,0,0.4,0 --goal 0.45,0.4,0.5 -o motion.csv",
                      "a motion, and its trajectory as a table"}},
        .exits = exits(
            {{kFound, "a motion was returned"},
             {kBadFile, "robot, scene or another file is missing or broken"},
             {kInvalidQuery, "start or goal outside, blocked, or proven out of reach"},
             {kNoPath,
              "none found, or a limit is spent: that a goal in reach has no way is never proven"},
             kOutput,
             {kInterrupted, "interrupted, best so far written"}}),
        .json = "program/JSON of an arm's motion"}},
      {"help",
       {.examples = {{"lasius help json", "the fields of results"},
                     {"lasius help plan", "what `lasius plan --help` says"}}}},
  };
}

}  // namespace

Notes notes_of(std::string_view command) {
  static const auto kNotes = make_notes();
  const auto known = kNotes.find(command);
  Notes notes = known == kNotes.end() ? Notes{} : known->second;
  if (notes.exits.empty()) notes.exits = exits({});
  return notes;
}

}  // namespace lasius::tool
