// Exact shortest paths of a disc on a bitmap, anytime, with a certificate.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/bucket_queue.h"
#include "core/base/poller.h"
#include "core/disc/disc_answer.h"
#include "core/disc/disc_graph.h"
#include "core/disc/disc_space.h"
#include "core/disc/labels.h"
#include "core/disc/view.h"

namespace lasius::disc {

/// What is paid on top of a path's length for where it goes at its ends.
struct EndPrices {
  std::function<double(Point)> at_start, at_goal;  ///< of the direction away from the end; from 0
  double most = 0;                                 ///< what both may come to
};

/// A* over taut turns. Keeps its memory from search to search. One thread at a time.
///
/// A shortest path of a disc's centre is made of arcs about corners of blocked cells and of lines
/// that touch them: it is taut. A label is a way to an arc, with its length g to where it touches
/// it; to leave it is to turn around the arc, and to go on along a line to what is seen from there
/// (core/disc/view.h). The frontier holds labels by g + h, h the straight distance to the goal. No
/// path is shorter than its least key (lower bound), the first label that sees the goal gives a
/// path (upper bound); where they meet, it is proven shortest. docs/exact.md proves that none is
/// missed.
///
/// The first labels are asked whether they see the goal, then the goal tells which arcs see it.
/// With a graph views are taken from start and goal alone; without, a weighted search over the same
/// labels has a path sooner. Start and goal look as far as a horizon; when the
/// bound has risen to it, farther.
class DiscSearch {
 public:
  /// Plans between two clear points. Deterministic, except for when it is stopped.
  /// @param graph  of this space; null: none
  void search(const DiscSpace& space, const DiscGraph* graph, Point start, Point goal,
              const ExactOptions& options, const StopCondition& stop, DiscAnswer& answer);

  /// No taut path, shortest or not, has less length and prices at its ends together, of two clear
  /// points that do not see each other; of those that do their distance is told. Stopped: less.
  /// Paths through gaps of just the disc's width, where left and right turns are one, may have.
  double least(const DiscSpace& space, Point start, Point goal, const EndPrices& prices,
               double target_gap, const StopCondition& stop);

  std::int64_t bytes() const noexcept;

 private:
  static constexpr int kMostScans = 4;
  struct Sink;
  struct GoalSink;
  // Where an arc is left straight for the goal, by arc and turn.
  struct Exit {
    std::uint32_t stamp = 0;
    bool free = false;  // the line was looked along
    Normal normal;
    double angle, length;
  };

  /// Why it was cut short, by the poller or by who looks on, or none.
  StopCondition::Cause run(const ExactOptions& options, Poller& poller);
  void search_weighted(std::int64_t steps, Poller& poller);
  bool next_label(std::uint32_t& number, Poller& poller);
  bool look_as_far_as(double length, Poller& poller);
  void expand(std::uint32_t number);
  bool leave(std::uint32_t number);
  bool leave_start();
  bool leads_to_goal(std::uint32_t number, const Root& root);
  bool meets_goal(std::uint32_t number, const Root& root);
  bool follow(std::uint32_t number);
  bool exits(std::uint32_t number);
  void look_from_goal();
  bool reached(std::uint32_t number);
  bool dominated(const Label& label, std::uint32_t number = ~std::uint32_t{0});
  bool matters(std::uint32_t number);
  double ahead(int scans) const noexcept;
  bool tell_improvement(const Poller* poller);

  const DiscSpace* space_ = nullptr;  // these of the call in hand
  const DiscGraph* graph_ = nullptr;
  const EndPrices* prices_ = nullptr;
  Poller* poller_ = nullptr;
  Point start_, goal_;
  std::uint32_t in_hand_ = 0;  // the label whose view is taken
  Point leaves_;               // where its first ray does
  double horizon_ = 0;         // paths over it that are longer do not matter yet
  double straight_ = 0;
  double lower_ = 0, upper_ = 0;  // upper: length of the best path
  std::uint32_t last_ = 0;        // its last label
  Normal last_normal_;            // where it leaves that
  double goal_horizon_ = 0;       // longer paths may have exits that are not known yet
  int goal_looks_ = 0;
  std::uint32_t exit_stamp_ = 0;
  std::vector<Exit> exits_;
  bool weighted_on_ = false;  // until there is a path
  bool weighing_ = false;     // the weighted search expands
  exact::Improvements improvements_;
  Labels labels_;
  BucketQueue frontier_, weighted_frontier_;
  ViewMemory view_;
  std::int64_t expansions_ = 0;
};

}  // namespace lasius::disc
