#include "tools/study/claims.h"

#include <algorithm>
#include <cmath>

#include "tools/draw/text.h"
#include "tools/study/values.h"

namespace lasius::study {
namespace {

using tool::fixed;

using Test = Claim::Test;

/// Values of a and, where there is a control, of b, by question.
struct Measured {
  std::vector<Pair> pairs;
  std::vector<const Sample*> a, b;
  std::size_t seeds = SIZE_MAX;  ///< of the sample with the fewest runs
  std::string obstacle;
};

/// The least of every `count` values; what is left over is dropped.
std::vector<double> least_of(const std::vector<double>& values, int count) {
  std::vector<double> least;
  const auto group = static_cast<std::size_t>(count);
  for (std::size_t i = 0; i + group <= values.size(); i += group)
    least.push_back(*std::min_element(values.begin() + static_cast<std::ptrdiff_t>(i),
                                      values.begin() + static_cast<std::ptrdiff_t>(i + group)));
  return least;
}

Measured measure(const Claim& claim, const Findings& findings) {
  Measured all;
  for (const std::string& experiment : claim.in) {
    for (const Sample* a : findings.of(experiment, claim.a)) {
      if (a->runs.empty()) continue;  // of many questions, after a signal most
      const Sample* const b =
          claim.b.empty() ? a : findings.find(experiment, a->question->name, claim.b);
      if (b == nullptr || b->runs.empty()) continue;
      const double budget = common_budget(claim.value, *a, *b);
      const auto optimum = findings.optimum(*a->experiment, *a->question);
      const auto values = [&](const Sample& sample) {
        return sample.each(
            [&](const Run& run) { return value_of(sample, run, claim.value, budget, optimum); });
      };
      all.seeds = std::min({all.seeds, a->runs.size(), b->runs.size()});
      const int group = claim.value.best_of;
      all.pairs.push_back({least_of(values(*a), group), {}});
      if (!claim.b.empty()) all.pairs.back().b = least_of(values(*b), group);
      if (all.pairs.back().a.empty() || (!claim.b.empty() && all.pairs.back().b.empty()))
        all.obstacle = "needs " + std::to_string(group) + " seeds";
      all.a.push_back(a);
      all.b.push_back(b);
      for (const auto* list : {&all.pairs.back().a, &all.pairs.back().b})
        if (std::ranges::any_of(*list, [](double v) { return std::isnan(v); }))
          all.obstacle = "not recorded by these planners";
    }
  }
  if (all.pairs.empty())
    all.obstacle = findings.whole ? "not run" : "interrupted before it was run";
  if (all.obstacle.empty() && !findings.whole) all.obstacle = "interrupted: not all seeds were run";
  return all;
}

/// True where all runs of both have one value: nothing can be told apart.
bool all_equal(const Pair& pair) {
  const double first = pair.a.front();
  const auto same = [&](double v) {
    return v == first ||
           (std::isfinite(first) && std::abs(v - first) <= kSameLength * std::abs(first));
  };
  return std::ranges::all_of(pair.a, same) && std::ranges::all_of(pair.b, same);
}

std::vector<Pair> scaled(std::vector<Pair> pairs, double factor) {
  for (Pair& pair : pairs)
    for (double& value : pair.a) value *= factor;
  return pairs;
}

/// The first contender's values on all questions.
std::vector<double> pooled(const std::vector<Pair>& pairs) {
  std::vector<double> values;
  for (const Pair& pair : pairs) values.insert(values.end(), pair.a.begin(), pair.a.end());
  return values;
}

std::string of(int part, int whole) {
  return std::to_string(part) + " of " + std::to_string(whole);
}

std::string number_text(double value) {
  if (std::isinf(value)) return "never";
  return fixed(value, std::abs(value) >= 100 ? 1 : std::abs(value) >= 0.01 ? 3 : 5);
}

/// Runs that come to an end: of an effort the expected running time to the target, all runs' cost
/// by the number of successes (Hoos and Stuetzle 2004; Hansen et al. 2009).
std::string success_text(const Claim& claim, const Measured& all, bool first) {
  int hits = 0, runs = 0;
  double cost = 0;
  for (std::size_t q = 0; q < all.pairs.size(); ++q) {
    const Sample& sample = first ? *all.a[q] : *all.b[q];
    const auto& values = first ? all.pairs[q].a : all.pairs[q].b;
    const double budget = common_budget(claim.value, *all.a[q], *all.b[q]);
    for (std::size_t r = 0; r < values.size(); ++r) {
      ++runs;
      hits += std::isfinite(values[r]);
      const double whole = spent(sample, sample.runs[r], claim.value.at,
                                 static_cast<std::size_t>(sample.runs[r].iterations));
      cost += std::isfinite(values[r]) ? values[r] : std::fmin(whole, budget);
    }
  }
  if (claim.value.best_of > 1) return {};
  if (hits == runs && claim.value.name != "effort") return {};
  std::string text = "; " + (first ? claim.a : claim.b) + ": success in " + of(hits, runs) +
                     interval_text(share_interval(hits, runs), 2);
  if (claim.value.name == "effort")
    text += ", expected running time " + (hits > 0 ? number_text(cost / hits) : "unbounded");
  return text;
}

/// How many of these runs have a value in the claim's range.
int hits_of(const Claim& claim, const std::vector<double>& values) {
  return static_cast<int>(std::ranges::count_if(values, [&](double value) {
    return value >= claim.from && value <= claim.to * (1 + kSameLength);
  }));
}

/// One-sided p that a claim holds of these questions and that it fails, and its effect.
struct Sides {
  double holds, fails, effect;
};
Sides sides(const Claim& claim, const std::vector<Pair>& pairs) {
  if (claim.test == Test::most) {
    const auto values = pooled(pairs);
    const int hits = hits_of(claim, values), runs = static_cast<int>(values.size());
    return {binomial_above(hits, runs, claim.share), binomial_below(hits, runs, claim.share),
            static_cast<double>(hits) / runs};
  }
  if (claim.test == Test::similar) {
    const RankTest high = rank_test(scaled(pairs, 1 / (1 + claim.within)));
    const RankTest low = rank_test(scaled(pairs, 1 / (1 - claim.within)));
    return {std::max(high.less, low.greater), std::min(1.0, 2 * std::min(high.greater, low.less)),
            median_ratio(pairs)};
  }
  const RankTest test = rank_test(scaled(pairs, claim.factor));
  return {test.less, test.greater, test.effect};
}

/// What the questions say together and each by itself.
void test_sides(const Claim& claim, const std::vector<Pair>& pairs, Evidence& evidence) {
  evidence.questions = static_cast<int>(pairs.size());
  const Sides whole = sides(claim, pairs);
  evidence.p_for = whole.holds;
  evidence.p_against = whole.fails;
  evidence.effect = whole.effect;
  int holds = 0, fails = 0;  // clearly: after Bonferroni over the questions
  for (const Pair& pair : pairs) {
    const Sides one = sides(claim, {pair});
    const double count = 2.0 * static_cast<double>(pairs.size());
    holds += one.holds * count < kSignificant;
    fails += one.fails * count < kSignificant;
    evidence.clearest_for = std::min(evidence.clearest_for, one.holds * count);
    evidence.clearest_against = std::min(evidence.clearest_against, one.fails * count);
  }
  if (pairs.size() > 1)
    evidence.figures = "holds clearly on " + of(holds, evidence.questions) +
                       " questions, clearly fails on " + std::to_string(fails) + "; ";
}

std::string medians_text(const std::vector<Pair>& pairs) {
  constexpr std::size_t kMost = 3;
  std::string text = "medians ";
  for (std::size_t q = 0; q < std::min(kMost, pairs.size()); ++q)
    text += (q > 0 ? ", " : "") + number_text(quantile(pairs[q].a, 0.5)) + " against " +
            number_text(quantile(pairs[q].b, 0.5));
  if (pairs.size() > kMost) text += " and others";
  return text;
}

void compare(const Claim& claim, const Measured& all, std::vector<Pair> pairs, Evidence& evidence) {
  // Where equal runs stay equal when they are scaled by what the claim allows, they say nothing.
  const double allowed = claim.test == Test::similar ? 1 / (1 + claim.within) : claim.factor;
  const auto equal = std::erase_if(pairs, [&](const Pair& pair) {
    return all_equal(pair) && all_equal(scaled({pair}, allowed)[0]);
  });
  if (pairs.empty()) {
    evidence.obstacle =
        "all runs of both do the same: " + number_text(all.pairs.front().a.front()) +
        "; nothing to tell apart";
    return;
  }
  const double ratio = median_ratio(pairs);
  const Interval ratios = resampled_interval(pairs, median_ratio);
  test_sides(claim, pairs, evidence);
  evidence.interval = claim.test == Test::similar
                          ? ratios
                          : resampled_interval(scaled(pairs, claim.factor), share_less);
  evidence.figures += medians_text(pairs);
  if (std::isfinite(ratio))
    evidence.figures += ", ratio " + fixed(ratio, 3) + interval_text(ratios, 3);
  if (equal > 0)
    evidence.figures += "; " + std::to_string(equal) + " more where all runs do the same";
  evidence.figures += success_text(claim, all, true) + success_text(claim, all, false);
}

void count(const Claim& claim, const Measured& all, Evidence& evidence) {
  test_sides(claim, all.pairs, evidence);
  const auto values = pooled(all.pairs);
  const int hits = hits_of(claim, values), runs = static_cast<int>(values.size());
  evidence.interval = share_interval(hits, runs);
  evidence.neutral = claim.share;
  evidence.figures += of(hits, runs) + " runs; median " + number_text(quantile(values, 0.5)) +
                      ", quartiles " + number_text(quantile(values, 0.25)) + " to " +
                      number_text(quantile(values, 0.75));
}

/// Runs in which what must hold does not: a fault of ours.
int exceptions(const Claim& claim, const Findings& findings) {
  int found = 0;
  for (const std::string& experiment : claim.in) {
    for (const Sample* a : findings.of(experiment, claim.a)) {
      const Sample* const b =
          claim.b.empty() ? nullptr : findings.find(experiment, a->question->name, claim.b);
      for (std::size_t r = 0; r < a->runs.size(); ++r) {
        const Run& run = a->runs[r];
        if (b == nullptr)  // the best so far never rises
          found += std::ranges::adjacent_find(run.best, std::less<>()) != run.best.end();
        else if (r < b->runs.size() && claim.value.name == "limit")  // fewer choices
          found += run.limit > b->runs[r].limit * (1 + kSameLength);
        else if (r < b->runs.size())  // the same draws
          found += run.length != b->runs[r].length && (run.solved() || b->runs[r].solved());
      }
    }
  }
  return found;
}

/// The range of the control is where the source puts it: runs on both sides, or most within.
std::string missing_baseline(const Claim& claim, const Findings& findings) {
  const Measured all = measure(claim, findings);
  if (!all.obstacle.empty()) return claim.a + " " + all.obstacle;
  const auto values = pooled(all.pairs);
  const double low = quantile(values, 0.25), high = quantile(values, 0.75);
  if (low <= claim.to && high >= claim.from) return {};
  return claim.a + ": " + value_text(claim.value) + " is " + number_text(low) + " to " +
         number_text(high) + " in the middle half of the runs, by the source " +
         number_text(claim.from) + " to " + number_text(claim.to);
}

Evidence weigh(const Study& study, const Claim& claim, const Findings& findings) {
  Evidence evidence{.study = &study, .claim = &claim};
  if (claim.test == Test::none || claim.test == Test::arithmetic) {
    evidence.obstacle = claim.note;
    if (claim.test == Test::arithmetic) evidence.questions = exceptions(claim, findings);
    return evidence;
  }
  const Measured all = measure(claim, findings);
  evidence.obstacle = all.obstacle;
  if (all.pairs.empty()) return evidence;
  evidence.seeds = static_cast<int>(all.seeds);
  if (!evidence.obstacle.empty()) return evidence;
  if (claim.test == Test::most)
    count(claim, all, evidence);
  else
    compare(claim, all, all.pairs, evidence);
  for (const Claim& control : claim.baseline)
    if (auto missing = missing_baseline(control, findings); !missing.empty()) {
      evidence.verdict = Verdict::no_baseline;
      evidence.obstacle = std::move(missing);
    }
  return evidence;
}

}  // namespace

std::vector<Evidence> weigh(const Study& study, const Findings& findings) {
  std::vector<Evidence> all;
  for (const Claim& claim : study.claims) all.push_back(weigh(study, claim, findings));
  return all;
}

}  // namespace lasius::study
