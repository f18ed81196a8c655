#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/invalid_parameter.h"
#include "core/base/parallel.h"
#include "core/exact/labels/label_search.h"
#include "core/exact/prepared_search.h"
#include "core/params/parameter_table.h"
#include "core/plan/lengths_near.h"
#include "core/plan/plan_ends.h"
#include "core/plan/planner_impl.h"
#include "lasius/plan/planner.h"

namespace lasius {

namespace {

// Vertices that one search of all of a graph reaches in the time that a path to a target takes.
constexpr std::int64_t kVerticesPerTarget = 300;

using exact::PreparedSearch;

// Whether it is over, for threads that each poll.
class Ended {
 public:
  explicit Ended(const StopCondition& stop) : stop_(stop) {}
  explicit operator bool() const noexcept { return ended_; }
  void set() noexcept { ended_ = true; }
  /// Searches of small maps are over before they ask.
  bool poll() {
    if (stop_.poll() != StopCondition::Cause::none) ended_ = true;
    return ended_;
  }

 private:
  const StopCondition& stop_;
  std::atomic<bool> ended_{false};
};

std::vector<PreparedSearch::Target> seen_from(const Planner::Impl& map,
                                              std::span<const Point> targets,
                                              std::span<PreparedSearch> searches,
                                              const StopCondition& stop, Ended& ended) {
  std::vector<PreparedSearch::Target> seen(targets.size());
  parallel_for(static_cast<int>(targets.size()), static_cast<int>(searches.size()),
               [&](int to, int thread) {
                 if (!ended.poll() &&
                     searches[thread].view(map.grid, *map.graph, targets[to], stop, seen[to]))
                   ended.set();
               });
  return seen;
}

// A row of lengths for each source, by answer(source, first, part, thread): `part` is the row from
// the target `first` on. Where the sources are the targets, these lie behind the source, and the
// others are the same the other way round. Nothing where it ended before.
template <class Answer>
std::optional<std::vector<double>> by_rows(std::size_t sources, std::size_t targets, bool same,
                                           int threads, Ended& ended, const Answer& answer) {
  std::vector<double> lengths(sources * targets, 0);
  parallel_for(static_cast<int>(sources), threads, [&](int row, int thread) {
    const std::size_t first = same ? row + 1 : 0;
    if (first >= targets || ended.poll()) return;
    answer(row, first, std::span(lengths).subspan(row * targets + first, targets - first), thread);
  });
  if (ended) return std::nullopt;
  for (std::size_t row = 0; same && row < targets; ++row)
    for (std::size_t to = row + 1; to < targets; ++to)
      lengths[to * targets + row] = lengths[row * targets + to];
  return lengths;
}

// By one search of all corners from each source.
std::optional<std::vector<double>> searched(const Planner::Impl& map,
                                            std::span<const Point> sources,
                                            std::span<const Point> targets, bool same, int threads,
                                            const StopCondition& stop) {
  std::vector<PreparedSearch> searches(static_cast<std::size_t>(threads));
  Ended ended(stop);
  const auto seen = seen_from(map, targets, searches, stop, ended);
  return by_rows(sources.size(), targets.size(), same, threads, ended,
                 [&](int row, std::size_t first, std::span<double> part, int thread) {
                   if (searches[thread].lengths_to(map.grid, *map.graph, sources[row],
                                                   std::span(seen).subspan(first), stop, part))
                     ended.set();
                 });
}

// By labels: a look from each place, and a merge for each pair.
std::optional<std::vector<double>> merged(const Planner::Impl& map, std::span<const Point> sources,
                                          std::span<const Point> targets, bool same, int threads,
                                          const StopCondition& stop) {
  using exact::LabelSearch;
  std::vector<LabelSearch> searches(static_cast<std::size_t>(threads));
  std::vector<LabelSearch::View> seen(targets.size());
  Ended ended(stop);
  const auto view = [&](LabelSearch& search, Point from) {
    return search.view(map.grid, *map.graph, *map.labels, from, stop);
  };
  parallel_for(static_cast<int>(targets.size()), threads, [&](int to, int thread) {
    if (!ended.poll()) seen[to] = view(searches[thread], targets[to]);
  });
  return by_rows(sources.size(), targets.size(), same, threads, ended,
                 [&](int row, std::size_t first, std::span<double> part, int thread) {
                   const auto from = view(searches[thread], sources[row]);
                   if (!ended.poll())
                     searches[thread].lengths_to(map.grid, *map.graph, *map.labels, from,
                                                 std::span(seen).subspan(first), part);
                 });
}

// The straight distance to the place that so many others are nearer than.
double straight_to_nearest(std::span<const Point> places, int from, int count) {
  std::vector<double> squares;
  squares.reserve(places.size());
  for (const Point p : places) {
    const double dx = p.x - places[from].x, dy = p.y - places[from].y;
    squares.push_back(dx * dx + dy * dy);
  }
  const auto at = squares.begin() + count;
  std::nth_element(squares.begin(), at, squares.end());
  return std::sqrt(*at);
}

}  // namespace

bool lengths_near(const Planner& planner, std::span<const Point> places,
                  std::span<const int> nearest, int threads, const StopCondition& stop,
                  const TakeLengths& take) {
  constexpr double kFirstReach = 1.3, kFarther = 2;  // of the straight distance; of one before it
  constexpr int kMostReaches = 8;
  const Planner::Impl& map = PlannerParts::of(planner);
  if (map.graph == nullptr || map.disc != nullptr) return false;
  const int n = static_cast<int>(places.size());
  std::vector<PreparedSearch> searches(static_cast<std::size_t>(thread_count(threads)));
  std::vector<std::vector<double>> rows(searches.size(), std::vector<double>(places.size()));
  Ended ended(stop);
  const auto seen = seen_from(map, places, searches, stop, ended);
  parallel_for(n, static_cast<int>(searches.size()), [&](int from, int thread) {
    const int wanted = std::min(nearest[from], n - 1);
    if (wanted <= 0 || ended.poll()) return;
    std::vector<double>& lengths = rows[thread];
    constexpr double kAll = std::numeric_limits<double>::infinity();
    double reach = wanted == n - 1 ? kAll : kFirstReach * straight_to_nearest(places, from, wanted);
    for (int reaches = 1;; ++reaches, reach = reaches < kMostReaches ? kFarther * reach : kAll) {
      if (searches[thread].lengths_to(map.grid, *map.graph, places[from], seen, stop, lengths,
                                      reach))
        return ended.set();
      const auto known = std::count_if(lengths.begin(), lengths.end(),
                                       [](double length) { return length < kAll; });
      if (known > wanted || reach == kAll) break;
    }
    take(from, lengths, reach);
  });
  return !ended;
}

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
        refuse((end.is_point ? "the point " : "the cell ") + end.name() + " is not free",
               "ask from and to free cells of the map");
      }
  const bool same = sources.data() == targets.data() && sources.size() == targets.size();
  const int team = static_cast<int>(thread_count(threads));
  if (impl_->labels != nullptr) return merged(*impl_, sources, targets, same, team, stop);
  if (impl_->graph != nullptr && impl_->disc == nullptr &&
      impl_->preparation.vertices <= kVerticesPerTarget * static_cast<std::int64_t>(targets.size()))
    return searched(*impl_, sources, targets, same, team, stop);
  std::vector<Workspace> workspaces(static_cast<std::size_t>(team));
  const Params params("exact");
  Ended ended(stop);
  return by_rows(
      sources.size(), targets.size(), same, team, ended,
      [&](int row, std::size_t first, std::span<double> part, int thread) {
        for (std::size_t i = 0; i < part.size() && !ended; ++i) {
          const Result found =
              plan({.stop = stop, .start_point = sources[row], .goal_point = targets[first + i]},
                   params, {.workspace = &workspaces[thread]});
          if (found.status == Status::limit || found.status == Status::interrupted) ended.set();
          part[i] = found.path.empty() ? std::numeric_limits<double>::infinity() : found.length;
        }
      });
}

}  // namespace lasius
