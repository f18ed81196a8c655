// How a disc's search comes to its goal, and what is paid there.
#include <algorithm>
#include <cmath>

#include "core/disc/disc_search.h"
#include "core/disc/scan_limits.h"

namespace lasius::disc {

// The arcs that the goal sees: turned around the other way, they are left for it.
struct DiscSearch::GoalSink {
  DiscSearch& search;

  void take(const Seen& seen) {
    search.exits_[2 * seen.arc + (seen.rising ? 0 : 1)] = {search.exit_stamp_, false, seen.normal,
                                                           seen.normal.angle(), seen.length};
  }
  template <int S>
  kernels::ConeLimits limits(int down, int line0) const noexcept {
    return limits_around<S>(view_of(search.space_->map()), search.goal_, search.start_,
                            search.goal_horizon_, down, line0);
  }
  bool go_on(std::int64_t words) { return !search.poller_->stop_after(words); }
};

void DiscSearch::look_from_goal() {
  goal_horizon_ = goal_looks_ < kMostScans ? std::min(upper_, lower_ + ahead(goal_looks_)) : upper_;
  ++goal_looks_;
  if (++exit_stamp_ == 0) {  // all numbers were used
    std::ranges::fill(exits_, Exit{});
    exit_stamp_ = 1;
  }
  exits_.resize(2 * space_->arcs().size());
  GoalSink sink{*this};
  View<GoalSink> view(*space_, view_, sink);
  bool cut_off = false;
  for (const int down : {1, -1}) {
    for (const int right : {1, -1}) cut_off |= view.look(Root::at(goal_, {right, down}));
  }
  if (!cut_off) goal_horizon_ = kInfinity;
  for (std::uint32_t i = 1; i < labels_.size(); ++i) {
    if (labels_[i].expanded) exits(i);
  }
}

// Does the goal see the arc of a label, where it turns on? Every other way on is longer then.
bool DiscSearch::exits(std::uint32_t number) {
  const Label& label = labels_[number];
  Exit& exit = exits_[2 * label.arc + (label.rising ? 1 : 0)];
  const double turned = label.rising ? exit.angle - label.angle : label.angle - exit.angle;
  if (exit.stamp != exit_stamp_ || turned < -kSlack) return false;
  if (!exit.free) {
    const Point leaves = point_on(space_->arcs()[label.arc], exit.normal, space_->radius());
    exit.free = space_->sees(leaves, goal_);
    if (!exit.free) {
      exit.stamp = 0;
      return false;
    }
  }
  double length = label.length + space_->radius() * std::max(0.0, turned) + exit.length;
  if (prices_ != nullptr) {
    const Point leaves = point_on(space_->arcs()[label.arc], exit.normal, space_->radius());
    length += prices_->at_goal({leaves.x - goal_.x, leaves.y - goal_.y});
  }
  if (length < upper_) {
    upper_ = length;
    last_ = number;
    last_normal_ = exit.normal;
  }
  return true;
}

// Is the goal where a taut path over this label goes straight to it?
bool DiscSearch::meets_goal(std::uint32_t number, const Root& root) {
  const Label& label = labels_[number];
  const Tangent line = tangent(root.heading.right * (goal_.x - root.x),
                               root.heading.down * (goal_.y - root.y), root.offset);
  // A goal at a wall's distance is met along an axis, up to rounding.
  if (line.length < 0 || std::min(line.normal.a, line.normal.b) < -kSlack) return false;
  const Normal n{std::max(0.0, line.normal.a), std::max(0.0, line.normal.b)};
  const double sign = label.rising ? 1 : -1;
  if (sign * (root.from.a * n.b - root.from.b * n.a) < -kSlack ||
      sign * (n.a * root.to.b - n.b * root.to.a) < -kSlack)
    return false;
  const double turned = std::max(0.0, sign * (n.angle() - label.angle));
  double length = label.length + space_->radius() * turned + line.length;
  if (prices_ != nullptr) {
    const Point leaves = root.leaves(n);
    length += prices_->at_goal({leaves.x - goal_.x, leaves.y - goal_.y});
  }
  if (length >= upper_) return true;
  if (!space_->sees(root.leaves(n), goal_)) return false;
  upper_ = length;
  last_ = number;
  last_normal_ = n;
  return true;
}

// Asks the goal's view, if there is one. A label of the weighted search may be past its horizon.
bool DiscSearch::leads_to_goal(std::uint32_t number, const Root& root) {
  return goal_looks_ == 0 || weighing_ ? meets_goal(number, root) : exits(number);
}

double DiscSearch::least(const DiscSpace& space, Point start, Point goal, const EndPrices& prices,
                         double target_gap, const StopCondition& stop) {
  DiscAnswer answer;
  prices_ = &prices;
  search(space, nullptr, start, goal, {.target_gap = target_gap}, stop, answer);
  prices_ = nullptr;
  return std::isfinite(lower_) ? exact::rounded_down(lower_) : lower_;
}

}  // namespace lasius::disc
