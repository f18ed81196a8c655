#include "exact.h"

#include <algorithm>
#include <cmath>

#include "grid_view.h"
#include "kernels/scan_line.h"
#include "kernels/sight.h"
#include "lasius/path.h"

namespace lasius {

using exact::Corner;
using exact::CornerTable;
using exact::Heading;
using kernels::ConeFrame;
using kernels::ConeScan;
using kernels::Fixed;
using kernels::Turn;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kBucketWidth = 0.125;  // cells

// The ants of a search without a target gap: how they weigh the distance to the goal, the number
// of expansions before the first are sent, and their share of the expansions since.
constexpr double kAntWeight = 1.2;
constexpr std::int64_t kFirstAnts = 16;
constexpr std::int64_t kAntShare = 8;
// With a target gap: the ants that are sent first, and their share later. Where they do not arrive
// soon (mazes, dense noise), the paths they find would mostly be found again by shorter ways.
constexpr std::int64_t kHurriedAnts = 131072;
constexpr std::int64_t kHurriedShare = 4;
// Without a hurry, a search that is soon over is not held up by ants for longer than this.
constexpr std::int64_t kAntsPatience = 256;

// In cells, between places in half cells: exact but for the square root.
double distance(int x0, int y0, int x1, int y1) noexcept {
  const double dx = x1 - x0;
  const double dy = y1 - y0;
  return 0.5 * std::sqrt(dx * dx + dy * dy);
}

// How far ahead of a corner's bound its cone is scanned at first, in cells and as a share of the
// bound, and how often it is scanned before the horizon is dropped.
constexpr double kHorizon = 256;
constexpr double kHorizonShare = 1.0 / 256;
constexpr int kMostScans = 4;
// On maps smaller than this, views are short enough to be scanned at once.
constexpr int kLongViews = 2048;

// Work between two looks at the stop condition, 20 to 100 microseconds; an expansion counts as so
// many words, besides those that it scans.
constexpr std::int64_t kWordsPerPoll = 8192;
constexpr std::int64_t kWordsPerExpansion = 16;

}  // namespace

// What a scan finds, put into the corners and the frontier. Columns u = S * x.
template <int S>
struct ExactSearch::Visitor {
  ExactSearch& search;
  int down;
  int line0;

  double corner(int u, int line, Turn turn) {
    const bool back = turn == Turn::back;
    const Heading heading(back ? -S : S, down, turn == Turn::onward);
    return search.reach(search.root_.index, S * u, line0 + down * line, heading);
  }

  bool beaten(const kernels::Rival& rival, Fixed u, int line) const noexcept {
    const double x = S * static_cast<double>(u) / static_cast<double>(kernels::kOne);
    const double y = line0 + down * line;
    const double from_root_x = x - 0.5 * search.root_.x;
    const double from_root_y = y - 0.5 * search.root_.y;
    const double from_rival_x = x - S * rival.u;
    const double from_rival_y = y - (line0 + down * rival.line);
    // With room for the rounding of any length, so that no way ever beats itself.
    return rival.length * (1 + exact::kRounding) +
               std::sqrt(from_rival_x * from_rival_x + from_rival_y * from_rival_y) <
           search.root_.length + std::sqrt(from_root_x * from_root_x + from_root_y * from_root_y);
  }

  bool go_on(std::int64_t words) noexcept {
    search.counters_.words += words;
    return !search.poller_->stop_after(words);
  }
};

