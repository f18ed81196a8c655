// lasius_bench labels: answers read off hub labels, against searches on the same queries.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "bench/clocks.h"
#include "bench/commands.h"
#include "bench/query_set.h"
#include "bench/report.h"
#include "bench/statistics.h"
#include "core/base/special_values.h"
#include "core/exact/exact.h"
#include "core/exact/labels/label_search.h"
#include "core/exact/prepared_search.h"
#include "lasius/path/path.h"
#include "lasius/plan/planner.h"

namespace lasius::bench {
namespace {

struct LabelOptions : QueryOptions, Reported {
  LabelOptions() : QueryOptions{.count = 2000, .rounds = 5} {}
  int threads = 1;
};

// Microseconds a query of each, the least of some rounds in turn; lengths that differ.
struct LabelTimes {
  double labels = kInfinity, checked = kInfinity, plan = kInfinity, graph = kInfinity,
         plain = kInfinity;
  int wrong = 0;
};

LabelTimes measure_answers(const QuerySet& set, const exact::CornerGraph& graph,
                           const exact::CornerLabels& labels, int rounds) {
  exact::LabelSearch by_labels;
  exact::PreparedSearch by_graph;
  ExactSearch plain;
  ExactAnswer answer, expected;
  const Planner planner(set.grid, PrepareOptions{.threads = 1, .labels = true});
  Workspace workspace;
  LabelTimes times;
  const auto ask = [&](const Query& query) {
    return by_labels.search(set.grid, graph, labels, centre(query.start), centre(query.goal), {},
                            {}, answer);
  };
  for (const Query& query : set.queries) {
    plain.search(set.grid, centre(query.start), centre(query.goal), {}, {}, expected);
    const bool found = ask(query);
    const bool equal =
        found && std::abs(answer.length - expected.length) <= exact::kRounding * expected.length;
    times.wrong += found != !expected.path.empty() || (found && !equal) ||
                   (found && path_fault(set.grid, answer.path));
  }
  const auto least = [&](double& time, const auto& call) {
    for (const Query& query : set.queries) call(query);  // what the others left in the caches goes
    const ThreadStopwatch watch;
    for (const Query& query : set.queries) call(query);
    time = std::min(time, 1e6 * watch.seconds() / static_cast<double>(set.queries.size()));
  };
  for (int round = 0; round < rounds; ++round) {
    least(times.labels, [&](const Query& query) { ask(query); });
    least(times.checked, [&](const Query& query) {
      if (ask(query) && path_fault(set.grid, answer.path)) ++times.wrong;
    });
    least(times.plan, [&](const Query& query) {
      planner.plan({query.start, query.goal}, {}, {.workspace = &workspace});
    });
    least(times.graph, [&](const Query& query) {
      by_graph.search(set.grid, graph, centre(query.start), centre(query.goal), {}, {}, expected);
    });
    least(times.plain, [&](const Query& query) {
      plain.search(set.grid, centre(query.start), centre(query.goal), {}, {}, expected);
    });
  }
  return times;
}

// Graph and labels of a map, and the seconds that they took.
struct MadeLabels {
  std::shared_ptr<const exact::CornerGraph> graph;
  std::shared_ptr<const exact::CornerLabels> labels;
  double graph_seconds = 0, label_seconds = 0;  // of processor time
  double wall = 0;

  double processor() const { return graph_seconds + label_seconds; }
};

MadeLabels make_labels(const Grid& grid, int threads) {
  const PrepareOptions how{.threads = threads, .labels = true};
  Preparation report;
  MadeLabels made;
  const Stopwatch wall;
  ProcessorStopwatch watch;
  made.graph = exact::CornerGraph::make(grid, how, report);
  made.graph_seconds = watch.seconds();
  if (made.graph == nullptr) return made;
  watch = {};
  made.labels = exact::CornerLabels::make(grid, *made.graph, how, report.labels);
  made.label_seconds = watch.seconds();
  made.wall = wall.seconds();
  return made;
}

// What more threads do to preparation: wall clock with one over that with all, and processor time
// with all over that with one, each the least of some rounds in turn.
std::pair<double, double> compare_preparation(const Grid& grid, int threads, int rounds) {
  struct LeastTimes {
    double wall = kInfinity, processor = kInfinity;
    void add(const MadeLabels& made) {
      wall = std::min(wall, made.wall);
      processor = std::min(processor, made.processor());
    }
  } one, all;
  for (int round = 0; round < rounds; ++round) {
    one.add(make_labels(grid, 1));
    all.add(make_labels(grid, threads));
  }
  return {one.wall / all.wall, all.processor / one.processor};
}

void run_labels(const LabelOptions& options) {
  Table table("Hub labels on " + std::to_string(options.count) +
                  " queries a map at most: processor time of one thread, the least of " +
                  std::to_string(options.rounds) + " rounds in turn; preparation by " +
                  std::to_string(options.threads) + " threads, processor time.",
              {"map", "labels, us", "path checked, us", "whole plan, us", "graph / labels",
               "exact / labels", "lengths that differ", "entries a corner", "labels, MB",
               "graph, MB", "graph, s", "labels, s", "preparation, time with 1 / all threads",
               "processor time, all / 1"},
              options.markdown);
  GeometricMean labelled, checked, plans, graphs, plain;
  double worst = 0;
  for (const QuerySource& source : sources_of(options.maps, {options.markdown})) {
    const QuerySet set = load(source, options.count);
    const MadeLabels made = make_labels(set.grid, options.threads);
    if (made.graph == nullptr) continue;
    const double graph_megabytes = 1e-6 * static_cast<double>(made.graph->bytes());
    if (made.labels == nullptr) {
      table.row(set.name, {kNaN, kNaN, kNaN, kNaN, kNaN, kNaN, kNaN, kNaN, graph_megabytes,
                           made.graph_seconds, made.label_seconds, kNaN, kNaN});
      continue;
    }
    const LabelTimes times = measure_answers(set, *made.graph, *made.labels, options.rounds);
    const auto [gain, cost] = options.threads > 1
                                  ? compare_preparation(set.grid, options.threads, options.rounds)
                                  : std::pair(kNaN, kNaN);
    table.row(set.name, {times.labels, times.checked, times.plan, times.graph / times.labels,
                         times.plain / times.labels, 1.0 * times.wrong,
                         static_cast<double>(made.labels->entry_count()) / made.graph->size(),
                         1e-6 * static_cast<double>(made.labels->bytes()), graph_megabytes,
                         made.graph_seconds, made.label_seconds, gain, cost});
    labelled.add(times.labels);
    checked.add(times.checked);
    plans.add(times.plan);
    graphs.add(times.graph / times.labels);
    plain.add(times.plain / times.labels);
    worst = std::max(worst, times.checked);
  }
  const auto mean = [](const GeometricMean& of) { return short_number(of.value()); };
  table.close(std::to_string(labelled.count()) +
              " maps with labels, geometric means: " + mean(labelled) + " us, path checked " +
              mean(checked) + " us (worst " + short_number(worst) + "), whole plan " + mean(plans) +
              " us; graph / labels " + mean(graphs) + ", exact / labels " + mean(plain) + ".\n");
}

}  // namespace

void add_labels_command(CLI::App& app) {
  const auto [command, options] =
      add_command(app, "labels", "Answers by hub labels, against the searches", run_labels);
  add_query_options(command, options);
  command.add_option("--threads", options.threads, "To prepare with")->check(CLI::Range(1, 1024));
}

}  // namespace lasius::bench
