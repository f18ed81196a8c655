// lasius_bench labels: answers read off hub labels, against searches on the same queries.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "bench/clocks.h"
#include "bench/commands.h"
#include "bench/query_set.h"
#include "bench/report.h"
#include "core/base/special_values.h"
#include "core/exact/exact.h"
#include "core/exact/labels/label_search.h"
#include "core/exact/prepared_search.h"
#include "lasius/path.h"

namespace lasius::bench {
namespace {

struct LabelOptions : QueryOptions {
  LabelOptions() : QueryOptions{.count = 2000, .rounds = 5} {}
  int threads = 1;
  std::string markdown;
};

// Microseconds a query of each, the least of some rounds in turn; lengths that differ.
struct LabelTimes {
  double labels = kInfinity, checked = kInfinity, graph = kInfinity, plain = kInfinity;
  int wrong = 0;
};

LabelTimes measure_answers(const QuerySet& set, const exact::CornerGraph& graph,
                           const exact::CornerLabels& labels, int rounds) {
  exact::LabelSearch by_labels;
  exact::PreparedSearch by_graph;
  ExactSearch plain;
  ExactAnswer answer, expected;
  LabelTimes times;
  const auto ask = [&](const Query& query) {
    return by_labels.search(set.grid, graph, labels, centre(query.start), centre(query.goal), {},
                            {}, answer);
  };
  for (const Query& query : set.queries) {
    plain.search(set.grid, query.start, query.goal, {}, {}, expected);
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
    least(times.graph, [&](const Query& query) {
      by_graph.search(set.grid, graph, query.start, query.goal, {}, {}, expected);
    });
    least(times.plain, [&](const Query& query) {
      plain.search(set.grid, query.start, query.goal, {}, {}, expected);
    });
  }
  return times;
}

void run_labels(const LabelOptions& options) {
  Table table("Hub labels on " + std::to_string(options.count) +
                  " queries a map at most: processor time of one thread, the least of " +
                  std::to_string(options.rounds) + " rounds in turn; preparation by " +
                  std::to_string(options.threads) + " threads, processor time.",
              {"map", "labels, us", "path checked, us", "graph / labels", "exact / labels",
               "lengths that differ", "entries a corner", "labels, MB", "graph, MB", "graph, s",
               "labels, s"},
              options.markdown);
  double labelled = 0, checked = 0, graphs = 0, plain = 0, worst = 0;
  int maps = 0;
  for (const QuerySource& source : sources_of(options.maps, {options.markdown})) {
    const QuerySet set = load(source, options.count);
    PrepareOptions how{.threads = options.threads, .labels = true};
    Preparation report;
    ProcessorStopwatch watch;
    const auto graph = exact::CornerGraph::make(set.grid, how, report);
    const double graph_seconds = watch.seconds();
    if (graph == nullptr) continue;
    watch = {};
    const auto labels = exact::CornerLabels::make(set.grid, *graph, how, report.labels);
    const double seconds = watch.seconds();
    if (labels == nullptr) {
      table.row(set.name, {kNaN, kNaN, kNaN, kNaN, kNaN, kNaN, kNaN,
                           1e-6 * static_cast<double>(graph->bytes()), graph_seconds, seconds});
      continue;
    }
    const LabelTimes times = measure_answers(set, *graph, *labels, options.rounds);
    table.row(set.name,
              {times.labels, times.checked, times.graph / times.labels, times.plain / times.labels,
               1.0 * times.wrong, static_cast<double>(labels->entry_count()) / graph->size(),
               1e-6 * static_cast<double>(labels->bytes()),
               1e-6 * static_cast<double>(graph->bytes()), graph_seconds, seconds});
    labelled += std::log(times.labels);
    checked += std::log(times.checked);
    graphs += std::log(times.graph);
    plain += std::log(times.plain);
    worst = std::max(worst, times.checked);
    ++maps;
  }
  const auto mean = [&](double logarithms) { return short_number(std::exp(logarithms / maps)); };
  table.close(std::to_string(maps) + " maps with labels, geometric means: " + mean(labelled) +
              " us, path checked " + mean(checked) + " us (worst " + short_number(worst) +
              "); graph / labels " + mean(graphs - labelled) + ", exact / labels " +
              mean(plain - labelled) + ".\n");
}

}  // namespace

void add_labels_command(CLI::App& app) {
  const auto [command, options] =
      add_command(app, "labels", "Answers by hub labels, against the searches", run_labels);
  add_query_options(command, options);
  command.add_option("--threads", options.threads, "To prepare with")->check(CLI::Range(1, 1024));
  add_output(command, options.markdown);
}

}  // namespace lasius::bench
