// The trends that the source reports, judged on the runs, and the report.
#include <algorithm>
#include <cmath>

#include "lasius/version.h"
#include "study/goritov2020.h"
#include "study/statistics.h"
#include "study/table.h"
#include "study/text.h"

namespace lasius::study {
namespace {

using Runs = std::vector<std::vector<ArmRun>>;

double final_best(const ArmRun& run) { return run.best.empty() ? kUnknown : run.best.back(); }

/// Final best lengths of `b` minus those of `a`, paired by question and seed, in shares of the
/// optimum: positive where `a` is shorter.
std::vector<double> differences(const Runs& a, const Runs& b) {
  std::vector<double> list;
  for (std::size_t q = 0; q < a.size(); ++q) {
    for (std::size_t s = 0; s < a[q].size(); ++s) {
      const double d = final_best(b[q][s]) - final_best(a[q][s]);
      if (std::isfinite(d)) list.push_back(d);
    }
  }
  return list;
}

std::string percent(double share) { return fixed(100 * share, 1); }

struct Contrast {
  double mean = 0;
  Interval interval;

  Contrast(const Runs& a, const Runs& b) {
    const auto list = differences(a, b);
    mean = summarise(list).mean;
    interval = mean_interval(list);
  }
  bool first_shorter() const { return interval.low > 0; }
  bool second_shorter() const { return interval.high < 0; }
  /// How much longer the second one is, in percent of the optimum.
  std::string text() const {
    std::string text(mean >= 0 ? "+" : "");
    text.append(percent(mean)).append("% [").append(percent(interval.low)).append(", ");
    return text.append(percent(interval.high)).append("]");
  }
};

/// The iteration from which a run's mean tour never changes again; 0 where it changes in the last
/// tenth.
int frozen_from(const ArmRun& run) {
  const auto& mean = run.mean;
  std::size_t from = mean.size();
  while (from > 0 && std::abs(mean[from - 1] - mean.back()) <= 1e-12 * mean.back()) --from;
  return from + mean.size() / 10 < mean.size() ? static_cast<int>(from) + 1 : 0;
}

struct Freezing {
  int frozen = 0, all = 0;
  double median = kUnknown;

  explicit Freezing(const Runs& runs) {
    std::vector<double> when;
    for (const auto& question : runs) {
      for (const ArmRun& run : question) {
        ++all;
        if (const int from = frozen_from(run); from > 0) when.push_back(from);
      }
    }
    frozen = static_cast<int>(when.size());
    if (!when.empty()) median = quantile(when, 0.5);
  }
  double share() const { return all > 0 ? static_cast<double>(frozen) / all : 0; }
  std::string text() const {
    return percent(share()) + "% frozen" + (frozen > 0 ? ", median " + fixed(median, 0) : "");
  }
};

double mean_steps(const Runs& runs) {
  double sum = 0, count = 0;
  for (const auto& question : runs) {
    for (const ArmRun& run : question) {
      sum += static_cast<double>(run.steps);
      ++count;
    }
  }
  return sum / count;
}

double mean_reached(const Runs& runs) {
  double sum = 0, count = 0;
  for (const auto& question : runs) {
    for (const ArmRun& run : question) {
      const auto first = std::find(run.best.begin(), run.best.end(), run.best.back());
      sum += static_cast<double>(first - run.best.begin()) + 1;
      ++count;
    }
  }
  return sum / count;
}

/// One trend under one reading.
class Judge {
 public:
  Judge(const ArmFindings& findings, std::size_t reading)
      : findings_(findings), reading_(reading) {}

  /// `best` is shorter than each of `others`.
  Claim::Answer shortest(const std::string& best, const std::vector<std::string>& others) const {
    Claim::Answer answer{Verdict::confirmed, ""};
    for (const auto& other : others) {
      const Contrast c(of(best), of(other));
      add(answer.figures, other + " " + c.text());
      if (c.second_shorter())
        answer.verdict = Verdict::refuted;
      else if (!c.first_shorter() && answer.verdict == Verdict::confirmed)
        answer.verdict = Verdict::open;
    }
    return answer;
  }

