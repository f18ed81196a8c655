// Exchanges of up to three edges along candidates, all of them, and kicks out of what these cannot
// improve.
#pragma once

#include <vector>

#include "core/base/poller.h"
#include "core/tour/order/array_tour.h"
#include "core/tour/order/candidates.h"
#include "kernels/base/random_stream.h"

namespace lasius::tour {

/// Improves tours. Keeps its memory from tour to tour.
class LocalSearch {
 public:
  static constexpr int kDepth = 3;

  /// Exchanges are of up to `depth` edges, 2 or 3.
  LocalSearch(const Costs& costs, const Candidates& candidates, int depth = kDepth);

  /// Exchanges edges until none of that depth is cheaper, beginning at all stops; false if stopped.
  /// Keeps each: what all wrote would take the memory of hundreds of tours.
  bool improve(ArrayTour& tour, Poller& poller);
  /// So often: lets two segments of up to 30 stops change places, beside one another or on both
  /// sides of a third, at a random place, improves there, and goes back where the tour became
  /// dearer. False if stopped.
  bool kick(ArrayTour& tour, std::int64_t times, kernels::RandomStream& random, Poller& poller);

 private:
  bool run(ArrayTour& tour, Poller& poller, bool keeps);
  bool improve_at(ArrayTour& tour, int stop);
  template <bool kForward>
  bool improve_behind(ArrayTour& tour, int stop);
  void exchange(ArrayTour& tour, int edges);
  void queue(int stop);

  int depth_;
  const Costs* costs_;
  const Candidates* candidates_;
  std::vector<int> waiting_;
  std::vector<char> waits_;
  int t_[2 * kDepth];  // ends of edges that go; between them, and round, those that come
  std::int64_t work_ = 0;
};

/// A tour along the edges that save most of a way by the first stop (Clarke & Wright 1964), which
/// in corridors that branch is a shortest: greedy over the candidates, loose ends joined by the
/// nearest.
std::vector<int> savings_order(const Costs& costs, const Candidates& candidates);
/// A tour that goes on to a candidate by chance, with probability in proportion to 1 / cost^2.
std::vector<int> random_order(const Costs& costs, const Candidates& candidates,
                              kernels::RandomStream& random);

}  // namespace lasius::tour
