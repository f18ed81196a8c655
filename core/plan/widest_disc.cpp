// How wide a disc can be that goes from one cell to another.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/disc/disc_search.h"
#include "core/plan/planner_impl.h"
#include "lasius/grid/clearance.h"

namespace lasius {
namespace {

double radius_of(int squared_half_cells) { return std::sqrt(1.0 * squared_half_cells) / 2; }

/// The square of the distance in half cells from a cell's centre to what is blocked, as far as it
/// matters: whole.
int squared_clearance(const Grid& map, Cell c) {
  const double clearance = 2 * nearest_blocked(map, centre(c), disc::kLargestRadius + 1).distance;
  return static_cast<int>(std::lround(clearance * clearance));
}

/// Does free space lead from one cell's centre to another's? Nothing if stopped.
std::optional<bool> leads(const disc::DiscSpace& space, Cell a, Cell b, const StopCondition& stop) {
  if (!space.clear(centre(a)) || !space.clear(centre(b))) return false;
  constexpr double kAny = 1e9;  // a gap that ends the search at the first path
  disc::DiscSearch search;
  disc::DiscAnswer answer;
  search.search(space, nullptr, centre(a), centre(b), {.target_gap = kAny}, stop, answer);
  if (!answer.path.empty()) return true;
  return answer.end == ExactEnd::unreachable ? std::optional(false) : std::nullopt;
}

}  // namespace

std::shared_ptr<const Planner::Impl::Regions> Planner::Impl::regions(
    int squared_half_cells, const StopCondition& stop) const {
  {
    const std::scoped_lock lock(regions_kept_);
    if (const auto known = regions_.find(squared_half_cells); known != regions_.end())
      return known->second;
  }
  const auto space = space_with(squared_half_cells, stop);
  if (space == nullptr) return nullptr;
  auto joined = Components::make(space->blocked_cells(), Components::Connectivity::four, stop);
  if (!joined) return nullptr;
  auto made = std::make_shared<const Regions>(Regions{space->blocked_cells(), std::move(*joined)});
  const std::scoped_lock lock(regions_kept_);
  if (regions_.size() >= kMostRegions) return made;
  return regions_.emplace(squared_half_cells, std::move(made)).first->second;
}

std::shared_ptr<const disc::DiscSpace> Planner::Impl::space_with(int squared_half_cells,
                                                                 const StopCondition& stop) const {
  {
    const std::scoped_lock lock(regions_kept_);
    if (last_space_ != nullptr && last_radius_ == squared_half_cells) return last_space_;
  }
  auto made = disc::DiscSpace::make(map(), radius_of(squared_half_cells), stop);
  if (!made) return nullptr;
  auto space = std::make_shared<const disc::DiscSpace>(std::move(*made));
  const std::scoped_lock lock(regions_kept_);
  last_radius_ = squared_half_cells;
  return last_space_ = std::move(space);
}

// The narrowest place of the widest way lies midway between the two points of blocked squares that
// hold the disc there, which are lattice points or straight across from one, or it is one of the
// ends. So four times the square of the radius is a whole number. Cells that are not blocked say
// quickly what is closed; what they leave open is searched.
std::optional<double> Planner::widest_disc(Cell a, Cell b, const StopCondition& stop) const {
  const Grid& map = impl_->map();
  if (map.blocked(a) || map.blocked(b)) return std::nullopt;
  constexpr int kMost = static_cast<int>(4 * disc::kLargestRadius * disc::kLargestRadius);
  const int ends = std::min({squared_clearance(map, a), squared_clearance(map, b), kMost});
  if (a == b) return radius_of(ends);
  int open = 0, closed = kMost + 1;  // whatever the ends: other questions ask for the same radii
  for (const bool searched : {false, true}) {
    if (searched) closed = std::exchange(open, 0) + 1;
    // Mostly nothing is closed but what cells say: then the first radius searched is the last.
    for (int next = searched ? closed - 1 : closed / 2; closed - open > 1;
         next = open + (closed - open) / 2) {
      if (next > ends) {
        closed = next;
        continue;
      }
      const auto regions = impl_->regions(next, stop);
      if (regions == nullptr) return std::nullopt;
      // A cell that keeps a clear point may count as blocked by rounding alone.
      bool joined = regions->blocked.free(a) && regions->blocked.free(b) &&
                    regions->four.connected(regions->blocked, a, b);
      if (joined && searched) {
        const auto space = impl_->space_with(next, stop);
        const auto found = space != nullptr ? leads(*space, a, b, stop) : std::nullopt;
        if (!found) return std::nullopt;
        joined = *found;
      }
      (joined ? open : closed) = next;
    }
  }
  return open > 0 ? std::optional(radius_of(open)) : std::nullopt;
}

bool Planner::joined(Cell a, Cell b) const {
  if (!clear(a) || !clear(b)) return false;
  if (impl_->disc == nullptr || !impl_->disc->space) return connected(a, b);
  return impl_->disc->space->joined(centre(a), centre(b));
}

}  // namespace lasius
