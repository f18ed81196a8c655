// Exact Euclidean shortest paths on a map whose corners have hub labels.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/exact/corner_graph.h"
#include "core/exact/exact_answer.h"
#include "core/exact/labels/corner_labels.h"

namespace lasius::exact {

/// Merges labels of the corners that start and goal see. Keeps its memory, 12 bytes a corner, from
/// query to query. One thread at a time.
///
/// A shortest path is straight, or s c1 ... ck g, where s sees c1 and g sees ck. The corner of the
/// highest rank of c1 ... ck is a hub of c1 and of ck at its true distance, see find_hubs(), so the
/// least sum over common hubs of corners in sight is the length. At c1 the path goes on tautly, and
/// so does any other way of that length from c1 to the hub: its group is among the first ones of
/// its side.
class LabelSearch {
 public:
  /// Plans between two points, each of a free cell, its border included. False where labels do not
  /// tell: no common hub, or stopped while it looked around from an end that is no centre.
  bool search(const Grid& grid, const CornerGraph& graph, const CornerLabels& labels, Point start,
              Point goal, const ExactOptions& options, const StopCondition& stop,
              ExactAnswer& answer);
  /// Entries that an end reaches over one corner.
  struct Block {
    std::uint32_t first, last;
    std::uint32_t corner;
    double before;  ///< length from the end to the corner
  };
  /// What a point of a free cell sees, and all entries behind that.
  struct View {
    QueryEnd at;
    std::vector<Block> blocks;
    std::int64_t entries = 0;
    std::vector<std::uint32_t> dead = {};  ///< corners at which a path can only end
  };
  /// Incomplete when stopped.
  View view(const Grid& grid, const CornerGraph& graph, const CornerLabels& labels, Point place,
            const StopCondition& stop);
  /// The lengths of shortest paths from one place to others, a merge each; infinite where there is
  /// none. All views are of this map.
  void lengths_to(const Grid& grid, const CornerGraph& graph, const CornerLabels& labels,
                  const View& start, std::span<const View> targets, std::span<double> lengths);

  std::int64_t bytes() const noexcept;  ///< memory held

 private:
  using End = View;
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  // A way from an end to a hub: over its corner, and from there by an entry.
  struct Chain {
    std::uint32_t corner, entry;
    double length;
  };

  bool find(const Grid& grid, const CornerGraph& graph, const CornerLabels& labels, Point start,
            Point goal, const StopCondition& stop);
  void begin(const CornerGraph& graph, const CornerLabels& labels);
  template <class Dead>
  bool gather(const kernels::BitmapView& map, End& end, Poller& poller, const Dead& dead);
  void add(const TileCorner& seen, End& end) const;
  void add(const SeenCorner& seen, End& end) const;
  template <class Turn>
  void add_taut(std::uint32_t corner, Side side, int bend, double before, const Turn& turn,
                End& end) const;
  void write_path(const ExactOptions& options, ExactAnswer& answer);
  void scatter(const End& end);
  void clear(const End& end);
  void merge(const End& from, const End& to);
  Chain best_chain(const End& end) const;
  void follow(const Chain& chain, std::vector<std::uint32_t>& corners) const;
  void join(const Chain& from_start, const Chain& from_goal);
  void outline(std::vector<Point>& path) const;
  double distance_to(const End& end, std::uint32_t corner) const noexcept;

  const CornerGraph* graph_ = nullptr;
  const CornerLabels* labels_ = nullptr;
  const LabelArrays* arrays_ = nullptr;
  std::vector<double> lengths_;       // by rank, from the end that was scattered
  std::vector<std::uint32_t> marks_;  // by corner, of those that the start sees
  std::uint32_t stamp_ = 0;
  End start_, goal_;
  std::vector<std::uint32_t> corners_, more_;
  double best_ = 0;                  // length of the best path
  std::uint32_t best_hub_ = kNone;   // rank
  std::uint32_t best_bend_ = kNone;  // the corner, if there is but one
  Improvements improvements_;
};

}  // namespace lasius::exact
