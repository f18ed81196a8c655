// What a planner on a bitmap is asked.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lasius/base/stop.h"
#include "lasius/grid/geometry.h"

namespace lasius {

/// Processes that send the islands of one colony (Params::islands) together. All ask the same of
/// the same map; each sends a share of the islands and gets the whole answer, that of one process.
/// Where one of them is told to stop, all end; an observer is shown the islands of its own process.
struct Ranks {
  int own = 0;    ///< the number of this process, from 0, below `count`
  int count = 1;  ///< of processes, 1 or more
  /// Hands in what this one has, and gets what each has handed in, `count` by number; empty: it has
  /// ended, which is as if its deadline had passed. Called by the thread that plans, once an
  /// iteration and once at the end; of Exchange::asynchronous at the beginning and the end alone.
  /// What it throws ends the call.
  std::function<std::vector<std::string>(std::string)> gather = {};
  /// Of Exchange::asynchronous: tells all others a text, if it is not empty, and gets those that
  /// have arrived from them, without waiting for any; an empty one: a process has ended, which is
  /// as if its deadline had passed. What was told before a gather is not heard after it. Called by
  /// the thread that plans, once an iteration. What it throws ends the call.
  std::function<std::vector<std::string>(std::string)> pass = {};
};

/// What is asked of a planner.
struct Request {
  Cell start = {};          ///< the path begins at its centre
  Cell goal = {};           ///< and ends at the centre of this one
  StopCondition stop = {};  ///< when to end with the best path so far
  /// Stop at this certified gap, as a fraction, 0 or more; above 0 only for algorithms that certify
  /// one (Algorithm::Kind::exact).
  double target_gap = 0;
  /// Where the goal cannot be reached, the path ends at the nearest centre of a cell that can be,
  /// at most so far from it, in cells, ties to the smaller row, then column. For a disc, by
  /// `exact`, at the nearest point. 0 or more.
  double goal_tolerance = 0;
  /// Where the path begins and ends, in place of a cell's centre, which is not looked at then: any
  /// points of the map, on a free cell or its border. A centre is the same as its cell.
  std::optional<Point> start_point = {};
  std::optional<Point> goal_point = {};  ///< likewise
  /// Points that the path goes through on its way, in this order: it is planned from each to the
  /// next, and joined. A goal tolerance is of the goal alone, a target gap of every leg.
  std::vector<Point> via = {};
  static constexpr int kMostAlternatives = 100;  ///< of one request
  /// Of `exact` for a point, without a target gap and points on the way: so many other ways are
  /// wanted as well, see Result::alternatives. At most kMostAlternatives.
  int alternatives = 0;
  const Ranks* ranks = nullptr;  ///< null: this process alone
};

}  // namespace lasius
