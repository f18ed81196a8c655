#include "tools/study/claims.h"

#include <algorithm>
#include <cmath>

#include "tools/draw/text.h"

namespace lasius::study {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kSignificant = 0.05;

/// Both samples of every question.
using Pairs = std::vector<std::pair<const Sample*, const Sample*>>;

Pairs pairs(const Findings& findings, const Experiments& experiments, const std::string& a,
            const std::string& b) {
  Pairs found;
  for (const std::string& experiment : experiments)
    for (const Sample* first : findings.of(experiment, a))
      if (const Sample* second = findings.find(experiment, first->question->name, b))
        found.emplace_back(first, second);
  return found;
}

std::vector<const Sample*> samples(const Findings& findings, const Experiments& experiments,
                                   const std::string& contender) {
  std::vector<const Sample*> found;
  for (const std::string& experiment : experiments)
    for (const Sample* sample : findings.of(experiment, contender)) found.push_back(sample);
  return found;
}

/// The shortest length of the first `runs` runs; infinite without a path.
double best_of(const Sample& sample, int runs) {
  double best = kInfinity;
  for (const Run& run : sample.runs)
    if (run.seed <= static_cast<std::uint64_t>(runs) && run.solved())
      best = std::min(best, run.length);
  return best;
}

std::string of(int part, std::size_t whole) {
  return std::to_string(part) + " of " + std::to_string(whole);
}

double mean_length(const Sample& sample) {
  const auto lengths = sample.lengths();
  return lengths.size() == sample.runs.size() ? summarise(lengths).mean : kInfinity;
}

Claim::Answer verdict(bool holds, std::string figures) {
  return {holds ? Verdict::confirmed : Verdict::refuted, std::move(figures)};
}

const Claim::Answer kNotRun{Verdict::open, "not run"};

/// The first iteration after which a run's best length is the optimum; 0 if none is.
int iteration_of(const Run& run, double optimum) {
  for (std::size_t i = 0; i < run.best.size(); ++i)
    if (run.best[i] <= optimum * (1 + kSameLength)) return static_cast<int>(i) + 1;
  return 0;
}

}  // namespace

std::vector<double> differences(const Sample& a, const Sample& b) {
  std::vector<double> values;
  for (std::size_t r = 0; r < std::min(a.runs.size(), b.runs.size()); ++r) {
    const Run &first = a.runs[r], &second = b.runs[r];
    if (!first.solved() || !second.solved()) {
      values.push_back(first.solved() ? kInfinity : second.solved() ? -kInfinity : 0);
      continue;
    }
    const double d = second.length - first.length;
    values.push_back(std::abs(d) <= kSameLength * first.length ? 0 : d);
  }
  return values;
}

SignedRank compare(const Sample& a, const Sample& b) { return signed_rank(differences(a, b)); }

Check shorter_everywhere(Experiments experiments, std::string a, std::string b) {
  return [=](const Findings& findings) {
    const Pairs all = pairs(findings, experiments, a, b);
    if (all.empty()) return kNotRun;
    int shorter = 0, longer = 0;
    std::vector<double> p;
    std::vector<bool> ahead;
    for (const auto& [first, second] : all) {
      const SignedRank test = compare(*first, *second);
      p.push_back(test.p);
      ahead.push_back(test.effect > 0);
      const double mean_a = mean_length(*first), mean_b = mean_length(*second);
      shorter += mean_a < mean_b;
      longer += mean_b < mean_a;
    }
    int clear = 0, clear_loss = 0;
    const auto adjusted = holm(p);
    for (std::size_t i = 0; i < p.size(); ++i)
      if (adjusted[i] < kSignificant) ++(ahead[i] ? clear : clear_loss);
    const int count = static_cast<int>(all.size());
    return verdict(shorter == count,
                   "shorter in the mean on " + of(shorter, all.size()) + ", longer on " +
                       std::to_string(longer) + "; significant at 5% after Holm: " +
                       std::to_string(clear) + " won, " + std::to_string(clear_loss) + " lost");
  };
}

Check faster_everywhere(Experiments experiments, std::string a, std::string b, double factor) {
  return [=](const Findings& findings) {
    const Pairs all = pairs(findings, experiments, a, b);
    if (all.empty()) return kNotRun;
    double least = kInfinity, most = 0;
    for (const auto& [first, second] : all) {
      const double ratio = summarise(second->seconds()).median / summarise(first->seconds()).median;
      least = std::min(least, ratio);
      most = std::max(most, ratio);
    }
    return verdict(least >= factor, "median time of the other is " + fixed(least, 2) + " to " +
                                        fixed(most, 2) + " times as long");
  };
}

