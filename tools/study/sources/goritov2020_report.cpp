// The report of system D.
#include <cmath>

#include "lasius/version.h"
#include "tools/draw/text.h"
#include "tools/study/sources/goritov2020.h"
#include "tools/study/sources/goritov2020_measures.h"
#include "tools/study/statistics.h"
#include "tools/study/table.h"

namespace lasius::study {
namespace {

std::string verdict_text(const Claim::Answer& answer) {
  const char* name = answer.verdict == Verdict::confirmed ? "confirmed"
                     : answer.verdict == Verdict::refuted ? "**does not reproduce**"
                                                          : "open";
  return std::string(name) + ": " + answer.figures;
}

Table question_table(const ArmFindings& findings) {
  Table table{{"question", "lattice", "optimum, m", "optimum / Manhattan", "straight way"}, {}};
  for (std::size_t q = 0; q < findings.questions.size(); ++q) {
    const ArmGround& ground = findings.grounds[q];
    const auto& [x, y, z] = ground.points;
    table.rows.push_back({"seed " + std::to_string(findings.questions[q].seed) + ", wall " +
                              fixed(findings.questions[q].wall, 1),
                          std::to_string(x) + " x " + std::to_string(y) + " x " + std::to_string(z),
                          fixed(ground.optimum, 3), fixed(ground.detour, 2),
                          ground.straight ? "open" : "closed"});
  }
  return table;
}

Table setting_table(const ArmFindings& findings, std::size_t reading) {
  Table table{{"setting", "best length / optimum, mean [95%]", "runs at the optimum",
               "mean tour at last / optimum", "iteration of the best", "mean tour frozen",
               "questions", "steps"},
              {}};
  for (const ArmSetting& setting : findings.settings) {
    const Runs& runs = findings.of(reading, setting.name());
    std::vector<double> lengths, tours;
    double questions = 0;
    int optimal = 0, all = 0;
    for (const auto& question : runs) {
      for (const ArmRun& run : question) {
        ++all;
        questions += static_cast<double>(run.questions);
        if (!std::isfinite(final_best(run))) continue;
        lengths.push_back(final_best(run));
        tours.push_back(run.mean.back());
        optimal += final_best(run) <= 1 + 1e-9;
      }
    }
    if (lengths.empty()) continue;
    const Interval interval = mean_interval(lengths);
    table.rows.push_back({setting.name(),
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

std::string arm_report(const ArmFindings& findings, const std::vector<std::string>& pictures) {
  std::string text =
      "# goritov2020\n\nGoritov, Goncharov: Motion trajectory planning for a multi-link "
      "manipulator "
      "in an unknown environment based on ant colony optimization. Proceedings of TUSUR University "
      "23 (2), 2020, 55-64. Repeated with lasius " LASIUS_VERSION ", seeds 1 to " +
      std::to_string(findings.seeds) +
      ".\n\nThe source's arm and scenes are lost. Here: the arm maps/arms/industrial6.json among "
      "12 "
      "random obstacles, with a wall between start and goal in half of the questions. Lengths are "
      "shares of the optimum of the fully known lattice, found by A*. Its words speak of pheromone "
      "on edges, its set of edges of ordered pairs: both readings are run, `arcs` being this "
      "program's default.\n\n";
  text += question_table(findings).markdown() + "\n## Trends\n\n";
  Table trends{{"reported", "found, arcs", "found, edges"}, {}};
  for (const ArmTrend& trend : arm_trends(findings))
    trends.rows.push_back({trend.text, verdict_text(trend.found[0]), verdict_text(trend.found[1])});
  text += trends.markdown();
  text +=
      "\nFigures say how much longer the best path is, in percent of the optimum, mean over all "
      "questions and seeds and 95% interval of the paired differences (10 000 resampled means). A "
      "trend is confirmed where every interval says so, and does not reproduce where one says the "
      "opposite. A run's mean tour is frozen where it does not change in the last tenth.\n";
  for (std::size_t r = 0; r < kReadings.size(); ++r) {
    text += "\n## All settings, pheromone on " + std::string(kReadings[r]) + "\n\n" +
            setting_table(findings, r).markdown();
  }
  text += "\n## Curves\n\n";
  for (const auto& picture : pictures) text += "![" + picture + "](" + picture + ")\n";
  return text;
}

}  // namespace lasius::study
