// Exact Euclidean shortest paths on a map whose corners know what they see.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/base/bucket_queue.h"
#include "core/base/large_array.h"
#include "core/base/poller.h"
#include "core/exact/corner_graph.h"
#include "core/exact/exact_answer.h"
#include "core/exact/query_end.h"
#include "core/exact/taut_row.h"
#include "kernels/sight/scan_cone.h"
#include "kernels/sight/sight.h"

namespace lasius::exact {

/// A* over the stored edges of a CornerGraph. Only what start and goal see is scanned. Keeps its
/// memory from search to search: 32 bytes for each corner of the graph, mapped where searches go.
/// One thread at a time.
///
/// Each corner keeps the least known length and the edge that it came by, and goes on along those
/// of its edges with which the path bends around its block: they are the first ones of the side
/// across from the parent, in the order of the turn. That loses no shortest path. Let v, w follow
/// each other on one, v reached at its least length. If the kept way to v is another one of that
/// length, going on to w is as short, hence a shortest path too, hence taut: w is among the edges
/// followed. Lengths are compared as computed; the answer is the optimum up to kRounding.
///
/// The estimate of what is left to go is the straight distance or the bound by landmarks, whichever
/// is more. Neither exceeds the true distance, so that while no path is proven shortest, a corner
/// of a shortest path waits in the frontier at its least length with a key of at most the optimum:
/// the least key is a lower bound. A corner that is reached by a shorter way later waits again.
///
/// Where paths of the map seldom leave the straight line, a search keeps to a horizon first: a path
/// over p is no longer than it only if |start p| + |p goal| is not, so all such paths lie in that
/// ellipse. Elsewhere the first few corners are asked whether they see the goal, before the goal's
/// view is scanned. Where that does not end it, the search sets out again.
class PreparedSearch {
 public:
  /// Plans from one point to another, both inside `grid`, whose graph this is, and each of a free
  /// cell, its border included. Deterministic, except for when it is stopped.
  void search(const Grid& grid, const CornerGraph& graph, Point start, Point goal,
              const ExactOptions& options, const StopCondition& stop, ExactAnswer& answer);

  /// The same where the shortest path is the only one, up to kAlike of its length: then it is that
  /// of any other exact search, bit for bit. False where another one may be as short, where there
  /// is none, and when stopped.
  bool search_only(const Grid& grid, const CornerGraph& graph, Point start, Point goal,
                   const StopCondition& stop, ExactAnswer& answer);
  /// Ways that differ by less of their length count as equal there: far more than rounding does.
  static constexpr double kAlike = 1e-11;

  /// The lengths of the shortest ways over edges of the graph, taut or not, from the centre of a
  /// free cell to all corners, each edge rounded down to grains; infinite where there is none.
  /// Returns true if stopped.
  bool flood(const Grid& grid, const CornerGraph& graph, Cell start, double grain,
             const StopCondition& stop, std::vector<double>& lengths);

  /// A place, and the corners at which a shortest path to it may turn last.
  struct Target {
    QueryEnd at;
    std::vector<std::uint32_t> corners = {};
  };
  /// A point of a free cell or its border as a target. Returns true if stopped.
  bool view(const Grid& grid, const CornerGraph& graph, Point point, const StopCondition& stop,
            Target& target);
  /// The lengths of shortest paths from such a point to targets, by one search of all corners that
  /// are nearer than `limit`; infinite where there is none that is shorter. Returns true if
  /// stopped.
  bool lengths_to(const Grid& grid, const CornerGraph& graph, Point start,
                  std::span<const Target> targets, const StopCondition& stop,
                  std::span<double> lengths,
                  double limit = std::numeric_limits<double>::infinity());

  /// As ExactSearch::row.
  bool row(const Grid& grid, const CornerGraph& graph, Point from, Point to, double bound,
           const StopCondition& stop, TautRow& row);

  std::int64_t bytes() const noexcept;  ///< memory held

