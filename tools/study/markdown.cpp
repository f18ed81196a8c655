#include "tools/study/markdown.h"

#include <algorithm>

#include "lasius/version.h"
#include "tools/study/factors.h"

namespace lasius::study {
namespace {

constexpr const char* kHowToRead =
    R"(A claim is a hypothesis whose statistic, control and test stood in the study's file before the runs.
Runs are independent, not paired by seed. "less": Mann and Whitney's test in the sum over the
questions (of shares it is Fisher's exact test); A12 is the share of pairs of runs in which the first
is less. "within": two such tests at the bounds; the effect is the ratio of medians. "in more than":
a binomial test of the share of runs, with Clopper and Pearson's interval. The other intervals are
percentiles of 2000 resamplings of the runs. p is two-sided, by Holm's method over all tests of the
table; below 0.05 counts, where the interval agrees and no question speaks clearly against the
others. A claim is "map-dependent" where it holds on one question (a map with start and goal) and
fails on another, p of each by Bonferroni over questions and tests, 5% of its own; p in the table is
that of all questions together. Questions on which all runs of both do the same decide nothing, but
where a factor or "within" is asked. A run that does not get there counts as infinitely long; the
expected running time is what all runs spent by the number of successes. "At equal steps": both are
read where the more frugal of them ended.
)";

constexpr const char* kHowToReadResults =
    R"(Quartiles and medians are over all runs, one without a path counting as infinitely long ("-").
Paths are those that ants or individuals built. Time is the median processor time of a run on one
thread.
)";

std::string settings_text(const Experiment& experiment) {
  Table table{{"name", "algorithm", "settings over the defaults"}};
  for (const Contender& c : experiment.contenders) {
    std::string settings;
    for (const auto& [name, value] : c.settings)
      settings.append("`").append(name).append("=").append(value).append("` ");
    table.rows.push_back({c.name, c.label + " (`" + c.algorithm + "`)", settings});
  }
  return table.markdown();
}

std::string paragraph(const std::string& text) { return text.empty() ? "" : text + "\n\n"; }

std::string section(const Experiment& experiment, const Findings& findings,
                    const std::vector<Figure>& figures) {
  std::string text = "## " + experiment.title + "\n\n" + paragraph(experiment.text);
  text += result_table(findings, experiment).markdown() + "\n";
  const Table factors = findings.whole ? factor_table(findings, experiment) : Table{};
  if (!factors.rows.empty())
    text += "What each parameter does, whatever the others are:\n\n" + factors.markdown() + "\n";
  for (const Figure& figure : figures) {
    if (figure.experiment != &experiment) continue;
    text += "![" + figure.caption + "](" + figure.file + ".png)\n\n" + figure.caption + " ([SVG](" +
            figure.file + ".svg))\n\n";
  }
  return text + "<details><summary>Settings</summary>\n\n" + settings_text(experiment) +
         "\n</details>\n\n";
}

}  // namespace

std::string report_page(const Study& study, const Findings& findings,
                        std::span<const Evidence> evidence, Seeds seeds,
                        const std::vector<Figure>& figures) {
  std::string text = "# Study " + study.title() + "\n\n" + paragraph(study.source) + "`" +
                     called(study.asked(), seeds) +
                     "`, lasius " LASIUS_VERSION ". Lengths: " + study.unit + ". " + study.text +
                     "\n\n";
  if (!findings.whole) {
    std::size_t done = 0;
    for (const Sample& s : findings.samples) done += s.runs.size();
    text += "**Partial: interrupted after " + std::to_string(done) + " of " +
            std::to_string(findings.samples.size() * static_cast<std::size_t>(seeds.count)) +
            " runs; no verdicts.**\n\n";
  }
  for (const SkippedContender& a : findings.skipped)
    text += "Not run: " + a.contender + " in `" + a.experiment + "` (" + a.reason + ").\n\n";
  if (!evidence.empty())
    text += (study.file.empty() ? "## What the source claims\n\n" : "## Claims\n\n") +
            claim_table(evidence).markdown() + "\n";
  for (const Experiment& experiment : study.experiments)
    text += section(experiment, findings, figures);
  return text + "## How to read the tables\n\n" + kHowToRead + "\n" + kHowToReadResults +
         "\nEvery run: `runs.csv`; the tables: `claims.csv`, `results.csv`.\n";
}

std::vector<std::span<const Evidence>> by_study(std::span<const Evidence> evidence) {
  std::vector<std::span<const Evidence>> all;
  while (!evidence.empty()) {
    const Study* const study = evidence.front().study;
    const auto other = std::ranges::find_if(evidence, [&](auto& e) { return e.study != study; });
    const auto count = static_cast<std::size_t>(other - evidence.begin());
    all.push_back(evidence.first(count));
    evidence = evidence.subspan(count);
  }
  return all;
}

std::string claims_page(std::span<const Evidence> evidence, const std::string& command) {
  std::string outcomes;
  for (const auto of_one : by_study(evidence)) {
    const std::string& name = of_one.front().study->name;
    outcomes += "\n## `" + name + "`\n\nPlaces, statistics, tests and figures: [" + name +
                "](claims/" + name + ".md).\n\n" + outcome_table(of_one).markdown();
  }
  const auto count = [&](Verdict verdict) {
    return std::to_string(std::ranges::count(evidence, verdict, &Evidence::verdict)) + " " +
           verdict_text(verdict);
  };
  return "# The claims of all sources\n\n`" + command + "`, lasius " LASIUS_VERSION ": " +
         count(Verdict::confirmed) + ", " + count(Verdict::refuted) + ", " +
         count(Verdict::depends) + ", " + count(Verdict::undecided) + ", " +
         count(Verdict::no_baseline) + ", " + count(Verdict::arithmetic) + ", " +
         count(Verdict::none) +
         ". A row's own command is `lasius study STUDY --seeds SEEDS`, whose report corrects over "
         "its own rows only.\n\n" +
         kHowToRead + outcomes;
}

std::string claim_details(std::span<const Evidence> evidence) {
  return "# The claims of " + evidence.front().study->title() +
         "\n\nHow to read them, and those of the other sources: [claims.md](../claims.md).\n" +
         claim_table(evidence).markdown_lists();
}

}  // namespace lasius::study