Check optimum_by(Experiments experiments, std::string contender, int median, int worst) {
  return [=](const Findings& findings) {
    std::vector<double> iterations;
    int runs = 0;
    for (const Sample* sample : samples(findings, experiments, contender)) {
      const auto optimum = findings.optimum(*sample->experiment, *sample->question);
      if (!optimum) return kNotRun;
      for (const Run& run : sample->runs) {
        ++runs;
        if (const int at = iteration_of(run, *optimum)) iterations.push_back(at);
      }
    }
    if (runs == 0) return kNotRun;
    std::string figures =
        "optimal in " + std::to_string(iterations.size()) + " of " + std::to_string(runs) + " runs";
    if (iterations.empty()) return verdict(false, figures);
    const Summary s = summarise(iterations);
    figures += ", at iteration " + fixed(s.median, 1) + " in the median, " + fixed(s.most, 0) +
               " at worst";
    return verdict(s.count == runs && s.median <= median && s.most <= worst, figures);
  };
}

Check best_is_optimal(Experiments experiments, std::string contender, int runs, int questions) {
  return [=](const Findings& findings) {
    int optimal = 0;
    std::size_t known = 0;
    for (const Sample* sample : samples(findings, experiments, contender)) {
      const auto optimum = findings.optimum(*sample->experiment, *sample->question);
      if (!optimum) continue;
      ++known;
      optimal += best_of(*sample, runs) <= *optimum * (1 + kSameLength);
    }
    if (known == 0) return kNotRun;
    return verdict(optimal >= questions, "the best of " + std::to_string(runs) +
                                             " runs is optimal on " + of(optimal, known));
  };
}

Check best_never_longer(Experiments experiments, std::string a, std::string b, int runs) {
  return [=](const Findings& findings) {
    const Pairs all = pairs(findings, experiments, a, b);
    if (all.empty()) return kNotRun;
    int shorter = 0, longer = 0;
    for (const auto& [first, second] : all) {
      const double ours = best_of(*first, runs), theirs = best_of(*second, runs);
      shorter += ours < theirs * (1 - kSameLength);
      longer += ours > theirs * (1 + kSameLength);
    }
    return verdict(longer == 0, "best of " + std::to_string(runs) + " runs: shorter on " +
                                    of(shorter, all.size()) + ", longer on " +
                                    std::to_string(longer));
  };
}

Check sooner_everywhere(Experiments experiments, std::string a, std::string b) {
  return [=](const Findings& findings) {
    const Pairs all = pairs(findings, experiments, a, b);
    if (all.empty()) return kNotRun;
    int sooner = 0;
    std::vector<double> ours, theirs;
    for (const auto& [first, second] : all) {
      if (first->solved() == 0 || second->solved() == 0) continue;
      ours.push_back(summarise(first->iterations_to_converge()).median);
      theirs.push_back(summarise(second->iterations_to_converge()).median);
      sooner += ours.back() < theirs.back();
    }
    if (ours.empty()) return verdict(false, "no question on which both find a path");
    return verdict(sooner == static_cast<int>(all.size()),
                   "sooner on " + of(sooner, all.size()) + "; median iterations over the maps " +
                       fixed(quantile(ours, 0.5), 1) + " against " +
                       fixed(quantile(theirs, 0.5), 1));
  };
}

Check converged_by(Experiments experiments, std::string contender, int iteration) {
  return [=](const Findings& findings) {
    std::vector<double> all;
    for (const Sample* sample : samples(findings, experiments, contender))
      for (const double i : sample->iterations_to_converge()) all.push_back(i);
    if (all.empty()) return kNotRun;
    const auto by = std::count_if(all.begin(), all.end(), [=](double i) { return i <= iteration; });
    return verdict(by == static_cast<std::ptrdiff_t>(all.size()),
                   std::to_string(by) + " of " + std::to_string(all.size()) +
                       " runs improve no more after iteration " + std::to_string(iteration) +
                       "; the last improvement comes at iteration " +
                       fixed(summarise(all).median, 1) + " in the median");
  };
}

Check never_rises(Experiments experiments, std::string contender) {
  return [=](const Findings& findings) {
    int runs = 0, rises = 0;
    for (const Sample* sample : samples(findings, experiments, contender)) {
      for (const Run& run : sample->runs) {
        ++runs;
        rises += std::adjacent_find(run.best.begin(), run.best.end(),
                                    [](double a, double b) { return b > a; }) != run.best.end();
      }
    }
    if (runs == 0) return kNotRun;
    return verdict(rises == 0,
                   "rises in " + std::to_string(rises) + " of " + std::to_string(runs) + " runs");
  };
}

}  // namespace lasius::study
