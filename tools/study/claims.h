// The kinds of sentences that sources write about their results, as checks of findings.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/study/findings.h"
#include "tools/study/statistics.h"

namespace lasius::study {

/// Two lengths that differ by less than this fraction are equal.
inline constexpr double kSameLength = 1e-9;

/// Test of b's lengths minus a's, paired by seed: a positive effect says that `a` is shorter. A run
/// without a path counts as infinitely long, two of them as equal.
SignedRank compare(const Sample& a, const Sample& b);
/// The paired differences themselves.
std::vector<double> differences(const Sample& a, const Sample& b);

using Check = std::function<Claim::Answer(const Findings&)>;

/// Names of experiments whose questions count together.
using Experiments = std::vector<std::string>;

/// `a` is shorter than `b` in the mean on every question; the figures tell how many of them are
/// significant at 5% after Holm.
Check shorter_everywhere(Experiments experiments, std::string a, std::string b);
/// The best of the first `runs` runs of `a` is no longer than that of `b`, on every question.
Check best_never_longer(Experiments experiments, std::string a, std::string b, int runs);
/// `a` takes at most 1 / `factor` of the time of `b` on every question.
Check faster_everywhere(Experiments experiments, std::string a, std::string b, double factor);
/// `a` converges in fewer iterations than `b` in the median, on every question.
Check sooner_everywhere(Experiments experiments, std::string a, std::string b);
/// Every run finds the optimum, by iteration `median` in the median and `worst` at worst.
Check optimum_by(Experiments experiments, std::string contender, int median, int worst);
/// The best of the first `runs` runs on a question is optimal, on at least `questions` of them.
Check best_is_optimal(Experiments experiments, std::string contender, int runs, int questions);
/// No run improves after this iteration.
Check converged_by(Experiments experiments, std::string contender, int iteration);
/// The best length never rises from one iteration to the next, in any run.
Check never_rises(Experiments experiments, std::string contender);

}  // namespace lasius::study