 private:
  // Of a corner. Only those with the search's own stamp mean anything.
  struct Node {
    double length;
    double to_goal;  // estimate
    std::uint32_t parent;
    std::uint32_t stamp;
    Side side;  // on which to go on
    bool sees_goal;
    bool expanded;
    bool listed;  // among what may be part of a path as short as the best
  };
  static_assert(sizeof(Node) == 32);
  static constexpr std::uint32_t kStart = ~std::uint32_t{0};  // as a parent
  // How much longer than straight a path may be for a search to keep near the straight line at
  // first.
  static constexpr double kMostDetour = 1.01;
  static constexpr std::int64_t kNoBudget = std::numeric_limits<std::int64_t>::max();
  // Work of an expansion beside its edges, in words as scans count them.
  static constexpr std::int64_t kWordsPerNode = 4;
  enum class Mode {
    first_few,  // corners are asked whether they see the goal; straight estimates
    near_line,  // corners that the goal sees are known; up to the horizon; straight estimates
    whole_map,  // corners that the goal sees are known; the whole map; estimates by landmarks, too
    flood,      // there is no goal; edges are rounded, taut or not
    all,        // there is no goal; as towards one
    row,        // the goal ends no way; up to a bound
  };
  // The corner in hand: a lattice point, and the length of the path to it.
  struct Root {
    int x, y;
    double length;
  };

  template <class Found>
  struct Sink;
  void begin(const Grid& grid, const CornerGraph& graph, Point start, Point goal, Mode mode,
             Poller& poller);
  bool search_near(double target_gap);
  bool search_few(double target_gap);
  bool search_whole_map(double target_gap);
  void scan_goal_view();
  void scan_start_view();
  void restart();
  void reach_all(double limit);
  void reach_start_corners();
  void measure_landmarks();
  bool run(double target_gap, std::int64_t budget);
  bool reach_goal_from(std::uint32_t index);
  std::int64_t expand(std::uint32_t index);
  std::int64_t expand_all(std::uint32_t index);
  void follow(std::uint32_t index, const Root& root, const GraphEdge& edge);
  bool too_long(double length, int x, int y) const noexcept;
  bool next_corner(std::uint32_t& index);
  double estimate(std::uint32_t index, int x, int y) const noexcept;
  void reach(std::uint32_t parent, double length, std::uint32_t index, int x, int y, Side side);
  template <class Found>
  void scan_view(const QueryEnd& end, const QueryEnd& other, const Found& found);
  kernels::FinePoint place(std::uint32_t index) const noexcept;
  void trace(std::vector<Point>& path) const;
  bool tell_improvement();
  // What is this long or longer does not matter.
  double longest() const noexcept { return upper_ * (1 + margin_); }
  bool alike(double length, double other) const noexcept;
  void note_way(std::uint32_t to, std::uint32_t from);
  bool is_only();
  void list_ways_to(std::size_t step);
  void list_step(std::uint32_t corner, std::size_t leg);
  bool on_leg(std::size_t leg, std::uint32_t corner) const noexcept;

  kernels::BitmapView map_{};
  const CornerGraph* graph_ = nullptr;
  Poller* poller_ = nullptr;   // of the call in hand
  Anytime* beside_ = nullptr;  // of the search in hand, or null
  Improvements improvements_;
  bool told_to_stop_ = false;  // by who looks on
  QueryEnd start_, goal_;
  Mode mode_ = Mode::first_few;
  double straight_ = 0;  // distance from start to goal
  double horizon_ = 0;   // paths that are longer do not matter yet
  double grain_ = 0;     // of a flood
  double lower_ = 0;
  double upper_ = 0;        // length of the best path
  std::uint32_t last_ = 0;  // its last corner
  Landmarks::Goal goal_distances_;

  ZeroArray<Node> nodes_;
  std::uint32_t nodes_size_ = 0;
  std::uint32_t stamp_ = 0;
  std::vector<std::uint32_t> start_corners_, goal_corners_;  // in their sight
  BucketQueue frontier_;
  std::vector<kernels::Interval> stack_;

  // Another way to a corner, about as short as the one kept when it was found.
  struct Way {
    std::uint32_t to, from;
    std::uint32_t next;  // of the same corner
  };
  double margin_ = 0;  // of the best length: what is that much longer is looked at as well
  std::vector<Way> ways_;
  ZeroArray<std::uint32_t> last_way_;  // by corner; means something where that way leads there
  std::uint32_t last_ways_ = 0;        // how many
  std::vector<std::uint32_t> way_;     // the best path's corners, from the goal; kStart the last
  struct Step {
    std::uint32_t corner;
    std::size_t leg;  // of the best path: leg k ends at way_[k]
  };
  std::vector<Step> steps_;
};

}  // namespace lasius::exact
