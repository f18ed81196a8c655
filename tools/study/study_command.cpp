#include <algorithm>
#include <filesystem>

#include "core/base/did_you_mean.h"
#include "tools/console/exit_code.h"
#include "tools/console/progress.h"
#include "tools/console/signals.h"
#include "tools/console/streams.h"
#include "tools/console/values.h"
#include "tools/options/commands.h"
#include "tools/study/files.h"
#include "tools/study/markdown.h"
#include "tools/study/pictures.h"
#include "tools/study/portrait.h"
#include "tools/study/runner.h"
#include "tools/study/table.h"

namespace lasius::tool {
namespace {

namespace fs = std::filesystem;

#ifdef LASIUS_WITH_POLYGON
constexpr std::string_view kMaklink = "maklink";  // among polygons: runs and reports on its own
#endif
/// It asks arms, not maps, and has a runner of its own.
constexpr const char* kArmStudy = "goritov2020";

std::string list_text() {
  std::string text;
  for (const study::Entry& entry : study::catalogue())
    text += std::string(entry.name) + "\t" + entry.make().summary + "\n";
#ifdef LASIUS_WITH_POLYGON
  text += std::string(kMaklink) + "\tant colony system over MAKLINK lines, a genetic comparator\n";
#endif
  return text + kArmStudy + "\tthe source's parameters on arms among unknown obstacles\n";
}

study::Study make_study(const std::string& name) {
  std::vector<std::string_view> names;
  for (const study::Entry& entry : study::catalogue()) {
    if (entry.name == name) return entry.make();
    names.push_back(entry.name);
  }
#ifdef LASIUS_WITH_POLYGON
  names.push_back(kMaklink);
#endif
  names.push_back(kArmStudy);
  names.push_back("list");
  throw UsageError("unknown study \"" + name + "\"; " + did_you_mean(name, names));
}

/// Maps are looked for in the option's folder, else beside the installed program, else in the
/// source tree.
fs::path find_maps(const std::string& option) {
  if (!option.empty()) return option;
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  const fs::path installed = program.parent_path() / LASIUS_INSTALLED_MAPS;
  return fs::is_directory(installed, ignored) ? installed : fs::path(LASIUS_SOURCE_MAPS);
}

void write_report(const study::Study& study, const study::Findings& findings,
                  const StudyCommand& command, const fs::path& maps, const StopCondition& stop) {
  const fs::path folder = command.folder;
  auto figures = study::draw_pictures(study, findings, folder, maps);
  for (auto& figure : study::draw_portraits(study, folder, maps, stop))
    figures.push_back(std::move(figure));
  std::string results, tests;
  for (const study::Experiment& experiment : study.experiments) {
    results += experiment.name + "\n" + result_table(findings, experiment).csv() + "\n";
    tests += experiment.name + "\n" + test_table(findings, experiment).csv() + "\n";
  }
  study::write_text(folder / "runs.csv", run_table(findings).csv());
  study::write_text(folder / "results.csv", results);
  study::write_text(folder / "tests.csv", tests);
  study::write_text(folder / "report.md", report_page(study, findings, command.seeds, figures));
}

}  // namespace

int run_study(const StudyCommand& command) {
  if (command.name == "list") {
    print(list_text());
    return kFound;
  }
  const fs::path maps = find_maps(command.maps);
#ifdef LASIUS_WITH_POLYGON
  if (command.name == kMaklink) return run_maklink_study(command, maps.string());
#endif
  if (command.name == kArmStudy) return run_arm_study(command, maps);
  const study::Study study = make_study(command.name);
  SignalWatcher signals;
  const auto findings = [&] {
    constexpr std::int64_t kParts = 1000;
    ProgressLine bar(wants_progress(command.messages), kParts);
    study::RunnerOptions options{.seeds = command.seeds,
                                 .threads = command.threads,
                                 .folder = command.folder,
                                 .maps = maps,
                                 .stop = signals.token()};
    options.progress = [&](std::int64_t done, std::int64_t total, const std::string& note) {
      bar.update(done * kParts / std::max<std::int64_t>(total, 1), note);
    };
    return study::run_study(study, options);
  }();
  if (!findings) {
    message("interrupted; the same command goes on from here");
    return kInterrupted;
  }
  write_report(study, *findings, command, maps, {.token = signals.token()});
  print((fs::path(command.folder) / "report.md").string() + "\n");
  return kFound;
}

}  // namespace lasius::tool
