#include "tools/study/sources/maklink.h"

#include <algorithm>
#include <cmath>

#include "tools/console/values.h"
#include "tools/draw/text.h"
#include "tools/study/statistics.h"

namespace lasius::study {
namespace {

constexpr const char* kGenes = "real-ga";

std::vector<double> values_of(const Sample& sample, double (*value)(const Run&)) {
  std::vector<double> list;
  for (const Run& run : sample.runs) list.push_back(value(run));
  return list;
}
Summary lengths(const Sample& sample) {
  return summarise(values_of(sample, [](const Run& t) { return t.length; }));
}
double mean_of(const Sample& sample, double (*value)(const Run&)) {
  return summarise(values_of(sample, value)).mean;
}
int at_limit(const Sample& sample) {
  return static_cast<int>(std::ranges::count_if(
      sample.runs, [](const Run& t) { return t.length <= t.limit * (1 + 1e-9); }));
}
double limit_of(const Sample& sample) { return sample.runs.front().limit; }
double milliseconds_an_iteration(const Sample& sample) {
  return 1e3 * mean_of(sample, [](const Run& t) { return t.seconds / std::max(1, t.iterations); });
}
double seconds_to_converge(const Sample& sample) {
  return mean_of(
      sample, [](const Run& t) { return t.seconds * t.converged() / std::max(1, t.iterations); });
}
double iterations_to_converge(const Sample& sample) {
  return mean_of(sample, [](const Run& t) { return double(t.converged()); });
}

const Sample& find(const Findings& findings, std::string_view name) {
  return *findings.of("trials", name).front();
}

Table path_table(const Findings& findings, const MaklinkWorld::Figures& world) {
  Table table{{"path", "paper, m", "ours, m", "above the world's optimum, %"}, {}};
  const auto row = [&](const std::string& what, const char* paper, double length) {
    table.rows.push_back(
        {what, paper, fixed(length, 3), fixed(100 * (length / world.optimum - 1), 3)});
  };
  const auto& coarse = find(findings, "acs-11");
  const auto& fine = find(findings, "acs-21");
  row("Dijkstra, through midpoints", "507.692", world.dijkstra);
  row("ants, 11 values, best", "440.233", lengths(coarse).least);
  row("ants, 21 values, best", "439.372", lengths(fine).least);
  row("optimum of these lines, 11 values", "-", limit_of(coarse));
  row("optimum of these lines, 21 values", "-", limit_of(fine));
  row("optimum of these lines, any points", "-", world.sequence_optimum);
  row("optimum of the world", "-", world.optimum);
  return table;
}

Table cost_table(const Findings& findings) {
  Table table{{"algorithm", "paper: ms an iteration", "ms an iteration", "paper: iterations",
               "iterations to converge", "paper: s to the optimum", "s to converge"},
              {}};
  for (const auto& sample : findings.samples) {
    const std::string& name = sample.contender->name;
    const bool ants = name == "acs-11", genes = name == "ga-1000";
    table.rows.push_back({sample.contender->label,
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

Table spread_table(const Findings& findings, double optimum) {
  Table table{{"algorithm", "paths", "best", "mean", "worst", "sd", "95% interval of the mean",
               "own limit", "runs at it", "gap of the mean to the world's optimum, %"},
              {}};
  for (const auto& sample : findings.samples) {
    const Summary s = lengths(sample);
    const auto interval = mean_interval(values_of(sample, [](const Run& t) { return t.length; }));
    table.rows.push_back(
        {sample.contender->label,
         std::to_string(sample.paths_an_iteration * sample.runs.front().iterations),
         fixed(s.least, 3), fixed(s.mean, 3), fixed(s.most, 3), fixed(s.sd, 4),
         fixed(interval.low, 3) + " .. " + fixed(interval.high, 3), fixed(limit_of(sample), 3),
         std::to_string(at_limit(sample)) + " of " + std::to_string(s.count),
         fixed(100 * (s.mean / optimum - 1), 3)});
  }
  return table;
}

/// The first iteration after which the deviation stays below a length; 0 where it never does.
int falls_below(const Sample& sample, double length) {
  const auto by_iteration = deviation(sample);
  int last = static_cast<int>(by_iteration.size());
  while (last > 0 && by_iteration[last - 1] < length) --last;
  return last == static_cast<int>(by_iteration.size()) ? 0 : last + 1;
}

std::string when(int iteration) {
  return iteration > 0 ? "after " + std::to_string(iteration) + " iterations" : "never";
}

std::string claims(const Findings& findings, double dijkstra) {
  const auto& ants = find(findings, "acs-11");
  const auto& fine = find(findings, "acs-21");
  const auto& control = find(findings, "control");
  const auto& equal = find(findings, "ga");
  const auto& tenfold = find(findings, "ga-x10");
  const auto& long_run = find(findings, "ga-1000");
  std::string text;
  const auto claim = [&](const std::string& what, bool holds, const std::string& figures) {
    text += "* " + what + " **" + (holds ? "Confirmed" : "Not confirmed") + "**: " + figures + "\n";
  };
  const auto sd = [](const Sample& s) { return fixed(lengths(s).sd, 4); };
  claim("Ants shorten Dijkstra's path (by 13.3% in the source).", lengths(ants).most < dijkstra,
        "by " + fixed(100 * (1 - lengths(ants).mean / dijkstra), 1) + "% on average.");
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

MaklinkWorld::MaklinkWorld(const Study& study, const std::filesystem::path& maps)
    : file_((maps / study.experiments.front().questions.front().map).string()),
      planner_(polygon::read_world(file_)) {
  const auto first = planner_.plan({}, polygon::Params("maklink-acs"));
  figures_ = {.lines = static_cast<int>(planner_.maklink().lines.size()),
              .crossed = static_cast<int>(first.crossing.lines.size()),
              .dijkstra = first.dijkstra->length,
              .sequence_optimum = first.sequence_optimum->length,
              .optimum = planner_.plan().length};
}

Task MaklinkWorld::task(const Question& question, const Contender& contender) const {
  const auto params = configured(polygon::Params(contender.algorithm), contender);
  // Of the two sizes a search has one.
  Task task = task_of(question.map + ' ' + contender.algorithm, params,
                      parameters_of(polygon::algorithms(), contender.algorithm), figures_.crossed);
  task.run = [this, params](std::uint64_t seed, const std::stop_token& stop, Workspace&) {
    auto seeded = params;
    seeded.seed = seed;
    const auto timed = [&] {
      const double begin = thread_seconds();
      auto result = planner_.plan({.start = {}, .goal = {}, .stop = {.token = stop}}, seeded);
      return std::pair{thread_seconds() - begin, std::move(result)};
    };
    const auto [seconds, result] = timed();
    seeded.iterations = 0;
    const double rest = timed().first;  // graph search and optima
    return Run{.status = result.status,
               .length = result.length,
               .iterations = result.iterations,
               .seconds = std::max(0.0, seconds - rest),
               .best = result.best,
               .limit = params.algorithm() == kGenes ? result.sequence_optimum->length
                                                     : result.discrete_optimum->length};
  };
  return task;
}

std::string maklink_page(const Study& study, const Findings& findings, const MaklinkWorld& world,
                         const std::vector<std::pair<std::string, std::string>>& pictures) {
  const auto& figures = world.figures();
  const std::string trials = std::to_string(findings.samples.front().runs.size());
  std::string page =
      "# Study: maklink-acs\n\nSource: " + study.source + "\n\nThe source's world is lost. Ours, " +
      std::filesystem::path(world.file()).filename().string() +
      ", has its size, 200 m x 200 m: " + std::to_string(figures.lines) +
      " free lines (the source: 26), of which Dijkstra's path crosses " +
      std::to_string(figures.crossed) +
      " (9). It was chosen among random ones for the length of that path and for these numbers, "
      "before any comparison was made. " +
      trials + " trials of each, seeds 1 to " + trials +
      "; the source made 100. Times are processor-dependent; all else is not.\n\n" + study.text +
      "\n\n## Paths\n\n";
  page += path_table(findings, figures).markdown() + "\n## Cost\n\n" +
          cost_table(findings).markdown() +
          "\nTo converge: until the best path of the run was found.\n\n## Spread\n\nThe own limit "
          "is the optimum of the lines and values for ants, of the lines for the genetic "
          "algorithm.\n\n" +
          spread_table(findings, figures.optimum).markdown() + "\n## Claims\n\n" +
          claims(findings, figures.dijkstra);
  for (const auto& [file, caption] : pictures)
    page += "\n![" + caption + "](" + file + ")\n\n" + caption + "\n";
  return page;
}

Table maklink_runs(const Findings& findings) {
  Table table{{"contender", "seed", "length", "own_limit", "iterations", "converged", "seconds"},
              {}};
  for (const auto& sample : findings.samples) {
    for (const auto& t : sample.runs)
      table.rows.push_back({sample.contender->name, std::to_string(t.seed), tool::to_text(t.length),
                            tool::to_text(t.limit), std::to_string(t.iterations),
                            std::to_string(t.converged()), tool::to_text(t.seconds)});
  }
  return table;
}

std::vector<double> deviation(const Sample& sample) {
  std::size_t longest = 0;
  for (const Run& trial : sample.runs) longest = std::max(longest, trial.best.size());
  std::vector<double> result;
  for (std::size_t q = 0; q < longest; ++q) {
    std::vector<double> lengths;
    for (const Run& trial : sample.runs)  // a run that ended keeps its path
      lengths.push_back(trial.best[std::min(q, trial.best.size() - 1)]);
    result.push_back(summarise(lengths).sd);
  }
  return result;
}

}  // namespace lasius::study
