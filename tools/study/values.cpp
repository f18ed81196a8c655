#include "tools/study/values.h"

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>

#include "tools/console/parameters.h"
#include "tools/draw/text.h"
#include "tools/study/statistics.h"

namespace lasius::study {
namespace {

using tool::fixed;

using Curve = std::vector<double>;

/// A value or budget of a claim, and what tables call it.
struct Label {
  std::string_view name, text;
};
constexpr std::array kValues{
    Label{"length", "length of the best path"},
    Label{"gap", "gap of the best path to the optimum"},
    Label{"gain", "length of the best path / that of the path it begins with"},
    Label{"spread", "distance of the best length from its median over the runs"},
    Label{"raw", "mean raw tour of the last 10 iterations / shortest walk"},
    Label{"cut", "mean cut tour of the last 10 iterations / shortest walk"},
    Label{"cut-best", "shortest cut tour so far / shortest walk"},
    Label{"band", "share of steps within 10% of the distance of the straight line"},
    Label{"band-rise", "share of steps near the straight line / that of iteration 10"},
    Label{"contraction", "mean raw tour of the last 10 iterations / of the first 10"},
    Label{"last-gain", "iteration of the last improvement of the best path"},
    Label{"last-cut-gain", "iteration of the last improvement of the shortest cut tour"},
    Label{"frozen", "iteration from which the mean tour never changes"},
    Label{"rises", "share of iterations whose best tour is longer than the one before"},
    Label{"answer-rises", "share of iterations whose own answer is longer than the one before"},
    Label{"effort", ""},
    Label{"spent", ""}};
constexpr std::array kBudgets{Label{"end", "iterations"}, Label{"iterations", "iterations"},
                              Label{"steps", "steps"}, Label{"time", "seconds"},
                              Label{"paths", "paths"}};

std::string_view text_of(std::span<const Label> list, const std::string& name) {
  const auto found = std::ranges::find(list, name, &Label::name);
  if (found == list.end()) throw std::invalid_argument("no value or budget " + name);
  return found->text;
}

/// How many iterations a run did within a budget.
std::size_t within(const Sample& sample, const Run& run, const std::string& at, double budget) {
  std::size_t done = 0, beyond = static_cast<std::size_t>(run.iterations) + 1;
  while (done + 1 < beyond) {
    const std::size_t middle = (done + beyond) / 2;
    (spent(sample, run, at, middle) <= budget * (1 + 1e-12) ? done : beyond) = middle;
  }
  return done;
}

double entry(const Curve& curve, std::size_t count) {
  if (curve.empty()) return kUnknown;
  return count == 0 ? kInfinity : curve[std::min(count, curve.size()) - 1];
}

double length_after(const Run& run, std::size_t count) {
  if (run.best.empty()) return run.solved() ? run.length : kInfinity;
  const double length = entry(run.best, count);
  return std::isfinite(length) ? length : kInfinity;
}

double mean_of_last(const Curve& curve, std::size_t count) {
  constexpr std::size_t kLast = 10;
  if (curve.empty()) return kUnknown;
  double sum = 0;
  int values = 0;
  count = std::min(count, curve.size());
  for (std::size_t i = count - std::min(count, kLast); i < count; ++i) {
    if (!std::isfinite(curve[i])) continue;
    sum += curve[i];
    ++values;
  }
  return values > 0 ? sum / values : kInfinity;
}

/// The shortest of an iteration and all before it.
Curve running_best(Curve curve) {
  double best = kInfinity;
  for (double& value : curve) value = best = std::fmin(best, value);
  return curve;
}

double last_gain(const Curve& best, std::size_t count) {
  if (best.empty()) return kUnknown;
  count = std::min(count, best.size());
  if (count == 0 || !std::isfinite(best[count - 1])) return kInfinity;
  std::size_t first = count;
  while (first > 1 && best[first - 2] == best[count - 1]) --first;
  return static_cast<double>(first);
}

double frozen_from(const Curve& mean) {
  if (mean.empty()) return kUnknown;
  std::size_t from = mean.size();
  while (from > 0 && std::abs(mean[from - 1] - mean.back()) <= 1e-12 * mean.back()) --from;
  return from + mean.size() / 10 < mean.size() ? static_cast<double>(from) + 1 : kInfinity;
}

/// Over the pairs of iterations in which ants arrived; infinite where there is none.
double rises(const Curve& best) {
  if (best.empty()) return kUnknown;
  double count = 0, pairs = 0;
  for (std::size_t i = 1; i < best.size(); ++i) {
    if (!std::isfinite(best[i]) || !std::isfinite(best[i - 1])) continue;
    ++pairs;
    count += best[i] > best[i - 1] * (1 + kSameLength);
  }
  return pairs > 0 ? count / pairs : kInfinity;
}

double effort(const Sample& sample, const Run& run, const Value& value, std::size_t count,
              std::optional<double> optimum) {
  const double ideal = value.own_limit ? run.limit : optimum.value_or(kUnknown);
  if (std::isnan(ideal)) return kUnknown;
  if (run.best.empty() && length_after(run, count) <= ideal * (1 + value.target + kSameLength))
    return spent(sample, run, value.at, count);  // one answer, without iterations
  for (std::size_t i = 1; i <= count; ++i)
    if (length_after(run, i) <= ideal * (1 + value.target + kSameLength))
      return spent(sample, run, value.at, i);
  return kInfinity;
}

}  // namespace

std::vector<std::string_view> value_names() { return tool::names_of<Label>(kValues); }
std::vector<std::string_view> budget_names() { return tool::names_of<Label>(kBudgets); }

std::string target_text(double target, bool own_limit) {
  return (target > 0 ? "within " + fixed(100 * target, 1) + "% of " : std::string("at ")) +
         (own_limit ? "the optimum of its own values" : "the optimum");
}

std::string value_text(const Value& value) {
  const std::string unit(text_of(kBudgets, value.at));
  std::string text(text_of(kValues, value.name));
  if (value.best_of > 1) text += ", least of " + std::to_string(value.best_of) + " runs";
  if (value.name == "spent") text = unit + " of a run";
  if (value.name == "effort") text = unit + " until " + target_text(value.target, value.own_limit);
  if (!std::isnan(value.budget)) return text + ", at " + fixed(value.budget, 0) + " " + unit;
  return value.at == "end" || value.name == "spent" ? text : text + ", at equal " + unit;
}

double spent(const Sample& sample, const Run& run, const std::string& at, std::size_t iterations) {
  const auto count = static_cast<double>(iterations);
  if (at == "time") return run.seconds * count / std::max(1, run.iterations);
  if (at == "paths") return count * sample.paths_an_iteration;
  if (at != "steps") return count;
  if (iterations >= static_cast<std::size_t>(run.iterations) && run.steps > 0)
    return static_cast<double>(run.steps);
  if (run.steps_by.empty()) return kUnknown;
  double sum = 0;
  for (std::size_t i = 0; i < std::min(iterations, run.steps_by.size()); ++i)
    sum += run.steps_by[i];
  return sum;
}

double common_budget(const Value& value, const Sample& a, const Sample& b) {
  if (!std::isnan(value.budget) || value.at == "end" || value.name == "spent") return value.budget;
  double common = kInfinity;
  for (const Sample* sample : {&a, &b}) {
    double most = 0;
    for (const Run& run : sample->runs)
      most =
          std::max(most, spent(*sample, run, value.at, static_cast<std::size_t>(run.iterations)));
    common = std::min(common, most);
  }
  return common;
}

double value_of(const Sample& sample, const Run& run, const Value& value, double budget,
                std::optional<double> optimum) {
  const std::string& name = value.name;
  if (name == "spent")
    return spent(sample, run, value.at, static_cast<std::size_t>(run.iterations));
  const std::size_t count = std::isnan(budget) ? static_cast<std::size_t>(run.iterations)
                                               : within(sample, run, value.at, budget);
  if (name == "length") return length_after(run, count);
  if (name == "gap") return optimum ? length_after(run, count) / *optimum - 1 : kUnknown;
  if (name == "gain") return length_after(run, count) / run.reference;
  if (name == "raw") return mean_of_last(run.mean, count) / run.limit;
  if (name == "cut") return mean_of_last(run.cut_mean, count) / run.limit;
  if (name == "cut-best") return entry(running_best(run.cut_best), count) / run.limit;
  if (name == "band") return entry(run.band, count);
  if (name == "band-rise") return entry(run.band, count) / entry(run.band, 10);
  if (name == "contraction") return mean_of_last(run.mean, count) / mean_of_last(run.mean, 10);
  if (name == "last-gain") return last_gain(run.best, count);
  if (name == "last-cut-gain") return last_gain(running_best(run.cut_best), count);
  if (name == "frozen") return frozen_from(run.mean);
  if (name == "rises") return rises(run.raw_best);
  if (name == "answer-rises") return rises(run.iteration_best);
  if (name == "effort") return effort(sample, run, value, count, optimum);
  Value length = value;  // spread
  length.name = "length";
  const auto all = sample.each(
      [&](const Run& other) { return value_of(sample, other, length, budget, optimum); });
  const double own = length_after(run, count);
  return std::isfinite(own) ? std::abs(own - quantile(all, 0.5)) : kInfinity;
}

std::string optimum_text(const Optimum& which) {
  if (which.kind != Optimum::Kind::moves) return "true optimum";
  return std::string("optimum of ") + (which.neighbours == Neighbours::four ? "4" : "8") + " moves";
}

}  // namespace lasius::study
