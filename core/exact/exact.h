// Exact Euclidean shortest paths on a bitmap, anytime, with a certificate.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/bucket_queue.h"
#include "core/base/poller.h"
#include "core/exact/exact_answer.h"
#include "core/exact/exact_corner_table.h"
#include "core/exact/taut_row.h"
#include "core/grid/cell_set.h"
#include "kernels/sight/scan_cone.h"
#include "lasius/base/stop.h"
#include "lasius/grid/grid.h"

namespace lasius {

namespace exact {
/// Buckets of a weighted frontier from the least key to the greatest that is wanted.
constexpr double kTrailBuckets = 1024;
/// Lines from a root to where its scan asks for limits: doubled after a scan that they did not cut.
constexpr int kLeastNear = 12, kMostNear = 96;

/// Corners that are looked at for whether they are barren, and more for each that is.
constexpr int kFirstBarrenTests = 64, kTestsForBarren = 8;

/// Expansions until the way in hand is looked at for ties.
constexpr std::int64_t kFirstLook = 64;

/// Ways from here on, in cells, are so long that a path is looked for before the proof.
constexpr double kLongWay = 2048;

/// Ways whose lengths differ by less of themselves may be equally long but for rounding.
constexpr double kAlike = 1e-11;
/// Is a length beyond another by more than that?
constexpr bool beyond(double length, double other) noexcept {
  return length > other * (1 + kAlike);
}

/// What a search did, for benchmarks and tests.
struct Counters {
  std::int64_t expansions = 0;
  std::int64_t words = 0;  ///< rows of intervals, and windows of wide ones
  /// Whether another path may be as short, where that was looked for.
  enum class Ties { unknown, none, some } ties = Ties::unknown;
};
}  // namespace exact

/// A* over taut corners. Keeps its memory from search to search: a second one of the same size does
/// not allocate. Nothing in it grows with the map. One thread at a time.
///
/// A shortest path bends only at corners of blocked cells, and only around them. Each corner is
/// reached with the best known length g; its cone, the directions in which a path can go on and
/// still be taut, is scanned for the corners seen in it (kernels/sight/scan_cone.h). The frontier
/// holds corners by g + h, h the straight distance to the goal. No path is shorter than its least
/// key (lower bound), and a weighted search gives a path (upper bound); where the two meet, it is
/// proven shortest.
///
/// The weighted search expands corners, too, but in the order of g + W h, best first: weighted A*
/// (Pohl 1970) beside A*, as in anytime weighted A* (Hansen & Zhou 2007). It has a frontier of its
/// own, of the corners that were not expanded yet, and runs for some expansions now and then until
/// it sees the goal; all corners that it sees enter both queues. With a target gap it begins as the
/// bounding search: W is almost 1 plus that gap, and corners are taken up again when a shorter way
/// to them is found. Then its least key is at most W times the optimum: of a shortest path, the
/// first corner w that was not expanded at its least length waits with
/// g + W h <= W (g + h) <= W optimum. (Behind a horizon H <= optimum it waits as its parent v, with
/// key H + (W - 1) h(v).) So that key divided by W is a lower bound, and the first path is within
/// the gap. Where no path is found soon, W is set back to its default, 1.2.
///
/// Why no shortest path is missed. Let v, w follow each other on one, v reached at its least
/// length. The scan of v's cone leaves w out only where
///   * w is outside the taut cone: then the path could be pulled shorter at v;
///   * a known way to w, or to a point between v and w, is shorter than the one over v (rivals);
///   * every path over v and w is at least as long as the best one known (the ellipse of limits());
///   * w is behind the horizon: then v stays in the queues, with a key that no path over v and
///     what lies behind the horizon is shorter than.
/// The first two cannot be on a shortest path; the third cannot improve the answer; the fourth is
/// only put off. Ties do no harm: two shortest ways to v see the same w, else one of them could be
/// pulled shorter than the optimum. Lengths are compared as computed, so the answer is the optimum
/// up to exact::kRounding.
///
/// Where no gap is asked for and nobody looks on, a search without the weighted one goes first, and
/// leaves out corners in whose cone there is neither goal nor corner (barren): no shortest path
/// bends there. Of several shortest paths it may meet another one, so it notes ways as long as the
/// one kept, and its path counts only where there is none: then any search finds that path.
///
/// Start and goal may be any points. A corner's cone is scanned from the corner, a lattice point;
/// of what it came from only the cone's one edge tells, a slope. Where that is no lattice direction
/// the scan may take a corner less than kernels::kSlack outside of the cone for one in it, which
/// does no harm, and misses none: in a sliver so thin there is no lattice point beside a ray
/// through another one. The goal is asked for by exact sight; what a start sees that is no centre,
/// too.
class ExactSearch {
 public:
  /// Plans from one point to another, both inside `grid` and each of a free cell, its border
  /// included. Deterministic, except for when it is stopped.
  void search(const Grid& grid, Point start, Point goal, const ExactOptions& options,
              const StopCondition& stop, ExactAnswer& answer);

  /// A taut path between the centres of two free cells that is shorter than `length`, which is
  /// finite, and bends only at corners that one of `cells` touches; empty where none was found. A
  /// shortest path of all is found if all corners that it meets are touched. Most others are, too;
  /// but what leaves no shortest path out, see above, may leave out one of them. Ends early, with
  /// the shortest one found so far or none, after about so much `work` (words scanned, and
  /// exact::kWordsPerExpansion for each corner) and when stopped. Deterministic but for that.
  void shortcut(const Grid& grid, Cell start, Cell goal, double length, const CellSet& cells,
                std::int64_t work, const StopCondition& stop, std::vector<Point>& path);

