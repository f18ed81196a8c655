// Local search of a path whose order is given in part (Gambardella & Dorigo 2000: adjacent pieces
// change places, keeping their direction), with reversed pieces where costs are symmetric.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/poller.h"
#include "core/tour/order/stop_path.h"

namespace lasius::tour {

/// A path as positions, what its arcs cost, and what is carried behind each node.
struct PathState {
  std::vector<int> nodes, position;
  std::vector<Cost> arcs;             ///< from each position to the next
  std::vector<std::int64_t> carried;  ///< empty without a capacity
  std::int64_t cost = 0;
};

/// Exchanges that break nothing of what is given.
class PathExchange {
 public:
  explicit PathExchange(const StopPath& path);

  const PathState& now() const noexcept { return now_; }
  /// Takes a path that breaks nothing.
  void set(std::vector<int> nodes);
  /// Writes nodes over those from position `from` on, which are the same ones in another order.
  void rewrite(int from, const std::vector<int>& nodes);
  /// Whether the pieces behind `h` up to `i` and behind `i` up to `j` may change places.
  bool may_swap(int h, int i, int j) const;
  void swap(int h, int i, int j);

  /// Has `improve` look at the arcs of a node.
  void wake(int node);
  void wake_all();
  /// Until no woken node has a cheaper exchange; false once stopped.
  bool improve(Poller& poller);

  /// The positions that were written since the last call of `keep` or `restore`, first and last.
  int first_written() const noexcept { return first_; }
  int last_written() const noexcept { return last_; }
  /// Copies what was written to `state`, or back from there.
  void keep(PathState& state);
  void restore(const PathState& state);

 private:
  struct Exchange {
    std::int64_t gain = 0;
    bool reversed = false;  // else two pieces change places
    int h = 0, i = 0, j = 0;
  };

  void consider(const Exchange& exchange, std::int64_t gone, int a, int b, int c, int d,
                Exchange& best);
  void try_arc(int a, int b, Cost cost, Exchange& best);
  void try_forward(int at, int to, Cost cost, Exchange& best);
  void try_backward(int at, int to, Cost cost, Exchange& best);
  bool carries(const Exchange& exchange) const;
  bool may_reverse(int h, int j) const;
  void apply(const Exchange& exchange);
  void written(int from, int to);  // positions of nodes
  void copy(const PathState& from, PathState& to);

  const StopPath& path_;
  PathState now_;
  std::vector<int> woken_;
  std::vector<char> awake_;
  int first_ = 0, last_ = -1;
  std::int64_t work_ = 0;
};

}  // namespace lasius::tour
