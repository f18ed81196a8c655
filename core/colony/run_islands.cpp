#include <algorithm>
#include <array>
#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/stored_arrays.h"
#include "core/colony/islands.h"
#include "core/colony/rank_talk.h"
#include "core/colony/tour_board.h"
#include "core/loop/run_status.h"

namespace lasius {
namespace {

using Cause = StopCondition::Cause;

/// Waits until all ranks are here. @throws Error(file_broken) where they are asked for other things
void meet(const Ranks& ranks, const Grid& grid, const Request& request, const Params& params,
          TourBoard& board) {
  ArrayWriter own;
  own.value(std::array{request.start.x, request.start.y, request.goal.x, request.goal.y,
                       grid.width(), grid.height(), static_cast<int>(params.neighbours),
                       params.islands, params.ants});
  const std::vector<std::string> all = gather(ranks, own.text());
  for (int rank = 0; rank < ranks.count; ++rank) {
    const std::string& text = all[static_cast<std::size_t>(rank)];
    if (text.empty())
      board.stop(Cause::deadline);
    else
      told_by(text, rank).require(text == own.text());
  }
}

/// Puts together what all ranks have walked. The first cause, by rank, that ended one.
Cause join(const Ranks& ranks, Cause cause, std::vector<IterationSums>& course) {
  ArrayWriter own;
  own.value(cause);
  own.array(course);
  const std::vector<std::string> all = gather(ranks, own.text());
  cause = Cause::none;
  course.clear();
  for (int rank = 0; rank < ranks.count; ++rank) {
    ArrayReader from = told_by(all[static_cast<std::size_t>(rank)], rank);
    const auto told = from.at_end() ? Cause::deadline : from.value<Cause>();
    if (cause == Cause::none) cause = told;
    if (from.at_end()) continue;
    add_part(course, from.array<IterationSums>());
    from.require(from.at_end());
  }
  return cause;
}

Result run_apart(const Grid& grid, const Request& request, const Params& params,
                 ColonyMemory& memory, const Observer& observer, const disc::DiscSpace* disc,
                 const cost::Terrain* terrain, Islands::Part here) {
  const Ranks* const ranks = request.ranks;
  if (ranks != nullptr) require_ranks(*ranks, true);
  TourBoard board(ranks);
  if (ranks != nullptr) meet(*ranks, grid, request, params, board);

  const int islands = (params.islands - here.own + here.count - 1) / here.count;
  const int count = std::min(islands, region_threads(thread_count(params.threads)));
  std::deque<Islands> parts;
  for (int p = 0; p < count; ++p)
    parts.emplace_back(grid, params, memory, disc, terrain,
                       Islands::Part{here.own + p * here.count, here.count * count}, nullptr,
                       &board);
  std::vector<Convergence> seen(parts.size());
  bool observed = false;  // by thread 0, which calls
  const Observer none;
  parallel_for(count, count, [&](int p, int thread) {
    const auto i = static_cast<std::size_t>(p);
    const bool shows = thread == 0 && !std::exchange(observed, true);
    try {
      board.stop(parts[i].walk(request, shows ? observer : none, seen[i]));
    } catch (...) {
      board.stop(Cause::token);
      throw;
    }
  });

  std::vector<IterationSums> course;
  FoundPath best;
  for (Islands& part : parts) {
    add_part(course, part.course());
    FoundPath found = part.found();
    if (best.points.empty() || found.rank < best.rank) best = std::move(found);
  }
  Cause cause = board.poll();
  if (ranks != nullptr) cause = join(*ranks, cause, course);
  Convergence run;
  for (const IterationSums& sums : course) record(sums, run);
  return result_after(cause, std::move(run), best_of(ranks, std::move(best)));
}

}  // namespace

Result run_islands(const Grid& grid, const Request& request, const Params& params,
                   ColonyMemory& memory, const Observer& observer, const disc::DiscSpace* disc,
                   const cost::Terrain* terrain) {
  const Ranks* const ranks = request.ranks;
  const auto here = ranks != nullptr ? Islands::Part{ranks->own, ranks->count} : Islands::Part{};
  if (params.exchange == Exchange::asynchronous)
    return run_apart(grid, request, params, memory, observer, disc, terrain, here);
  return Islands(grid, params, memory, disc, terrain, here, ranks, nullptr).run(request, observer);
}

}  // namespace lasius
