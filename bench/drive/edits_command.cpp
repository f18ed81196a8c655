// lasius_bench edits: a map that changes, a few cells at a time, prepared or not.
#include <array>
#include <cmath>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include "bench/clocks.h"
#include "bench/commands.h"
#include "bench/query_set.h"
#include "bench/report.h"
#include "bench/statistics.h"
#include "core/exact/corner_graph.h"
#include "core/exact/prepared_search.h"
#include "lasius/navigator.h"

namespace lasius::bench {
namespace {

struct EditsOptions : QueryOptions {
  EditsOptions() : QueryOptions{.count = 100, .rounds = 5} {}
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

// Microseconds of processor time a query, mean; medians over the rounds, but for one to warm up.
double prepared_time(const QuerySet& set, const exact::CornerGraph& graph, int rounds,
                     std::vector<double>& lengths) {
  exact::PreparedSearch search;
  ExactAnswer answer;
  double sum = 0;
  lengths.clear();
  for (const Query& query : set.queries) {
    if (set.grid.blocked(query.start) || set.grid.blocked(query.goal)) continue;
    const auto plan = [&] {
      search.search(set.grid, graph, query.start, query.goal, {}, {}, answer);
    };
    plan();  // to warm up
    sum += median_microseconds(rounds, plan);
    lengths.push_back(answer.length);
  }
  return sum / static_cast<double>(lengths.size());
}

void measure_prepared(QuerySet set, const EditsOptions& options, Table& table) {
  Preparation report;
  const PrepareOptions prepare{.max_bytes = std::int64_t{4} << 30};
  const Stopwatch watch;
  const auto graph = exact::CornerGraph::make(set.grid, prepare, report);
  const double prepared = watch.seconds();
  const auto left_out = [&] {
    std::cerr << set.name << ": left out, " << to_string(report.state) << '\n';
  };
  if (graph == nullptr) return left_out();
  std::vector<double> lengths, fresh_lengths, times;
  const double before = prepared_time(set, *graph, options.rounds, lengths);
  std::mt19937_64 random(options.maps.seed);
  for (int i = 0; i < options.edits; ++i) {
    const Rectangle part = edit(set.grid, options, random);
    const Stopwatch spent;
    graph->update(set.grid, part);
    times.push_back(spent.microseconds());
  }
  const auto fresh = exact::CornerGraph::make(set.grid, prepare, report);
  if (fresh == nullptr) return left_out();
  const double anew = prepared_time(set, *fresh, options.rounds, fresh_lengths);
  const double after = prepared_time(set, *graph, options.rounds, lengths);
  int differ = 0, landmarks = 0;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    differ += std::abs(lengths[i] - fresh_lengths[i]) > 1e-9 * fresh_lengths[i];
  }
  for (std::size_t i = 0; i < graph->landmarks().cells().size(); ++i) {
    landmarks += graph->landmarks().bounds(i);
  }
  std::vector<std::string> cells{set.name};
  for (const double figure :
       {prepared, median(times), quantile(times, 0.99), largest(times), before, anew, after})
    cells.push_back(short_number(figure));
  cells.push_back(std::to_string(landmarks));
  cells.push_back(std::to_string(differ + (graph->edge_count() != fresh->edge_count())));
  table.row(cells);
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
  Table table(what + "; " + std::to_string(options.count) +
                  " queries, median of rounds: " + std::to_string(options.rounds) + ".",
              {"map", "prepared, s", "edit, us, median", "99%", "most", "query, us, before",
               "on a fresh graph", "on the edited one", "landmarks left", "differences"});
  for (const QuerySource& source : sources_of(options.maps))
    measure_prepared(load(source, options.count), options, table);
}

}  // namespace

void add_edits_command(CLI::App& app) {
  const auto [command, options] = add_command(
      app, "edits", "A map that changes: edits, and queries on the prepared one", run_edits);
  add_query_options(command, options);
  add_number(command, "--edits", options.edits, "Edits of each map", 1);
  add_number(command, "--cells", options.cells, "Cells that an edit changes, at most", 1);
  command.add_flag("--unprepared", options.unprepared, "A Navigator's map that is not prepared");
  add_number(command, "--side", options.side, "Of the square that they are in", 1, 1000);
}

}  // namespace lasius::bench
