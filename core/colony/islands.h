// A colony split into islands: several colonies side by side, in one loop.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "core/colony/grid_colony.h"

namespace lasius {

/// Params::islands colonies on one bitmap, each with a trail and a share of the ants of its own; an
/// ant has the random numbers that it has in one colony of all ants, since its number is the same.
/// At the beginning of each `exchange_every`-th iteration, the first left out, every island is told
/// the best tour so far of the one before it (of the first, the last), by which its trail learns in
/// that iteration as by one more ant. After the circular exchange of locally best solutions of
/// Middendorf, Reischle & Schmeck: Multi colony ant algorithms. Journal of Heuristics 8, 2002,
/// 305-320; that the tour teaches as an ant does, whatever the update, is ours.
///
/// Islands are sent side by side over threads, an island by one; what they find depends on their
/// number and the schedule alone.
class Islands final : public ColonyWorld {
 public:
  /// As GridColony for one run; `params` have more than one island, and an ant for each.
  Islands(const Grid& grid, const Params& params, ColonyMemory& memory, const disc::DiscSpace* disc,
          const cost::Terrain* terrain);

  Result run(const Request& request, const Observer& observer);

  // What the loop asks for: of all ants, by their numbers.
  StopCondition::Cause send_ants(int q) override;
  void offer() override;
  void offer_cut() override;
  void update_trail(int q) override;
  int ants() const override { return params_.ants; }
  int threads() const override { return threads_; }
  double tour_length(int ant) const override;
  std::optional<Walked> walked(int ant) const override;
  /// The mean over islands that have a trail.
  double trail_entropy() const override;
  double best_length() const override { return leader_->best_length(); }
  double iteration_best() const override;
  /// All islands have.
  bool settled() const override;
  /// Shows the island that has the shortest path, of equal ones the first.
  StopCondition::Cause observe(const Convergence& run) override;

 private:
  struct Island {
    Params params;
    GridColony colony;
    StopCondition::Cause cause = StopCondition::Cause::none;

    Island(const Grid& grid, Params share, ColonyMemory& memory, int first_ant,
           const disc::DiscSpace* disc, const cost::Terrain* terrain)
        : params(std::move(share)),
          colony(grid, params, memory, no_own_rules(), GridColony::After::nothing, disc, terrain,
                 first_ant) {}
  };
  struct Place {
    const GridColony* colony;
    int ant;
  };

  template <class Do>
  void for_each(const Do& act);
  void exchange_tours();

  const Params& params_;
  int threads_;
  std::deque<Island> islands_;
  std::vector<Place> places_;  ///< of all ants
  GridColony* leader_ = nullptr;
};

}  // namespace lasius
