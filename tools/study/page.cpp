#include "tools/study/page.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>

#include "lasius/version.h"
#include "tools/bitmap/bitmap_report.h"
#include "tools/draw/line_chart.h"
#include "tools/report/report.h"
#include "tools/report/thinned.h"
#include "tools/study/map_source.h"
#include "tools/study/pictures.h"
#include "tools/study/table.h"

namespace lasius::study {
namespace {

using tool::Json;

constexpr std::size_t kMostPoints = 250;         // of a curve
constexpr std::size_t kMostBytes = 3'500'000;    // of charts and maps together
constexpr std::size_t kMostPathVertices = 1000;  // of a path

/// In six digits: more cannot be seen.
Json rounded(double value) {
  if (!std::isfinite(value)) return nullptr;
  if (value == 0) return 0;
  const double power = std::pow(10, 5 - std::floor(std::log10(std::abs(value))));
  return std::round(value * power) / power;
}

Json values_json(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : tool::thinned(values, values.size() / kMostPoints + 1))
    list.push_back(rounded(value));
  return list;
}

Json chart_json(const tool::LineChart& chart) {
  Json curves = Json::array(), levels = Json::array();
  for (const tool::Curve& curve : chart.curves)
    curves.push_back({{"name", curve.label},
                      {"x", values_json(curve.x)},
                      {"y", values_json(curve.y)},
                      {"low", values_json(curve.low)},
                      {"high", values_json(curve.high)}});
  for (const tool::Level& level : chart.levels)
    levels.push_back({{"name", level.label}, {"value", rounded(level.value)}});
  return {{"title", chart.title},  {"x_label", chart.x_label}, {"y_label", chart.y_label},
          {"calm", chart.lengths}, {"curves", curves},         {"levels", levels}};
}

Json charts_json(const std::vector<tool::LineChart>& charts) {
  Json list = Json::array();
  for (const tool::LineChart& chart : charts) list.push_back(chart_json(chart));
  return list;
}

Json table_json(const Table& table) { return {{"header", table.header}, {"rows", table.rows}}; }

Json path_json(const std::vector<Point>& path) {
  return tool::points(tool::thinned(path, path.size() / kMostPathVertices + 1));
}

/// The map of a question with the best path of each contender.
Json map_json(const PageInput& input, const Experiment& experiment, const Question& question) {
  const Grid grid = load_map(question, input.maps);
  Json paths = Json::array();
  for (const Sample* sample : drawn(input.findings, experiment, question)) {
    const Run* const run = best_run(*sample);
    paths.push_back({{"name", sample->contender->label},
                     {"length", run != nullptr ? rounded(run->length) : Json(nullptr)},
                     {"path", run != nullptr ? path_json(run->path) : Json(nullptr)}});
  }
  return {{"width", grid.width()},
          {"height", grid.height()},
          {"window", {0, 0, grid.width(), grid.height()}},
          {"walls", tool::walls_json(grid, tool::whole(grid))},
          {"to_world", nullptr},
          {"start", {question.start.x, question.start.y}},
          {"goal", {question.goal.x, question.goal.y}},
          {"paths", std::move(paths)}};
}

/// Views of an experiment: of each question, or the experiment's own charts.
class Views {
 public:
  explicit Views(const PageInput& input) : input_(input) {}

  Json of(const Experiment& experiment) {
    Json views = Json::array();
    for (const auto& chart : experiment.charts)
      add(views, [&] {
        return Json{{"name", chart.first},
                    {"map", nullptr},
                    {"charts", charts_json(contender_charts(input_.study, input_.findings,
                                                            experiment, chart.second))}};
      });
    if (!draws_questions(experiment)) return views;
    for (const Question& question : experiment.questions) {
      if (drawn(input_.findings, experiment, question).empty()) continue;
      add(views, [&] {
        return Json{{"name", question.name},
                    {"map", input_.study.kind == ProblemKind::bitmap
                                ? map_json(input_, experiment, question)
                                : Json(nullptr)},
                    {"charts", charts_json(convergence_charts(input_.study, input_.findings,
                                                              experiment, question))}};
      });
    }
    return views;
  }
  std::size_t left_out() const { return left_out_; }

 private:
  template <class Make>
  void add(Json& views, const Make& make) {
    if (bytes_ < kMostBytes) {
      Json view = make();
      bytes_ += tool::line(view).size();
      if (bytes_ < kMostBytes) return views.push_back(std::move(view));
    }
    ++left_out_;
  }

  const PageInput& input_;
  std::size_t bytes_ = 0, left_out_ = 0;
};

}  // namespace

void write_study_page(std::ostream& out, const PageInput& input) {
  const Study& study = input.study;
  Json content = {{"kind", "study"},          {"title", study.title()}, {"subtitle", study.source},
                  {"text", study.text},       {"unit", study.unit},     {"command", input.called},
                  {"version", LASIUS_VERSION}};
  content["whole"] = input.findings.whole;
  content["claims"] = table_json(claim_table(input.evidence));
  content["experiments"] = Json::array();
  Views views(input);
  for (const Experiment& experiment : study.experiments)
    content["experiments"].push_back(
        {{"title", experiment.title},
         {"text", experiment.text},
         {"results", table_json(result_table(input.findings, experiment))},
         {"views", views.of(experiment)}});
  content["left_out"] = views.left_out();
  tool::write_report_page(out, content);
}

}  // namespace lasius::study
