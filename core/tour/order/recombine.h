// Edge assembly (Nagata & Kobayashi 2013): a tour that takes over a circuit of another's edges.
#pragma once

#include <utility>
#include <vector>

#include "core/base/poller.h"
#include "core/tour/order/array_tour.h"
#include "core/tour/order/candidates.h"
#include "kernels/base/random_stream.h"

namespace lasius::tour {

/// Keeps its memory from pair to pair.
class Recombiner {
 public:
  Recombiner(const Costs& costs, const Candidates& candidates);

  /// Parts the edges in which two tours differ into circuits of an edge of `a`, one of `b`, and so
  /// on, drawn by chance; exchanges in `a` those of one circuit, up to 30 circuits singly, and
  /// joins what falls apart by the cheapest exchange of two edges along candidates. The cheapest
  /// tour that is cheaper than `a` replaces it; false where there is none.
  bool improve(ArrayTour& a, const ArrayTour& b, kernels::RandomStream& random, Poller& poller);

 private:
  using Circuit = std::vector<int>;  // stops; an edge of `a` from the first, one of `b`, ...
  void part(const ArrayTour& a, const ArrayTour& b, kernels::RandomStream& random);
  bool build(const ArrayTour& a, const Circuit& circuit, std::int64_t& change);
  bool join_parts(const ArrayTour& a, std::int64_t& change);
  void replace(int stop, int from, int to);
  void restore(const ArrayTour& a);
  int part_of(const ArrayTour& a, int stop) const;

  const Costs* costs_;
  const Candidates* candidates_;
  std::vector<std::pair<int, int>> sides_;  // neighbours of each stop in the tour in hand
  std::vector<int> touched_;
  std::vector<Circuit> circuits_;
  std::vector<int> cuts_, part_, size_;  // of the pieces of `a` between its cuts
  std::vector<int> left_a_[2], left_b_[2];
  std::vector<int> even_, odd_;
};

}  // namespace lasius::tour
