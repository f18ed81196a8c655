// lasius_bench edits: a map that changes, a few cells at a time, prepared or not.
#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "bench/clocks.h"
#include "bench/commands.h"
#include "bench/query_set.h"
#include "bench/report.h"
#include "bench/statistics.h"
#include "core/exact/corner_graph.h"
#include "core/exact/exact.h"
#include "core/exact/labels/corner_labels.h"
#include "core/exact/prepared_search.h"
#include "core/plan/stale_answers.h"
#include "lasius/drive/navigator.h"
#include "lasius/plan/planner.h"

namespace lasius::bench {
namespace {

struct EditsOptions : QueryOptions {
  EditsOptions() : QueryOptions{.count = 300, .rounds = 1} {}
  int edits = 1000;
  int cells = 10;
  int side = 5;
  bool unprepared = false;
};

// Blocks or frees cells of a square, so many of them as long as there are any.
Rectangle edit(Grid& grid, const EditsOptions& options, std::mt19937_64& random) {
  const int side = options.side;
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const Rectangle part{below(grid.width() - side + 1), below(grid.height() - side + 1), side, side};
  const bool blocked = random() % 2 == 0;
  for (int changed = 0, tries = 0; changed < options.cells && tries < 1000; ++tries) {
    const Cell cell{part.x + below(side), part.y + below(side)};
    if (grid.blocked(cell) == blocked) continue;
    grid.set_blocked(cell, blocked);
    ++changed;
  }
  return part;
}

// How answers by what was prepared before some edits fare.
struct Stale {
  int asked = 0, unchanged = 0, told = 0, told_of_unchanged = 0, wrong = 0;
  double stale_us = 0, exact_us = 0;  // sums
};

Stale ask_all(const QuerySet& set, const std::vector<double>& before, const Grid& now,
              const StaleAnswers& stale) {
  exact::LabelSearch labels;
  exact::PreparedSearch prepared;
  ExactSearch plain;
  ExactAnswer answer, right;
  Stale sum;
  for (std::size_t i = 0; i < set.queries.size(); ++i) {
    const auto& [start, goal, optimum] = set.queries[i];
    if (now.blocked(start) || now.blocked(goal) || std::isnan(before[i])) continue;
    const Point from = centre(start), to = centre(goal);
    bool told = false;
    sum.stale_us += median_microseconds(3, [&] {
      told = stale.search({labels, prepared}, now, from, to, {}, {}, answer);
    });
    sum.exact_us += median_microseconds(3, [&] { plain.search(now, from, to, {}, {}, right); });
    const double near = 1e-9 * right.length;
    const bool unchanged = std::abs(right.length - before[i]) <= near;
    ++sum.asked;
    sum.unchanged += unchanged;
    sum.told += told;
    sum.told_of_unchanged += told && unchanged;
    sum.wrong += told && !(std::abs(answer.length - right.length) <= near);
  }
  return sum;
}

void measure_prepared(const QuerySet& set, const EditsOptions& options, Table& table) {
  const PrepareOptions how{.threads = 1, .max_bytes = std::int64_t{4} << 30, .labels = true};
  const Planner planner = Planner(set.grid).prepared(how);
  Preparation report;
  std::shared_ptr<const exact::CornerGraph> graph = exact::CornerGraph::make(set.grid, how, report);
  const auto labels =
      graph == nullptr ? nullptr : exact::CornerLabels::make(set.grid, *graph, how, report.labels);
  if (labels == nullptr) {
    std::cerr << set.name << ": left out, without labels\n";
    return;
  }
  std::vector<double> before;
  ExactSearch search;
  ExactAnswer answer;
  for (const Query& query : set.queries) {
    search.search(set.grid, centre(query.start), centre(query.goal), {}, {}, answer);
    before.push_back(answer.length);
  }
  StaleAnswers stale(std::make_shared<const PreparedMap>(PreparedMap{set.grid, graph, labels}),
                     set.grid, {});
  std::mt19937_64 random(options.maps.seed);
  Grid now = set.grid;
  int done = 0;
  for (const int edits : {1, 10, 100}) {
    std::vector<Cell> changed;
    for (; done < edits; ++done) {
      const Rectangle part = edit(now, options, random);
      for (int y = part.y; y < part.y + part.height; ++y)
        for (int x = part.x; x < part.x + part.width; ++x) changed.push_back({x, y});
    }
    stale = StaleAnswers(stale, now, changed);
    std::vector<Planner::Edit> all;
    for (int y = 0; y < now.height(); ++y)
      for (int x = 0; x < now.width(); ++x)
        if (now.blocked({x, y}) != set.grid.blocked({x, y}))
          all.push_back({{x, y}, now.blocked({x, y})});
    const Planner edited = *planner.edited(all);
    ProcessorStopwatch watch;
    const Preparation again = edited.prepared(how).preparation();
    const double again_seconds = watch.seconds();
    watch = {};
    const Preparation anew = Planner(now).prepared(how).preparation();
    const double anew_seconds = watch.seconds();
    const Stale sum = ask_all(set, before, now, stale);
    table.row(
        set.name + ", " + std::to_string(edits),
        {100.0 * sum.unchanged / sum.asked, 100.0 * sum.told / sum.asked,
         100.0 * sum.told_of_unchanged / std::max(sum.unchanged, 1), 1.0 * sum.wrong,
         sum.stale_us / sum.asked, sum.exact_us / sum.asked, 1e3 * again_seconds,
         1e3 * anew_seconds,
         static_cast<double>(again.labels.entries) / static_cast<double>(anew.labels.entries)});
  }
}

/// Of a Navigator's map, not prepared, until it is known again what is joined to what.
void measure_unprepared(const QuerySet& set, const EditsOptions& options, Table& table) {
  const Query& query = set.queries.front();
  Navigator navigator(set.grid, query.goal);
  Grid grid = set.grid;
  std::mt19937_64 random(options.maps.seed);
  const std::int64_t before = navigator.bytes();
  std::vector<double> times;
  for (int i = 0; i < options.edits; ++i) {
    const Rectangle part = edit(grid, options, random);
    std::array<std::vector<Cell>, 2> cells;  // free, blocked
    for (int y = part.y; y < part.y + part.height; ++y) {
      for (int x = part.x; x < part.x + part.width; ++x) {
        cells[grid.blocked({x, y})].push_back({x, y});
      }
    }
    const ThreadStopwatch watch;
    navigator.observe(cells[0], false);
    navigator.observe(cells[1], true);
    (void)navigator.connected(query.start, query.goal);
    times.push_back(1e6 * watch.seconds());
  }
  table.row(set.name, {median(times), quantile(times, 0.99), largest(times),
                       static_cast<double>(navigator.bytes() - before) / options.edits});
}

void run_edits(const EditsOptions& options) {
  const std::string what = std::to_string(options.edits) + " edits of up to " +
                           std::to_string(options.cells) + " cells in a square of " +
                           std::to_string(options.side) + ", blocked or freed; " +
                           std::to_string(options.maps.seed) + " is the seed";
  if (options.unprepared) {
    Table table(what +
                    ". Microseconds of processor time until it is known what is joined to what; "
                    "bytes held more after each edit, mean.",
                {"map", "edit, us, median", "99%", "most", "bytes"});
    for (const QuerySource& source : sources_of(options.maps))
      measure_unprepared(load(source, 1), options, table);
    return;
  }
  Table table(what + ". Of " + std::to_string(options.count) +
                  " queries a map at most, after 1, 10 and 100 edits: whose optimum is unchanged; "
                  "which the labels made before answer, of all and of these; wrong answers; mean "
                  "microseconds of such a try, and of the ordinary search; all prepared again on "
                  "one thread, in the kept order and anew, milliseconds of processor time; "
                  "entries, kept / anew.",
              {"map, edits", "unchanged, %", "told, %", "of unchanged, %", "wrong", "stale, us",
               "exact, us", "again, ms", "anew, ms", "entries"});
  for (const QuerySource& source : sources_of(options.maps))
    measure_prepared(load(source, options.count), options, table);
}

}  // namespace

void add_edits_command(CLI::App& app) {
  const auto [command, options] = add_command(
      app, "edits", "A map that changes: edits, and queries on the prepared one", run_edits);
  add_query_options(command, options);
  add_number(command, "--edits", options.edits, "Edits of each map that is not prepared", 1);
  add_number(command, "--cells", options.cells, "Cells that an edit changes, at most", 1);
  command.add_flag("--unprepared", options.unprepared, "A Navigator's map that is not prepared");
  add_number(command, "--side", options.side, "Of the square that they are in", 1, 1000);
}

}  // namespace lasius::bench
