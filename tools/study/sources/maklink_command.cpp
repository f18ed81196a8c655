// lasius study maklink.
#include <nlohmann/json_fwd.hpp>

#include "tools/draw/line_chart.h"
#include "tools/options/commands.h"
#include "tools/polygon/polygon_picture.h"
#include "tools/study/conduct.h"
#include "tools/study/files.h"
#include "tools/study/sources/maklink.h"
#include "tools/study/study_file.h"

namespace lasius::tool {
namespace {

namespace fs = std::filesystem;

study::Curve curve(const study::Sample& sample, std::size_t colour) {
  return {.label = sample.contender->label, .colour = study::palette(colour)};
}

/// Standard deviation by iteration, over paths tried so that both kinds share an axis.
study::LineChart deviation_chart(const study::Findings& findings) {
  study::LineChart chart{.title = "Standard deviation of the best length over the trials",
                         .x_label = "paths tried",
                         .y_label = "standard deviation, m"};
  constexpr std::size_t kMostPaths = 10000;
  std::size_t colour = 0;
  for (const auto& sample : findings.samples) {
    if (sample.contender->name == "ga" || sample.contender->name == "ga-x10") continue;
    study::Curve one = curve(sample, colour++);
    const auto values = study::deviation(sample);
    const auto paths = static_cast<std::size_t>(sample.paths_an_iteration);
    for (std::size_t q = 0; q < values.size() && (q + 1) * paths <= kMostPaths; ++q) {
      one.x.push_back(static_cast<double>((q + 1) * paths));
      one.y.push_back(values[q]);
    }
    chart.curves.push_back(std::move(one));
  }
  return chart;
}

study::LineChart trial_chart(const study::Findings& findings, double optimum) {
  study::LineChart chart{.title = "Length of the path found, trial by trial",
                         .x_label = "trial",
                         .y_label = "length, m",
                         .level = optimum,
                         .level_label = "optimum of the world"};
  std::size_t colour = 0;
  for (const auto& sample : findings.samples) {
    study::Curve one = curve(sample, colour++);
    one.dots = true;
    for (const auto& trial : sample.runs) {
      one.x.push_back(static_cast<double>(trial.seed));
      one.y.push_back(trial.length);
    }
    chart.curves.push_back(std::move(one));
  }
  return chart;
}

void save_chart(const study::LineChart& chart, const fs::path& file) {
  study::chart_page({chart}, 860, 528).save(file.string());
}

/// The plan of seed 1, as `lasius plan` draws it.
void save_plan(const std::string& world_file, const fs::path& file) {
  PolygonCommand command;
  command.world.file = world_file;
  command.algorithm = "maklink-acs";
  std::vector<std::string> notes;
  const auto parameters = polygon_parameters(command, notes);
  const LoadedWorld world = load_world(command.world);
  write_polygon_picture(file.string(), world, polygon_answer(world, command, parameters, {}));
}

}  // namespace

int run_maklink_study(const StudyCommand& command, const std::string& maps) {
  const fs::path folder = command.folder;
  const study::Study study = study::make_study(command.name);
  const study::MaklinkWorld world(study, maps);
  return conduct(command, study, world, [&](const study::Findings& findings, const StopCondition&) {
    save_plan(world.file(), folder / "plan.svg");
    save_chart(trial_chart(findings, world.figures().optimum), folder / "trials.svg");
    save_chart(deviation_chart(findings), folder / "deviation.svg");
    study::write_text(folder / "runs.csv", study::maklink_runs(findings).csv());
    study::write_text(
        folder / "report.md",
        study::maklink_page(study, findings, world,
                            {{"plan.svg", "Lines, Dijkstra's path, the ants' path (seed 1)"},
                             {"trials.svg", "Variation over the trials (the source's figure 8)"},
                             {"deviation.svg", "Standard deviation (the source's figure 10)"}}));
  });
}

}  // namespace lasius::tool
