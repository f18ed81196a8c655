#include "core/polygon/shortest_path.h"

#include <algorithm>
#include <queue>
#include <utility>

#include "core/base/poller.h"
#include "core/base/special_values.h"
#include "core/polygon/sight.h"
#include "lasius/path/path.h"

namespace lasius::polygon {
namespace {

class VisibilitySearch {
 public:
  VisibilitySearch(const Regions& regions, const Place& start, const Place& goal,
                   const StopCondition& stop)
      : regions_(regions), sight_(regions), start_(start), goal_(goal), stop_(stop), poller_(stop) {
    const std::size_t corners = regions.space().corners.size();
    length_.assign(corners + 2, kInfinity);
    before_.assign(corners + 2, -1);
    done_.assign(corners + 2, 0);
    in_goal_.assign(regions.regions().size(), 0);
    for (const int r : goal.regions) in_goal_[r] = 1;
  }

  ShortestPath run() {
    const int start = start_node(), goal = goal_node();
    length_[start] = 0;
    ShortestPath result;
    result.lower_bound = distance(start_.given, goal_.given);
    result.cause = stop_.poll();
    if (result.cause != StopCondition::Cause::none) return result;
    queue_.emplace(result.lower_bound, start);
    while (!queue_.empty()) {
      const auto [key, node] = queue_.top();
      queue_.pop();
      if (done_[node] != 0) continue;
      done_[node] = 1;
      result.lower_bound = std::max(result.lower_bound, key);
      if (node == goal) break;
      expand(node);
      if (poller_.stopped()) break;
    }
    result.cause = poller_.cause();
    if (done_[goal] == 0) return result;
    for (int node = goal; node >= 0; node = before_[node]) result.path.push_back(point(node));
    std::ranges::reverse(result.path);
    result.path.erase(std::unique(result.path.begin(), result.path.end()), result.path.end());
    result.length = path_length(result.path);
    result.lower_bound = result.length;
    return result;
  }

 private:
  int start_node() const { return static_cast<int>(regions_.space().corners.size()); }
  int goal_node() const { return start_node() + 1; }
  LatticePoint at(int node) const {
    if (node == start_node()) return start_.at;
    return node == goal_node() ? goal_.at : regions_.at(node);
  }
  Point point(int node) const {
    if (node == start_node()) return start_.given;
    return node == goal_node() ? goal_.given : regions_.space().point(regions_.at(node));
  }

  void expand(int node) {
    sight_.from(
        at(node), node == start_node() ? start_.regions : regions_.around(node), poller_,
        [&](int corner) { offer(node, corner); },
        [&](int region, const auto& seen) {
          if (in_goal_[region] != 0 && seen(goal_.at)) offer(node, goal_node());
        });
  }

  void offer(int from, int to) {
    if (to != goal_node() && !regions_.reflex(to)) return;
    if (done_[to] != 0) return;
    const double length = length_[from] + distance(point(from), point(to));
    if (!(length < length_[to])) return;
    length_[to] = length;
    before_[to] = from;
    queue_.emplace(length + distance(point(to), goal_.given), to);
  }

  const Regions& regions_;
  Sight sight_;
  const Place& start_;
  const Place& goal_;
  const StopCondition& stop_;
  Poller poller_;
  std::vector<double> length_;
  std::vector<int> before_;
  std::vector<char> done_, in_goal_;
  std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>>
      queue_;
};

}  // namespace

ShortestPath shortest_path(const Regions& regions, const Place& start, const Place& goal,
                           const StopCondition& stop) {
  return VisibilitySearch(regions, start, goal, stop).run();
}

}  // namespace lasius::polygon
