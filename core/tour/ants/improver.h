// What improves the tours of ants.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/poller.h"
#include "core/tour/order/local_search.h"
#include "core/tour/order/one_more.h"
#include "core/tour/order/path_exchange.h"
#include "lasius/tour/ants.h"

namespace lasius::tour {

/// Local search of whole tours, a thread's at a time. Edges are exchanged of symmetric costs alone,
/// of 8 stops or more whose order is not given; pieces of more than 3 stops whatever is given, and
/// a tour begins at the start then. Holds neither costs nor order.
class Improver {
 public:
  /// For exchanges of pieces a closed tour has a start.
  Improver(const Costs& costs, const Ends& ends, const PartialOrder& given, Improvement kind,
           bool symmetric, int threads, const StopCondition& stop);

  bool improves() const noexcept { return local_ || path_; }
  bool keeps_start() const noexcept { return path_.has_value(); }
  /// A cheaper order of the same ends, or this one. With `best` exchanges of pieces are sought only
  /// where the order differs from that one. Once the poller stops, what there is by then.
  std::vector<int> improved(std::vector<int> order, std::span<const int> best, int thread,
                            Poller& poller);

 private:
  void wake_differences(PathExchange& exchange, std::span<const int> best) const;

  const int edges_;
  std::optional<OneMore> more_;  // of open tours
  std::optional<Costs> local_;   // of the closed ones that are improved by edges
  std::optional<Candidates> candidates_;
  std::optional<StopPath> path_;
  std::vector<PathExchange> exchanges_;  // one a thread
};

}  // namespace lasius::tour
