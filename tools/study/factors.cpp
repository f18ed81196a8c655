#include "tools/study/factors.h"

#include <algorithm>
#include <map>

#include "tools/console/values.h"
#include "tools/draw/text.h"
#include "tools/study/statistics.h"

namespace lasius::study {
namespace {

using tool::fixed;

std::string share_text(double fraction) { return fixed(100 * fraction, 2) + "%"; }

/// A value of a factor, or a part of its range, and the gaps of the runs that had it, by question.
struct Level {
  std::string text;
  double low = 0, high = 0;
  std::map<const Question*, std::vector<double>> gaps = {};
};

/// Up to so many values are levels; more are cut into three parts of equal size.
constexpr std::size_t kMostLevels = 8, kParts = 3;

std::vector<Level> levels_of(std::vector<std::string> values) {
  std::vector<Level> levels;
  if (values.size() <= kMostLevels) {
    for (auto& value : values) levels.push_back({.text = std::move(value)});
    return levels;
  }
  std::vector<double> numbers;
  for (const auto& value : values) numbers.push_back(tool::parse_real(value).value_or(0));
  std::ranges::sort(numbers);
  for (std::size_t part = 0; part < kParts; ++part) {
    const double low = numbers[part * numbers.size() / kParts];
    const double high = numbers[(part + 1) * numbers.size() / kParts - 1];
    levels.push_back({tool::to_text(low) + " to " + tool::to_text(high), low, high});
  }
  return levels;
}

std::vector<Level> factor_levels(const Findings& findings, const Experiment& experiment,
                                 const std::string& name) {
  std::vector<std::string> values;
  for (const Contender& c : experiment.contenders)
    if (const auto value = factor_value(c, name);
        !value.empty() && std::ranges::find(values, value) == values.end())
      values.push_back(value);
  auto levels = levels_of(values);
  const bool parts = values.size() > kMostLevels;
  for (const Sample& s : findings.samples) {
    const auto value = factor_value(*s.contender, name);
    const auto optimum = findings.optimum(experiment, *s.question);
    if (s.experiment != &experiment || value.empty() || !optimum) continue;
    const double number = tool::parse_real(value).value_or(0);
    const auto level = std::ranges::find_if(levels, [&](const Level& l) {
      return parts ? number >= l.low && number <= l.high : l.text == value;
    });
    for (const double length : s.lengths())
      level->gaps[s.question].push_back(length / *optimum - 1);
  }
  std::erase_if(levels, [](const Level& l) { return l.gaps.empty(); });
  return levels;
}

/// The gaps of two levels of a factor, on questions that both have.
std::vector<Pair> pairs_of(const Level& a, const Level& b) {
  std::vector<Pair> pairs;
  for (const auto& [question, gaps] : a.gaps)
    if (const auto other = b.gaps.find(question); other != b.gaps.end())
      pairs.push_back({gaps, other->second});
  return pairs;
}

}  // namespace

std::vector<std::string> factor_names(const Findings& findings) {
  std::vector<std::string> names;
  for (const Sample& s : findings.samples)
    for (const auto& [name, value] : s.contender->factors)
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  return names;
}

std::string factor_value(const Contender& contender, const std::string& name) {
  for (const auto& [factor, value] : contender.factors)
    if (factor == name) return value;
  return {};
}

Table factor_table(const Findings& findings, const Experiment& experiment) {
  Table table{{"parameter", "value", "runs", "median gap", "quartiles",
               "A12 against the first value [95%]", "p, Holm"}};
  std::vector<double> p;
  for (const auto& name : factor_names(findings)) {
    const auto levels = factor_levels(findings, experiment, name);
    for (const Level& level : levels) {
      const auto pairs = pairs_of(level, levels.front());
      std::vector<double> all;
      for (const auto& [question, gaps] : level.gaps)
        all.insert(all.end(), gaps.begin(), gaps.end());
      auto& row = table.rows.emplace_back(std::vector<std::string>{
          name, level.text, std::to_string(all.size()), share_text(quantile(all, 0.5)),
          share_text(quantile(all, 0.25)) + " to " + share_text(quantile(all, 0.75)), "-"});
      if (&level == levels.data() || pairs.empty()) continue;
      const RankTest test = rank_test(pairs);
      row.back() = fixed(test.effect, 2) + interval_text(resampled_interval(pairs, share_less), 2);
      p.push_back(std::min(1.0, 2 * std::min(test.less, test.greater)));
    }
  }
  const auto adjusted = holm(p);
  auto next = adjusted.begin();
  for (auto& row : table.rows) row.push_back(row.back() == "-" ? "-" : tool::p_text(*next++));
  return table;
}

}  // namespace lasius::study
