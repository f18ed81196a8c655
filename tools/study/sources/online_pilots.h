// The pilots that the study `online` compares with a Navigator.
#pragma once

#include <span>

#include "bench/peers/dstar_lite.h"
#include "lasius/navigator.h"

namespace lasius::study {

/// A Navigator that forgets its way, and its trail, whenever it learns of a change.
class ForgetfulPilot final : public Pilot {
 public:
  ForgetfulPilot(const Grid& map, Cell goal, const NavigatorOptions& options)
      : navigator_(map, goal, options) {}

  void observe(const Rectangle& part, bool blocked) override;
  void observe(std::span<const Cell> cells, bool blocked) override;
  const Way& step(Cell robot, const StopCondition& stop) override;
  Cell goal() const noexcept override { return navigator_.goal(); }
  const Grid& map() const noexcept override { return navigator_.map(); }
  const Grid& passable() const noexcept override { return navigator_.passable(); }
  bool connected(Cell a, Cell b) override { return navigator_.connected(a, b); }

 private:
  Navigator navigator_;
  bool changed_ = false;
};

/// D* Lite for a point robot. It cannot be stopped; a way's path is its next move.
class DStarPilot final : public Pilot {
 public:
  DStarPilot(const Grid& map, Cell start, Cell goal)
      : map_(map), goal_(goal), search_(map, start, goal) {}

  void observe(const Rectangle& part, bool blocked) override;
  void observe(std::span<const Cell> cells, bool blocked) override;
  const Way& step(Cell robot, const StopCondition& stop) override;
  Cell goal() const noexcept override { return goal_; }
  const Grid& map() const noexcept override { return map_; }
  const Grid& passable() const noexcept override { return map_; }
  bool connected(Cell a, Cell b) override;

 private:
  Grid map_;
  Cell goal_;
  peers::DStarLite search_;
  Way way_;
  bool changed_ = true;
};

}  // namespace lasius::study
