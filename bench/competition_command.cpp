// lasius_bench competition: the Grid-Based Path Planning Competition's any-angle track, as its
// start kit runs an entry.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/clocks.h"
#include "bench/commands.h"
#include "bench/competition/entry.h"
#include "bench/query_set.h"
#include "bench/report.h"
#include "bench/statistics.h"
#include "core/exact/exact.h"
#include "lasius/path/path.h"

namespace lasius::bench {
namespace {

struct CompetitionOptions : QueryOptions, Reported {
  CompetitionOptions() : QueryOptions{.count = 1000, .rounds = 1} {}
  bool unprepared = false;
};

/// The corner at which the competition begins and ends: the upper left one of a cell.
Point corner_of(Cell c) { return {1.0 * c.x, 1.0 * c.y}; }

/// Is a path one of the map, and as short as the ordinary search finds it?
bool is_right(const Grid& grid, ExactSearch& search, Point from, Point to,
              const std::vector<xyLoc>& path) {
  if (from == to) return path.empty();
  ExactAnswer answer;
  search.search(grid, from, to, {}, {}, answer);
  std::vector<Point> points;
  for (const xyLoc p : path) points.push_back({p.x, p.y});
  if (points.empty()) return answer.path.empty();
  return points.front() == from && points.back() == to && !path_fault(grid, points) &&
         std::abs(path_length(points) - answer.length) <= 1e-9 * answer.length;
}

void run_competition(const CompetitionOptions& options) {
  Table table(
      "The competition's any-angle track: scenarios between the upper left corners of "
      "cells, " +
          std::to_string(options.count) +
          " a map at most, each asked once; processor time of one thread.",
      {"map", "queries", "preparation, s", "file, MB", "loaded, ms", "query, us", "median", "99%",
       "most", "wrong"},
      options.markdown);
  double sum = 0, seconds = 0;
  std::size_t asked = 0;
  GeometricMean means;
  for (const QuerySource& source : sources_of(options.maps, {options.markdown})) {
    const QuerySet set = load(source, options.count);
    const int width = set.grid.width(), height = set.grid.height();
    std::vector<bool> bits;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) bits.push_back(set.grid.free({x, y}));
    namespace fs = std::filesystem;
    const fs::path file = fs::temp_directory_path() / ("lasius_competition_" + set.name);
    fs::remove(file);
    ThreadStopwatch watch;
    if (!options.unprepared) PreprocessMap(bits, width, height, file.string());
    const double preparation = watch.seconds();
    const bool kept = fs::exists(file);
    const double megabytes = kept ? 1e-6 * static_cast<double>(fs::file_size(file)) : 0;
    watch = {};
    void* const data = PrepareForSearch(bits, width, height, file.string());
    const double loaded = watch.seconds();
    fs::remove(file);
    std::vector<double> times;
    std::vector<xyLoc> path;
    ExactSearch search;
    int wrong = 0;
    for (const Query& query : set.queries) {
      const Point from = corner_of(query.start), to = corner_of(query.goal);
      const ThreadStopwatch spent;
      while (!GetPath(data, {from.x, from.y}, {to.x, to.y}, path)) {
      }
      times.push_back(1e6 * spent.seconds());
      wrong += !is_right(set.grid, search, from, to, path);
    }
    double total = 0;
    for (const double time : times) total += time;
    const double mean = total / static_cast<double>(times.size());
    table.row(set.name, {static_cast<double>(times.size()), preparation, megabytes, 1e3 * loaded,
                         mean, median(times), quantile(times, 0.99), largest(times), 1.0 * wrong});
    sum += total;
    asked += times.size();
    means.add(mean);
    seconds += preparation;
  }
  table.close(
      std::to_string(means.count()) + " maps, " + std::to_string(asked) +
      " queries: " + short_number(sum / static_cast<double>(std::max<std::size_t>(asked, 1))) +
      " us a query in the mean, " + short_number(means.value()) +
      " us in the geometric mean of the maps; prepared in " + short_number(seconds) + " s.\n");
}

}  // namespace

void add_competition_command(CLI::App& app) {
  const auto [command, options] =
      add_command(app, "competition", "The Grid-Based Path Planning Competition's any-angle track",
                  run_competition);
  add_query_options(command, options);
  command.add_flag("--unprepared", options.unprepared, "Prepare nothing");
}

}  // namespace lasius::bench
