// The verdicts that follow from the evidence.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/study/claims.h"

namespace lasius::study {
namespace {

using Test = Claim::Test;

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

/// How many seeds would decide were the effect what was found: root * root times as many.
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
                                    "map-dependent",
                                    "baseline not reproduced",
                                    "follows from arithmetic",
                                    "not repeated"};
  return kTexts[static_cast<int>(verdict)];
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
      const double both = std::max(e.clearest_for, e.clearest_against);
      const double opposite = e.holds() ? e.clearest_against : e.clearest_for;
      if (both * family < kSignificant) {
        e.verdict = Verdict::depends;
      } else if (std::min(both, std::max(e.adjusted, opposite)) < kSignificant) {
        note("some question says the opposite");
      } else if (e.adjusted < kSignificant) {
        e.verdict = verdict_of(e);
        if (e.verdict == Verdict::undecided)
          note(seeds_at_this_effect(e, shrinking_of_interval(e)));
      } else if (least_p(e, e.seeds) * family >= kSignificant) {
        note(too_few_seeds(e, family));
      } else {
        note(seeds_at_this_effect(e, std::max(growth_of_z(e, family), shrinking_of_interval(e))));
      }
    }
  }
}

}  // namespace lasius::study
