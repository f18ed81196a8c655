#include "tools/study/markdown.h"

#include "lasius/version.h"
#include "tools/study/table.h"

namespace lasius::study {
namespace {

constexpr const char* kHowToRead =
    R"(Lengths are in cells. Mean, sd and interval are over the runs that found a path; the interval is the
2.5 to 97.5 percentile of 10 000 resampled means. A gap is (length - optimum) / optimum against the
true optimum. Iterations to converge: the last one that improved a run's best length, median (least
to most). Time is the median processor time of a run on one thread.

Tests compare the first algorithm of a table with each other one, paired by seed: Wilcoxon's
signed-rank test, two-sided, exact, p adjusted by Holm's method over the table; effect is the
matched-pairs rank biserial correlation, from -1 to 1, positive where the first one is shorter;
"longer by" is the median of the paired differences; a run without a path counts as infinitely
long. "x10": the other algorithm has ten times the iterations.
)";

std::string claims_text(const Study& study, const Findings& findings) {
  if (study.claims.empty()) return {};
  Table table{{"claim", "verdict", "figures", "likely reason"}, {}};
  for (const Claim& claim : study.claims) {
    const auto answer = claim.check(findings);
    table.rows.push_back({claim.text, verdict_text(answer.verdict), answer.figures,
                          answer.verdict == Verdict::refuted ? claim.reason : ""});
  }
  return "## What the source claims\n\n" + table.markdown() + "\n";
}

std::string settings_text(const Experiment& experiment) {
  Table table{{"algorithm", "settings over the defaults"}, {}};
  for (const Contender& c : experiment.contenders) {
    std::string settings;
    for (const auto& [name, value] : c.settings) settings += "`" + name + "=" + value + "` ";
    if (c.budget > 1) settings += std::to_string(c.budget) + " times the iterations";
    table.rows.push_back({c.label + " (`" + c.algorithm + "`)", settings});
  }
  return table.markdown();
}

std::string section(const Experiment& experiment, const Findings& findings,
                    const std::vector<Figure>& figures) {
  std::string text = "## " + experiment.title + "\n\n" + experiment.text + "\n\n";
  text += result_table(findings, experiment).markdown() + "\n";
  const auto tests = test_table(findings, experiment);
  if (!tests.rows.empty()) text += tests.markdown() + "\n";
  for (const Figure& figure : figures) {
    if (figure.experiment != &experiment) continue;
    text += "![" + figure.caption + "](" + figure.file + ".png)\n\n" + figure.caption + " ([SVG](" +
            figure.file + ".svg))\n\n";
  }
  return text + "<details><summary>Settings</summary>\n\n" + settings_text(experiment) +
         "\n</details>\n\n";
}

}  // namespace

std::string verdict_text(Verdict verdict) {
  constexpr const char* kTexts[] = {"confirmed", "**does not reproduce**", "open"};
  return kTexts[static_cast<int>(verdict)];
}

std::string report_page(const Study& study, const Findings& findings, int seeds,
                        const std::vector<Figure>& figures) {
  std::string text = "# Study " + study.name + ": " + study.summary + "\n\n" + study.source +
                     "\n\n" + std::to_string(seeds) + " seeds, lasius " LASIUS_VERSION ". " +
                     study.text + "\n\n";
  for (const Absent& a : findings.absent)
    text += "Not run: " + a.contender + " in `" + a.experiment + "` (" + a.reason + ").\n\n";
  text += claims_text(study, findings);
  for (const Experiment& experiment : study.experiments)
    text += section(experiment, findings, figures);
  return text + "## How to read the tables\n\n" + kHowToRead +
         "\nEvery run: `runs.csv`; the tables: `results.csv`, `tests.csv`.\n";
}

}  // namespace lasius::study