  /// Each one's paths are shorter than those of the one before it.
  Claim::Answer ordered(const std::vector<std::string>& names) const {
    Claim::Answer answer{Verdict::confirmed, ""};
    for (std::size_t i = 0; i + 1 < names.size(); ++i) {
      const Contrast c(of(names[i + 1]), of(names[i]));
      add(answer.figures, names[i] + " over " + names[i + 1] + " " + c.text());
      if (c.second_shorter())
        answer.verdict = Verdict::refuted;
      else if (!c.first_shorter() && answer.verdict == Verdict::confirmed)
        answer.verdict = Verdict::open;
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
    const Runs &a = of("base"), &b = of("beta-0");
    for (std::size_t q = 0; q < a.size(); ++q) {
      for (std::size_t s = 0; s < a[q].size(); ++s) {
        same = same && a[q][s].best == b[q][s].best && a[q][s].mean == b[q][s].mean;
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
  const Runs& of(const std::string& name) const { return findings_.of(reading_, name); }
  static void add(std::string& text, const std::string& more) {
    if (!text.empty()) text += "; ";
    text += more;
  }

  const ArmFindings& findings_;
  std::size_t reading_;
};

std::string verdict_text(const Claim::Answer& answer) {
  const char* name = answer.verdict == Verdict::confirmed ? "confirmed"
                     : answer.verdict == Verdict::refuted ? "**does not reproduce**"
                                                          : "open";
  return std::string(name) + ": " + answer.figures;
}

Table question_table(const ArmFindings& findings) {
  Table table{{"question", "lattice", "optimum, m", "optimum / Manhattan", "straight way"}, {}};
  for (std::size_t q = 0; q < findings.questions.size(); ++q) {
    const ArmGround& ground = findings.grounds[q];
    const auto& [x, y, z] = ground.points;
    table.rows.push_back({"seed " + std::to_string(findings.questions[q].seed) + ", wall " +
                              fixed(findings.questions[q].wall, 1),
                          std::to_string(x) + " x " + std::to_string(y) + " x " + std::to_string(z),
                          fixed(ground.optimum, 3), fixed(ground.detour, 2),
                          ground.straight ? "open" : "closed"});
  }
  return table;
}

Table setting_table(const ArmFindings& findings, std::size_t reading) {
  Table table{{"setting", "best length / optimum, mean [95%]", "runs at the optimum",
               "mean tour at last / optimum", "iteration of the best", "mean tour frozen",
               "questions", "steps"},
              {}};
  for (const ArmSetting& setting : findings.settings) {
    const Runs& runs = findings.of(reading, setting.name());
    std::vector<double> lengths, tours;
    double questions = 0;
    int optimal = 0, all = 0;
    for (const auto& question : runs) {
      for (const ArmRun& run : question) {
        ++all;
        questions += static_cast<double>(run.questions);
        if (!std::isfinite(final_best(run))) continue;
        lengths.push_back(final_best(run));
        tours.push_back(run.mean.back());
        optimal += final_best(run) <= 1 + 1e-9;
      }
    }
    if (lengths.empty()) continue;
    const Interval interval = mean_interval(lengths);
    table.rows.push_back({setting.name(),
                          fixed(summarise(lengths).mean, 3) + " [" + fixed(interval.low, 3) + ", " +
                              fixed(interval.high, 3) + "]",
                          percent(static_cast<double>(optimal) / all) + "%",
                          fixed(summarise(tours).mean, 2), fixed(mean_reached(runs), 1),
                          Freezing(runs).text(), fixed(questions / all, 0),
                          fixed(mean_steps(runs), 0)});
  }
  return table;
}

}  // namespace

std::vector<ArmTrend> arm_trends(const ArmFindings& findings) {
  std::vector<ArmTrend> trends;
  const auto add = [&](const char* text, const auto& judge) {
    ArmTrend trend{text, {}};
    for (std::size_t r = 0; r < kReadings.size(); ++r) trend.found[r] = judge(Judge(findings, r));
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

std::string arm_report(const ArmFindings& findings, const std::vector<std::string>& pictures) {
  std::string text =
      "# goritov2020\n\nGoritov, Goncharov: Motion trajectory planning for a multi-link "
      "manipulator "
      "in an unknown environment based on ant colony optimization. Proceedings of TUSUR University "
      "23 (2), 2020, 55-64. Repeated with lasius " LASIUS_VERSION ", seeds 1 to " +
      std::to_string(findings.seeds) +
      ".\n\nThe source's arm and scenes are lost. Here: the arm maps/arms/industrial6.json among "
      "12 "
      "random obstacles, with a wall between start and goal in half of the questions. Lengths are "
      "shares of the optimum of the fully known lattice, found by A*. Its words speak of pheromone "
      "on edges, its set of edges of ordered pairs: both readings are run, `arcs` being this "
      "program's default.\n\n";
  text += question_table(findings).markdown() + "\n## Trends\n\n";
  Table trends{{"reported", "found, arcs", "found, edges"}, {}};
  for (const ArmTrend& trend : arm_trends(findings))
    trends.rows.push_back({trend.text, verdict_text(trend.found[0]), verdict_text(trend.found[1])});
  text += trends.markdown();
  text +=
      "\nFigures say how much longer the best path is, in percent of the optimum, mean over all "
      "questions and seeds and 95% interval of the paired differences (10 000 resampled means). A "
      "trend is confirmed where every interval says so, and does not reproduce where one says the "
      "opposite. A run's mean tour is frozen where it does not change in the last tenth.\n";
  for (std::size_t r = 0; r < kReadings.size(); ++r) {
    text += "\n## All settings, pheromone on " + std::string(kReadings[r]) + "\n\n" +
            setting_table(findings, r).markdown();
  }
  text += "\n## Curves\n\n";
  for (const auto& picture : pictures) text += "![" + picture + "](" + picture + ")\n";
  return text;
}

}  // namespace lasius::study
