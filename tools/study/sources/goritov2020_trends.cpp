// The trends that the source reports, judged on the runs.
#include "tools/draw/text.h"
#include "tools/study/sources/goritov2020.h"
#include "tools/study/sources/goritov2020_measures.h"

namespace lasius::study {
namespace {

/// One trend under one reading.
class Judge {
 public:
  Judge(const Findings& findings, const char* reading) : findings_(findings), reading_(reading) {}

  /// `best` is shorter than each of `others`.
  Claim::Answer shortest(const std::string& best, const std::vector<std::string>& others) const {
    Claim::Answer answer{Verdict::confirmed, ""};
    for (const auto& other : others) weigh(answer, other, {of(best), of(other)});
    return answer;
  }

  /// Each one's paths are shorter than those of the one before it.
  Claim::Answer ordered(const std::vector<std::string>& names) const {
    Claim::Answer answer{Verdict::confirmed, ""};
    for (std::size_t i = 0; i + 1 < names.size(); ++i) {
      weigh(answer, names[i] + " over " + names[i + 1], {of(names[i + 1]), of(names[i])});
    }
    return answer;
  }

  Claim::Answer alpha_freezes() const {
    Claim::Answer answer;
    std::vector<double> when;
    bool most = true;
    for (const char* name : {"base", "alpha-2", "alpha-3", "alpha-4"}) {
      const Freezing f(of(name));
      add(answer.figures, std::string(name) + " " + f.text());
      if (std::string(name) == "base") continue;
      most = most && f.share() >= 0.5;
      when.push_back(f.median);
    }
    const bool falling = when[0] >= when[1] && when[1] >= when[2];
    answer.verdict = most && falling ? Verdict::confirmed : Verdict::refuted;
    return answer;
  }

  Claim::Answer beta_is_inert() const {
    bool same = true;
    const Runs a = of("base"), b = of("beta-0");
    for (std::size_t q = 0; q < a.size(); ++q) {
      for (std::size_t s = 0; s < a[q]->runs.size(); ++s) {
        const Run &first = a[q]->runs[s], &second = b[q]->runs[s];
        same = same && first.best == second.best && first.mean == second.mean;
      }
    }
    return {same ? Verdict::confirmed : Verdict::refuted,
            same ? "all runs are equal, bit for bit" : "runs differ"};
  }

  Claim::Answer gamma_zero_is_slow() const {
    const double times = mean_steps(of("gamma-0")) / mean_steps(of("base"));
    const Contrast c(of("base"), of("gamma-0"));
    return {c.first_shorter() && times >= 2   ? Verdict::confirmed
            : c.first_shorter() || times >= 2 ? Verdict::open
                                              : Verdict::refuted,
            fixed(times, 1) + " times the steps of the base set; length " + c.text()};
  }

  /// Within 5% of the optimum of the base set, whatever the value.
  Claim::Answer little_effect(const std::vector<std::string>& others) const {
    Claim::Answer answer{Verdict::confirmed, ""};
    for (const auto& other : others) {
      const Contrast c(of("base"), of(other));
      add(answer.figures, other + " " + c.text());
      if (c.interval.low > 0.05 || c.interval.high < -0.05) answer.verdict = Verdict::refuted;
      const bool within = c.interval.low >= -0.05 && c.interval.high <= 0.05;
      if (!within && answer.verdict == Verdict::confirmed) answer.verdict = Verdict::open;
    }
    return answer;
  }

  Claim::Answer sooner_with_more_ants() const {
    Claim::Answer answer{Verdict::confirmed, ""};
    double before = 1e300;
    for (const char* name : {"m-4", "m-8", "m-16", "base"}) {
      const double reached = mean_reached(of(name));
      add(answer.figures, std::string(name) + " " + fixed(reached, 1));
      if (reached > before) answer.verdict = Verdict::refuted;
      before = reached;
    }
    return answer;
  }

  Claim::Answer strong_elite_freezes() const {
    const Contrast c(of("e-64"), of("e-256"));
    const Freezing f(of("e-256"));
    return {c.first_shorter() && f.share() >= 0.5 ? Verdict::confirmed
            : c.second_shorter()                  ? Verdict::refuted
                                                  : Verdict::open,
            "e-256 over e-64 " + c.text() + "; " + f.text()};
  }

 private:
  /// Adds the contrast's figures: the first one should be shorter.
  static void weigh(Claim::Answer& answer, const std::string& what, const Contrast& contrast) {
    add(answer.figures, what + " " + contrast.text());
    if (contrast.second_shorter())
      answer.verdict = Verdict::refuted;
    else if (!contrast.first_shorter() && answer.verdict == Verdict::confirmed)
      answer.verdict = Verdict::open;
  }

  Runs of(const std::string& name) const { return findings_.of(reading_, name); }
  static void add(std::string& text, const std::string& more) {
    if (!text.empty()) text += "; ";
    text += more;
  }

  const Findings& findings_;
  const char* reading_;
};

}  // namespace

std::vector<ArmTrend> arm_trends(const Findings& findings) {
  std::vector<ArmTrend> trends;
  const auto add = [&](const char* text, const auto& judge) {
    ArmTrend trend{text, {}};
    for (std::size_t r = 0; r < kReadings.size(); ++r)
      trend.found[r] = judge(Judge(findings, kReadings[r]));
    trends.push_back(std::move(trend));
  };
  add("alpha = 1 gives the shortest path", [](const Judge& j) {
    return j.shortest("base", {"alpha-0", "alpha-2", "alpha-3", "alpha-4"});
  });
  add("alpha > 1: the mean length freezes, at iteration 77 (2), 44 (3), 14 (4)",
      [](const Judge& j) { return j.alpha_freezes(); });
  add("beta has no effect", [](const Judge& j) { return j.beta_is_inert(); });
  add("gamma = 1 is best of 0.25, 0.5, 1, 2", [](const Judge& j) {
    return j.shortest("gamma-1", {"base", "gamma-0.5", "gamma-2"});
  });
  add("gamma = 0 is hopelessly slow", [](const Judge& j) { return j.gamma_zero_is_slow(); });
  add("rho matters little (here: within 5% of the optimum)", [](const Judge& j) {
    return j.little_effect({"rho-0", "rho-0.5", "rho-1"});
  });
  add("more ants give shorter paths", [](const Judge& j) {
    return j.ordered({"m-4", "m-8", "m-16", "base"});
  });
  add("more ants need fewer iterations (here: mean iteration of the best path)",
      [](const Judge& j) { return j.sooner_with_more_ants(); });
  add("at m T = 6400 more ants beat more iterations", [](const Judge& j) {
    return j.ordered({"T-200", "base", "T-50", "T-25", "T-16", "T-8"});
  });
  add("e = 16 and e = 64 (e <= m) beat the plain system by a wide margin", [](const Judge& j) {
    const auto a = j.shortest("e-16", {"base"}), b = j.shortest("e-64", {"base"});
    const Verdict verdict = a.verdict == b.verdict ? a.verdict : Verdict::open;
    return Claim::Answer{verdict, "over e-16: " + a.figures + "; over e-64: " + b.figures};
  });
  add("e = 256 (e > m) freezes in a local optimum",
      [](const Judge& j) { return j.strong_elite_freezes(); });
  return trends;
}

}  // namespace lasius::study
