#include "core/drive/live_costs.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/held_bytes.h"
#include "core/base/number_text.h"
#include "core/cost/eight_moves.h"
#include "core/cost/inflation.h"
#include "core/cost/merged.h"
#include "core/cost/path_cost.h"
#include "core/cost/polish.h"
#include "core/cost/straightened.h"
#include "core/grid/cell_distance.h"
#include "core/grid/clearance.h"
#include "core/loop/run_status.h"
#include "core/plan/cost_paths.h"
#include "lasius/error.h"
#include "lasius/path.h"

namespace lasius {
namespace {

/// The part of a map that is so far from a rectangle, or nearer, along each axis.
Rectangle grown(const Rectangle& part, std::int64_t reach, const Grid& map) noexcept {
  const auto low = [&](int at) { return static_cast<int>(std::max<std::int64_t>(at - reach, 0)); };
  const auto high = [&](std::int64_t end, int side) {
    return static_cast<int>(std::min<std::int64_t>(end + reach, side));
  };
  const int x = low(part.x), y = low(part.y);
  return {x, y, high(std::int64_t{part.x} + part.width, map.width()) - x,
          high(std::int64_t{part.y} + part.height, map.height()) - y};
}

Grid cut_out(const Grid& map, const Rectangle& part) {
  Grid cut(part.width, part.height);
  for (int y = 0; y < part.height; ++y)
    for (int x = 0; x < part.width; ++x)
      if (map.blocked({part.x + x, part.y + y})) cut.set_blocked({x, y});
  return cut;
}

}  // namespace

LiveCosts::LiveCosts(const EditedMap& map, const CostField& costs,
                     const std::optional<Inflation>& inflation)
    : map_(map),
      given_(costs.weights().begin(), costs.weights().end()),
      least_(*std::ranges::min_element(given_)),
      inflation_(inflation),
      terrain_(map.passable(), costs) {
  if (!inflation_) return;
  cost::check_inflation(*inflation_);
  check_sum(given_);
  edited_.add({0, 0, map.map().width(), map.map().height()});
  bring_up_to_date();
}

/// @throws Error(invalid_parameter) where given costs and the inflation pass what is allowed.
void LiveCosts::check_sum(std::span<const double> weights) const {
  if (!inflation_) return;
  if (const double most = *std::ranges::max_element(weights) + inflation_->weight;
      !(most <= CostField::kMost))
    throw Error(ErrorCode::invalid_parameter,
                "costs and inflation together may weigh " + number_text(most),
                "use smaller ones: weights are at most " + number_text(CostField::kMost));
}

void LiveCosts::set(const Rectangle& part, std::span<const double> weights) {
  const CostField checked(part.width, part.height, weights);  // throws
  const Grid& map = map_.map();
  if (const Rectangle inside = grown(part, 0, map); part.x < 0 || part.y < 0 || inside != part)
    throw Error(ErrorCode::invalid_parameter,
                "costs of " + size_text(part.width, part.height) + " cells from " +
                    pair_text(part.x, part.y) + " leave the map",
                "give those inside of it");
  check_sum(weights);
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

void LiveCosts::bring_up_to_date() {
  const StopCondition never;
  Poller poller(never);
  const Grid& map = map_.map();
  const int inflated = inflation_ ? static_cast<int>(inflation_->radius) : 0;
  changed_.clear();
  for (const Rectangle& edit : edited_.parts()) {
    const Rectangle part = grown(edit, std::max(inflated, map_.growth().reach()), map);
    const Rectangle seen = grown(part, inflated, map);
    std::optional<ClearanceField> nearest;
    if (inflation_) nearest = clearance(cut_out(map, seen), ClearanceOf::blocked_centres, poller);
    for (int y = part.y; y < part.y + part.height; ++y) {
      for (int x = part.x; x < part.x + part.width; ++x) {
        const auto at = static_cast<std::size_t>(y - seen.y) * seen.width + (x - seen.x);
        const double weight = weight_of({x, y}, nearest ? nearest->squared_half_cells[at] : 0);
        if (weight == terrain_.weight(x, y)) continue;
        terrain_.set({x, y}, weight);
        changed_.push_back({x, y});
      }
    }
  }
  edited_.clear();
  if (field_) field_->changed(changed_);
}

Result LiveCosts::run(const Request& request, const disc::DiscSpace* space) {
  bring_up_to_date();
  walk_.clear();
  if (!field_ || field_->goal() != request.goal || field_->least() > least_)
    field_.emplace(terrain_, request.goal, least_);
  Poller poller(request.stop);
  Result result;
  if (!field_->update(request.start, poller)) {
    end_run(result, poller.cause(), Status::limit);
    return result;
  }
  walk_ = field_->walk();
  if (walk_.empty())
    walk_ = cost::EightMoves().search(terrain_, request.start, request.goal, Corners::forbid,
                                      poller, false);
  if (walk_.empty()) {
    end_run(result, poller.cause(), Status::no_path);
    return result;
  }
  // What is farther on is polished when the robot has come nearer.
  constexpr std::size_t kNear = 200;  // pieces, one in each cell
  const std::vector<cost::Leg> legs = cost::straightened(terrain_, walk_);
  const std::span<const cost::Leg> near(legs.data(), std::min(kNear, legs.size()));
  result.path = cost::Polish(terrain_).polish(centre(walk_[0]), near, poller);
  for (std::size_t i = near.size(); i < legs.size(); ++i) result.path.push_back(legs[i].to);
  result.path = cost::merged(terrain_, result.path);
  if (!can_go(space, result.path)) result.path = repaired(*space, result.path, request.stop);
  if (result.path.empty())
    for (const Cell c : walk_) result.path.push_back(centre(c));
  end_run(result, poller.cause(), Status::solved);
  result.length = path_length(result.path);
  return result;
}

double LiveCosts::move_cost(Cell from, Cell to) {
  bring_up_to_date();
  return distance(from, to) * 0.5 * (terrain_.weight(from.x, from.y) + terrain_.weight(to.x, to.y));
}

std::int64_t LiveCosts::bytes() const noexcept {
  return held_bytes(given_, changed_, walk_) + terrain_.bytes() + edited_.bytes() +
         (field_ ? field_->bytes() : 0);
}

}  // namespace lasius
