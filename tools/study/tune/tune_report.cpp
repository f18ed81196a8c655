#include "tools/study/tune/tune_report.h"

#include <algorithm>
#include <cmath>

#include "lasius/version.h"
#include "tools/console/values.h"
#include "tools/draw/text.h"
#include "tools/study/values.h"

namespace lasius::study {
namespace {

using tool::fixed;

constexpr double kLevel = 0.05;

constexpr const char* kHowToReadTuning =
    R"(A block is one question with one seed; every candidate that is left answers it. After the first
blocks Friedman's test is made after each: where it finds a difference, candidates leave whose rank
sum is further behind the best one's than Conover's critical difference; of two the worse leaves by
Wilcoxon's signed rank test (F-race: Birattari et al. 2002, 2010). Mean ranks are among those that
are left, over all blocks; "behind" is the interval of a mean rank's distance from the best one's.

The winner is judged by runs of its own on other maps, against the default, not paired by seed; where
the default won, its strongest rival is. A12 is the share of pairs of runs in which the candidate's
value is less (ties half), the ratio that of the medians, by question; intervals are percentiles of
2000 resamplings of the runs, p is two-sided by Mann and Whitney's test in the sum over the
questions, by Holm's method over the families. "as good": the interval of the ratio lies within 1%.
What was raced on decides nothing here.
)";

std::string value_text(double value) {
  return std::isfinite(value) ? fixed(value, std::abs(value) < 10 ? 4 : 2) : "no path";
}

std::string settings_text(const Settings& settings) {
  std::string text;
  for (const auto& [name, value] : settings)
    text.append(text.empty() ? "" : " ").append(name).append("=").append(value);
  return text;
}

std::string family_verdict(const Family& family) {
  if (family.p < kLevel && family.effect.low > 0.5) return "better";
  if (family.p < kLevel && family.effect.high < 0.5) return "worse";
  const bool close = family.ratios.low >= 0.99 && family.ratios.high <= 1.01;
  return close ? "as good" : "no difference shown";
}

Table family_table(const Tuning& tuning, const Tuned& tuned) {
  const std::string name = tuning.candidates[tuned.judged].name;
  Table table{{"maps", "questions", "A12, " + name + " less [95%]",
               "median, " + name + " / default [95%]", "p", name + " is"}};
  for (const Family& f : tuned.families)
    table.rows.push_back({f.name.empty() ? "all" : f.name, std::to_string(f.pairs.size()),
                          fixed(f.test.effect, 3) + interval_text(f.effect, 3),
                          fixed(f.ratio, 4) + interval_text(f.ratios, 3), tool::p_text(f.p),
                          family_verdict(f)});
  return table;
}

/// Candidates: first those still in the race, by rank; then those that left, the last first.
std::vector<std::size_t> order_of(const Race& race) {
  std::vector<std::size_t> order;
  for (const auto& s : race.standings()) order.push_back(s.candidate);
  const auto left = order.size();
  for (std::size_t c = 0; c < race.runners().size(); ++c)
    if (race.runners()[c].left_after > 0) order.push_back(c);
  std::stable_sort(
      order.begin() + static_cast<std::ptrdiff_t>(left), order.end(),
      [&](auto a, auto b) { return race.runners()[a].left_after > race.runners()[b].left_after; });
  return order;
}

}  // namespace

std::string verdict_text(const Tuning& tuning, const Tuned& tuned) {
  const std::size_t winner = tuned.race.best();
  const std::string name = tuning.candidates[winner].name;
  if (!tuned.whole) return "interrupted: " + name + " was best so far, and is not judged";
  const std::string judged = tuning.candidates[tuned.judged].name;
  const Family& all = tuned.families.front();
  return (winner == 0 ? "the default won; its strongest rival, " + judged + "," : judged) +
         " on other maps: " + family_verdict(all) + ", A12 " + fixed(all.test.effect, 3) +
         interval_text(all.effect, 3) + ", ratio of medians " + fixed(all.ratio, 4) +
         interval_text(all.ratios, 3) + ", p " + tool::p_text(all.p);
}

std::string preset_text(const Tuning& tuning, const Tuned& tuned) {
  const Contender& winner = tuning.candidates[tuned.race.best()];
  Settings settings = tuning.fixed;
  for (const auto& [name, value] : winner.factors) {
    std::erase_if(settings, [&name = name](const auto& s) { return s.first == name; });
    settings.emplace_back(name, value);
  }
  std::string text = "# By lasius tune " + tuning.file + ", lasius " LASIUS_VERSION ".\n# " +
                     verdict_text(tuning, tuned) + ".\nalgorithm: " + winner.algorithm + "\n";
  if (winner.preset != Preset::usual)
    text += "preset: " + std::string(to_string(winner.preset)) + "\n";
  text += settings.empty() ? "set: {}\n" : "set:\n";
  for (const auto& [name, value] : settings) text += "  " + name + ": \"" + value + "\"\n";
  return text;
}

Table candidate_table(const Tuning& tuning, const Tuned& tuned) {
  Table table{{"candidate", "settings", "blocks", "mean rank", "behind [95%]", "median",
               "left after", "p"}};
  const auto standings = tuned.race.standings();
  for (const std::size_t c : order_of(tuned.race)) {
    const Runner& runner = tuned.race.runners()[c];
    const auto standing = std::ranges::find(standings, c, &Race::Standing::candidate);
    const bool there = standing != standings.end();
    const bool compared = there && std::isfinite(standing->behind.high);
    table.rows.push_back(
        {tuning.candidates[c].name, settings_text(tuning.candidates[c].factors),
         std::to_string(runner.values.size()), there ? fixed(standing->mean_rank, 2) : "-",
         compared ? fixed(standing->mean_rank - standings.front().mean_rank, 2) +
                        interval_text(standing->behind, 3)
                  : "-",
         runner.values.empty() ? "-" : value_text(quantile(runner.values, 0.5)),
         there ? "-" : std::to_string(runner.left_after), there ? "-" : tool::p_text(runner.p)});
  }
  return table;
}

Table race_table(const Tuned& tuned) {
  return {{"block", "question", "map", "seed", "candidate", "value"}, tuned.rows};
}

std::string tune_page(const Tuning& tuning, const Tuned& tuned) {
  const Contender& winner = tuning.candidates[tuned.race.best()];
  std::string text =
      "# Tuning " + tuning.name + ": " + winner.algorithm + "\n\n`lasius tune " + tuning.file +
      "`, lasius " LASIUS_VERSION ". " + verdict_text(tuning, tuned) + ".\n\nThe winner: " +
      (winner.factors.empty() ? "the default" : "`" + settings_text(winner.factors) + "`") +
      ". To use it: `--preset preset.yaml`.\n\n## Judged on other maps\n\n";
  text += tuned.families.empty() ? "Nothing was judged.\n" : family_table(tuning, tuned).markdown();
  text += "\n## The race\n\n" + tool::counted(tuned.race.blocks(), "block") + ", " +
          tool::counted(std::ssize(tuned.rows), "run") + ", " +
          std::to_string(tuned.race.left().size()) + " of " +
          std::to_string(tuning.candidates.size()) + " candidates left; " +
          value_text(tuning.value) + ".\n\n" + candidate_table(tuning, tuned).markdown();
  return text + "\n## How to read the tables\n\n" + kHowToReadTuning +
         "\nEvery run of the race: `race.csv`; the candidates: `candidates.csv`.\n";
}

}  // namespace lasius::study
