#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "tools/console/exit_code.h"
#include "tools/console/progress.h"
#include "tools/console/signals.h"
#include "tools/console/streams.h"
#include "tools/draw/line_chart.h"
#include "tools/options/commands.h"
#include "tools/polygon/polygon_picture.h"
#include "tools/study/files.h"
#include "tools/study/sources/maklink.h"

namespace lasius::tool {
namespace {

namespace fs = std::filesystem;

study::Curve curve(const study::CrossingSample& sample, std::size_t colour) {
  return {.label = sample.contender.label, .colour = study::palette(colour)};
}

/// Standard deviation by iteration, over paths tried so that both kinds share an axis.
study::LineChart deviation_chart(const study::MaklinkStudy& study) {
  study::LineChart chart{.title = "Standard deviation of the best length over the trials",
                         .x_label = "paths tried",
                         .y_label = "standard deviation, m"};
  constexpr std::size_t kMostPaths = 10000;
  std::size_t colour = 0;
  for (const auto& sample : study.samples) {
    if (sample.contender.name == "ga" || sample.contender.name == "ga-x10") continue;
    study::Curve one = curve(sample, colour++);
    const auto values = study::deviation(sample);
    const auto paths = static_cast<std::size_t>(sample.contender.paths);
    for (std::size_t q = 0; q < values.size() && (q + 1) * paths <= kMostPaths; ++q) {
      one.x.push_back(static_cast<double>((q + 1) * paths));
      one.y.push_back(values[q]);
    }
    chart.curves.push_back(std::move(one));
  }
  return chart;
}

study::LineChart trial_chart(const study::MaklinkStudy& study) {
  study::LineChart chart{.title = "Length of the path found, trial by trial",
                         .x_label = "trial",
                         .y_label = "length, m",
                         .level = study.optimum,
                         .level_label = "optimum of the world"};
  std::size_t colour = 0;
  for (const auto& sample : study.samples) {
    study::Curve one = curve(sample, colour++);
    one.dots = true;
    for (const auto& trial : sample.trials) {
      one.x.push_back(static_cast<double>(trial.seed));
      one.y.push_back(trial.length);
    }
    chart.curves.push_back(std::move(one));
  }
  return chart;
}

void save_chart(const study::LineChart& chart, const fs::path& file) {
  constexpr int kWidth = 900, kHeight = 560;
  Canvas canvas(kWidth, kHeight);
  study::draw(canvas, {20, 16, kWidth - 40.0, kHeight - 32.0}, chart);
  canvas.save(file.string());
}

/// The plan of seed 1, as `lasius plan` draws it.
void save_plan(const study::MaklinkStudy& study, const fs::path& file) {
  PolygonCommand command;
  command.world.file = study.world;
  command.algorithm = "maklink-acs";
  std::vector<std::string> notes;
  const auto parameters = polygon_parameters(command, notes);
  const PreparedWorld world = prepare_world(command.world);
  write_polygon_picture(file.string(), world, polygon_answer(world, command, parameters, {}));
}

}  // namespace

int run_maklink_study(const StudyCommand& command, const std::string& maps) {
  const fs::path folder = command.folder;
  study::make_folder(folder);
  SignalWatcher signals;
  const auto study = [&] {
    ProgressLine bar(wants_progress(command.messages), 1000);
    return study::run_maklink(maps, command.seeds, signals.token(), [&](int done, int all) {
      bar.update(std::int64_t{1000} * done / all, "");
    });
  }();
  if (!study) {
    message("interrupted");
    return kInterrupted;
  }
  save_plan(*study, folder / "plan.svg");
  save_chart(trial_chart(*study), folder / "trials.svg");
  save_chart(deviation_chart(*study), folder / "deviation.svg");
  study::write_text(folder / "runs.csv", study::maklink_runs(*study).csv());
  study::write_text(
      folder / "report.md",
      study::maklink_page(*study,
                          {{"plan.svg", "Lines, Dijkstra's path, the ants' path (seed 1)"},
                           {"trials.svg", "Variation over the trials (the source's figure 8)"},
                           {"deviation.svg", "Standard deviation (the source's figure 10)"}}));
  print((folder / "report.md").string() + "\n");
  return kFound;
}

}  // namespace lasius::tool
