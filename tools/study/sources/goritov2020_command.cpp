// lasius study goritov2020.
#include "tools/draw/line_chart.h"
#include "tools/options/commands.h"
#include "tools/study/conduct.h"
#include "tools/study/files.h"
#include "tools/study/sources/goritov2020.h"
#include "tools/study/sources/goritov2020_measures.h"
#include "tools/study/study_file.h"

namespace lasius::tool {
namespace {

namespace fs = std::filesystem;
using study::Experiment;
using study::Findings;
using study::LineChart;

/// The curves of one sweep under one reading, the base set among them.
LineChart chart_of(const Findings& findings, const Experiment& reading, const std::string& sweep,
                   const std::string& base, std::vector<double> study::Run::*curve,
                   const std::string& what) {
  LineChart chart{.title = what + ", " + sweep + " (" + reading.name + ")",
                  .x_label = "iteration",
                  .y_label = "length / optimum"};
  for (const study::Contender& setting : reading.contenders) {
    const bool is_base = setting.name == "base";
    if (!is_base && !setting.name.starts_with(sweep + "-")) continue;
    study::Curve line{.label = is_base ? sweep + " = " + base : setting.label,
                      .colour = study::palette(chart.curves.size())};
    line.y = study::mean_curve(findings.of(reading.name, setting.name), curve);
    for (std::size_t i = 0; i < line.y.size(); ++i) line.x.push_back(static_cast<double>(i) + 1);
    chart.curves.push_back(std::move(line));
  }
  return chart;
}

std::vector<std::string> draw_sweeps(const study::Study& study, const Findings& findings,
                                     const fs::path& folder) {
  struct Sweep {
    const char *name, *base;
  };
  static constexpr Sweep kSweeps[] = {{"alpha", "1"},  {"beta", "1"}, {"gamma", "0.25"},
                                      {"rho", "0.25"}, {"m", "64"},   {"T", "100"},
                                      {"e", "0"}};
  std::vector<std::string> files;
  for (const Experiment& reading : study.experiments) {
    for (const Sweep& sweep : kSweeps) {
      files.push_back(reading.name + "-" + sweep.name + ".svg");
      const auto chart = [&](std::vector<double> study::Run::*curve, const char* what) {
        return chart_of(findings, reading, sweep.name, sweep.base, curve, what);
      };
      study::chart_page(
          {chart(&study::Run::best, "best so far"), chart(&study::Run::mean, "mean tour")}, 620,
          420)
          .save((folder / files.back()).string());
    }
  }
  return files;
}

}  // namespace

int run_arm_study(const StudyCommand& command, const fs::path& maps) {
  const fs::path folder = command.folder;
  const study::Study study = study::make_study(command.name);
  const study::ArmScenes scenes(study, maps);
  return conduct(command, study, scenes, [&](const Findings& findings, const StopCondition&) {
    std::vector<study::ArmGround> grounds;
    for (const study::Question& question : study.experiments.front().questions)
      grounds.push_back(scenes.ground(question));
    study::write_text(folder / "report.md",
                      arm_report(study, findings, grounds, draw_sweeps(study, findings, folder)));
  });
}

}  // namespace lasius::tool