// A corner of a blocked cell at lattice point (x, y), seen from the root in hand. Returns the
// length of a shorter way there, or a negative number.
double ExactSearch::reach(std::uint32_t parent, int x, int y, Heading heading) {
  ++counters_.reports;
  const double length = root_.length + distance(root_.x, root_.y, 2 * x, 2 * y);
  const std::size_t slot = corners_.slot(x, y);
  std::uint32_t index = corners_.at(slot);
  double to_goal = 0;
  if (index != CornerTable::kStart) {
    const Corner& known = corners_[index];
    if (length >= known.length) return known.length;
    to_goal = known.to_goal;
  } else {
    to_goal = distance(2 * x, 2 * y, goal_x_, goal_y_);
    if (length + to_goal >= upper_) return -1;
    index = corners_.add(slot, x, y);
  }
  Corner& corner = corners_[index];
  corner.length = length;
  corner.to_goal = to_goal;
  corner.parent = parent;
  corner.heading = heading;
  corner.expanded = false;
  corner.scans = 0;
  if (length + to_goal < upper_) {
    ++counters_.pushes;
    frontier_.push(index, length + to_goal);
    if (ants_out_ && !corner.walked) trail_.push(index, length + ant_weight_ * to_goal);
  }
  return -1;
}

// The part of the map where a path over the root in hand can be shorter than the best one: the box
// around the ellipse of points p with length + |root p| + |p goal| < horizon.
template <int S>
ConeFrame ExactSearch::frame(int down) const noexcept {
  ConeFrame f;
  f.map = map_;
  f.down = down;
  f.line0 = down > 0 ? (root_.y + 1) >> 1 : root_.y >> 1;
  f.depth0 = 0.5 * (root_.y & 1);
  f.root = S * root_.x * (kernels::kOne / 2);
  f.last_line = down > 0 ? map_.height - f.line0 : f.line0;  // the border's row
  f.last_column = S > 0 ? map_.width + 1 : 1;
  if (horizon_ < kInfinity) {
    const double dx = 0.25 * (goal_x_ - root_.x);  // from the root to the middle of the ellipse
    const double dy = 0.25 * (goal_y_ - root_.y);
    const double sum = 0.5 * (horizon_ - root_.length);  // long half axis
    const double minor = std::max(0.0, sum * sum - dx * dx - dy * dy);
    const double right = S * (0.5 * root_.x + dx) + std::sqrt(minor + dx * dx);
    const double depth = down * dy + std::sqrt(minor + dy * dy);
    constexpr int kSpare = 2;  // rounding, and the column that a scan may leave out
    f.last_column = std::min(f.last_column, static_cast<int>(std::floor(right)) + 1 + kSpare);
    f.last_line = std::min(f.last_line, static_cast<int>(depth) + kSpare);
  }
  return f;
}

// Is the goal where a taut path over this corner may go straight to it?
template <int S>
bool ExactSearch::goal_in_cone(const Corner& corner, const Corner& parent) const noexcept {
  const Heading heading = corner.heading;
  const std::int64_t goal_u = S * (goal_x_ - corner.x);
  const std::int64_t goal_depth = heading.down() * (goal_y_ - corner.y);
  const std::int64_t u = S * (corner.x - parent.x);
  const std::int64_t depth = heading.down() * (corner.y - parent.y);
  if (goal_u < 0 || goal_depth <= 0) return false;
  const std::int64_t side = goal_u * depth - u * goal_depth;
  return heading.towards_column() ? side <= 0 : side >= 0;
}

// Scans the cone of a corner. Where the view is long, only as far as paths not much longer than the
// corner's own bound can lead; what lies behind stays in the frontier, as the corner itself with
// that horizon as its key. Each further scan looks four times as far ahead.
void ExactSearch::expand(std::uint32_t index) {
  ++counters_.expansions;
  Corner& corner = corners_[index];
  corner.expanded = true;
  const double bound = corner.length + corner.to_goal;
  horizon_ = upper_;
  if (long_views_ && corner.scans < kMostScans) {
    const double ahead = (kHorizon + kHorizonShare * bound) * (1 << 2 * corner.scans);
    horizon_ = std::min(upper_, bound + ahead);
  }
  const double horizon = horizon_;
  const bool cut_off = index == CornerTable::kStart ? leave_start()
                       : corner.heading.right() > 0 ? leave_corner<1>(index)
                                                    : leave_corner<-1>(index);
  if (!cut_off || horizon >= upper_) return;
  Corner& again = corners_[index];
  again.expanded = false;
  again.walked = false;
  ++again.scans;
  frontier_.push(index, horizon);
  if (ants_out_) trail_.push(index, horizon + (ant_weight_ - 1) * again.to_goal);
}

