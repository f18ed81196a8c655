// A pilot that the study `online` compares with a Navigator.
#pragma once

#include <span>
#include <utility>

#include "lasius/drive/navigator.h"

namespace lasius::study {

/// A Navigator that forgets its way, and its trail, whenever it learns of a change.
class ForgetfulPilot final : public Pilot {
 public:
  ForgetfulPilot(const Grid& map, Cell goal, const NavigatorOptions& options)
      : navigator_(map, goal, options) {}

  void observe(const Rectangle& part, bool blocked) override {
    navigator_.observe(part, blocked);
    changed_ = true;
  }
  void observe(std::span<const Cell> cells, bool blocked) override {
    navigator_.observe(cells, blocked);
    changed_ = changed_ || !cells.empty();
  }
  const Way& step(Cell robot, const StopCondition& stop) override {
    if (std::exchange(changed_, false)) navigator_.forget();
    return navigator_.step(robot, stop);
  }
  Cell goal() const noexcept override { return navigator_.goal(); }
  const Grid& map() const noexcept override { return navigator_.map(); }
  const Grid& passable() const noexcept override { return navigator_.passable(); }
  bool connected(Cell a, Cell b) override { return navigator_.connected(a, b); }
  double radius() const noexcept override { return navigator_.radius(); }
  Corners corners() const noexcept override { return navigator_.corners(); }

 private:
  Navigator navigator_;
  bool changed_ = false;
};

}  // namespace lasius::study
