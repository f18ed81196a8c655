#include "tools/study/table.h"

#include <algorithm>
#include <cmath>

#include "tools/draw/text.h"
#include "tools/study/claims.h"
#include "tools/study/statistics.h"

namespace lasius::study {
namespace {

const Published* published(const Sample& sample) {
  for (const Published& p : sample.question->published)
    if (p.contender == sample.contender->name) return &p;
  return nullptr;
}

std::string percent_text(double fraction, int decimals) {
  return fixed(100 * fraction, decimals) + "%";
}

/// Thousandths are needed where lengths are sums of 1 and sqrt(2), hundredths say enough elsewhere.
std::string length_text(double length) { return fixed(length, length < 100 ? 3 : 2); }

std::vector<std::string> result_row(const Findings& findings, const Sample& sample) {
  const auto lengths = sample.lengths();
  const auto iterations = sample.iterations_to_converge();
  const Published* const paper = published(sample);
  const auto optimum = findings.optimum(*sample.experiment, *sample.question);
  const int runs = static_cast<int>(sample.runs.size());
  const int solved = static_cast<int>(lengths.size());

  std::vector<std::string> row{sample.question->name, sample.contender->label,
                               paper ? length_text(paper->length) : "-"};
  if (solved > 0) {
    const Summary s = summarise(lengths);
    const Interval interval = mean_interval(lengths);
    const int hits = optimum ? static_cast<int>(std::count_if(
                                   lengths.begin(), lengths.end(),
                                   [&](double l) { return l <= *optimum * (1 + kSameLength); }))
                             : 0;
    row.insert(row.end(), {length_text(s.least), length_text(s.mean), length_text(s.sd),
                           length_text(interval.low) + " to " + length_text(interval.high),
                           optimum ? percent_text(s.least / *optimum - 1, 2) : "-",
                           optimum ? percent_text(s.mean / *optimum - 1, 2) : "-",
                           optimum ? std::to_string(hits) : "-"});
  } else {
    row.insert(row.end(), 7, "-");
  }
  row.push_back(std::to_string(solved) + " of " + std::to_string(runs));
  row.push_back(paper ? fixed(paper->iterations, 0) : "-");
  if (solved > 0) {
    const Summary s = summarise(iterations);
    row.push_back(fixed(s.median, 1) + " (" + fixed(s.least, 0) + " to " + fixed(s.most, 0) + ")");
  } else {
    row.push_back("-");
  }
  row.push_back(paper ? seconds_text(paper->seconds) : "-");
  row.push_back(seconds_text(summarise(sample.seconds()).median));
  return row;
}

/// Who is ahead, by how much, and how sure that is.
std::vector<std::string> test_cells(const Sample& first, const Sample* other, double p) {
  if (other == nullptr) return {"-", "-", "-", "-"};
  const SignedRank test = compare(first, *other);
  const double gain = quantile(differences(first, *other), 0.5);
  const std::string winner = p >= 0.05 ? "undecided" : test.effect > 0 ? "won" : "lost";
  const std::string gain_text = std::isfinite(gain) ? fixed(gain, 3)
                                : gain > 0          ? "no path there"
                                                    : "no path here";
  return {gain_text, p_text(p), fixed(test.effect, 2), winner};
}

void append(std::vector<std::string>& row, std::vector<std::string> cells) {
  row.insert(row.end(), cells.begin(), cells.end());
}

}  // namespace

std::string Table::markdown() const {
  const auto line = [](const std::vector<std::string>& cells) {
    std::string text = "|";
    for (const auto& cell : cells) text += " " + cell + " |";
    return text + "\n";
  };
  std::string text = line(header) + "|";
  for (std::size_t i = 0; i < header.size(); ++i) text += "---|";
  text += "\n";
  for (const auto& row : rows) text += line(row);
  return text;
}

std::string Table::csv() const {
  const auto line = [](const std::vector<std::string>& cells) {
    std::string text;
    for (const auto& cell : cells) {
      if (!text.empty()) text += ',';
      const bool quoted = cell.find_first_of(",\"") != std::string::npos;
      if (!quoted) {
        text += cell;
        continue;
      }
      text += '"';
      for (const char c : cell) text += c == '"' ? std::string("\"\"") : std::string(1, c);
      text += '"';
    }
    return text + "\n";
  };
  std::string text = line(header);
  for (const auto& row : rows) text += line(row);
  return text;
}

Table result_table(const Findings& findings, const Experiment& experiment) {
  Table table{
      {"question", "algorithm", "paper: length", "best", "mean", "sd", "95% interval of the mean",
       "gap of the best", "gap of the mean", "optimal runs", "with a path", "paper: iterations",
       "iterations to converge", "paper: time, s", "time, s"},
      {}};
  for (const Question& question : experiment.questions) {
    if (const auto optimum = findings.optimum(experiment, question)) {
      std::vector<std::string> row(table.header.size(), "");
      row[0] = question.name;
      row[1] = "true optimum";
      row[3] = row[4] = length_text(*optimum);
      table.rows.push_back(std::move(row));
    }
    for (const Contender& contender : experiment.contenders)
      if (const Sample* s = findings.find(experiment.name, question.name, contender.name))
        table.rows.push_back(result_row(findings, *s));
  }
  return table;
}

Table test_table(const Findings& findings, const Experiment& experiment) {
  Table table{{"question", "against", "equal: longer by", "p", "effect", "verdict",
               "x10: longer by", "p", "effect", "verdict"},
              {}};
  struct Row {
    const Sample *first, *equal, *tenfold;
  };
  std::vector<Row> rows;
  std::vector<double> p;
  for (const Question& question : experiment.questions) {
    const auto find = [&](const std::string& name) {
      return findings.find(experiment.name, question.name, name);
    };
    const Sample* const first = find(experiment.contenders.front().name);
    if (first == nullptr) continue;
    for (const Contender& contender : experiment.contenders) {
      const Sample* const equal = find(contender.name);
      if (contender.budget > 1 || equal == nullptr || equal == first) continue;
      rows.push_back({first, equal, find(tenfold(contender).name)});
      for (const Sample* other : {rows.back().equal, rows.back().tenfold})
        if (other != nullptr) p.push_back(compare(*first, *other).p);
    }
  }
  p = holm(p);
  auto next = p.begin();
  for (const Row& row : rows) {
    std::vector<std::string> cells{row.first->question->name, row.equal->contender->label};
    for (const Sample* other : {row.equal, row.tenfold})
      append(cells, test_cells(*row.first, other, other != nullptr ? *next++ : 1));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

Table run_table(const Findings& findings) {
  Table table{{"experiment", "question", "contender", "algorithm", "seed", "status", "length",
               "optimum", "iterations", "iterations_to_converge", "paths", "seconds"},
              {}};
  for (const Sample& s : findings.samples) {
    const auto optimum = findings.optimum(*s.experiment, *s.question);
    for (const Run& run : s.runs) {
      table.rows.push_back({s.experiment->name, s.question->name, s.contender->name,
                            s.contender->algorithm, std::to_string(run.seed),
                            std::string(to_string(run.status)), fixed(run.length, 9),
                            optimum ? fixed(*optimum, 9) : "-", std::to_string(run.iterations),
                            std::to_string(run.converged()),
                            std::to_string(std::int64_t{run.iterations} * s.paths_an_iteration),
                            fixed(run.seconds, 6)});
    }
  }
  return table;
}

}  // namespace lasius::study
