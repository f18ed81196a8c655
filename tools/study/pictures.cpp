#include "tools/study/pictures.h"

#include <algorithm>
#include <cmath>

#include "tools/draw/line_chart.h"
#include "tools/draw/map_panel.h"
#include "tools/draw/text.h"
#include "tools/study/files.h"
#include "tools/study/map_source.h"
#include "tools/study/statistics.h"
#include "tools/study/values.h"

namespace lasius::study {
namespace {

using tool::fixed;

constexpr std::size_t kMostDrawn = 12;  ///< contenders: more cannot be told apart

}  // namespace

bool draws_questions(const Experiment& experiment) {
  return experiment.charts.empty() && experiment.contenders.size() <= kMostDrawn;
}

std::vector<const Sample*> drawn(const Findings& findings, const Experiment& experiment,
                                 const Question& question) {
  std::vector<const Sample*> samples;
  for (const Contender& contender : experiment.contenders)
    if (const Sample* s = findings.find(experiment.name, question.name, contender.name))
      if (!s->runs.empty()) samples.push_back(s);
  return samples;
}

const Run* best_run(const Sample& sample) {
  const Run* best = nullptr;
  for (const Run& run : sample.runs)
    if (run.solved() && (best == nullptr || run.length < best->length)) best = &run;
  return best;
}

namespace {

namespace fs = std::filesystem;

/// Median and quartiles over the runs of all samples, by paths built; a run without a path yet
/// counts as infinitely long.
tool::Curve curve_of(const std::vector<const Sample*>& samples, std::vector<double> Run::*values,
                     std::size_t number) {
  tool::Curve curve{.label = samples.front()->contender->label, .colour = tool::palette(number)};
  std::size_t iterations = 0;
  for (const Sample* sample : samples)
    for (const Run& run : sample->runs) iterations = std::max(iterations, (run.*values).size());
  for (std::size_t i = 0; i < iterations; ++i) {
    std::vector<double> lengths;
    for (const Sample* sample : samples) {
      for (const Run& run : sample->runs) {
        const auto& all = run.*values;
        const double length = all.empty() ? kInfinity : all[std::min(i, all.size() - 1)];
        lengths.push_back(std::isfinite(length) ? length : kInfinity);
      }
    }
    curve.x.push_back(static_cast<double>(i + 1) * samples.front()->paths_an_iteration);
    curve.y.push_back(quantile(lengths, 0.5));
    curve.low.push_back(quantile(lengths, 0.25));
    curve.high.push_back(quantile(lengths, 0.75));
  }
  return curve;
}

tool::LineChart chart_of(const std::string& title, const Study& study) {
  return {.title = title + ": median, band of the quartiles",
          .x_label = "paths built",
          .y_label = "length, " + study.unit};
}

/// Share of the runs within the experiment's target, by paths built.
tool::LineChart run_lengths(const std::vector<const Sample*>& samples, double optimum) {
  const double target = samples.front()->experiment->targets.front();
  tool::LineChart chart{.title = "Runs " + target_text(target),
                        .x_label = "paths built",
                        .y_label = "share of the runs",
                        .lengths = false};
  for (const Sample* sample : samples) {
    tool::Curve curve{.label = sample->contender->label,
                      .colour = tool::palette(chart.curves.size())};
    auto efforts = sample->each([&](const Run& run) {
      return value_of(*sample, run, {.name = "effort", .at = "paths", .target = target}, kUnknown,
                      optimum);
    });
    std::ranges::sort(efforts);
    double done = 0, most = 0;
    for (const Run& run : sample->runs) most = std::max(most, 1.0 * run.iterations);
    curve.x.push_back(0);
    curve.y.push_back(0);
    for (const double effort : efforts) {
      if (!std::isfinite(effort)) break;
      for (const double share : {done, done + 1 / static_cast<double>(efforts.size())}) {
        curve.x.push_back(effort);
        curve.y.push_back(done = share);
      }
    }
    curve.x.push_back(most * sample->paths_an_iteration);
    curve.y.push_back(done);
    chart.curves.push_back(std::move(curve));
  }
  return chart;
}

/// A contender's name and its best length.
std::string legend_of(const Sample& sample, const std::optional<double>& optimum) {
  const Run* const run = best_run(sample);
  if (run == nullptr) return sample.contender->label + ": no path";
  const std::string text = sample.contender->label + ": " + fixed(run->length, 3);
  return optimum ? text + tool::against(run->length, *optimum, "optimum", fixed(*optimum, 3))
                 : text;
}

/// The map with the best path of each contender, the first one on top; lengths below.
void draw_paths(const Findings& findings, const Experiment& experiment, const Question& question,
                const Grid& grid, const fs::path& file) {
  const auto samples = drawn(findings, experiment, question);
  const auto optimum = findings.optimum(experiment, question);
  std::vector<tool::Key> keys;
  for (const Sample* sample : samples)
    keys.push_back(tool::line_key(legend_of(*sample, optimum), tool::palette(keys.size()), 3));
  std::ranges::copy(tool::map_keys(), std::back_inserter(keys));
  const auto draw = [&](tool::Canvas& canvas, const tool::Box& box) {
    const tool::Axes axes = tool::draw_map(canvas, box, grid, question.start, question.goal);
    for (std::size_t i = samples.size(); i-- > 0;)
      if (const Run* const run = best_run(*samples[i]))  // wider below: equal paths stay visible
        canvas.polyline(axes.at(run->path), tool::palette(i), 3 + 2.5 * static_cast<double>(i));
  };
  save(tool::Page{.title = "Best paths on " + question.name,
                  .legend = keys,
                  .wide = 1.0 * grid.width(),
                  .high = 1.0 * grid.height(),
                  .bands = {{.rows = {{{"", draw}}}}}},
       file);
}

}  // namespace

std::vector<tool::LineChart> convergence_charts(const Study& study, const Findings& findings,
                                                const Experiment& experiment,
                                                const Question& question) {
  tool::LineChart chart = chart_of("Best length so far on " + question.name, study);
  const auto optimum = findings.optimum(experiment, question);
  if (optimum) chart.levels = {{optimum_text(experiment.optimum), *optimum}};
  const auto samples = drawn(findings, experiment, question);
  for (const Sample* sample : samples)
    chart.curves.push_back(curve_of({sample}, &Run::best, chart.curves.size()));
  if (std::ranges::all_of(chart.curves, [](const tool::Curve& c) { return c.x.size() < 2; }))
    return {};
  std::vector<tool::LineChart> charts{std::move(chart)};
  if (optimum)
    if (tool::LineChart lengths = run_lengths(samples, *optimum);
        std::ranges::any_of(lengths.curves, [](const tool::Curve& c) { return c.y.back() > 0; }))
      charts.push_back(std::move(lengths));
  return charts;
}

std::vector<tool::LineChart> contender_charts(const Study& study, const Findings& findings,
                                              const Experiment& experiment,
                                              const std::vector<std::string>& contenders) {
  std::vector<tool::LineChart> charts{chart_of("Best so far", study), chart_of("Mean tour", study)};
  for (const std::string& name : contenders) {
    const auto samples = findings.of(experiment.name, name);
    if (samples.empty()) continue;
    for (auto& chart : charts)
      chart.curves.push_back(curve_of(samples, &chart == charts.data() ? &Run::best : &Run::mean,
                                      chart.curves.size()));
  }
  return charts;
}

std::vector<Figure> draw_pictures(const Study& study, const Findings& findings,
                                  const fs::path& folder, const fs::path& maps) {
  make_folder(folder / "pictures");
  std::vector<Figure> figures;
  for (const Experiment& experiment : study.experiments) {
    for (const auto& [name, contenders] : experiment.charts) {
      const std::string file = "pictures/" + experiment.name + "-" + name;
      save(contender_charts(study, findings, experiment, contenders), folder / file);
      figures.push_back({&experiment, file, "Best and mean tours, " + name});
    }
    if (!draws_questions(experiment)) continue;
    for (const Question& question : experiment.questions) {
      if (drawn(findings, experiment, question).empty()) continue;
      const std::string stem = "pictures/" + experiment.name + "-" + question.name;
      if (study.kind == ProblemKind::bitmap) {
        const Grid grid = load_map(question, maps);
        draw_paths(findings, experiment, question, grid, folder / (stem + "-paths"));
        figures.push_back(
            {&experiment, stem + "-paths", "Best paths of each algorithm on " + question.name});
      }
      const auto charts = convergence_charts(study, findings, experiment, question);
      if (charts.empty()) continue;
      save(charts, folder / (stem + "-convergence"));
      figures.push_back({&experiment, stem + "-convergence",
                         "Best length so far by paths built on " + question.name});
    }
  }
  return figures;
}

}  // namespace lasius::study
