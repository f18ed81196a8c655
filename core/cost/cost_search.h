// The cheapest any-angle path over costs, with a lower bound that is proven.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/poller.h"
#include "core/cost/edge_field.h"
#include "core/cost/eight_moves.h"
#include "core/cost/terrain.h"
#include "core/exact/exact_answer.h"
#include "lasius/cost/proof.h"

namespace lasius::cost {

/// What a search answers: as of an exact search, `length` and `lower_bound` being costs.
using CostAnswer = ExactAnswer;

/// A path soon, then in turns a better one and a higher bound. Finer levels, twice as many
/// intervals an edge each, march from either end in turn, only where the level before leaves room
/// for a path better than the best. A level is done when path or time allow no more; the last
/// one by itself has `kMostIntervals`, a target gap asks for more, up to those of CellChords.
class CostSearch {
 public:
  static constexpr int kMostIntervals = 16;

  /// Two free cells that are joined, and where in them it begins and ends, inside of them: as in
  /// [0, 1] x [0, 1]. They may be one, with two points.
  struct Question {
    Cell start, goal;
    Point from = kMiddle, to = kMiddle;
  };
  /// The terrain outlives the call.
  /// @param proof  where it is not null: becomes the levels that prove the lower bound, between
  /// the cells' centres alone
  void search(const Terrain& terrain, const Question& asked, const ExactOptions& options,
              const StopCondition& stop, CostAnswer& answer,
              std::vector<CostProof::Level>* proof = nullptr);
  /// The cheapest walk by eight moves, from centre to centre; `optimal` means of those.
  void search_eight_moves(const Terrain& terrain, Cell start, Cell goal, Corners corners,
                          const StopCondition& stop, CostAnswer& answer);

  /// What a level came to, for benchmarks and tests.
  struct Level {
    int intervals = 0;
    std::int64_t cells = 0;
    int rounds = 0;  ///< of marching
    double lower = 0, upper = 0, excess = 1;
    double seconds = 0;  ///< of the processor, since the search began
  };
  const std::vector<Level>& levels() const noexcept { return levels_; }
  std::int64_t most_bytes() const noexcept { return most_bytes_; }  ///< of the last search

 private:
  class Run;

  EightMoves eight_moves_;
  std::vector<Level> levels_;
  std::int64_t most_bytes_ = 0;
};

}  // namespace lasius::cost
