// By the frontier alone: the only shortest path, a shortcut, all corners near a question's ends.
#include <algorithm>
#include <limits>

#include "core/exact/exact.h"

namespace lasius {

using exact::CornerTable;
using exact::kBucketWidth;
using exact::kWordsPerPoll;
using exact::TautRow;

namespace {

// Where ties are found to be frequent the search that notes them ends early; and after each that
// was in vain more of the next searches do without.
constexpr std::int64_t kFewTies = 8;
constexpr std::int64_t kExpansionsForTie = 32;
constexpr std::int64_t kNoLimit = std::numeric_limits<std::int64_t>::max();
constexpr int kMorePause = 8, kMostPause = 256;

}  // namespace

// Expands corners by the frontier alone, for about so much work.
void ExactSearch::run_plain(const StopCondition& stop, std::int64_t work, exact::Anytime* beside) {
  Poller poller(stop, kWordsPerPoll);
  poller_ = &poller;
  beside_ = beside;
  frontier_.reset(lower_, kBucketWidth);
  std::uint32_t index = CornerTable::kStart;
  do {
    step(index);
  } while (!poller.stopped() && work_done() < work && !given_up(index) && next_corner(index));
  poller_ = nullptr;
  beside_ = nullptr;
  cause_ = poller.cause();
}

// Finds the shortest path if it is the only one, or that there is none; or is stopped. Else false.
bool ExactSearch::search_only(const ExactOptions& options, const StopCondition& stop) {
  const bool looked_at = options.improved != nullptr && !options.improved_once_polled;
  if (options.target_gap > 0 || looked_at || stop.deadline != Clock::time_point::max() ||
      straight_ > exact::kLongWay)
    return false;
  if (rest_ > 0) {
    --rest_;
    return false;
  }
  mode_ = Mode::only;
  run_plain(stop, kNoLimit, options.beside);
  if (cause_ != StopCondition::Cause::none ||
      (!ties_.in_vain && !ties_.at_goal && is_only(last_))) {
    if (pause_ > 0) --pause_;
    rest_ = pause_;
    counters_.ties = exact::Counters::Ties::none;
    return true;
  }
  counters_.ties = exact::Counters::Ties::some;
  rest_ = pause_ = std::min(2 * pause_ + kMorePause, kMostPause);
  return false;
}

// Where ties are frequent, or one lies on the way to the corner in hand: the best one begins so,
// too, as a rule.
bool ExactSearch::given_up(std::uint32_t index) noexcept {
  if (mode_ != Mode::only || ties_.noted == 0) return false;
  if (counters_.expansions >= ties_.next_look) {
    ties_.next_look = counters_.expansions * 3 / 2;
    ties_.in_vain = !is_only(index);
  }
  if (ties_.noted > kFewTies && ties_.noted * kExpansionsForTie > counters_.expansions)
    ties_.in_vain = true;
  return ties_.in_vain;
}

// Is no other path as short as the best? Let one be, and let it join the best one at a corner, or
// at the goal: it came there by a corner that was expanded at its least length, which was noted.
bool ExactSearch::is_only(std::uint32_t index) const noexcept {
  for (std::uint32_t i = index; i != CornerTable::kStart; i = corners_[i].parent)
    if (corners_[i].tied) return false;
  return true;
}

void ExactSearch::shortcut(const Grid& grid, Cell start, Cell goal, double length,
                           const CellSet& cells, std::int64_t work, const StopCondition& stop,
                           std::vector<Point>& path) {
  begin(grid, centre(start), centre(goal), Mode::plain);
  path.clear();
  if (lower_ >= length) return;
  if (start_.sees(map_, goal_)) return trace(path);
  upper_ = length;
  touched_ = &cells;
  run_plain(stop, work);
  if (upper_ < length) trace(path);
}

bool ExactSearch::row(const Grid& grid, Point from, Point to, double bound,
                      const StopCondition& stop, TautRow& row) {
  begin(grid, from, to, Mode::row);
  row.corners.clear();
  upper_ = bound;
  run_plain(stop, kNoLimit);
  for (std::uint32_t i = 1; i < corners_.size(); ++i) {
    const exact::Corner& corner = corners_[i];
    const std::uint32_t parent =
        corner.parent == CornerTable::kStart ? TautRow::kEnd : corner.parent - 1;
    row.corners.push_back({corner.x / 2, corner.y / 2, corner.length, parent});
  }
  return cause_ != StopCondition::Cause::none;
}

}  // namespace lasius
