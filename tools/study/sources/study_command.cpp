// lasius study: the studies on bitmaps, and where the others begin.
#include <algorithm>
#include <filesystem>

#include "core/base/did_you_mean.h"
#include "tools/console/exit_code.h"
#include "tools/console/streams.h"
#include "tools/console/values.h"
#include "tools/options/commands.h"
#include "tools/study/bitmaps.h"
#include "tools/study/conduct.h"
#include "tools/study/files.h"
#include "tools/study/markdown.h"
#include "tools/study/pictures.h"
#include "tools/study/portrait.h"
#include "tools/study/study_file.h"
#include "tools/study/table.h"

namespace lasius::tool {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMaklink = "maklink";       // among polygons
constexpr std::string_view kArmStudy = "goritov2020";  // of arms

std::vector<std::string_view> names() {
  auto all = study::study_names();
#ifndef LASIUS_WITH_POLYGON
  std::erase(all, kMaklink);
#endif
  return all;
}

std::string list_text() {
  std::string text;
  for (const auto name : names())
    text += std::string(name) + "\t" + study::make_study(name).summary + "\n";
  return text;
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
  auto known = names();
  if (std::ranges::find(known, command.name) == known.end()) {
    known.push_back("list");
    throw UsageError("unknown study \"" + command.name + "\"; " +
                     did_you_mean(command.name, known));
  }
  const fs::path maps = find_maps(command.maps);
#ifdef LASIUS_WITH_POLYGON
  if (command.name == kMaklink) return run_maklink_study(command, maps.string());
#endif
  if (command.name == kArmStudy) return run_arm_study(command, maps);
  const study::Study study = study::make_study(command.name);
  return conduct(command, study, study::Bitmaps(study, maps),
                 [&](const study::Findings& findings, const StopCondition& stop) {
                   write_report(study, findings, command, maps, stop);
                 });
}

}  // namespace lasius::tool
