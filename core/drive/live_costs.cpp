#include "core/drive/live_costs.h"

#include <algorithm>

#include "core/base/held_bytes.h"
#include "core/base/invalid_parameter.h"
#include "core/base/number_text.h"
#include "core/cost/eight_moves.h"
#include "core/cost/inflation.h"
#include "core/cost/merged.h"
#include "core/cost/path_cost.h"
#include "core/cost/polish.h"
#include "core/cost/straightened.h"
#include "core/grid/changed_parts.h"
#include "core/grid/clearance.h"
#include "core/loop/run_status.h"
#include "core/plan/cost_paths.h"
#include "lasius/path/path.h"

namespace lasius {
namespace {

Grid cut_out(const Grid& map, const Rectangle& part) {
  Grid cut(part.width, part.height);
  for (int y = 0; y < part.height; ++y)
    for (int x = 0; x < part.width; ++x)
      if (map.blocked({part.x + x, part.y + y})) cut.set_blocked({x, y});
  return cut;
}

/// Does a move pass a blocked cell?
bool beside_blocked(const cost::Terrain& terrain, Cell a, Cell b) noexcept {
  return !(terrain.free(a.x, b.y) && terrain.free(b.x, a.y));
}

}  // namespace

LiveCosts::LiveCosts(const EditedMap& map, const CostField& costs,
                     const std::optional<Inflation>& inflation, Corners corners)
    : map_(map),
      given_(costs.weights().begin(), costs.weights().end()),
      least_(*std::ranges::min_element(given_)),
      inflation_(inflation),
      terrain_(map.passable(), costs),
      squeezes_(corners == Corners::allow) {
  if (!inflation_) return;
  cost::check_inflation(*inflation_);
  cost::check_sum(given_, *inflation_);
  const StopCondition never;
  Poller poller(never);
  update({0, 0, map.map().width(), map.map().height()}, poller);
}

void LiveCosts::set(const Rectangle& part, std::span<const double> weights) {
  const CostField checked(part.width, part.height, weights);  // throws
  const Grid& map = map_.map();
  if (const Rectangle inside = widened(part, 0, map); part.x < 0 || part.y < 0 || inside != part)
    refuse("costs of " + size_text(part.width, part.height) + " cells from " +
               pair_text(part.x, part.y) + " leave the map",
           "give those inside of it");
  if (inflation_) cost::check_sum(weights, *inflation_);
  for (int y = 0; y < part.height; ++y) {
    for (int x = 0; x < part.width; ++x) {
      const double weight = checked.weight({x, y});
      given_[static_cast<std::size_t>(part.y + y) * map.width() + part.x + x] = weight;
      least_ = std::min(least_, weight);
    }
  }
  edited_.add(part);
}

double LiveCosts::weight_of(Cell c, std::int32_t squared_half_cells) const noexcept {
  if (map_.passable().blocked(c)) return kInfinity;
  const double given = given_[static_cast<std::size_t>(c.y) * map_.map().width() + c.x];
  return inflation_
             ? std::min(given + cost::inflated(*inflation_, squared_half_cells), CostField::kMost)
             : given;
}

/// False when stopped: then the field is told of what was done, and the rest waits.
bool LiveCosts::bring_up_to_date(Poller& poller) {
  changed_.clear();
  while (!edited_.parts().empty() && update(edited_.parts().back(), poller)) edited_.drop_last();
  if (field_) field_->changed(changed_);
  return edited_.parts().empty();
}

bool LiveCosts::update(const Rectangle& edit, Poller& poller) {
  const Grid& map = map_.map();
  const int inflated = inflation_ ? static_cast<int>(inflation_->radius) : 0;
  const Rectangle part = widened(edit, std::max(inflated, map_.growth().reach()), map);
  const Rectangle seen = widened(part, inflated, map);
  std::optional<ClearanceField> nearest;
  if (inflation_) {
    nearest = clearance(cut_out(map, seen), ClearanceOf::blocked_centres, poller);
    if (!nearest) return false;
  }
  for (int y = part.y; y < part.y + part.height; ++y) {
    if (poller.stop_after(part.width)) return false;
    for (int x = part.x; x < part.x + part.width; ++x) {
      const auto at = static_cast<std::size_t>(y - seen.y) * seen.width + (x - seen.x);
      const double weight = weight_of({x, y}, nearest ? nearest->squared_half_cells[at] : 0);
      if (weight == terrain_.weight(x, y)) continue;
      terrain_.set({x, y}, weight);
      if (field_) changed_.push_back({x, y});
    }
  }
  return true;
}

/// A walk that squeezes nowhere as a path of any angle, the first `most` pieces polished.
std::vector<Point> LiveCosts::polished(std::span<const Cell> walk, std::size_t most,
                                       Poller& poller) const {
  const std::vector<cost::Leg> legs = cost::straightened(terrain_, walk);
  const std::span<const cost::Leg> near(legs.data(), std::min(most, legs.size()));
  std::vector<Point> path{centre(walk[0])};
  if (!near.empty()) path = cost::Polish(terrain_).polish(path[0], near, poller);
  for (std::size_t i = near.size(); i < legs.size(); ++i) path.push_back(legs[i].to);
  return cost::merged(terrain_, path);
}

void LiveCosts::find_path(const disc::DiscSpace* space, const StopCondition& stop, Poller& poller,
                          Result& result) {
  // What is farther on is polished when the robot has come nearer.
  constexpr std::size_t kNear = 120;  // pieces, one in each cell
  const std::span<const Cell> walk(walk_);
  cost_ = walk_cost_ = 0;
  for (std::size_t i = 1; i < walk.size(); ++i)
    walk_cost_ += terrain_.move_cost(walk[i - 1], walk[i]);
  for (std::size_t first = 0; first < walk.size();) {
    std::size_t end = first + 1;  // of what squeezes nowhere
    while (end < walk.size() && !beside_blocked(terrain_, walk[end - 1], walk[end])) ++end;
    const std::size_t most = kNear - std::min(kNear, first);
    const auto part = polished(walk.subspan(first, end - first), most, poller);
    cost_ += cost::cost_of(terrain_, part);
    if (end < walk.size()) cost_ += terrain_.move_cost(walk[end - 1], walk[end]);
    result.path.insert(result.path.end(), part.begin(), part.end());
    first = end;
  }
  if (can_go(space, result.path)) return;
  result.path = repaired(*space, result.path, stop);
  cost_ = cost::cost_of(terrain_, result.path);
  if (!result.path.empty() && cost_ <= walk_cost_) return;
  result.path.clear();
  for (const Cell c : walk) result.path.push_back(centre(c));
  cost_ = walk_cost_;
}

Result LiveCosts::run(const Request& request, const disc::DiscSpace* space) {
  Poller poller(request.stop);
  Result result;
  walk_.clear();
  const bool ready = bring_up_to_date(poller);
  if (ready && (!field_ || field_->goal() != request.goal || field_->least() > least_))
    field_.emplace(terrain_, request.goal, least_, squeezes_);
  if (!ready || !field_->update(request.start, poller)) {
    end_run(result, poller.cause(), Status::limit);
    return result;
  }
  walk_ = field_->walk();
  if (walk_.empty())
    walk_ = cost::EightMoves().search(terrain_, request.start, request.goal,
                                      squeezes_ ? Corners::allow : Corners::forbid, poller, false);
  if (!walk_.empty()) find_path(space, request.stop, poller, result);
  end_run(result, poller.cause(), walk_.empty() ? Status::no_path : Status::solved);
  if (!walk_.empty()) result.length = path_length(result.path);
  return result;
}

double LiveCosts::move_cost(Cell from, Cell to) {
  const StopCondition never;
  Poller poller(never);
  bring_up_to_date(poller);
  return terrain_.move_cost(from, to);
}

std::int64_t LiveCosts::bytes() const noexcept {
  return held_bytes(given_, changed_, walk_) + terrain_.bytes() + edited_.bytes() +
         (field_ ? field_->bytes() : 0);
}

}  // namespace lasius
