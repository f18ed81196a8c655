// A closed tour in an array, changed by exchanges of edges that can be undone.
#pragma once

#include <span>
#include <vector>

#include "core/tour/order/costs.h"

namespace lasius::tour {

/// An exchange in hand: edges behind some places are taken out, others put in.
struct Exchange {
  static constexpr int kMostCuts = 8;
  int cuts = 0;
  int cut[kMostCuts];  ///< places, rising: the edge from there to the next is taken out
  std::span<const int> cut_span() const noexcept { return {cut, cut + cuts}; }
  int partner[2 *
              kMostCuts];  ///< of end 2j (at cut j) and 2j + 1 (behind it): what it is joined to
};

class ArrayTour {
 public:
  ArrayTour(const Costs& costs, std::vector<int> order);

  int size() const noexcept { return static_cast<int>(at_.size()); }
  int at(int place) const noexcept { return at_[place]; }
  int place(int stop) const noexcept { return place_[stop]; }
  int next(int stop) const noexcept { return at_[after(place_[stop])]; }
  int previous(int stop) const noexcept { return at_[before(place_[stop])]; }
  int after(int place) const noexcept { return place + 1 == size() ? 0 : place + 1; }
  int before(int place) const noexcept { return place == 0 ? size() - 1 : place - 1; }
  Cost to_next(int stop) const noexcept { return leg_[place_[stop]]; }
  Cost to_previous(int stop) const noexcept { return leg_[before(place_[stop])]; }
  std::int64_t cost() const noexcept { return cost_; }
  const std::vector<int>& order() const noexcept { return at_; }

  /// Does it. Precondition: it leaves one tour. All pieces but the longest are written anew.
  void apply(const Exchange& exchange);
  /// Forgets how to go back to what was.
  void keep() noexcept { log_.clear(); }
  /// Goes back to the tour of the last keep().
  void undo();

 private:
  struct Written {
    int place, stop;
    Cost leg;
  };
  void write(int place, int stop);
  void set_leg(int place);

  const Costs* costs_;
  std::vector<int> at_, place_;
  std::vector<Cost> leg_;  // from a place to the next
  std::int64_t cost_ = 0;
  std::vector<Written> log_;
  std::vector<int> copy_;
};

}  // namespace lasius::tour
