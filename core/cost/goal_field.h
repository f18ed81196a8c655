// The cheapest walks by eight moves to a goal, while the weights change.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/large_array.h"
#include "core/base/poller.h"
#include "core/cost/terrain.h"

namespace lasius::cost {

/// What the cheapest walk to a goal costs from the cells that a robot's walk may go over; a change
/// takes the work of what it changes of these: D* Lite in its optimised form (Koenig & Likhachev
/// 2002, figure 4). A move costs its length times the mean of both weights.
class GoalField {
 public:
  /// @param terrain  outlives the field; whoever changes it says so: changed()
  /// @param least    above 0; no weight is ever less
  /// @param squeezes  moves pass blocked corners, and between two of them; else neither
  GoalField(const Terrain& terrain, Cell goal, double least, bool squeezes);

  Cell goal() const noexcept { return goal_; }
  double least() const noexcept { return least_; }
  /// The terrain's weights in these cells are others now, or they became blocked or free.
  void changed(std::span<const Cell> cells);
  /// Brings costs up to date for a robot in a free cell. False if stopped: the next call goes on.
  bool update(Cell robot, Poller& poller);
  /// The cells of its cheapest walk, the robot's first; empty where there is none, and where costs
  /// so far apart meet that rounding hides the lower ones.
  std::vector<Cell> walk() const;

  std::int64_t bytes() const noexcept;  ///< memory held

 private:
  struct Key {
    double first, second;
    friend bool operator<(const Key& a, const Key& b) noexcept {
      return a.first < b.first || (a.first == b.first && a.second < b.second);
    }
  };
  struct Entry {
    Key key;
    std::uint32_t at;
  };
  static bool later(const Entry& a, const Entry& b) noexcept { return b.key < a.key; }

  std::size_t index(Cell c) const noexcept { return terrain_.index(c.x, c.y); }
  bool open(std::size_t at, int move) const noexcept;
  double step_cost(std::size_t at, int move) const noexcept;
  double look_ahead(std::size_t at) const noexcept;
  double estimate(std::size_t at) const noexcept;
  Key key(std::size_t at) const noexcept;
  void queue(std::size_t at);
  bool stale(const Entry& entry) const noexcept;
  void drop_first();
  void drop_stale();

  const Terrain& terrain_;
  Cell goal_, robot_;
  double least_;
  bool squeezes_;
  double moved_ = 0;  // what the robot's moves have taken off the estimates: the paper's k_m
  std::ptrdiff_t step_[8];
  GrowingArray<double> cost_, ahead_;  // the paper's g and rhs
  std::vector<Entry> heap_;            // with entries that hold no more, told by stale()
  std::size_t kept_ = 0;               // entries when these were dropped last
  std::vector<std::uint32_t> touched_;
};

}  // namespace lasius::cost
