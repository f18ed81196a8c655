// What legs of a vehicle's tour cost: plans where there are some, else what no plan is below.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "core/base/poller.h"
#include "core/tour/routes/routes.h"
#include "lasius/vehicle/planner.h"

namespace lasius::vehicle {

/// A pose at one of the places of a tour.
struct TourPose {
  Pose pose;
  int place = 0;
};

/// From one such pose, by its index, to another.
using PosePair = std::pair<int, int>;

/// Between all poses of a tour, either way.
class LegPrices {
 public:
  /// Finds the bounds: of each pair of places around the obstacles, of each pair of poses without
  /// them. After a deadline none is around the obstacles, after a token's stop they are straight.
  LegPrices(const Planner& planner, std::vector<TourPose> poses, int threads,
            const StopCondition& stop);

  const TourPose& at(int pose) const { return poses_[pose]; }
  tour::Costs costs() const { return {size(), costs_.data()}; }
  /// What no routes are below that the problem allows, over these poses as stops; rounded down. Not
  /// by whole numbers where exact_routes knows them. `upper`: the length of some.
  double lower_bound(const tour::RouteProblem& problem, bool open, double upper,
                     Poller& poller) const;
  double scale() const noexcept { return scale_; }  ///< grains of a length, or over costs of a cost

  /// Plans legs that are not known. A plan that a deadline stopped is none, one that a signal did
  /// only where it has no path yet. `hasty_states`: above 0 after a signal, by a hastier search
  /// that enters so many states, and as it finds them.
  void price(std::span<const PosePair> legs, int threads, const StopCondition& stop,
             int hasty_states = 0);
  /// Those of `legs` that are not known.
  std::vector<PosePair> unknown(std::vector<PosePair> legs) const {
    std::erase_if(legs, [&](const PosePair& leg) { return known(leg); });
    return legs;
  }
  bool known(const PosePair& leg) const { return plans_.contains(leg); }
  bool has_way(const PosePair& leg) const { return !plans_.at(leg).segments.empty(); }
  /// Of a known one; without a path where none was found.
  const Result& plan(const PosePair& leg) const { return plans_.at(leg); }
  const std::map<PosePair, Result>& plans() const noexcept { return plans_; }
  static double value(const Result& plan) { return plan.over_costs ? plan.cost : plan.length; }

 private:
  int size() const noexcept { return static_cast<int>(poses_.size()); }
  std::size_t index(const PosePair& leg) const {
    return static_cast<std::size_t>(leg.first) * poses_.size() +
           static_cast<std::size_t>(leg.second);
  }

  const Planner& planner_;
  std::vector<TourPose> poses_;
  double scale_ = 1;
  std::vector<double> bounds_;
  std::vector<tour::Cost> costs_;
  std::map<PosePair, Result> plans_;
};

}  // namespace lasius::vehicle
