#include "tools/study/pictures.h"

#include <algorithm>
#include <cmath>

#include "tools/draw/line_chart.h"
#include "tools/draw/map_panel.h"
#include "tools/draw/text.h"
#include "tools/study/files.h"
#include "tools/study/map_source.h"
#include "tools/study/statistics.h"

namespace lasius::study {
namespace {

namespace fs = std::filesystem;

constexpr double kMargin = 20, kTitle = 34, kLegendLine = 22, kLegendText = 34, kLegendSize = 14;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The samples of a question with the equal budget: what is drawn.
std::vector<const Sample*> drawn(const Findings& findings, const Experiment& experiment,
                                 const Question& question) {
  std::vector<const Sample*> samples;
  for (const Contender& contender : experiment.contenders)
    if (contender.budget == 1)
      if (const Sample* s = findings.find(experiment.name, question.name, contender.name))
        samples.push_back(s);
  return samples;
}

/// Median and quartiles over the runs of the best length, by paths built; a run without a path yet
/// counts as infinitely long.
Curve convergence(const Sample& sample, Colour colour) {
  Curve curve{.label = sample.contender->label, .colour = colour};
  std::size_t iterations = 0;
  for (const Run& run : sample.runs) iterations = std::max(iterations, run.best.size());
  for (std::size_t i = 0; i < iterations; ++i) {
    std::vector<double> lengths;
    for (const Run& run : sample.runs) {
      const double best = run.best.empty() ? kInfinity : run.best[std::min(i, run.best.size() - 1)];
      lengths.push_back(std::isfinite(best) ? best : kInfinity);
    }
    curve.x.push_back(static_cast<double>(i + 1) * sample.paths_an_iteration);
    curve.y.push_back(quantile(lengths, 0.5));
    curve.low.push_back(quantile(lengths, 0.25));
    curve.high.push_back(quantile(lengths, 0.75));
  }
  return curve;
}

void draw_convergence(const Findings& findings, const Experiment& experiment,
                      const Question& question, const fs::path& file) {
  LineChart chart{.title = "Convergence on " + question.name + ": median and quartiles",
                  .x_label = "paths built",
                  .y_label = "best length so far, cells",
                  .level = findings.optimum(experiment, question),
                  .level_label = "true optimum"};
  for (const Sample* sample : drawn(findings, experiment, question))
    chart.curves.push_back(convergence(*sample, palette(chart.curves.size())));
  save(chart_page({chart}, 920, 560), file);
}

const Run* best_run(const Sample& sample) {
  const Run* best = nullptr;
  for (const Run& run : sample.runs)
    if (run.solved() && (best == nullptr || run.length < best->length)) best = &run;
  return best;
}

/// A contender's name and its best length.
std::string legend_of(const Sample& sample, const std::optional<double>& optimum) {
  const Run* const run = best_run(sample);
  if (run == nullptr) return sample.contender->label + ": no path";
  const std::string text = sample.contender->label + ": " + fixed(run->length, 3);
  if (!optimum) return text;
  return text + ", " + fixed(100 * (run->length / *optimum - 1), 2) + "% above the optimum";
}

/// The map with the best path of each contender, the first one on top; lengths below.
void draw_paths(const Findings& findings, const Experiment& experiment, const Question& question,
                const Grid& grid, const fs::path& file) {
  const auto samples = drawn(findings, experiment, question);
  const auto optimum = findings.optimum(experiment, question);
  std::vector<std::string> legends;
  Canvas measure(1, 1);
  double widest = 0;
  for (const Sample* sample : samples) {
    legends.push_back(legend_of(*sample, optimum));
    widest = std::max(widest, measure.text_width(legends.back(), kLegendSize));
  }
  double scale = std::min(1100.0 / grid.width(), 800.0 / grid.height());
  if (scale > 1) scale = std::floor(scale);
  const double wide = std::max({420.0, grid.width() * scale, kLegendText + widest});
  const double legend = static_cast<double>(samples.size()) * kLegendLine;
  const Box box{kMargin + (wide - grid.width() * scale) / 2, kMargin + kTitle, grid.width() * scale,
                grid.height() * scale};
  Canvas canvas(static_cast<int>(wide + 2 * kMargin),
                static_cast<int>(box.y + box.height + 16 + legend + kMargin));
  canvas.text({kMargin + wide / 2, kMargin + 18}, "Best paths on " + question.name, 17,
              Align::centre, kInk, true);
  paint_walls(canvas, box, grid);
  const auto page = [&](Point p) { return Point{box.x + p.x * scale, box.y + p.y * scale}; };
  for (std::size_t i = samples.size(); i-- > 0;) {
    if (const Run* const run = best_run(*samples[i])) {
      std::vector<Point> points;
      for (const Point p : run->path) points.push_back(page(p));
      // Wider below: equal paths stay visible as bands.
      canvas.polyline(points, palette(i), 3 + 2.5 * static_cast<double>(i));
    }
    const double y = box.y + box.height + 26 + static_cast<double>(i) * kLegendLine;
    canvas.line({kMargin, y}, {kMargin + 26, y}, palette(i), 3);
    canvas.text({kMargin + kLegendText, y + 5}, legends[i], kLegendSize, Align::left, kInk);
  }
  mark_ends(canvas, box, scale, question.start, question.goal);
  save(canvas, file);
}

}  // namespace

std::vector<Figure> draw_pictures(const Study& study, const Findings& findings,
                                  const fs::path& folder, const fs::path& maps) {
  make_folder(folder / "pictures");
  std::vector<Figure> figures;
  for (const Experiment& experiment : study.experiments) {
    for (const Question& question : experiment.questions) {
      if (drawn(findings, experiment, question).empty()) continue;
      const std::string stem = "pictures/" + experiment.name + "-" + question.name;
      const Grid grid = load_map(question.map, maps);
      draw_paths(findings, experiment, question, grid, folder / (stem + "-paths"));
      figures.push_back(
          {&experiment, stem + "-paths", "Best paths of each algorithm on " + question.name});
      draw_convergence(findings, experiment, question, folder / (stem + "-convergence"));
      figures.push_back({&experiment, stem + "-convergence",
                         "Best length so far by paths built on " + question.name});
    }
  }
  return figures;
}

}  // namespace lasius::study
