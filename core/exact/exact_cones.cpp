// What an expansion sees: the cone of the root in hand, and what is done with the corners in it.
#include <algorithm>
#include <cmath>

#include "core/exact/ellipse_limits.h"
#include "core/exact/exact.h"
#include "kernels/sight/scan_line.h"
#include "kernels/sight/sight.h"

namespace lasius {

using exact::Corner;
using exact::CornerTable;
using exact::distance;
using exact::Heading;
using kernels::ConeFrame;
using kernels::ConeLimits;
using kernels::ConeScan;
using kernels::Fixed;
using kernels::frame_at;
using kernels::Turn;

// What a scan finds, put into the corners and the frontier. Columns u = S * x.
template <int S>
struct ExactSearch::Visitor {
  ExactSearch& search;
  int down;
  int line0;
  kernels::ConeLimits far = {};
  bool far_known = false;

  const kernels::ConeLimits& limits() {
    if (!far_known) far = search.limits<S>(down, line0);
    far_known = true;
    return far;
  }

  double corner(int u, int line, Turn turn) {
    const bool back = turn == Turn::back;
    const Heading heading(back ? -S : S, down, turn == Turn::onward);
    return search.reach(S * u, line0 + down * line, heading);
  }

  bool beaten(const kernels::Rival& rival, Fixed u, int line) const noexcept {
    const double x = S * static_cast<double>(u) / static_cast<double>(kernels::kOne);
    const double y = line0 + down * line;
    const double from_root_x = x - 0.5 * search.root_.x;
    const double from_root_y = y - 0.5 * search.root_.y;
    const double from_rival_x = x - S * rival.u;
    const double from_rival_y = y - (line0 + down * rival.line);
    // With room for the rounding of any length, so that no way ever beats itself.
    return rival.length * (1 + exact::kWorstRounding) +
               std::sqrt(from_rival_x * from_rival_x + from_rival_y * from_rival_y) <
           search.root_.length + std::sqrt(from_root_x * from_root_x + from_root_y * from_root_y);
  }