// Returns whether rays were cut off at the horizon.
template <int S>
bool ExactSearch::leave_corner(std::uint32_t index) {
  const Corner& corner = corners_[index];
  const Corner& parent = corners_[corner.parent];
  const Heading heading = corner.heading;
  if (goal_in_cone<S>(corner, parent) &&
      kernels::sees(map_, {corner.x, corner.y}, {goal_x_, goal_y_})) {
    upper_ = corner.length + corner.to_goal;
    last_ = index;
    return false;  // every other way on from here is longer
  }
  const int u = S * (corner.x - parent.x);
  const int depth = heading.down() * (corner.y - parent.y);
  const Fixed slope =
      depth == 0
          ? kernels::kLevelSlope
          : static_cast<Fixed>(static_cast<double>(u) * static_cast<double>(kernels::kOne) / depth);
  root_ = {index, corner.x, corner.y, corner.length};  // corners may move from here on
  const ConeFrame cone = frame<S>(heading.down());
  Visitor<S> visitor{*this, heading.down(), cone.line0};
  if (heading.towards_column()) {
    return ConeScan<S, Visitor<S>>(cone, stack_, visitor).from_corner(0, slope);
  }
  kernels::Rival level{-1, 0, 0};
  const auto report = [&](int column, bool above) {
    const double shorter = reach(index, S * column, cone.line0, Heading(S, above ? -1 : 1, true));
    if (shorter >= 0 && level.length < 0) level = {shorter, column, 0};
  };
  const bool cut_line =
      kernels::scan_line<S>(map_, cone.line0, S * (root_.x >> 1), cone.last_column, report);
  const bool cut_cone = ConeScan<S, Visitor<S>>(cone, stack_, visitor)
                            .from_corner(slope, kernels::kLevelSlope, level);
  return cut_line || cut_cone;
}

template <int S>
bool ExactSearch::leave_start(int down) {
  const ConeFrame cone = frame<S>(down);
  Visitor<S> visitor{*this, down, cone.line0};
  return ConeScan<S, Visitor<S>>(cone, stack_, visitor).from_centre(S > 0 ? map_.width : 0);
}

bool ExactSearch::leave_start() {
  const Corner& start = corners_[CornerTable::kStart];
  root_ = {CornerTable::kStart, start.x, start.y, 0};
  bool cut_off = false;
  for (const int down : {1, -1}) {
    cut_off |= leave_start<1>(down);
    cut_off |= leave_start<-1>(down);
  }
  return cut_off;
}

// Takes the best corner of the frontier; false when none can lead to a shorter path.
bool ExactSearch::next_corner(std::uint32_t& index) {
  while (frontier_.advance()) {
    lower_ = std::max(lower_, frontier_.floor());
    if (lower_ >= upper_) return false;
    index = frontier_.pop();
    const Corner& corner = corners_[index];
    if (!corner.expanded && corner.length + corner.to_goal < upper_) return true;
  }
  lower_ = upper_;
  return false;
}

// Ants follow their own frontier, which weighs the distance to the goal more: each goes from the
// best corner that no ant has been to. They explore for all: what they find enters both frontiers.
void ExactSearch::send_ants(std::int64_t steps, Poller& poller) {
  for (; steps > 0 && upper_ == kInfinity && !poller.stopped() && trail_.advance(); --steps) {
    const std::uint32_t index = trail_.pop();
    Corner& corner = corners_[index];
    if (corner.walked || corner.expanded) continue;
    corner.walked = true;
    ++counters_.ant_steps;
    expand(index);
    poller.stop_after(kWordsPerExpansion);
  }
  ants_out_ = upper_ == kInfinity;
}

