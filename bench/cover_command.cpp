// lasius_bench cover: tours that cover maps, against the same swaths in the textbook's order.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "bench/clocks.h"
#include "bench/commands.h"
#include "bench/query_set.h"
#include "bench/report.h"
#include "lasius/tour/cover.h"

namespace lasius::bench {
namespace {

struct CoverBenchOptions {
  MapOptions maps = {};
  double width = 8, radius = 0;
  int generations = 20;
};

/// A swath on the line that is `c` beside the origin, from and to along it.
struct SwathLine {
  int swath;
  double c, from, to;
};

std::vector<SwathLine> lines_of(const CoverResult& cover) {
  constexpr double kRadians = 3.14159265358979323846 / 180;
  const double x = std::cos(cover.angle * kRadians), y = std::sin(cover.angle * kRadians);
  std::vector<SwathLine> lines;
  for (int i = 0; i < cover.swaths(); ++i) {
    const Point a = cover.stops[2 * i], b = cover.stops[2 * i + 1];
    const double ta = a.x * x + a.y * y, tb = b.x * x + b.y * y;
    lines.push_back(
        {i, (a.y + b.y) / 2 * x - (a.x + b.x) / 2 * y, std::min(ta, tb), std::max(ta, tb)});
  }
  std::sort(lines.begin(), lines.end(), [](const SwathLine& a, const SwathLine& b) {
    return a.c != b.c ? a.c < b.c : a.from < b.from;
  });
  return lines;
}

/// A cell is swaths on lines one after another, each beside one alone, which is beside it alone.
std::vector<std::vector<int>> cells_of(const std::vector<SwathLine>& lines) {
  const int n = static_cast<int>(lines.size());
  std::vector<int> next(lines.size(), -1), beside_next(lines.size(), 0),
      beside_last(lines.size(), 0);
  const auto beside = [&](int i, int j) {
    return lines[j].c > lines[i].c + 1e-6 && lines[j].from < lines[i].to &&
           lines[j].to > lines[i].from;
  };
  for (int i = 0; i < n; ++i) {
    double nearest = std::numeric_limits<double>::infinity();
    for (int j = i + 1; j < n && lines[j].c <= nearest + 1e-6; ++j) {
      if (!beside(i, j)) continue;
      nearest = std::min(nearest, lines[j].c);
      next[i] = j;
      ++beside_next[i];
      ++beside_last[j];
    }
  }
  std::vector<std::vector<int>> cells;
  std::vector<int> cell(lines.size(), -1);
  for (int i = 0; i < n; ++i) {
    if (cell[i] < 0) {
      cell[i] = static_cast<int>(cells.size());
      cells.emplace_back();
    }
    cells[cell[i]].push_back(lines[i].swath);
    if (beside_next[i] == 1 && beside_last[next[i]] == 1) cell[next[i]] = cell[i];
  }
  return cells;
}

/// Swaths line by line, cell by cell: the nearest end of a cell that is left comes next, by
/// straight lines; in a cell swaths go to and fro.
std::vector<int> to_and_fro(const CoverResult& cover) {
  std::vector<std::vector<int>> cells = cells_of(lines_of(cover));
  std::vector<int> order;
  Point at = cover.stops.front();
  const auto away = [&](int stop) {
    return std::hypot(cover.stops[stop].x - at.x, cover.stops[stop].y - at.y);
  };
  while (!cells.empty()) {
    std::size_t chosen = 0;
    bool turned = false;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < cells.size(); ++i)
      for (const bool back : {false, true}) {
        const int swath = back ? cells[i].back() : cells[i].front();
        const double way = std::min(away(2 * swath), away(2 * swath + 1));
        if (way < least) least = way, chosen = i, turned = back;
      }
    if (turned) std::reverse(cells[chosen].begin(), cells[chosen].end());
    for (const int swath : cells[chosen]) {
      const bool back = away(2 * swath + 1) < away(2 * swath);
      order.push_back(2 * swath + back);
      order.push_back(2 * swath + !back);
      at = cover.stops[order.back()];
    }
    cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(chosen));
  }
  return order;
}

double length_of(const Planner& planner, const std::vector<int>& order, const CoverResult& cover) {
  const Params exact("exact");
  Workspace workspace;
  double sum = 0;
  for (std::size_t i = 0; i < order.size(); ++i)
    sum += planner
               .plan({.start_point = cover.stops[order[i]],
                      .goal_point = cover.stops[order[(i + 1) % order.size()]]},
                     exact, {.workspace = &workspace})
               .length;
  return sum;
}

void run_cover(const CoverBenchOptions& options) {
  Table table(
      "Closed tours that cover maps; widths to cover at a time " + short_number(options.width) +
          " cells, radius " + short_number(options.radius) +
          ". \"area\": what can be covered over the width. Lengths in cells; one thread.",
      {"map", "swaths", "area", "swept", "length", "to and fro", "gap, %", "covered, %", "CPU s"});
  for (const QuerySource& source : sources_of(or_generated(options.maps, {256}))) {
    const QuerySet set = load(source, 1);
    const Planner planner(set.grid, Disc{options.radius});
    CoverRequest request;
    request.width = options.width;
    request.generations = options.generations;
    request.threads = 1;
    const ThreadStopwatch time;
    const CoverResult cover = plan_cover(planner, request);
    const double seconds = time.seconds();
    if (cover.tour.order.empty()) continue;
    const double area = static_cast<double>(set.grid.count_free()) * (1 - cover.unreachable);
    table.row(set.name, {static_cast<double>(cover.swaths()), area / options.width, cover.swept,
                         cover.tour.length, length_of(planner, to_and_fro(cover), cover),
                         cover.tour.gap() ? 100 * *cover.tour.gap() : kUnknown, 100 * cover.covered,
                         seconds});
  }
}

}  // namespace

void add_cover_command(CLI::App& app) {
  const auto [command, options] = add_command(
      app, "cover", "Tours that cover maps, against swaths taken to and fro", run_cover);
  add_map_options(command, options.maps);
  add_number(command, "--width", options.width, "To cover at a time, cells", 0.1, 1e4);
  add_number(command, "--radius", options.radius, "Of the tool, cells", 0, 54);
  add_number(command, "--generations", options.generations, "Of the search for the order", 0,
             1'000'000);
}

}  // namespace lasius::bench
