#include "tools/study/table.h"

#include <algorithm>
#include <cmath>

#include "tools/console/values.h"
#include "tools/draw/text.h"
#include "tools/study/factors.h"
#include "tools/study/values.h"

namespace lasius::study {
namespace {

using tool::fixed;

const Published* published(const Sample& sample) {
  for (const Published& p : sample.question->published)
    if (p.contender == sample.contender->name) return &p;
  return nullptr;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::string percent_text(double fraction, int decimals) {
  return fixed(100 * fraction, decimals) + "%";
}

/// Thousandths are needed where lengths are sums of 1 and sqrt(2), hundredths say enough elsewhere.
std::string length_text(double length) { return fixed(length, length < 100 ? 3 : 2); }

std::string range_text(const std::vector<double>& values, std::string (*text)(double)) {
  return text(quantile(values, 0.25)) + " to " + text(quantile(values, 0.75));
}

/// How many runs got within a target, and what it took them.
void add_efforts(const Sample& sample, double target, const std::optional<double>& optimum,
                 std::vector<std::string>& row) {
  const Value value{.name = "effort", .at = "paths", .target = target};
  const int runs = static_cast<int>(sample.runs.size());
  const auto efforts =
      sample.each([&](const Run& run) { return value_of(sample, run, value, kUnknown, optimum); });
  const auto hits =
      static_cast<int>(std::ranges::count_if(efforts, [](double e) { return std::isfinite(e); }));
  double cost = 0;
  for (std::size_t r = 0; r < efforts.size(); ++r)
    cost += std::isfinite(efforts[r])
                ? efforts[r]
                : static_cast<double>(sample.runs[r].iterations) * sample.paths_an_iteration;
  const auto whole = [](double v) { return std::isinf(v) ? std::string("never") : fixed(v, 0); };
  row.push_back(optimum ? std::to_string(hits) + interval_text(share_interval(hits, runs), 2)
                        : "-");
  row.push_back(!optimum ? "-" : hits > 0 ? fixed(cost / hits, 0) : "unbounded");
  row.push_back(optimum ? whole(quantile(efforts, 0.25)) + ", " + whole(quantile(efforts, 0.5)) +
                              ", " + whole(quantile(efforts, 0.75))
                        : "-");
}

std::vector<std::string> result_row(const Findings& findings, const Sample& sample) {
  const auto lengths = sample.lengths();
  const Published* const paper = published(sample);
  const auto optimum = findings.optimum(*sample.experiment, *sample.question);
  const int runs = static_cast<int>(sample.runs.size());
  const double median = quantile(lengths, 0.5);
  std::vector<std::string> row{sample.question->name,
                               sample.contender->label,
                               paper ? length_text(paper->length) : "-",
                               length_text(quantile(lengths, 0)),
                               length_text(median),
                               range_text(lengths, length_text),
                               optimum ? percent_text(median / *optimum - 1, 2) : "-",
                               std::to_string(std::ranges::count_if(sample.runs, &Run::solved)) +
                                   " of " + std::to_string(runs)};
  for (const double target : sample.experiment->targets) add_efforts(sample, target, optimum, row);
  row.push_back(paper ? fixed(paper->iterations, 0) : "-");
  row.push_back(paper ? tool::seconds_text(paper->seconds) : "-");
  row.push_back(
      tool::seconds_text(quantile(sample.each([](const Run& r) { return r.seconds; }), 0.5)));
  return row;
}

std::string effect_text(const Evidence& e) {
  if (!e.tested()) return "-";
  const char* const what = e.claim->test == Claim::Test::most      ? "share "
                           : e.claim->test == Claim::Test::similar ? "ratio "
                                                                   : "A12 ";
  return what + fixed(e.effect, 2) + interval_text(e.interval, 2);
}

std::string control_text(const Evidence& e) { return e.claim->b.empty() ? "-" : e.claim->b; }

/// The hypothesis: what of whom, on which experiments.
std::string statistic_text(const Claim& claim) {
  if (claim.test == Claim::Test::none || claim.test == Claim::Test::arithmetic) return "-";
  std::string text = value_text(claim.value);
  if (claim.test == Claim::Test::less && claim.factor != 1)
    text = fixed(claim.factor, 2) + " times the " + text;
  if (claim.test == Claim::Test::less) text += ": less";
  if (claim.test == Claim::Test::similar) text += ": within " + fixed(100 * claim.within, 0) + "%";
  if (claim.test == Claim::Test::most) {
    const bool above = std::isfinite(claim.from), below = std::isfinite(claim.to);
    text += above ? ": " + fixed(claim.from, 2) + (below ? " to " : " or more") : ": at most ";
    if (below) text += fixed(claim.to, 2);
    text += " in more than " + fixed(100 * claim.share, 0) + "% of the runs";
  }
  return text + " (" + claim.a + "; " + joined(claim.in) + ")";
}

}  // namespace

std::string Table::markdown() const {
  constexpr tool::Escape kCell[] = {{'|', "\\|"}, {'\n', " "}, {'\r', " "}};
  const auto line = [&](const std::vector<std::string>& cells) {
    std::string text = "|";
    for (const auto& cell : cells) text += " " + tool::with_escapes(cell, kCell) + " |";
    return text + "\n";
  };
  std::string text = line(header) + "|";
  for (std::size_t i = 0; i < header.size(); ++i) text += "---|";
  text += "\n";
  for (const auto& row : rows) text += line(row);
  return text;
}

std::string Table::markdown_lists() const {
  std::string text;
  for (const auto& row : rows) {
    text += "\n## " + row[0] + "\n\n";
    for (std::size_t i = 1; i < row.size(); ++i)
      if (!row[i].empty() && row[i] != "-") text += "* " + header[i] + ": " + row[i] + "\n";
  }
  return text;
}

std::string Table::csv() const {
  const auto line = [](const std::vector<std::string>& cells) {
    std::string text;
    for (std::size_t i = 0; i < cells.size(); ++i)
      text += (i > 0 ? "," : "") + tool::csv_field(cells[i]);
    return text + "\n";
  };
  std::string text = line(header);
  for (const auto& row : rows) text += line(row);
  return text;
}

std::string called(const std::string& study, Seeds seeds) {
  std::string text = "lasius study " + study + " --seeds ";
  if (seeds.first != 1) text += std::to_string(seeds.first) + "..";
  return text + std::to_string(seeds.first + static_cast<std::uint64_t>(seeds.count) - 1);
}

Table result_table(const Findings& findings, const Experiment& experiment) {
  Table table{{"question", "algorithm", "paper: length", "shortest", "median", "quartiles",
               "gap of the median", "runs with a path"}};
  auto& header = table.header;
  for (const double target : experiment.targets) {
    const std::string text = target_text(target);
    for (const std::string& title : {"runs " + text + " [95%]", "expected paths until " + text,
                                     std::string("paths of 25, 50, 75% of the runs")})
      header.push_back(title);
  }
  for (const char* title : {"paper: iterations", "paper: time, s", "time, s"})
    header.emplace_back(title);
  for (const Question& question : experiment.questions) {
    std::vector<const Sample*> run;
    for (const Contender& contender : experiment.contenders)
      if (const Sample* s = findings.find(experiment.name, question.name, contender.name))
        if (!s->runs.empty()) run.push_back(s);
    if (run.empty() && !findings.whole) continue;  // after a signal perhaps thousands
    if (const auto optimum = findings.optimum(experiment, question)) {
      std::vector<std::string> row(table.header.size(), "");
      row[0] = question.name;
      row[1] = optimum_text(experiment.optimum);
      row[3] = row[4] = length_text(*optimum);
      table.rows.push_back(std::move(row));
    }
    for (const Sample* s : run) table.rows.push_back(result_row(findings, *s));
  }
  return table;
}

Table claim_table(std::span<const Evidence> evidence) {
  Table table{{"claim", "place", "statistic", "control", "outcome", "effect [95%]", "p, Holm",
               "seeds", "figures"}};
  for (const Evidence& e : evidence) {
    const bool ran = e.seeds > 0;
    table.rows.push_back({e.claim->text, e.claim->place, statistic_text(*e.claim), control_text(e),
                          verdict_text(e.verdict), effect_text(e), tool::p_text(e.adjusted),
                          ran ? std::to_string(e.seeds) : "-", e.figures});
  }
  return table;
}

Table outcome_table(std::span<const Evidence> evidence) {
  Table table{{"claim", "outcome", "effect [95%]", "control"}};
  for (const Evidence& e : evidence)
    table.rows.push_back({e.claim->text, verdict_text(e.verdict), effect_text(e), control_text(e)});
  return table;
}

Table evidence_table(std::span<const Evidence> evidence) {
  Table table{{"study", "claim", "place", "statistic", "control", "outcome", "effect", "low",
               "high", "p_for", "p_against", "p_holm", "seeds", "questions", "figures", "command"}};
  for (const Evidence& e : evidence)
    table.rows.push_back({e.study->name, e.claim->text, e.claim->place, statistic_text(*e.claim),
                          e.claim->b, verdict_text(e.verdict), fixed(e.effect, 6),
                          fixed(e.interval.low, 6), fixed(e.interval.high, 6), fixed(e.p_for, 9),
                          fixed(e.p_against, 9), fixed(e.adjusted, 9), std::to_string(e.seeds),
                          std::to_string(e.questions), e.figures,
                          called(e.study->asked(), {e.study->seeds.first, e.seeds})});
  return table;
}

Table run_table(const Findings& findings) {
  const auto factors = factor_names(findings);
  Table table{{"experiment", "question", "map", "contender", "algorithm"}};
  for (const auto& name : factors) table.header.push_back("set." + name);
  for (const char* title : {"seed", "status", "length", "optimum", "gap", "own_limit", "iterations",
                            "last_gain", "paths", "steps", "checks", "seconds"})
    table.header.emplace_back(title);
  for (const Sample& s : findings.samples) {
    const auto optimum = findings.optimum(*s.experiment, *s.question);
    for (const Run& run : s.runs) {
      auto& row = table.rows.emplace_back(
          std::vector<std::string>{s.experiment->name, s.question->name, s.question->map,
                                   s.contender->name, s.contender->algorithm});
      for (const auto& name : factors) row.push_back(factor_value(*s.contender, name));
      const double ideal = optimum.value_or(kUnknown);
      for (const std::string& cell :
           {std::to_string(run.seed), std::string(to_string(run.status)), fixed(run.length, 9),
            fixed(ideal, 9), fixed(run.length / ideal - 1, 9), fixed(run.limit, 9),
            std::to_string(run.iterations),
            fixed(value_of(s, run, {.name = "last-gain"}, kUnknown, optimum), 0),
            std::to_string(std::int64_t{run.iterations} * s.paths_an_iteration),
            std::to_string(run.steps), std::to_string(run.checks), fixed(run.seconds, 6)})
        row.push_back(cell);
    }
  }
  return table;
}

}  // namespace lasius::study