void ExactSearch::run(const ExactOptions& options, const StopCondition& stop) {
  Poller poller(stop, kWordsPerPoll);
  poller_ = &poller;
  const bool hurry = options.target_gap > 0;
  const bool patient = hurry || long_views_ || stop.deadline != Clock::time_point::max();
  ants_out_ = true;
  ant_weight_ = hurry ? 1 + options.target_gap : kAntWeight;
  trail_.reset(ant_weight_ * lower_, kBucketWidth);
  expand(CornerTable::kStart);
  std::int64_t next_ants = kFirstAnts;
  if (hurry) send_ants(kHurriedAnts, poller);
  std::uint32_t index = 0;
  while (!poller.stopped() && next_corner(index)) {
    if (upper_ - lower_ <= options.target_gap * lower_) break;
    expand(index);
    poller.stop_after(kWordsPerExpansion);
    if (!ants_out_ || counters_.expansions < next_ants) continue;
    if (counters_.expansions > kAntsPatience && !patient) {
      ants_out_ = false;
    } else {
      send_ants(counters_.expansions / (hurry ? kHurriedShare : kAntShare), poller);
      next_ants = counters_.expansions * 2;
    }
  }
  cause_ = poller.cause();
}

void ExactSearch::search(const Grid& grid, Cell start, Cell goal, const ExactOptions& options,
                         const StopCondition& stop, ExactAnswer& answer) {
  map_ = view_of(grid);
  goal_x_ = 2 * goal.x + 1;
  goal_y_ = 2 * goal.y + 1;
  counters_ = {};
  cause_ = StopCondition::Cause::none;
  const int x = 2 * start.x + 1;
  const int y = 2 * start.y + 1;
  lower_ = distance(x, y, goal_x_, goal_y_);
  upper_ = kInfinity;
  long_views_ = std::max(grid.width(), grid.height()) > kLongViews;
  last_ = CornerTable::kStart;
  corners_.reset(grid.width(), {x, y, 0, lower_, CornerTable::kStart, {}, false, true, 0});
  if (kernels::sees(map_, {x, y}, {goal_x_, goal_y_})) {
    upper_ = lower_;
  } else {
    frontier_.reset(lower_, kBucketWidth);
    run(options, stop);
  }
  finish(options, answer);
}

// The path back from its last corner, without corners that it passes straight by.
void ExactSearch::trace(std::vector<Point>& path) const {
  path.assign(1, {0.5 * goal_x_, 0.5 * goal_y_});
  int x = goal_x_;
  int y = goal_y_;
  for (std::uint32_t i = last_;; i = corners_[i].parent) {
    const Corner& corner = corners_[i];
    if (i != CornerTable::kStart) {
      const Corner& parent = corners_[corner.parent];
      const std::int64_t bend = static_cast<std::int64_t>(x - corner.x) * (corner.y - parent.y) -
                                static_cast<std::int64_t>(y - corner.y) * (corner.x - parent.x);
      if (bend == 0) continue;
    }
    path.push_back({0.5 * corner.x, 0.5 * corner.y});
    x = corner.x;
    y = corner.y;
    if (i == CornerTable::kStart) break;
  }
  std::reverse(path.begin(), path.end());
}

void ExactSearch::finish(const ExactOptions& options, ExactAnswer& answer) const {
  answer.path.clear();
  answer.length = std::numeric_limits<double>::quiet_NaN();
  answer.lower_bound = lower_ * (1 - exact::kRounding);
  answer.cause = cause_;
  answer.optimal = false;
  if (upper_ < kInfinity) {
    trace(answer.path);
    answer.length = path_length(answer.path);
    answer.optimal = lower_ >= upper_;
    if (answer.optimal) answer.lower_bound = answer.length;
  }
  if (answer.optimal) {
    answer.end = ExactEnd::proven;
  } else if (upper_ < kInfinity && upper_ - lower_ <= options.target_gap * lower_) {
    answer.end = ExactEnd::target_gap;
  } else if (cause_ != StopCondition::Cause::none) {
    answer.end = ExactEnd::stopped;
  } else {
    answer.end = ExactEnd::unreachable;
  }
}

std::int64_t ExactSearch::bytes() const noexcept {
  return corners_.bytes() + frontier_.bytes() +
         static_cast<std::int64_t>(stack_.capacity() * sizeof(kernels::Interval));
}

}  // namespace lasius
