#include <cmath>
#include <limits>
#include <vector>

#include "core/base/parallel.h"
#include "core/params/parameter_table.h"
#include "core/plan/answer.h"
#include "lasius/planner.h"

namespace lasius {

std::optional<std::vector<double>> Planner::distances(std::span<const Cell> sources,
                                                      std::span<const Cell> targets, int threads,
                                                      const StopCondition& stop) const {
  check_threads(threads);
  for (const auto cells : {sources, targets})
    for (const Cell c : cells)
      if (!clear(c))
        throw Error(ErrorCode::invalid_parameter, "the cell " + cell_name(c) + " is no free cell",
                    "ask from and to free cells of the map");
  const bool same = sources.data() == targets.data() && sources.size() == targets.size();
  const int rows = static_cast<int>(sources.size());
  const std::size_t columns = targets.size();
  std::vector<double> lengths(sources.size() * columns, 0);
  std::vector<Workspace> workspaces(thread_count(threads));
  const Params params("exact");
  std::atomic<bool> stopped{false};
  parallel_for(rows, static_cast<int>(workspaces.size()), [&](int row, int thread) {
    for (std::size_t to = same ? row + 1 : 0; to < columns && !stopped; ++to) {
      const Result found = plan({.start = sources[row], .goal = targets[to], .stop = stop}, params,
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
