#include <cmath>
#include <limits>
#include <vector>

#include "core/base/parallel.h"
#include "core/exact/labels/label_search.h"
#include "core/exact/prepared_search.h"
#include "core/params/parameter_table.h"
#include "core/plan/plan_ends.h"
#include "core/plan/planner_impl.h"
#include "lasius/planner.h"

namespace lasius {

namespace {

// Edges of a graph that are searched in the time that a path from a place to a target takes.
constexpr std::int64_t kEdgesPerTarget = 3000;

// By one search of all corners from each source.
std::optional<std::vector<double>> searched(const Planner::Impl& map,
                                            std::span<const Point> sources,
                                            std::span<const Point> targets, bool same, int threads,
                                            const StopCondition& stop) {
  using exact::PreparedSearch;
  std::vector<PreparedSearch> searches(static_cast<std::size_t>(threads));
  std::vector<PreparedSearch::Target> seen(targets.size());
  std::atomic<bool> stopped{false};
  // Searches of small maps are over before they ask.
  const auto over = [&] {
    if (stop.poll() != StopCondition::Cause::none) stopped = true;
    return stopped.load();
  };
  parallel_for(static_cast<int>(targets.size()), threads, [&](int to, int thread) {
    if (!over() && searches[thread].view(map.grid, *map.graph, targets[to], stop, seen[to]))
      stopped = true;
  });
  const std::size_t columns = targets.size();
  std::vector<double> lengths(sources.size() * columns, 0);
  parallel_for(static_cast<int>(sources.size()), threads, [&](int row, int thread) {
    const std::size_t first = same ? row + 1 : 0;
    if (first >= columns || over()) return;
    const std::span part(lengths.data() + row * columns + first, columns - first);
    if (searches[thread].lengths_to(map.grid, *map.graph, sources[row],
                                    std::span(seen).subspan(first), stop, part))
      stopped = true;
  });
  if (stopped) return std::nullopt;
  for (std::size_t row = 0; same && row < columns; ++row)
    for (std::size_t to = row + 1; to < columns; ++to)
      lengths[to * columns + row] = lengths[row * columns + to];
  return lengths;
}

// By labels: a look from each place, and a merge for each pair.
std::optional<std::vector<double>> merged(const Planner::Impl& map, std::span<const Point> sources,
                                          std::span<const Point> targets, bool same, int threads,
                                          const StopCondition& stop) {
  using exact::LabelSearch;
  std::vector<LabelSearch> searches(static_cast<std::size_t>(threads));
  std::vector<LabelSearch::View> seen(targets.size());
  std::atomic<bool> stopped{false};
  const auto over = [&] {
    if (stop.poll() != StopCondition::Cause::none) stopped = true;
    return stopped.load();
  };
  parallel_for(static_cast<int>(targets.size()), threads, [&](int to, int thread) {
    if (!over())
      seen[to] = searches[thread].view(map.grid, *map.graph, *map.labels, targets[to], stop);
  });
  const std::size_t columns = targets.size();
  std::vector<double> lengths(sources.size() * columns, 0);
  parallel_for(static_cast<int>(sources.size()), threads, [&](int row, int thread) {
    const std::size_t first = same ? row + 1 : 0;
    if (first >= columns || over()) return;
    LabelSearch& search = searches[thread];
    const auto from = search.view(map.grid, *map.graph, *map.labels, sources[row], stop);
    if (over()) return;
    search.lengths_to(map.grid, *map.graph, *map.labels, from, std::span(seen).subspan(first),
                      std::span(lengths).subspan(row * columns + first, columns - first));
  });
  if (stopped) return std::nullopt;
  for (std::size_t row = 0; same && row < columns; ++row)
    for (std::size_t to = row + 1; to < columns; ++to)
      lengths[to * columns + row] = lengths[row * columns + to];
  return lengths;
}

}  // namespace

std::optional<std::vector<double>> Planner::distances(std::span<const Cell> sources,
                                                      std::span<const Cell> targets, int threads,
                                                      const StopCondition& stop) const {
  std::vector<Point> from, to;
  for (const Cell c : sources) from.push_back(centre(c));
  if (sources.data() == targets.data() && sources.size() == targets.size())
    return distances(from, from, threads, stop);
  for (const Cell c : targets) to.push_back(centre(c));
  return distances(from, to, threads, stop);
}

std::optional<std::vector<double>> Planner::distances(std::span<const Point> sources,
                                                      std::span<const Point> targets, int threads,
                                                      const StopCondition& stop) const {
  check_threads(threads);
  for (const auto points : {sources, targets})
    for (const Point p : points)
      if (!clear_at(p)) {
        const Asked end(impl_->map(), {}, p);
        throw Error(ErrorCode::invalid_parameter,
                    (end.is_point ? "the point " : "the cell ") + end.name() + " is not free",
                    "ask from and to free cells of the map");
      }
  const bool same = sources.data() == targets.data() && sources.size() == targets.size();
  if (impl_->labels != nullptr)
    return merged(*impl_, sources, targets, same, static_cast<int>(thread_count(threads)), stop);
  if (impl_->graph != nullptr && impl_->disc == nullptr &&
      impl_->preparation.edges <= kEdgesPerTarget * static_cast<std::int64_t>(targets.size()))
    return searched(*impl_, sources, targets, same, static_cast<int>(thread_count(threads)), stop);
  const int rows = static_cast<int>(sources.size());
  const std::size_t columns = targets.size();
  std::vector<double> lengths(sources.size() * columns, 0);
  std::vector<Workspace> workspaces(thread_count(threads));
  const Params params("exact");
  std::atomic<bool> stopped{false};
  parallel_for(rows, static_cast<int>(workspaces.size()), [&](int row, int thread) {
    for (std::size_t to = same ? row + 1 : 0; to < columns && !stopped; ++to) {
      const Result found =
          plan({.stop = stop, .start_point = sources[row], .goal_point = targets[to]}, params,
               &workspaces[thread]);
      if (found.status == Status::limit || found.status == Status::interrupted) stopped = true;
      const double length =
          found.path.empty() ? std::numeric_limits<double>::infinity() : found.length;
      lengths[row * columns + to] = length;
      if (same) lengths[to * columns + row] = length;
    }
  });
  if (stopped) return std::nullopt;
  return lengths;
}

}  // namespace lasius