  /// The corners around a point over which ways to another may be shorter than `bound`, with their
  /// shortest ways; of those of one length some one. Returns true if stopped: then there are fewer.
  bool row(const Grid& grid, Point from, Point to, double bound, const StopCondition& stop,
           exact::TautRow& row);

  /// Begins a search for some path soon and shorter ones after it, for improve(): anytime repairing
  /// A* (ARA*; Likhachev, Gordon & Thrun 2003). Neither end sees the other.
  void begin_improving(const Grid& grid, Point start, Point goal);
  /// Goes on for about so much `work`, as in shortcut(), or until stopped. False when nothing is
  /// left to do: the path is within a hundredth of the optimum, or there is none, or it was
  /// stopped.
  bool improve(std::int64_t work, Poller& poller);
  /// What came of it so far: the length of the best path, infinite without one, a length that no
  /// path is shorter than, and the path.
  double upper() const noexcept { return upper_; }
  double lower() const noexcept { return lower_; }
  void trace(std::vector<Point>& path) const;

  const exact::Counters& counters() const noexcept { return counters_; }
  std::int64_t bytes() const noexcept;

 private:
  template <int S>
  struct Visitor;
  // A place in half cells, and the length of the path to it.
  struct Root {
    std::uint32_t index;
    kernels::HalfPoint at;  // of a start that is neither corner nor centre the nearest
    double x, y;
    double length;
  };

  // What the search in hand is for, and by which frontiers it goes.
  enum class Mode : std::uint8_t {
    plain,      // A*
    row,        // A* over all corners within a bound: the goal ends no way
    only,       // A* for the only shortest path: ways as long as the one kept are noted
    bounded,    // A* with a path of the bounding search
    weighted,   // A*, and the weighted search now and then, until it sees the goal
    bounding,   // the weighted search, as one that gives a lower bound
    improving,  // a bounding search whose weight falls; there is no A* beside it
  };
  // Does the weighted search go on?
  bool weighs() const noexcept { return mode_ >= Mode::weighted; }

  void begin(const Grid& grid, Point start, Point goal, Mode mode);
  kernels::FinePoint place(std::uint32_t index) const noexcept;
  void search_weighted(std::int64_t steps);
  void restore_default_weight();
  void run(const ExactOptions& options, const StopCondition& stop);
  void run_plain(const StopCondition& stop, std::int64_t work, exact::Anytime* beside = nullptr);
  bool search_only(const ExactOptions& options, const StopCondition& stop);
  bool is_only(std::uint32_t index) const noexcept;
  bool given_up(std::uint32_t index) noexcept;
  bool next_corner(std::uint32_t& index);
  void step(std::uint32_t index);
  void expand(std::uint32_t index);
  /// Scans the cone of a corner up to the horizon; returns whether rays were cut off there.
  bool scan_cone(std::uint32_t index);
  bool scan_around_start();
  void look_around_start();
  template <int S>
  bool scan_around_start(int down);
  template <int S>
  bool scan_cone(std::uint32_t index);
  template <int S>
  bool goal_in_cone(const exact::Corner& corner) const noexcept;
  template <int S>
  kernels::ConeLimits limits(int down, int line0) const noexcept;
  double reach(int x, int y, exact::Heading heading);
  bool is_barren(int x, int y, exact::Heading heading) noexcept;
  template <int S>
  bool is_barren_towards(int x, int y, exact::Heading heading) const noexcept;
  // Is no path of this length wanted?
  bool too_long(double length) const noexcept {
    return mode_ == Mode::only ? exact::beyond(length, upper_) : length >= upper_;
  }
  bool in_line(std::uint32_t a, std::uint32_t b, kernels::FinePoint at) const noexcept;
  void note_tie(exact::Corner& corner, std::uint32_t parent, exact::Heading heading) noexcept;
  void offer_goal(std::uint32_t index) noexcept;
  bool learn_limits(bool asked, bool cut_off) noexcept;
  std::int64_t work_done() const noexcept {
    return counters_.words + counters_.expansions * exact::kWordsPerExpansion;
  }
  bool lower_weight();
  bool tell_improvement();

  kernels::BitmapView map_{};
  exact::QueryEnd start_, goal_;
  Root root_{};             // of the cone in hand
  double horizon_ = 0;      // paths over the root that are longer do not matter yet
  double upper_ = 0;        // length of the best path
  std::uint32_t last_ = 0;  // its last corner
  double lower_ = 0;
  double straight_ = 0;               // distance from start to goal
  const CellSet* touched_ = nullptr;  // where paths may bend; null: everywhere
  Poller* poller_ = nullptr;          // of the call in hand
  exact::Anytime* beside_ = nullptr;  // of the search in hand, or null
  exact::Improvements improvements_;
  StopCondition::Cause cause_ = StopCondition::Cause::none;

  exact::CornerTable corners_;
  BucketQueue frontier_;
  BucketQueue weighted_frontier_;
  Mode mode_ = Mode::plain;
  double weight_ = 1;
  std::vector<kernels::Interval> stack_;
  int near_lines_ = exact::kLeastNear;  // to where scans ask for limits
  int barren_tests_ = 0;                // that are still worth their time
  struct Ties {
    std::int64_t noted = 0;
    std::int64_t next_look = exact::kFirstLook;  // for one on the way in hand
    bool at_goal = false;                        // another way to it is as short as the best
    bool in_vain = false;                        // the search for the only path was given up
  } ties_;
  int rest_ = 0, pause_ = 0;  // searches until that is tried again, and after a failure
  exact::Counters counters_;
};

}  // namespace lasius
