// A colony split into islands: several colonies side by side, in one loop.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/colony/grid_colony.h"
#include "core/colony/rank_talk.h"
#include "core/colony/tour_board.h"

namespace lasius {

/// Params::islands colonies on one bitmap, each with a trail and a share of the ants of its own; an
/// ant has the random numbers that it has in one colony of all ants, since its number is the same.
/// At the beginning of each `exchange_every`-th iteration, the first left out, every island is told
/// the best tour so far of the one before it (of the first, the last), by which its trail learns in
/// that iteration as by one more ant. After the circular exchange of locally best solutions of
/// Middendorf, Reischle & Schmeck: Multi colony ant algorithms. Journal of Heuristics 8, 2002,
/// 305-320; that the tour teaches as an ant does, whatever the update, is ours.
///
/// Islands are sent side by side over threads, an island by one, and over Request::ranks, island i
/// by rank i mod their number; what they find depends on their number and the schedule alone.
class Islands final : public ColonyWorld {
 public:
  /// Islands own, own + count, ... of all.
  struct Part {
    int own = 0, count = 1;
    bool has(int island) const { return island % count == own; }
  };
  /// As GridColony for one run; `params` have more than one island, and an ant for each. `part` of
  /// them alone, the others on other ranks; or with a board, which outlives the object, on this one
  /// thread, with tours of the others by way of that.
  /// @throws Error(invalid_parameter) for ranks that cannot be.
  Islands(const Grid& grid, const Params& params, ColonyMemory& memory, const disc::DiscSpace* disc,
          const cost::Terrain* terrain, Part part, const Ranks* ranks, TourBoard* board);

  Result run(const Request& request, const Observer& observer);
  /// Begins and runs the loop. Why it was cut short, or `none`.
  StopCondition::Cause walk(const Request& request, const Observer& observer, Convergence& run);
  /// The best path of all islands here, which gives it away.
  FoundPath found();
  /// Of islands with a board: what each iteration of `walk` was.
  const std::vector<IterationSums>& course() const { return course_; }

  // What the loop asks for: of all ants, by their numbers.

  /// Their whole iteration, the update too, after which all ranks know what each island found.
  StopCondition::Cause send_ants(int q) override;
  void offer() override {}
  void update_trail(int) override {}
  int ants() const override { return static_cast<int>(places_.size()); }
  int threads() const override { return threads_; }
  double tour_length(int ant) const override { return news_of(ant).length; }
  std::optional<Walked> walked(int ant) const override { return news_of(ant).walked; }
  /// The mean over islands that have a trail.
  double trail_entropy() const override { return entropies().mean(); }
  double best_length() const override;
  double iteration_best() const override;
  /// All islands have.
  bool settled() override;
  /// Shows the island that has the shortest path, of equal ones the first; of ranks the own ones'.
  StopCondition::Cause observe(const Convergence& run) override;

 private:
  struct Island {
    int number;
    Params params;
    GridColony colony;

    Island(int i, const Grid& grid, Params share, ColonyMemory& memory, int first_ant,
           const disc::DiscSpace* disc, const cost::Terrain* terrain)
        : number(i),
          params(std::move(share)),
          colony(grid, params, memory, no_own_rules(), GridColony::After::nothing, disc, terrain,
                 first_ant) {}
  };
  /// What is known of an island after an iteration.
  struct News {
    struct Whole {
      StopCondition::Cause cause = StopCondition::Cause::none;
      int settled = 0;
      double best = kNaN, iteration_best = kNaN, trail_entropy = kNaN, best_tour = kNaN;
    };
    struct OfAnt {
      double length;
      Walked walked;
    };
    Whole whole;
    std::vector<OfAnt> ants;
    std::vector<std::uint8_t> best_tour;  ///< its moves, where an exchange is due
  };
  struct Place {
    int island, ant;
  };

  template <class Do>
  void for_each(const Do& act);
  bool exchange_at(int q) const { return q > 0 && q % params_.exchange_every == 0; }
  void exchange_tours();
  void tell(Island& island, StopCondition::Cause cause, bool with_tour);
  /// Tells the others what this rank is told, and of its islands, and hears of theirs. The first
  /// cause, by rank, for which one is to stop.
  StopCondition::Cause share_news(StopCondition::Cause told);
  IterationSums::Values entropies() const;
  News& news(int island) { return news_[static_cast<std::size_t>(island)]; }
  const News::OfAnt& news_of(int ant) const {
    const Place place = places_[static_cast<std::size_t>(ant)];
    return news_[static_cast<std::size_t>(place.island)].ants[static_cast<std::size_t>(place.ant)];
  }

  const Params& params_;
  const Ranks* ranks_;
  TourBoard* board_;  ///< null: tours are exchanged as scheduled
  int threads_;
  StopCondition stop_;
  std::deque<Island> islands_;  ///< of this rank
  std::vector<News> news_;      ///< of all
  std::vector<Place> places_;   ///< of all ants, with a board of those here
  std::vector<IterationSums> course_;
  GridColony* leader_ = nullptr;
  /// Of ranks: why the own observer stops, which others hear of in the next iteration.
  StopCondition::Cause observed_ = StopCondition::Cause::none;
};

/// Runs a colony of more than one island by its Params::exchange. With ranks that do not wait for
/// one another each has its share of the islands, and there each thread; an observer sees those of
/// one thread, that which calls.
Result run_islands(const Grid& grid, const Request& request, const Params& params,
                   ColonyMemory& memory, const Observer& observer, const disc::DiscSpace* disc,
                   const cost::Terrain* terrain);

}  // namespace lasius
