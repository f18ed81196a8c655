// lasius study, lasius tune.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <tuple>

#include "tools/command_line/map_options.h"
#include "tools/command_line/search_options.h"
#include "tools/console/exit_code.h"
#include "tools/console/kinds.h"
#include "tools/console/parameters.h"
#include "tools/console/threads.h"
#include "tools/options/commands.h"
#include "tools/yaml/document.h"
#include "tools/yaml/preset_file.h"

namespace lasius::tool {
namespace {

/// What is typed of `study run`, beside what is read.
struct ShortText {
  std::string start, goal, algorithms;
  std::vector<std::string> set;
};

std::vector<std::string> values_in(const std::string& option, const std::string& text,
                                   std::size_t from = 0) {
  const auto parts = split(std::string_view(text).substr(from), ',');
  if (std::ranges::find(parts, "") != parts.end())
    throw UsageError(option + " " + text + ": a value is missing");
  return {parts.begin(), parts.end()};
}

/// NAME=VALUE,VALUE..., each tried with every algorithm that has the parameter.
std::pair<std::string, std::vector<std::string>> factor_of(
    const std::string& setting, const std::vector<std::string>& algorithms) {
  const auto equals = setting.find('=');
  if (equals == std::string::npos)
    throw UsageError("--set " + setting + ": not of the form NAME=VALUE,VALUE");
  const std::string name = setting.substr(0, equals);
  auto values = values_in("--set", setting, equals + 1);
  for (const std::string& value : values)
    if (std::ranges::count(values, value) > 1)
      throw UsageError("--set " + setting + ": " + value + " is given twice");
  bool known = false;
  for (const std::string& algorithm : algorithms) {
    if (!find_algorithm(algorithm).has(name)) continue;
    known = true;
    Params params(algorithm);
    for (const std::string& value : values) set_parameter(params, name, value);
  }
  if (!known)  // the message names the nearest
    (void)setting_of(setting, find_algorithm(algorithms.front()), lasius::algorithms());
  return {name, std::move(values)};
}

/// What `study run` asks for. @throws UsageError
void finish_run(ShortStudy& run, const ShortText& text) {
  require("study run: ", "MAP", run.map);
  if (is_polygon_file(run.map))
    throw UsageError("study run: " + run.map +
                     " is a polygon world; own studies plan on bitmaps alone");
  require("study run: ", "--start", text.start);
  require("study run: ", "--goal", text.goal);
  const auto end = [&](const char* option, const std::string& value) {
    const Point p = end_value(option, value, run.frame);
    constexpr double kOutside = 1e9;  // outside of every map
    return Point{std::clamp(p.x, -kOutside, kOutside), std::clamp(p.y, -kOutside, kOutside)};
  };
  run.start = end("--start", text.start);
  run.goal = end("--goal", text.goal);
  if (!text.algorithms.empty())
    run.algorithms = values_in("--algorithm", text.algorithms);
  else if (is_document(run.preset))
    run.algorithms = {read_preset_file(run.preset).algorithm};
  else
    require("study run: ", "--algorithm", "");
  for (const std::string& algorithm : run.algorithms) {
    (void)algorithm_of(bitmaps(), algorithm);
    if (std::ranges::count(run.algorithms, algorithm) > 1)
      throw UsageError("--algorithm " + text.algorithms + ": " + algorithm + " is given twice");
  }
  if (!run.preset.empty() && !is_document(run.preset))
    (void)choice_value("--preset", run.preset, kPresetNames);
  refuse_repeats(text.set);
  for (const std::string& setting : text.set)
    run.factors.push_back(factor_of(setting, run.algorithms));
}

void refuse_short_options(const OptionTable& table, const std::string& name) {
  for (const char* option :
       {"MAP", "--start", "--goal", "--frame", "--radius", "--cost", "--inflation", "--algorithm",
        "--preset", "--steps", "--time-limit", "--set"})
    if (table.given(option))
      throw UsageError((*option == 'M' ? "a second argument" : option) +
                       std::string(" is for `lasius study run MAP`; what ") + name +
                       " runs is in its file");
}

/// Where reports go unless -o says so: the file's name, or "run" for a map that is in none.
std::string usual_folder(const std::string& prefix, const std::string& file) {
  std::error_code ignored;
  const bool there = is_document(file) || std::filesystem::exists(file, ignored);
  return prefix + (there ? std::filesystem::path(file).stem().string() : "run");
}

int run_asked(const OptionTable& table, StudyCommand& study, const ShortText& text,
              const Call& call) {
  if (study.part.divided() && study.name == "list")
    throw UsageError("--part is for runs; list has none");
  if (study.part.divided() && is_page(study.folder))
    throw UsageError("-o " + study.folder + ": a part has no page; give a folder");
  study.called = call.line;
  if (study.threads == 0) study.threads = thread_count("");
  const bool run = study.name == "run";
  if (run)
    finish_run(study.run, text);
  else
    refuse_short_options(table, study.name);
  if (study.folder.empty())
    study.folder = run || is_document(study.name)
                       ? usual_folder("study-", run ? study.run.map : study.name)
                       : "study-" + study.name;
  return run_command(study);
}

void add_threads_and_maps(OptionTable& table, int& threads, std::string& maps) {
  threads = 0;
  table.add("--threads", "Runs at a time", "N",
            [&](const auto& text) { threads = thread_count(text); });
  table.text("--maps", maps, "Folder of the maps, instead of the program's own", "DIR");
}

/// What only `study run` reads.
void add_sweep_options(OptionTable& table, ShortStudy& run, ShortText& asked) {
  using enum Values::Names;
  table.text("--start", asked.start, "With run: where paths start", "X,Y");
  table.text("--goal", asked.goal, "With run: where they end", "X,Y");
  table.choice("--frame", run.frame, kFrames,
               "With run: of --start, --goal, --radius and --inflation, as plan has it",
               "cell|world");
  table.real("--radius", run.radius, 0, kNoLimit,
             "With run: of the robot, a disc, as plan --radius has it", "R");
  add_cost_options(table, run.costs);
  table.shell(table.text("--algorithm", asked.algorithms, "With run: the algorithms", "NAME,NAME"),
              {.names = algorithms, .list = true});
  table.shell(
      table.text("--preset", run.preset, "With run: numbers to start with", "usual|book|FILE"),
      {.choices = texts(kPresetNames), .files = true, .endings = kDocuments});
  table.shell(
      table.repeatable("--set", asked.set,
                       "With run: values of a parameter; all combinations are run (repeatable)",
                       "NAME=VALUE,VALUE"),
      {.names = parameters});
  table.real("--steps", run.steps, 1, 1e15, "With run: end a run after so many steps of its ants",
             "N");
  table.real("--time-limit", run.seconds, 1e-6, 1e9,
             "With run: end a run after this processor time", "SECONDS");
}

}  // namespace

Subcommand add_study(CLI::App& app) {
  struct Text : StudyCommand {
    ShortText texts;
  };
  auto to = std::make_shared<Text>();
  ShortStudy& run = to->run;
  OptionTable table(app, "study", "Run a study: a source's, your own, or a sweep");
  using enum Values::Names;
  table
      .shell(table.text("NAME", to->name,
                        "A study that the program holds, or FILE.yaml; run: a sweep on MAP; list: "
                        "what there is; all: each of them, and one table of claims",
                        "TEXT"),
             {.choices = {"list", "all", "run"},
              .files = true,
              .endings = kDocuments,
              .names = studies})
      ->required();
  table.text("MAP", run.map, "With run: the map, a file or \"KIND WxH DENSITY SEED\"", "FILE");
  table.add("--seeds", "Seeds of the runs, 1 to N or A to B (default: the study's own)",
            "N|A-B|A..B", [=](const auto& text) {
              std::tie(to->first_seed, to->seeds) = seed_range("--seeds", text, 1);
            });
  table.text(
      "-o,--output", to->folder,
      "Folder to write (default study-NAME); FILE.html: that page, and a folder FILE for the rest",
      "DIR|FILE.html");
  add_threads_and_maps(table, to->threads, to->maps);
  add_part(table, to->part,
           "Make the I-th of N parts of the runs, and no report; `lasius merge` joins the folders");
  add_sweep_options(table, run, to->texts);
  table.flag("-q,--quiet", to->messages.quiet, "Print errors only");
  return table.command(
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
       .exits = {{kBadFile, "a map or a study's file is missing or broken"},
                 {kInvalidQuery, "run's start or goal outside or blocked"},
                 kOutput,
                 {kInterrupted,
                  "interrupted: the report is partial and the same command goes on"}}},
      [=](const Call& call) { return run_asked(table, *to, to->texts, call); });
}

Subcommand add_tune(CLI::App& app) {
  auto to = std::make_shared<TuneCommand>();
  OptionTable table(app, "tune", "Find an algorithm's parameters for your maps by racing");
  table
      .file("FILE", to->file, "What is tuned, and on which maps: see lasius help studies",
            kDocuments)
      ->required();
  table.text("-o,--output", to->folder, "Folder to write (default tune-NAME)", "DIR");
  add_threads_and_maps(table, to->threads, to->maps);
  table.flag("-q,--quiet", to->messages.quiet, "Print errors only");
  return table.command(
      {.detail = "The result is judged on maps that were not used to find it, and written as a "
                 "preset for --preset. See `lasius help studies`.",
       .exits = {{kBadFile, "a map or the file is missing or broken"},
                 kOutput,
                 {kInterrupted,
                  "interrupted: the best so far is in preset.yaml, and the same command "
                  "goes on"}}},
      [to](const Call&) {
        if (to->threads == 0) to->threads = thread_count("");
        if (to->folder.empty()) to->folder = usual_folder("tune-", to->file);
        return run_command(*to);
      });
}

}  // namespace lasius::tool
