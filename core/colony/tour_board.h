// Where islands that do not wait for one another leave their tours.
#pragma once

#include <atomic>
#include <mutex>
#include <thread>

#include "core/colony/best_tour.h"
#include "core/colony/grid_colony.h"
#include "lasius/base/stop.h"
#include "lasius/plan/request.h"

namespace lasius {

/// The best tour that has arrived so far, of the islands of this process and by way of
/// Ranks::pass of the others', and why the search is to end. Any thread may use it.
class TourBoard {
 public:
  /// Ranks may be null. The thread that makes it is the one that talks to them.
  explicit TourBoard(const Ranks* ranks) : ranks_(ranks) {}

  void offer(const Tour& tour);
  /// Shows it to a colony whose own is longer.
  void teach(GridColony& colony);
  /// Ends the search of all for this cause, where it is the first.
  void stop(StopCondition::Cause cause);
  /// Why it is to end, or `none`. To be asked once an iteration: on the thread that talks it passes
  /// on what others do not know, and hears what has arrived.
  StopCondition::Cause poll();

 private:
  void talk();

  const Ranks* ranks_;
  std::thread::id talks_ = std::this_thread::get_id();
  std::mutex mutex_;
  BestTour best_;
  double passed_on_ = kInfinity;  ///< length of the best tour that others know
  StopCondition::Cause told_ = StopCondition::Cause::none;  ///< that others know
  std::atomic<StopCondition::Cause> cause_ = StopCondition::Cause::none;
};

}  // namespace lasius