  bool go_on(std::int64_t words) {
    search.counters_.words += words;
    return !search.poller_->stop_after(words);
  }
};

// Is there neither goal nor corner in the taut cone of a corner seen from the root in hand? Looks
// at the two rows ahead (which end the rays at most steps of an outline) and at the block's own.
template <int S>
bool ExactSearch::is_barren_towards(int x, int y, Heading heading) const noexcept {
  using B = kernels::Bits<S>;
  const int down = heading.down();
  const int to_goal = down * (goal_.near().y - 2 * y);  // in half cells
  if (to_goal >= -1 && to_goal <= 5) return false;
  const auto row = [&](int ahead) {
    return B::window(kernels::bytes_of(map_.row(down > 0 ? y + ahead : y - 1 - ahead)), S * x);
  };
  const auto first = [](std::uint64_t cells) {  // kValid if it is farther
    return cells == 0 ? B::kValid : std::min(B::first(cells), B::kValid);
  };
  const int dx = S * (2 * x - root_.at.x), dy = down * (2 * y - root_.at.y);
  if (heading.towards_column()) {
    if (dx == 0) return true;
    const int shut = first(~row(1));
    return shut > 0 && (dx < shut * dy || (shut < B::kValid && shut >= first(row(0))));
  }
  const int wall = first(row(0));
  if (wall == B::kValid || first(~row(-1)) < wall) return false;
  if (dx >= wall * dy) return true;
  const std::uint64_t open = ~row(1) & B::to(wall - 1);
  const int shut = open == 0 ? 0 : B::last(open) + 1;
  return shut < wall && dx > shut * dy;
}

// Only where it is to be the only path. Where few corners are barren they are no longer looked at.
[[gnu::noinline]] bool ExactSearch::is_barren(int x, int y, Heading heading) noexcept {
  if (barren_tests_ == 0 || root_.index == CornerTable::kStart) return false;
  const bool barren = heading.right() > 0 ? is_barren_towards<1>(x, y, heading)
                                          : is_barren_towards<-1>(x, y, heading);
  barren_tests_ += barren ? exact::kTestsForBarren : -1;
  return barren;
}

// A corner of a blocked cell at lattice point (x, y), seen from the root in hand. Returns the
// length of a shorter way there, or a negative number.
double ExactSearch::reach(int x, int y, Heading heading) {
  const double length = root_.length + distance(root_.x, root_.y, 2 * x, 2 * y);
  std::uint64_t* const slot = corners_.slot(x, y);
  std::uint32_t index = corners_.at(slot);
  double to_goal = 0;
  const bool only = mode_ == Mode::only;
  bool barren = false;
  if (index != CornerTable::kStart) {
    Corner& known = corners_[index];
    if (length >= known.length || (only && !exact::beyond(known.length, length))) {
      if (only && !exact::beyond(length, known.length)) [[unlikely]]
        note_tie(known, root_.index, heading);
      return known.length;
    }
    to_goal = known.to_goal;
    barren = only && is_barren(x, y, heading);
  } else {
    if (touched_ != nullptr && !touched_->touches(x, y)) return -1;
    to_goal = distance(2 * x, 2 * y, goal_.x, goal_.y);
    if (too_long(length + to_goal) || (only && is_barren(x, y, heading))) return -1;
    index = corners_.add(slot, x, y);
  }
  Corner& corner = corners_[index];
  corner.length = length;
  corner.to_goal = to_goal;
  corner.parent = root_.index;
  corner.heading = heading;
  corner.expanded = barren;
  corner.tied = false;
  corner.scans = 0;
  if (barren) {
    corner.weighed = true;
  } else if (!too_long(length + to_goal)) {
    if (mode_ != Mode::improving) frontier_.push(index, length + to_goal);
    if (mode_ >= Mode::bounding) corner.weighed = false;
    if (weighs() && !corner.weighed) weighted_frontier_.push(index, length + weight_ * to_goal);
  }
  return -1;
}

// Is the way over one of two corners to a place that over the other, which it passes straight?
bool ExactSearch::in_line(std::uint32_t a, std::uint32_t b, kernels::FinePoint at) const noexcept {
  const bool ordered = corners_[a].length < corners_[b].length;
  const std::uint32_t far = ordered ? a : b;
  for (std::uint32_t near = ordered ? b : a; near != far; near = corners_[near].parent) {
    if (near == CornerTable::kStart) return false;
    const kernels::FinePoint from = place(corners_[near].parent), over = place(near);
    const bool same_side = (from.x < at.x) == (over.x < at.x) && (from.y < at.y) == (over.y < at.y);
    if (!same_side || kernels::turn_sign(from, over, at) != 0) return false;
  }
  return true;
}

// A corner is reached by another way about as short. Of corners in a line the nearest is kept: what
// was noted of it counts, too.
[[gnu::noinline]] void ExactSearch::note_tie(Corner& corner, std::uint32_t parent,
                                             Heading heading) noexcept {
  if (parent == corner.parent) return;
  if (!in_line(parent, corner.parent, kernels::fine({corner.x, corner.y}))) {
    corner.tied = true;
    ++ties_.noted;
  } else if (corners_[parent].length > corners_[corner.parent].length) {
    corner.parent = parent;
    corner.heading = heading;
  }
}

// The straight way from a corner to the goal, which it sees.
void ExactSearch::offer_goal(std::uint32_t index) noexcept {
  const double length = corners_[index].length + corners_[index].to_goal;
  if (mode_ != Mode::only || exact::beyond(upper_, length)) {
    ties_.at_goal = false;
  } else {
    if (exact::beyond(length, upper_)) return;
    if (!in_line(index, last_, goal_.fine())) ties_.at_goal = true;
    if (corners_[index].length < corners_[last_].length) return;
  }
  upper_ = length;
  last_ = index;
}

// Where a path over the root in hand can be shorter than the horizon.
template <int S>
ConeLimits ExactSearch::limits(int down, int line0) const noexcept {
  const exact::Ellipse ellipse{root_.at, goal_.near(), horizon_ - root_.length + goal_.off()};
  return exact::limits_around<S>(map_, ellipse, down, line0);
}

// Is the goal where a taut path over this corner may go straight to it?
template <int S>
bool ExactSearch::goal_in_cone(const Corner& corner) const noexcept {
  const Heading heading = corner.heading;
  const kernels::FinePoint goal = goal_.fine();
  const kernels::FinePoint here = kernels::fine({corner.x, corner.y});
  if (S * (goal.x - here.x) < 0 || heading.down() * (goal.y - here.y) < 0) return false;
  const int turn = S * heading.down() * kernels::turn_sign(place(corner.parent), here, goal);
  return heading.towards_column() ? turn >= 0 : turn <= 0;
}

// Of a scan that asked for limits, or was cut off by them.
bool ExactSearch::learn_limits(bool asked, bool cut_off) noexcept {
  if (cut_off)
    near_lines_ = std::max(exact::kLeastNear, near_lines_ / 4);
  else if (asked)
    near_lines_ = std::min(exact::kMostNear, 2 * near_lines_);
  return cut_off;
}

// Returns whether rays were cut off at the horizon.
template <int S>
bool ExactSearch::scan_cone(std::uint32_t index) {
  const Corner& corner = corners_[index];
  const Heading heading = corner.heading;
  if (mode_ != Mode::row && goal_in_cone<S>(corner) &&
      goal_.sees(map_, kernels::HalfPoint{corner.x, corner.y})) {
    offer_goal(index);
    return false;  // every other way on from here is longer
  }
  if (mode_ == Mode::only && corner.length + corner.to_goal >= upper_) return false;
  const kernels::FinePoint here = place(index), parent = place(corner.parent);
  const auto u = static_cast<double>(S * (here.x - parent.x));
  const auto depth = static_cast<double>(heading.down() * (here.y - parent.y));
  constexpr double kOne = static_cast<double>(kernels::kOne);
  constexpr double kLevel = static_cast<double>(kernels::kLevelSlope) / kOne;
  Fixed slope = u >= kLevel * depth ? kernels::kLevelSlope : static_cast<Fixed>(u * kOne / depth);
  // Scans are about rays through half cells, which are never so near to a column: here the cone is
  // a little wider, and what more is found lies on paths that are valid, but not taut.
  constexpr Fixed kLeastSlope = kernels::kOne >> 12;
  if (corner.parent == CornerTable::kStart && slope < kLeastSlope && start_.off() > 0)
    slope = heading.towards_column() ? kLeastSlope : 0;
  const kernels::HalfPoint at{corner.x, corner.y};  // corners may move from here on
  root_ = {index, at, 1.0 * at.x, 1.0 * at.y, corner.length};
  const ConeFrame cone = frame_at<S>(map_, at.x, at.y, heading.down());
  Visitor<S> visitor{*this, heading.down(), cone.line0};
  if (heading.towards_column()) {
    const bool cut_off =
        ConeScan<S, Visitor<S>>(cone, stack_, visitor, near_lines_).from_corner(0, slope);
    return learn_limits(visitor.far_known, cut_off);
  }
  kernels::Rival level{-1, 0, 0};
  const auto report = [&](int column, bool above) {
    const double shorter = reach(S * column, cone.line0, Heading(S, above ? -1 : 1, true));
    if (shorter >= 0 && level.length < 0) level = {shorter, column, 0};
  };
  const auto last_column = [&] { return visitor.limits().last_column; };
  const bool cut_line =
      kernels::scan_line<S>(map_, cone.line0, S * (at.x >> 1), last_column, report);
  const bool cut_cone = ConeScan<S, Visitor<S>>(cone, stack_, visitor, near_lines_)
                            .from_corner(slope, kernels::kLevelSlope, level);
  return learn_limits(visitor.far_known, cut_line || cut_cone);
}

template <int S>
bool ExactSearch::scan_around_start(int down) {
  const ConeFrame cone = frame_at<S>(map_, root_.at.x, root_.at.y, down);
  Visitor<S> visitor{*this, down, cone.line0};
  return ConeScan<S, Visitor<S>>(cone, stack_, visitor).from_centre(S > 0 ? map_.width : 0);
}

// Looks at what paths up to the horizon may turn at first.
void ExactSearch::look_around_start() {
  const auto way = [this](int x, int y) { return distance(start_.x, start_.y, 2 * x, 2 * y); };
  const auto worth = [&](int x, int y) {
    return way(x, y) + distance(2 * x, 2 * y, goal_.x, goal_.y) < horizon_;
  };
  exact::EndView(map_, start_, *poller_).run(worth, [&](const exact::SeenCorner& seen) {
    const bool column = seen.side == exact::kColumn;
    const Heading heading(column ? -seen.block_x : seen.block_x,
                          column ? seen.block_y : -seen.block_y, column);
    reach(seen.x, seen.y, heading);
  });
}

bool ExactSearch::scan_around_start() {
  root_ = {CornerTable::kStart, start_.near(), start_.x, start_.y, 0};
  if (!start_.is_centre()) {
    look_around_start();
    return true;  // what lies behind the horizon was not looked at
  }
  bool cut_off = false;
  for (const int down : {1, -1}) {
    cut_off |= scan_around_start<1>(down);
    cut_off |= scan_around_start<-1>(down);
  }
  return cut_off;
}

bool ExactSearch::scan_cone(std::uint32_t index) {
  if (index == CornerTable::kStart) return scan_around_start();
  return corners_[index].heading.right() > 0 ? scan_cone<1>(index) : scan_cone<-1>(index);
}

}  // namespace lasius
