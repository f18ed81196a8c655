// What is known of a map beside its cells, brought up to date when it is asked for.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/held_bytes.h"
#include "core/colony/colony.h"
#include "core/grid/components.h"
#include "lasius/grid.h"
#include "lasius/params.h"
#include "lasius/progress.h"
#include "lasius/request.h"
#include "lasius/result.h"

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

  void changed(const Rectangle& part) {
    if (!changed_.empty()) {
      Rectangle& last = changed_.back();
      const Rectangle both = round(last, part);
      if (area(both) <= 4 * (area(last) + area(part))) {
        last = both;
        return;
      }
    }
    changed_.push_back(part);
    constexpr std::size_t kMost = 256;  // where nobody asks
    if (changed_.size() < kMost) return;
    Rectangle all = part;
    for (const Rectangle& one : changed_) all = round(all, one);
    changed_.assign(1, all);
  }
  Result run(const Request& request, const Observer& observer) {
    for (const Rectangle& part : changed_) colony_.changed(part);
    changed_.clear();
    return colony_.run(request.start, iterations_, request.stop, observer);
  }
  void forget() {
    changed_.clear();
    colony_.forget();
  }

 private:
  static std::int64_t area(const Rectangle& r) noexcept { return std::int64_t{r.width} * r.height; }
  static Rectangle round(const Rectangle& a, const Rectangle& b) noexcept {
    const int left = std::min(a.x, b.x), top = std::min(a.y, b.y);
    return {left, top, std::max(a.x + a.width, b.x + b.width) - left,
            std::max(a.y + a.height, b.y + b.height) - top};
  }

  SurvivingColony colony_;
  Cell goal_;
  int iterations_;
  std::vector<Rectangle> changed_;
};

}  // namespace lasius
