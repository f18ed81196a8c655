#include "tools/study/sources/maklink.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "tools/console/values.h"
#include "tools/draw/text.h"
#include "tools/study/statistics.h"

namespace lasius::study {
namespace {

constexpr const char* kWorld = "maklink200.geojson";

/// 2000 paths for each, as in the source's 200 iterations of 10 ants; ten times as many for the
/// genetic algorithm, and its own 1000 generations.
std::vector<CrossingContender> contenders() {
  return {{"acs-11", "maklink-acs, 11 values", "maklink-acs", {{"values", "11"}}, 10},
          {"acs-21", "maklink-acs, 21 values", "maklink-acs", {{"values", "21"}}, 10},
          {"control", "11 values, pheromone off", "maklink-acs", {{"evaporation", "0"}}, 10},
          {"ga", "real-ga, equal paths", "real-ga", {{"iterations", "40"}}, 50},
          {"ga-x10", "real-ga, paths x10", "real-ga", {{"iterations", "400"}}, 50},
          {"ga-1000", "real-ga, 1000 generations", "real-ga", {{"iterations", "1000"}}, 50}};
}

polygon::Params parameters_of(const CrossingContender& contender, std::uint64_t seed) {
  auto parameters = polygon::defaults(contender.algorithm);
  for (const auto& [name, value] : contender.settings)
    polygon::set_parameter(parameters, name, value);
  parameters.seed = seed;
  return parameters;
}

CrossingTrial run_trial(const polygon::Planner& planner, const CrossingContender& contender,
                        std::uint64_t seed, const std::stop_token& stop) {
  auto parameters = parameters_of(contender, seed);
  const polygon::Request request{.start = {}, .goal = {}, .stop = {.token = stop}};
  const auto timed = [&] {
    const auto begin = Clock::now();
    auto result = planner.plan(request, parameters);
    return std::pair{std::chrono::duration<double>(Clock::now() - begin).count(),
                     std::move(result)};
  };
  const auto [seconds, result] = timed();
  parameters.iterations = 0;
  const double rest = timed().first;  // graph search and optima
  CrossingTrial trial{.seed = seed,
                      .length = result.length,
                      .limit = contender.algorithm == "real-ga" ? result.sequence_optimum->length
                                                                : result.discrete_optimum->length,
                      .iterations = result.iterations,
                      .seconds = std::max(0.0, seconds - rest),
                      .best = result.best};
  const auto settled = std::ranges::find_if(
      result.best, [limit = result.length * (1 + 1e-12)](double best) { return best <= limit; });
  trial.converged = static_cast<int>(settled - result.best.begin()) + 1;
  return trial;
}

std::vector<double> values_of(const CrossingSample& sample, double (*value)(const CrossingTrial&)) {
  std::vector<double> list;
  for (const auto& trial : sample.trials) list.push_back(value(trial));
  return list;
}
Summary lengths(const CrossingSample& sample) {
  return summarise(values_of(sample, [](const CrossingTrial& t) { return t.length; }));
}
double mean_of(const CrossingSample& sample, double (*value)(const CrossingTrial&)) {
  return summarise(values_of(sample, value)).mean;
}
int at_limit(const CrossingSample& sample) {
  return static_cast<int>(std::ranges::count_if(
      sample.trials, [](const CrossingTrial& t) { return t.length <= t.limit * (1 + 1e-9); }));
}
double limit_of(const CrossingSample& sample) { return sample.trials.front().limit; }
double milliseconds_an_iteration(const CrossingSample& sample) {
  return 1e3 * mean_of(sample, [](const CrossingTrial& t) {
           return t.seconds / std::max(1, t.iterations);
         });
}
double seconds_to_converge(const CrossingSample& sample) {
  return mean_of(sample, [](const CrossingTrial& t) {
    return t.seconds * t.converged / std::max(1, t.iterations);
  });
}
double iterations_to_converge(const CrossingSample& sample) {
  return mean_of(sample, [](const CrossingTrial& t) { return double(t.converged); });
}

const CrossingSample& find(const MaklinkStudy& study, std::string_view name) {
  return *std::ranges::find_if(study.samples,
                               [&](const CrossingSample& s) { return s.contender.name == name; });
}

Table path_table(const MaklinkStudy& study) {
  Table table{{"path", "paper, m", "ours, m", "above the world's optimum, %"}, {}};
  const auto row = [&](const std::string& what, const char* paper, double length) {
    table.rows.push_back(
        {what, paper, fixed(length, 3), fixed(100 * (length / study.optimum - 1), 3)});
  };
  const auto& coarse = find(study, "acs-11");
  const auto& fine = find(study, "acs-21");
  row("Dijkstra, through midpoints", "507.692", study.dijkstra);
  row("ants, 11 values, best", "440.233", lengths(coarse).least);
  row("ants, 21 values, best", "439.372", lengths(fine).least);
  row("optimum of these lines, 11 values", "-", limit_of(coarse));
  row("optimum of these lines, 21 values", "-", limit_of(fine));
  row("optimum of these lines, any points", "-", study.sequence_optimum);
  row("optimum of the world", "-", study.optimum);
  return table;
}

Table cost_table(const MaklinkStudy& study) {
  Table table{{"algorithm", "paper: ms an iteration", "ms an iteration", "paper: iterations",
               "iterations to converge", "paper: s to the optimum", "s to converge"},
              {}};
  for (const auto& sample : study.samples) {
    const std::string& name = sample.contender.name;
    const bool ants = name == "acs-11", genes = name == "ga-1000";
    table.rows.push_back({sample.contender.label,
                          ants    ? "0.59"
                          : genes ? "0.67"
                                  : "-",
                          fixed(milliseconds_an_iteration(sample), 4),
                          ants    ? "175"
                          : genes ? "912"
                                  : "-",
                          fixed(iterations_to_converge(sample), 1),
                          ants    ? "0.1033"
                          : genes ? "0.6110"
                                  : "-",
                          seconds_text(seconds_to_converge(sample))});
  }
  return table;
}

Table spread_table(const MaklinkStudy& study) {
  Table table{{"algorithm", "paths", "best", "mean", "worst", "sd", "95% interval of the mean",
               "own limit", "runs at it", "gap of the mean to the world's optimum, %"},
              {}};
  for (const auto& sample : study.samples) {
    const Summary s = lengths(sample);
    const auto interval =
        mean_interval(values_of(sample, [](const CrossingTrial& t) { return t.length; }));
    table.rows.push_back({sample.contender.label,
                          std::to_string(sample.contender.paths * sample.trials.front().iterations),
                          fixed(s.least, 3), fixed(s.mean, 3), fixed(s.most, 3), fixed(s.sd, 4),
                          fixed(interval.low, 3) + " .. " + fixed(interval.high, 3),
                          fixed(limit_of(sample), 3),
                          std::to_string(at_limit(sample)) + " of " + std::to_string(s.count),
                          fixed(100 * (s.mean / study.optimum - 1), 3)});
  }
  return table;
}

/// The first iteration after which the deviation stays below a length; 0 where it never does.
int falls_below(const CrossingSample& sample, double length) {
  const auto by_iteration = deviation(sample);
  int last = static_cast<int>(by_iteration.size());
  while (last > 0 && by_iteration[last - 1] < length) --last;
  return last == static_cast<int>(by_iteration.size()) ? 0 : last + 1;
}

std::string when(int iteration) {
  return iteration > 0 ? "after " + std::to_string(iteration) + " iterations" : "never";
}

std::string claims(const MaklinkStudy& study) {
  const auto& ants = find(study, "acs-11");
  const auto& fine = find(study, "acs-21");
  const auto& control = find(study, "control");
  const auto& equal = find(study, "ga");
  const auto& tenfold = find(study, "ga-x10");
  const auto& long_run = find(study, "ga-1000");
  std::string text;
  const auto claim = [&](const std::string& what, bool holds, const std::string& figures) {
    text += "* " + what + " **" + (holds ? "Confirmed" : "Not confirmed") + "**: " + figures + "\n";
  };
  const auto sd = [](const CrossingSample& s) { return fixed(lengths(s).sd, 4); };
  claim("Ants shorten Dijkstra's path (by 13.3% in the source).",
        lengths(ants).most < study.dijkstra,
        "by " + fixed(100 * (1 - lengths(ants).mean / study.dijkstra), 1) + "% on average.");
  claim("A finer discretisation shortens it a little more.",
        lengths(fine).mean < lengths(ants).mean,
        fixed(lengths(ants).mean, 3) + " with 11 values, " + fixed(lengths(fine).mean, 3) +
            " with 21.");
  claim("The ants' results vary less than the genetic algorithm's.",
        lengths(ants).sd < std::min(lengths(tenfold).sd, lengths(equal).sd),
        "standard deviation " + sd(ants) + " m, against " + sd(equal) + " with equal paths and " +
            sd(tenfold) + " with ten times as many.");
  const int ants_fall = falls_below(ants, 0.5), genes_fall = falls_below(long_run, 0.5);
  claim("Their standard deviation falls sooner.",
        ants_fall > 0 && (genes_fall == 0 || ants_fall * 10 < genes_fall * 50),
        "below 0.5 m for good: ants " + when(ants_fall) + " of 10 paths, real-ga " +
            when(genes_fall) + " of 50.");
  claim("The ants are the faster ones.", seconds_to_converge(ants) < seconds_to_converge(long_run),
        seconds_text(seconds_to_converge(ants)) + " s to converge, against " +
            seconds_text(seconds_to_converge(long_run)) + " s in 1000 generations.");
  claim(
      "Pheromone helps at all (our control).", lengths(ants).mean < lengths(control).mean,
      fixed(lengths(ants).mean, 3) + " with it, " + fixed(lengths(control).mean, 3) + " without.");
  claim(
      "Given ten times the paths, the genetic algorithm finds the shorter path: its points are "
      "not bound to a grid (our control).",
      lengths(tenfold).mean < lengths(ants).mean,
      fixed(lengths(tenfold).mean, 3) + " against " + fixed(lengths(ants).mean, 3) + "; after " +
          "1000 generations " + fixed(lengths(long_run).mean, 3) + ".");
  return text;
}

}  // namespace

std::optional<MaklinkStudy> run_maklink(const std::filesystem::path& maps, int trials,
                                        const std::stop_token& stop,
                                        const std::function<void(int, int)>& progress) {
  MaklinkStudy study{.world = (maps / kWorld).string(), .trials = trials, .samples = {}};
  const polygon::Planner planner(polygon::read_world(study.world));
  const auto exact = planner.plan();
  study.optimum = exact.length;
  study.lines = static_cast<int>(planner.maklink().lines.size());
  const auto first = planner.plan({}, polygon::defaults("maklink-acs"));
  study.dijkstra = first.dijkstra->length;
  study.crossed = static_cast<int>(first.crossing.lines.size());
  study.sequence_optimum = first.sequence_optimum->length;
  for (auto& contender : contenders()) study.samples.push_back({std::move(contender), {}});
  const int all = trials * static_cast<int>(study.samples.size());
  int done = 0;
  for (int i = 0; i < trials; ++i) {
    for (auto& sample : study.samples) {
      sample.trials.push_back(
          run_trial(planner, sample.contender, static_cast<std::uint64_t>(i) + 1, stop));
      if (stop.stop_requested()) return std::nullopt;
      progress(++done, all);
    }
  }
  return study;
}

std::string maklink_page(const MaklinkStudy& study,
                         const std::vector<std::pair<std::string, std::string>>& pictures) {
  std::string page =
      "# Study: maklink-acs\n\nSource: lecture on ant algorithms for robot path planning, hybrid "
      "part: MAKLINK lines, Dijkstra's path through their midpoints, ant colony system over the "
      "crossing points, against a real-coded genetic algorithm.\n\nThe source's world is lost. "
      "Ours, " +
      std::filesystem::path(study.world).filename().string() +
      ", has its size, 200 m x 200 m: " + std::to_string(study.lines) +
      " free lines (the source: 26), of which Dijkstra's path crosses " +
      std::to_string(study.crossed) +
      " (9). It was chosen among random ones for the length of "
      "that path and for these numbers, before any comparison was made. " +
      std::to_string(study.trials) + " trials of each, seeds 1 to " + std::to_string(study.trials) +
      "; the source made 100. Times are processor-dependent; all else is not.\n\nThe source's "
      "genetic algorithm has a crossover constant whose value is lost: ours is 0.3, and children "
      "and parents compete. Ants end after ten iterations in a row on one way, not at the first: "
      "with q0 = 0.85 they agree by chance.\n\n## Paths\n\n";
  page += path_table(study).markdown() + "\n## Cost\n\n" + cost_table(study).markdown() +
          "\nTo converge: until the best path of the run was found.\n\n## Spread\n\nThe own limit "
          "is the optimum of the lines and values for ants, of the lines for the genetic "
          "algorithm.\n\n" +
          spread_table(study).markdown() + "\n## Claims\n\n" + claims(study);
  for (const auto& [file, caption] : pictures)
    page += "\n![" + caption + "](" + file + ")\n\n" + caption + "\n";
  return page;
}

Table maklink_runs(const MaklinkStudy& study) {
  Table table{{"contender", "seed", "length", "own_limit", "iterations", "converged", "seconds"},
              {}};
  for (const auto& sample : study.samples) {
    for (const auto& t : sample.trials)
      table.rows.push_back({sample.contender.name, std::to_string(t.seed), tool::to_text(t.length),
                            tool::to_text(t.limit), std::to_string(t.iterations),
                            std::to_string(t.converged), tool::to_text(t.seconds)});
  }
  return table;
}

std::vector<double> deviation(const CrossingSample& sample) {
  std::size_t longest = 0;
  for (const auto& trial : sample.trials) longest = std::max(longest, trial.best.size());
  std::vector<double> result;
  for (std::size_t q = 0; q < longest; ++q) {
    std::vector<double> lengths;
    for (const auto& trial : sample.trials)  // a run that ended keeps its path
      lengths.push_back(trial.best[std::min(q, trial.best.size() - 1)]);
    result.push_back(summarise(lengths).sd);
  }
  return result;
}

}  // namespace lasius::study
