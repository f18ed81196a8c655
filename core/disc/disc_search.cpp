#include "core/disc/disc_search.h"

#include <algorithm>
#include <cmath>

#include "core/base/special_values.h"
#include "core/disc/scan_limits.h"

namespace lasius::disc {

using exact::kBucketWidth;
using exact::kFirstWeighted;
using exact::kWeightedShare;
using exact::kWordsPerExpansion;
using exact::kWordsPerPoll;

namespace {

constexpr double kWeight = exact::kDefaultWeight;
// How far ahead of a label's bound its view is taken at first.
constexpr double kHorizon = 1.0 / 1024;
constexpr double kHorizonOfRise = 2;
// Labels that are asked whether they see the goal before the goal takes a look.
constexpr std::int64_t kFirstFew = 16;

}  // namespace

// What a view finds, put into labels and frontiers.
struct DiscSearch::Sink {
  DiscSearch& search;
  const Label from;

  // Lines of a view are looked along when their labels are the best ones.
  void take(const Seen& seen) {
    Label found = label(seen.arc, seen.rising, seen.normal.angle(), seen.length);
    if (search.prices_ != nullptr && search.in_hand_ == Labels::kStart)
      found.length += search.prices_->at_start(
          {seen.arrives.x - search.start_.x, seen.arrives.y - search.start_.y});
    if (search.dominated(found)) return;
    found.normal = seen.normal;
    add(found, seen.arrives);
  }
  Label label(std::uint32_t arc, bool rising, double angle, double way) const noexcept {
    double length = from.length + way;
    if (search.in_hand_ != Labels::kStart)
      length += search.space_->radius() * std::abs(angle - from.angle);
    return {
        .length = length, .angle = angle, .arc = arc, .parent = search.in_hand_, .rising = rising};
  }
  void add(Label& found, Point arrives) {
    found.to_goal = distance(arrives, search.goal_);
    const double key = found.length + found.to_goal;
    if (key >= search.upper_) return;
    const std::uint32_t number = search.labels_.add(found);
    search.frontier_.push(number, key);
    if (search.weighted_on_)
      search.weighted_frontier_.push(number, found.length + kWeight * found.to_goal);
  }
  template <int S>
  kernels::ConeLimits limits(int down, int line0) const noexcept {
    return limits_around<S>(view_of(search.space_->map()), search.leaves_, search.goal_,
                            search.horizon_ - from.length, down, line0);
  }
  bool beyond(Point p) const noexcept {
    return from.length + distance(search.leaves_, p) + distance(p, search.goal_) >= search.horizon_;
  }
  bool go_on(std::int64_t words) { return !search.poller_->stop_after(words); }
};

// Goes on along edges of the graph. Returns whether some were left out at the horizon.
bool DiscSearch::follow(std::uint32_t number) {
  const Label label = labels_[number];  // labels may move from here on
  const Root root = Root::on(*space_, label.arc, label.rising, label.normal);
  if (leads_to_goal(number, root)) return false;
  const std::uint32_t next = labels_.ahead(label, [this](std::uint32_t i) { return reached(i); });
  const double last = next != Labels::kStart ? labels_[next].angle : label.rising ? kInfinity : -1;
  Sink sink{*this, label};
  const double radius = space_->radius(), across = 4 * radius * radius;
  const double to_goal_x = goal_.x - root.x, to_goal_y = goal_.y - root.y;
  bool cut_off = false;
  for (const GraphEdge& edge : graph_->edges(label.arc, label.rising)) {
    if (label.rising ? edge.angle < label.angle - kSlack : edge.angle > label.angle + kSlack) break;
    if (label.rising ? edge.angle > last : edge.angle < last) continue;
    const double x = edge.dx, y = edge.dy;
    const double square = std::max(0.0, x * x + y * y - (edge.across() ? across : 0));
    Label found = sink.label(edge.to(), edge.rising(), edge.angle, std::sqrt(square));
    // What a path over it has left from the target's centre on.
    const double left = horizon_ + radius - found.length;
    const double goal_x = to_goal_x - x, goal_y = to_goal_y - y;
    if (!(left > 0 && goal_x * goal_x + goal_y * goal_y <= left * left)) {
      cut_off = true;
      continue;
    }
    if (dominated(found)) continue;
    const Tangent line = tangent(root.heading.right * edge.dx, root.heading.down * edge.dy,
                                 edge.across() ? 2 * root.offset : 0);
    const Normal n = line.normal;
    const Point leaves = root.leaves(n);
    found.normal = n;
    found.line = Label::Line::free;
    sink.add(found, {leaves.x + root.heading.right * (n.b * line.length),
                     leaves.y + root.heading.down * (n.a * line.length)});
  }
  return cut_off;
}

// Returns whether rays were cut off at the horizon.
bool DiscSearch::leave(std::uint32_t number) {
  const Label label = labels_[number];  // labels may move from here on
  Root root = Root::on(*space_, label.arc, label.rising, label.normal);
  const std::uint32_t next = labels_.ahead(label, [this](std::uint32_t i) { return reached(i); });
  if (next != Labels::kStart) root.to = labels_[next].normal;
  // Every other way on from here is longer, but may have a lower price at the goal.
  if (leads_to_goal(number, root) && prices_ == nullptr) return false;
  Sink sink{*this, label};
  View<Sink> view(*space_, view_, sink);
  leaves_ = root.leaves(root.from);
  bool cut_off = view.look(root);
  if (next == Labels::kStart) cut_off |= view.look_along_wall(root);
  return cut_off;
}

bool DiscSearch::leave_start() {
  Sink sink{*this, labels_[Labels::kStart]};
  View<Sink> view(*space_, view_, sink);
  leaves_ = start_;
  bool cut_off = false;
  for (const int down : {1, -1}) {
    for (const int right : {1, -1}) cut_off |= view.look(Root::at(start_, {right, down}));
  }
  return cut_off;
}

double DiscSearch::ahead(int scans) const noexcept {
  return (kHorizon * straight_ + kHorizonOfRise * (lower_ - straight_)) * (1 << 2 * scans);
}

// As in the search for a point: a view that was cut off waits in the frontier with the horizon as
// its key, and looks four times as far ahead then.
void DiscSearch::expand(std::uint32_t number) {
  ++expansions_;
  Label& label = labels_[number];
  label.expanded = true;
  horizon_ = upper_;
  if (label.scans < kMostScans)
    horizon_ = std::min(upper_, label.length + label.to_goal + ahead(label.scans));
  in_hand_ = number;
  const double horizon = horizon_;
  const bool cut_off = number == Labels::kStart ? leave_start()
                       : graph_ != nullptr      ? follow(number)
                                                : leave(number);
  if (!cut_off || horizon >= upper_) return;
  Label& again = labels_[number];
  again.expanded = again.weighed = false;
  ++again.scans;
  frontier_.push(number, horizon);
  if (weighted_on_) weighted_frontier_.push(number, horizon + (kWeight - 1) * again.to_goal);
}

// Is the line to a label free? Looks along it once.
bool DiscSearch::reached(std::uint32_t number) {
  Label& label = labels_[number];
  if (label.line == Label::Line::unknown) {
    const double radius = space_->radius();
    const Label& parent = labels_[label.parent];
    const Point from = label.parent == Labels::kStart
                           ? start_
                           : point_on(space_->arcs()[parent.arc], label.normal, radius);
    const Point to = point_on(space_->arcs()[label.arc], label.normal, radius);
    label.line = space_->sees(from, to) ? Label::Line::free : Label::Line::blocked;
  }
  return label.line == Label::Line::free;
}

bool DiscSearch::dominated(const Label& label, std::uint32_t number) {
  return labels_.dominated(label, number, [this](std::uint32_t i) { return reached(i); });
}

// Is a label still of use, and reached?
bool DiscSearch::matters(std::uint32_t number) {
  return number == Labels::kStart || (!dominated(labels_[number], number) && reached(number));
}

// Takes the best label of the frontier; false when none can lead to a shorter path, or stopped.
bool DiscSearch::next_label(std::uint32_t& number, Poller& poller) {
  while (frontier_.advance(poller)) {
    const double floor = frontier_.floor();
    if (!look_as_far_as(floor, poller)) return false;
    lower_ = std::max(lower_, std::min(floor, upper_));
    if (lower_ >= upper_) return false;
    number = frontier_.pop();
    const Label& label = labels_[number];
    if (!label.expanded && label.length + label.to_goal < upper_ && matters(number)) return true;
    if (poller.stop_after(1)) return false;
  }
  if (look_as_far_as(kInfinity, poller)) lower_ = upper_;
  return false;
}

// Paths over arcs that the goal sees only past its horizon are longer than that. False when
// stopped: what the goal saw then is not all.
bool DiscSearch::look_as_far_as(double length, Poller& poller) {
  while (goal_looks_ > 0 && length > goal_horizon_ && goal_horizon_ < upper_) {
    lower_ = std::max(lower_, goal_horizon_);
    look_from_goal();
    if (poller.stopped()) return false;
  }
  return true;
}

void DiscSearch::search_weighted(std::int64_t steps, Poller& poller) {
  weighing_ = true;
  for (;
       steps > 0 && upper_ == kInfinity && !poller.stopped() && weighted_frontier_.advance(poller);
       --steps) {
    const std::uint32_t number = weighted_frontier_.pop();
    Label& label = labels_[number];
    if (label.weighed || label.expanded) continue;
    label.weighed = true;
    if (!matters(number)) continue;
    expand(number);
    poller.stop_after(kWordsPerExpansion);
  }
  weighing_ = false;
  weighted_on_ = upper_ == kInfinity;
}

bool DiscSearch::tell_improvement(const Poller* poller) {
  return improvements_.tell(lower_, upper_, poller, [this](std::vector<Point>& path) {
    const Curve curve = trace(*space_, labels_, last_, last_normal_, start_, goal_);
    path = polyline_of(curve, *space_);
    return curve_length(curve);
  });
}

StopCondition::Cause DiscSearch::run(const ExactOptions& options, Poller& poller) {
  frontier_.reset(lower_, kBucketWidth);
  weighted_frontier_.reset(lower_, kBucketWidth);
  weighted_on_ = graph_ == nullptr;
  expand(Labels::kStart);
  std::int64_t next_weighted = kFirstWeighted;
  std::uint32_t number = 0;
  bool go_on = tell_improvement(&poller);
  while (go_on && !poller.stopped() && next_label(number, poller)) {
    if (upper_ - lower_ <= options.target_gap * lower_) break;
    if (goal_looks_ == 0 && expansions_ > kFirstFew) look_from_goal();
    expand(number);
    poller.stop_after(kWordsPerExpansion);
    go_on = tell_improvement(&poller);
    if (!weighted_on_ || expansions_ < next_weighted) continue;
    search_weighted(expansions_ / kWeightedShare, poller);
    next_weighted = expansions_ * 2;
  }
  return go_on ? poller.cause() : StopCondition::Cause::token;
}

void DiscSearch::search(const DiscSpace& space, const DiscGraph* graph, Point start, Point goal,
                        const ExactOptions& options, const StopCondition& stop,
                        DiscAnswer& answer) {
  Poller poller(stop, kWordsPerPoll);
  poller_ = &poller;
  space_ = &space;
  graph_ = graph;
  goal_looks_ = 0;
  start_ = start;
  goal_ = goal;
  expansions_ = 0;
  labels_.reset(space, prices_ != nullptr ? prices_->most : 0);
  straight_ = lower_ = distance(start, goal);
  labels_[Labels::kStart].to_goal = straight_;
  upper_ = kInfinity;
  last_ = Labels::kStart;
  improvements_.begin(options);
  auto cause = StopCondition::Cause::none;
  if (space.sees(start, goal))
    upper_ = lower_;
  else if (space.joined(start, goal))
    cause = run(options, poller);
  else
    lower_ = kInfinity;
  poller_ = nullptr;
  graph_ = nullptr;
  tell_improvement(nullptr);  // the last one; nothing is left to stop
  Curve curve;
  if (upper_ < kInfinity) curve = trace(space, labels_, last_, last_normal_, start, goal);
  conclude(lower_, upper_, cause, options.target_gap, std::move(curve), space, answer);
}

std::int64_t DiscSearch::bytes() const noexcept {
  return labels_.bytes() + frontier_.bytes() + weighted_frontier_.bytes() + view_.bytes() +
         improvements_.bytes() + held_bytes(exits_);
}

}  // namespace lasius::disc
