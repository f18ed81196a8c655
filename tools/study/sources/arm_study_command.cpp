// lasius study goritov2020.
#include <algorithm>

#include "tools/console/exit_code.h"
#include "tools/console/progress.h"
#include "tools/console/signals.h"
#include "tools/console/streams.h"
#include "tools/draw/canvas.h"
#include "tools/draw/line_chart.h"
#include "tools/options/commands.h"
#include "tools/study/files.h"
#include "tools/study/sources/goritov2020.h"
#include "tools/study/sources/goritov2020_measures.h"

namespace lasius::tool {
namespace {

namespace fs = std::filesystem;

/// The curves of one sweep under one reading, the base set among them.
study::LineChart chart_of(const study::ArmFindings& findings, std::size_t reading,
                          const std::string& sweep, const std::string& base,
                          std::vector<double> study::ArmRun::*curve, const std::string& what) {
  study::LineChart chart{.title = what + ", " + sweep + " (" + study::kReadings[reading] + ")",
                         .x_label = "iteration",
                         .y_label = "length / optimum",
                         .curves = {}};
  const auto add = [&](const std::string& name, const std::string& label) {
    study::Curve line{.label = label, .colour = study::palette(chart.curves.size())};
    line.y = study::mean_curve(findings.of(reading, name), curve);
    for (std::size_t i = 0; i < line.y.size(); ++i) line.x.push_back(static_cast<double>(i) + 1);
    chart.curves.push_back(std::move(line));
  };
  add("base", sweep + " = " + base);
  for (const auto& setting : findings.settings)
    if (setting.sweep == sweep) add(setting.name(), sweep + " = " + setting.value);
  return chart;
}

std::vector<std::string> draw_sweeps(const study::ArmFindings& findings, const fs::path& folder) {
  constexpr int kWidth = 620, kHeight = 420, kMargin = 16;
  static constexpr std::pair<const char*, const char*> kSweeps[] = {
      {"alpha", "1"}, {"beta", "1"}, {"gamma", "0.25"}, {"rho", "0.25"},
      {"m", "64"},    {"T", "100"},  {"e", "0"}};
  std::vector<std::string> files;
  for (std::size_t r = 0; r < study::kReadings.size(); ++r) {
    for (const auto& [sweep, base] : kSweeps) {
      Canvas canvas(2 * kWidth + 3 * kMargin, kHeight + 2 * kMargin);
      const Box left{kMargin, kMargin, kWidth, kHeight};
      const Box right{kWidth + 2 * kMargin, kMargin, kWidth, kHeight};
      study::draw(canvas, left,
                  chart_of(findings, r, sweep, base, &study::ArmRun::best, "best so far"));
      study::draw(canvas, right,
                  chart_of(findings, r, sweep, base, &study::ArmRun::mean, "mean tour"));
      files.push_back(std::string(study::kReadings[r]) + "-" + sweep + ".svg");
      canvas.save((folder / files.back()).string());
    }
  }
  return files;
}

}  // namespace

int run_arm_study(const StudyCommand& command, const fs::path& maps) {
  SignalWatcher signals;
  const fs::path folder = command.folder;
  const auto findings = [&] {
    constexpr std::int64_t kParts = 1000;
    ProgressLine bar(wants_progress(command.messages), kParts);
    study::ArmStudyOptions options{.seeds = command.seeds,
                                   .threads = command.threads,
                                   .folder = folder,
                                   .robot = maps / "arms" / "industrial6.json",
                                   .stop = signals.token()};
    options.progress = [&](std::int64_t done, std::int64_t total, const std::string& note) {
      bar.update(done * kParts / std::max<std::int64_t>(total, 1), note);
    };
    return study::run_arm_study(options);
  }();
  if (!findings) {
    message("interrupted; the same command goes on from here");
    return kInterrupted;
  }
  const auto pictures = draw_sweeps(*findings, folder);
  const fs::path report = folder / "report.md";
  study::write_text(report, study::arm_report(*findings, pictures));
  print(report.string() + "\n");
  return kFound;
}

}  // namespace lasius::tool
