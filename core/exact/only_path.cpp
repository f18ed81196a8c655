// Whether the shortest path of a prepared map is the only one.
#include <algorithm>
#include <cmath>

#include "core/base/special_values.h"
#include "core/exact/prepared_search.h"
#include "kernels/sight/sight.h"

namespace lasius::exact {

bool PreparedSearch::search_only(const Grid& grid, const CornerGraph& graph, Point start,
                                 Point goal, const StopCondition& stop, ExactAnswer& answer) {
  Poller poller(stop, kWordsPerPoll);
  begin(grid, graph, start, goal, Mode::first_few, poller);
  bool only = true;
  if (start_.sees(map_, goal_)) {
    upper_ = lower_;
    last_ = kStart;
  } else {
    margin_ = kAlike;
    ways_.clear();
    if (last_ways_ < nodes_size_) {
      last_ways_ = nodes_size_;
      last_way_ = ZeroArray<std::uint32_t>(last_ways_);
    }
    const bool near = graph.detour() <= kMostDetour && search_near(0) && longest() <= horizon_;
    if (!near) {
      if (mode_ != Mode::near_line) {
        horizon_ = kInfinity;
        scan_start_view();
      }
      ways_.clear();
      if (!poller.stopped()) search_whole_map(0);
    }
    only = !poller.stopped() && upper_ < kInfinity && is_only();
    margin_ = 0;
  }
  poller_ = nullptr;
  if (!only) return false;
  trace(answer.path);
  conclude(upper_, upper_, StopCondition::Cause::none, 0, answer);
  answer.stored_legs = true;
  return true;
}

bool PreparedSearch::alike(double length, double other) const noexcept {
  return std::abs(length - other) <= margin_ * length;
}

void PreparedSearch::note_way(std::uint32_t to, std::uint32_t from) {
  const auto count = static_cast<std::uint32_t>(ways_.size());
  std::uint32_t& last = last_way_[to];
  const bool first = last >= count || ways_[last].to != to;
  ways_.push_back({to, from, first ? kStart : last});
  last = count;
}

// Does no other path come within the margin of the best one? Goes back from the goal along all ways
// that may be part of one: the corners of the best path alone lie on it.
bool PreparedSearch::is_only() {
  way_.clear();
  for (std::uint32_t i = last_; i != kStart; i = nodes_[i].parent) way_.push_back(i);
  way_.push_back(kStart);
  steps_.clear();
  for (const std::uint32_t index : goal_corners_) {
    const Node& node = nodes_[index];
    if (node.length + node.to_goal <= longest()) list_step(index, 0);
  }
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    std::size_t& leg = steps_[i].leg;
    while (leg < way_.size() && !on_leg(leg, steps_[i].corner)) ++leg;
    if (leg == way_.size()) return false;
    list_ways_to(i);
  }
  return true;
}

void PreparedSearch::list_step(std::uint32_t corner, std::size_t leg) {
  bool& listed = nodes_[corner].listed;
  if (!listed) steps_.push_back({corner, leg});
  listed = true;
}

void PreparedSearch::list_ways_to(std::size_t step) {
  const auto [corner, leg] = steps_[step];
  const GraphCorner& to = graph_->corner(corner);
  const auto list = [&, leg = leg, corner = corner](std::uint32_t from) {
    if (from == kStart) return;
    const GraphCorner& by = graph_->corner(from);
    const double length =
        nodes_[from].length + distance(2 * by.x(), 2 * by.y(), 2 * to.x(), 2 * to.y());
    if (alike(length, nodes_[corner].length)) list_step(from, leg);
  };
  list(nodes_[corner].parent);
  const std::uint32_t last = last_way_[corner];
  if (last >= ways_.size() || ways_[last].to != corner) return;
  for (std::uint32_t way = last; way != kStart; way = ways_[way].next) list(ways_[way].from);
}

// Does a corner lie on a leg of the best path?
bool PreparedSearch::on_leg(std::size_t leg, std::uint32_t corner) const noexcept {
  const kernels::FinePoint a = leg == 0 ? goal_.fine() : place(way_[leg - 1]);
  const kernels::FinePoint b = place(way_[leg]), at = place(corner);
  const auto between = [](auto from, auto to, auto value) {
    return std::min(from, to) <= value && value <= std::max(from, to);
  };
  return kernels::turn_sign(a, b, at) == 0 && between(a.x, b.x, at.x) && between(a.y, b.y, at.y);
}

}  // namespace lasius::exact
