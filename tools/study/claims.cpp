#include "tools/study/claims.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/draw/text.h"
#include "tools/study/values.h"

namespace lasius::study {
namespace {

using tool::fixed;

constexpr double kSignificant = 0.05;
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

/// One-sided p that a claim holds of these questions and that it fails, and its effect.
struct Sides {
  double holds, fails, effect;
};
Sides sides(const Claim& claim, const std::vector<Pair>& pairs) {
  if (claim.test == Test::similar) {
    const RankTest high = rank_test(scaled(pairs, 1 / (1 + claim.within)));
    const RankTest low = rank_test(scaled(pairs, 1 / (1 - claim.within)));
    return {std::max(high.less, low.greater), std::min(1.0, 2 * std::min(high.greater, low.less)),
            median_ratio(pairs)};
  }
  const RankTest test = rank_test(scaled(pairs, claim.factor));
  return {test.less, test.greater, test.effect};
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
  const auto equal = std::erase_if(pairs, all_equal);
  evidence.questions = static_cast<int>(pairs.size());
  if (pairs.empty()) {
    evidence.obstacle =
        "all runs of both do the same: " + number_text(all.pairs.front().a.front()) +
        "; nothing to tell apart";
    return;
  }
  const double ratio = median_ratio(pairs);
  const Interval ratios = resampled_interval(pairs, median_ratio);
  const Sides whole = sides(claim, pairs);
  evidence.p_for = whole.holds;
  evidence.p_against = whole.fails;
  evidence.effect = whole.effect;
  evidence.interval = claim.test == Test::similar
                          ? ratios
                          : resampled_interval(scaled(pairs, claim.factor), share_less);
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
                       " questions, fails on " + std::to_string(fails) + "; ";
  evidence.figures += medians_text(pairs);
  if (std::isfinite(ratio))
    evidence.figures += ", ratio " + fixed(ratio, 3) + interval_text(ratios, 3);
  if (equal > 0)
    evidence.figures += "; " + std::to_string(equal) + " more where all runs do the same";
  evidence.figures += success_text(claim, all, true) + success_text(claim, all, false);
}

void count(const Claim& claim, const Measured& all, Evidence& evidence) {
  int hits = 0, runs = 0;
  std::vector<double> values;
  for (const Pair& pair : all.pairs) {
    for (const double value : pair.a) {
      ++runs;
      hits += value >= claim.from && value <= claim.to * (1 + kSameLength);
      values.push_back(value);
    }
  }
  evidence.questions = static_cast<int>(all.pairs.size());
  evidence.p_for = binomial_above(hits, runs, claim.share);
  evidence.p_against = binomial_below(hits, runs, claim.share);
  evidence.effect = static_cast<double>(hits) / runs;
  evidence.interval = share_interval(hits, runs);
  evidence.neutral = claim.share;
  evidence.figures = of(hits, runs) + " runs; median " + number_text(quantile(values, 0.5)) +
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
  std::vector<double> values;
  for (const Pair& pair : all.pairs) values.insert(values.end(), pair.a.begin(), pair.a.end());
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

/// The least two-sided p that so many seeds can give.
double least_p(const Evidence& e, int seeds) {
  seeds /= e.claim->value.best_of;
  if (e.claim->test != Test::most) return least_rank_p(e.questions, seeds);
  const double runs = static_cast<double>(e.questions) * seeds;
  return std::min(1.0, 2 * std::pow(std::max(e.claim->share, 1 - e.claim->share), runs));
}

/// Why the seeds that were run cannot decide among `family` claims, and how many could.
std::string too_few_seeds(const Evidence& e, double family) {
  std::string text = "cannot decide with " + std::to_string(e.seeds) + " seeds";
  int more = e.seeds;
  while (more < kMostSeeds && least_p(e, more) * family >= kSignificant) ++more;
  if (least_p(e, more) * family >= kSignificant)
    return text + ", nor with the " + std::to_string(kMostSeeds) + " that a study may have";
  return text + "; " + std::to_string(more) + " could";
}

/// Where the upper tail of the normal distribution is p, 0 < p <= 0.5: by halving.
double normal_quantile(double p) {
  double low = 0, high = 40;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (std::erfc(middle / std::numbers::sqrt2) / 2 > p ? low : high) = middle;
  }
  return low;
}

/// How many seeds would decide were the effect what was found, if they had to be root^2 as many.
std::string seeds_at_this_effect(const Evidence& e, double root) {
  const double seeds = std::ceil(e.seeds * root * root);
  if (!(seeds <= kMostSeeds)) return "at this effect no number of seeds decides";
  return "at this effect about " + std::to_string(static_cast<int>(seeds)) + " seeds would decide";
}

/// By how much a test's z would have to grow to decide among `family` claims: it does by the root
/// of the runs.
double growth_of_z(const Evidence& e, double family) {
  return normal_quantile(kSignificant / (2 * family)) /
         normal_quantile(std::min({e.p_for, e.p_against, 0.5}));
}

/// By how much the interval would have to shrink to lie on its side: it does by the root of the
/// runs.
double shrinking_of_interval(const Evidence& e) {
  const auto by = [](double half, double room) { return room > 0 ? half / room : INFINITY; };
  const bool similar = e.claim->test == Test::similar;
  const double least = similar ? 1 - e.claim->within : e.neutral;
  const double most = similar ? 1 + e.claim->within : INFINITY;
  const double below = e.effect - e.interval.low, above = e.interval.high - e.effect;
  return e.holds() ? std::max(by(below, e.effect - least), by(above, most - e.effect))
                   : std::min(by(above, least - e.effect), by(below, e.effect - most));
}

Verdict verdict_of(const Evidence& e) {
  const bool holds = e.holds();
  const auto& [low, high] = e.interval;
  if (e.claim->test == Test::similar) {
    const double least = 1 - e.claim->within, most = 1 + e.claim->within;
    const bool inside = low >= least && high <= most, outside = low > most || high < least;
    return holds && inside     ? Verdict::confirmed
           : !holds && outside ? Verdict::refuted
                               : Verdict::undecided;
  }
  return holds && low > e.neutral     ? Verdict::confirmed
         : !holds && high < e.neutral ? Verdict::refuted
                                      : Verdict::undecided;
}

}  // namespace

std::string verdict_text(Verdict verdict) {
  constexpr const char* kTexts[] = {"confirmed",
                                    "**refuted**",
                                    "undecided",
                                    "depends on the map",
                                    "baseline not reproduced",
                                    "follows from arithmetic",
                                    "not repeated"};
  return kTexts[static_cast<int>(verdict)];
}

std::vector<Evidence> weigh(const Study& study, const Findings& findings) {
  std::vector<Evidence> all;
  for (const Claim& claim : study.claims) all.push_back(weigh(study, claim, findings));
  return all;
}

void decide(std::span<Evidence> evidence) {
  std::vector<double> p;
  for (const Evidence& e : evidence)
    if (e.tested()) p.push_back(std::min(1.0, 2 * std::min(e.p_for, e.p_against)));
  const auto family = static_cast<double>(p.size());
  p = holm(p);
  auto next = p.begin();
  for (Evidence& e : evidence) {
    const auto note = [&](const std::string& text) {
      e.figures = e.figures.empty() ? text : text + "; " + e.figures;
    };
    if (e.claim->test == Test::none) e.verdict = Verdict::none;
    if (e.claim->test == Test::arithmetic) {
      e.verdict = Verdict::arithmetic;
      e.figures = e.obstacle + "; exceptions: " + std::to_string(e.questions);
    } else if (!e.tested()) {
      note(e.obstacle);
    } else {
      e.adjusted = *next++;
      if (std::max(e.clearest_for, e.clearest_against) * family < kSignificant) {
        e.verdict = Verdict::depends;
      } else if (e.adjusted < kSignificant &&
                 (e.holds() ? e.clearest_against : e.clearest_for) < kSignificant) {
        note("some question says the opposite");
      } else if (e.adjusted < kSignificant) {
        e.verdict = verdict_of(e);
        if (e.verdict == Verdict::undecided)
          note(seeds_at_this_effect(e, shrinking_of_interval(e)));
      } else if (least_p(e, e.seeds) * family >= kSignificant) {
        note(too_few_seeds(e, family));
      } else {
        note(seeds_at_this_effect(e, growth_of_z(e, family)));
      }
    }
  }
}

}  // namespace lasius::study
