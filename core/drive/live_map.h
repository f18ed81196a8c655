// What is known of a map beside its cells, brought up to date when it is asked for.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/held_bytes.h"
#include "core/colony/colony.h"
#include "core/drive/pending_parts.h"
#include "core/grid/components.h"
#include "lasius/grid/grid.h"
#include "lasius/params/params.h"
#include "lasius/plan/progress.h"
#include "lasius/plan/request.h"
#include "lasius/plan/result.h"

namespace lasius {

/// The components of a map that is edited, brought up to date when they are asked for.
class LiveComponents {
 public:
  LiveComponents(const Grid& grid, Components::Connectivity connectivity)
      : components_(grid, connectivity) {}

  /// `grid` has the change already.
  void changed(const Grid& grid, const Rectangle& part) {
    changed_.push_back(part);
    constexpr std::size_t kMost = 256;  // where nobody asks
    if (changed_.size() == kMost) (void)update(grid, {});
  }
  /// Nothing if stopped; the next call goes on.
  std::optional<bool> connected(const Grid& grid, Cell a, Cell b, const StopCondition& stop) {
    if (!update(grid, stop)) return std::nullopt;
    return components_.connected(grid, a, b);
  }
  std::int64_t bytes() const noexcept { return components_.bytes() + held_bytes(changed_); }

 private:
  bool update(const Grid& grid, const StopCondition& stop) {
    if (!changed_.empty() || !up_to_date_) {
      up_to_date_ = components_.update(grid, changed_, stop);
      changed_.clear();  // if it was stopped, they are kept there
    }
    return up_to_date_;
  }

  Components components_;
  std::vector<Rectangle> changed_;
  bool up_to_date_ = true;
};

/// A colony and what it was not told yet: changes beside each other in one, since each is repaired.
class LiveColony {
 public:
  LiveColony(const Grid& grid, Cell goal, const Params& params, const disc::DiscSpace* disc)
      : colony_(grid, goal, params, disc), goal_(goal), iterations_(params.iterations) {}

  Cell goal() const noexcept { return goal_; }

  void changed(const Rectangle& part) { changed_.add(part); }
  Result run(const Request& request, const Observer& observer) {
    for (const Rectangle& part : changed_.parts()) colony_.changed(part);
    changed_.clear();
    return colony_.run(request.start, iterations_, request.stop, observer);
  }
  void forget() {
    changed_.clear();
    colony_.forget();
  }

 private:
  SurvivingColony colony_;
  Cell goal_;
  int iterations_;
  PendingParts changed_;
};

}  // namespace lasius
