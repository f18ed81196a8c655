// All planners on the same queries in one run.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "bench/peers/peers.h"
#include "bench/query_set.h"

namespace lasius::bench {

/// How often, and for how long.
struct ComparisonOptions {
  int rounds = 5;       ///< each planner answers all queries of a map this often
  double seconds = 20;  ///< a planner that spent this on a map starts no further round there
};

/// One planner on one query.
struct Measurement {
  double microseconds = 0;  ///< median over the rounds
  double length = 0;
  int rounds = 0;
  std::string fault;  ///< why the path is wrong; empty if it is right
};

/// One planner on one map.
struct PlannerRun {
  double preparation_ms = 0;
  double prepared_bytes = 0;  ///< not a number where the planner does not count
  std::vector<Measurement> queries;
  double mean_microseconds() const;
  double median_microseconds() const;
};

/// One map: the planners' runs in the order given, and the best known optimum of each query.
struct MapComparison {
  std::string name;
  std::vector<double> optima;
  std::vector<PlannerRun> planners;
  /// Mean of (length - optimum) / optimum of a planner over the queries, as a fraction.
  double mean_gap(std::size_t planner) const;
};

/// Runs the planners one after another over all queries, round after round, the order turned by one
/// each time, on this thread. Paths are checked outside the timed part; an exact planner's length
/// is the optimum of queries that came without one, and is checked against the others.
MapComparison compare(const QuerySet& set, std::span<const peers::Peer> planners,
                      const ComparisonOptions& options);

}  // namespace lasius::bench
