// The report of system D.
#include <cmath>

#include "lasius/version.h"
#include "tools/draw/text.h"
#include "tools/study/markdown.h"
#include "tools/study/sources/goritov2020.h"
#include "tools/study/sources/goritov2020_measures.h"
#include "tools/study/statistics.h"
#include "tools/study/table.h"

namespace lasius::study {
namespace {

std::string answer_text(const Claim::Answer& answer) {
  return verdict_text(answer.verdict) + ": " + answer.figures;
}

Table question_table(const std::vector<ArmGround>& grounds) {
  Table table{{"question", "lattice", "optimum, m", "optimum / Manhattan", "straight way"}, {}};
  for (const ArmGround& ground : grounds) {
    const auto& [x, y, z] = ground.points;
    table.rows.push_back(
        {"seed " + std::to_string(ground.made.seed) + ", wall " + fixed(ground.made.wall, 1),
         std::to_string(x) + " x " + std::to_string(y) + " x " + std::to_string(z),
         fixed(ground.optimum, 3), fixed(ground.detour, 2), ground.straight ? "open" : "closed"});
  }
  return table;
}

Table setting_table(const Findings& findings, const Experiment& reading) {
  Table table{{"setting", "best length / optimum, mean [95%]", "runs at the optimum",
               "mean tour at last / optimum", "iteration of the best", "mean tour frozen",
               "questions", "steps"},
              {}};
  for (const Contender& setting : reading.contenders) {
    const Runs runs = findings.of(reading.name, setting.name);
    std::vector<double> lengths, tours;
    double questions = 0;
    int optimal = 0, all = 0;
    for (const Sample* question : runs) {
      for (const Run& run : question->runs) {
        ++all;
        questions += static_cast<double>(run.checks);
        if (!std::isfinite(final_best(run))) continue;
        lengths.push_back(final_best(run));
        tours.push_back(run.mean.back());
        optimal += final_best(run) <= 1 + 1e-9;
      }
    }
    if (lengths.empty()) continue;
    const Interval interval = mean_interval(lengths);
    table.rows.push_back({setting.name,
                          fixed(summarise(lengths).mean, 3) + " [" + fixed(interval.low, 3) + ", " +
                              fixed(interval.high, 3) + "]",
                          percent(static_cast<double>(optimal) / all) + "%",
                          fixed(summarise(tours).mean, 2), fixed(mean_reached(runs), 1),
                          Freezing(runs).text(), fixed(questions / all, 0),
                          fixed(mean_steps(runs), 0)});
  }
  return table;
}

}  // namespace

std::string arm_report(const Study& study, const Findings& findings,
                       const std::vector<ArmGround>& grounds,
                       const std::vector<std::string>& pictures) {
  std::string text = "# " + study.name + "\n\n" + study.source +
                     " Repeated with lasius " LASIUS_VERSION ", seeds 1 to " +
                     std::to_string(findings.samples.front().runs.size()) + ".\n\n" + study.text +
                     "\n\n" + question_table(grounds).markdown() + "\n## Trends\n\n";
  Table trends{{"reported", "found, arcs", "found, edges"}, {}};
  for (const ArmTrend& trend : arm_trends(findings))
    trends.rows.push_back({trend.text, answer_text(trend.found[0]), answer_text(trend.found[1])});
  text += trends.markdown();
  text +=
      "\nFigures say how much longer the best path is, in percent of the optimum, mean over all "
      "questions and seeds and 95% interval of the paired differences (10 000 resampled means). A "
      "trend is confirmed where every interval says so, and does not reproduce where one says the "
      "opposite. A run's mean tour is frozen where it does not change in the last tenth.\n";
  for (const Experiment& reading : study.experiments)
    text += "\n## " + reading.title + "\n\n" + setting_table(findings, reading).markdown();
  text += "\n## Curves\n\n";
  for (const auto& picture : pictures) text += "![" + picture + "](" + picture + ")\n";
  return text;
}

}  // namespace lasius::study
