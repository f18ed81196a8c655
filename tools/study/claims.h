// What the runs say of a source's claims.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/study/findings.h"
#include "tools/study/statistics.h"

namespace lasius::study {

inline constexpr double kSignificant = 0.05;

enum class Verdict {
  confirmed,
  refuted,
  undecided,
  depends,      ///< holds on some questions, the opposite on others
  no_baseline,  ///< its control does not do what the source says of it
  arithmetic,   ///< holds by itself
  none,         ///< was not repeated
};
/// As the tables say it.
std::string verdict_text(Verdict verdict);

/// A claim and the runs' evidence, and what follows from both.
struct Evidence {
  const Study* study = nullptr;
  const Claim* claim = nullptr;
  int seeds = 0;                    ///< of the contender with the fewest runs on a question
  int questions = 0;                ///< that can decide
  double p_for = 1, p_against = 1;  ///< one-sided
  double effect =
      kUnknown;            ///< A12; of `most` the share of runs; of `similar` the ratio of medians
  Interval interval = {};  ///< of the effect, 95%
  double neutral = 0.5;    ///< the effect that speaks for neither side
  double clearest_for = 1, clearest_against = 1;  ///< p of one question, Bonferroni over them
  std::string figures = {};                       ///< what was measured, in words
  std::string obstacle = {};  ///< why nothing can be said; empty: the test was made
  Verdict verdict = Verdict::undecided;
  double adjusted = kUnknown;  ///< two-sided p after Holm

  bool holds() const { return p_for < p_against; }  ///< rather than not
  bool tested() const { return obstacle.empty() && questions > 0; }
};

/// The evidence for each claim of a study, verdicts still open.
std::vector<Evidence> weigh(const Study& study, const Findings& findings);

/// Gives the verdicts, all tests of a report at once: p adjusted by Holm over them, 5%.
/// A claim is map-dependent where one question speaks for it and another against, each after
/// correction over the tests, too. Else it is confirmed or refuted where test and interval say so
/// and no question speaks clearly against; else undecided, with the seeds that could decide where
/// these could not.
void decide(std::span<Evidence> evidence);

}  // namespace lasius::study
