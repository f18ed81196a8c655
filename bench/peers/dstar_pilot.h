// Searches on 8 neighbours as planners of a robot under way: D* Lite, to compare a Navigator with.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "bench/peers/dstar_lite.h"
#include "lasius/drive/navigator.h"

namespace lasius::peers {

/// What they share: a point robot on a map of its own; a way's path is its walk.
class GridPilot : public Pilot {
 public:
  GridPilot(Grid map, Cell goal) : map_(std::move(map)), goal_(goal) {}

  void observe(const Rectangle& part, bool blocked) final;
  void observe(std::span<const Cell> cells, bool blocked) final;
  Cell goal() const noexcept final { return goal_; }
  const Grid& map() const noexcept final { return map_; }
  const Grid& passable() const noexcept final { return map_; }
  bool connected(Cell a, Cell b) final;

 protected:
  /// These cells have changed in map().
  virtual void changed(std::span<const Cell> cells, bool blocked) = 0;
  /// The way of this step: a walk, unless `length` is infinite.
  const Way& tell(double length, std::vector<Cell> walk, bool replanned);

 private:
  Grid map_;
  Cell goal_;
  Way way_;
};

/// D* Lite. It cannot be stopped; a way's walk is its next move.
class DStarPilot final : public GridPilot {
 public:
  DStarPilot(const Grid& map, Cell start, Cell goal)
      : GridPilot(map, goal), search_(map, start, goal) {}
  const Way& step(Cell robot, const StopCondition& stop) override;

 private:
  void changed(std::span<const Cell> cells, bool blocked) override;

  DStarLite search_;
  bool changed_ = true;
};

}  // namespace lasius::peers
