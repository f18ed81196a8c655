#include "core/exact/exact.h"

#include <algorithm>
#include <cmath>

#include "core/base/held_bytes.h"
#include "core/base/special_values.h"
#include "core/exact/anytime.h"
#include "core/grid/grid_view.h"
#include "kernels/sight/sight.h"

namespace lasius {

using exact::Corner;
using exact::CornerTable;
using exact::distance;
using exact::kBucketWidth;
using exact::kDefaultWeight;
using exact::kFirstWeighted;
using exact::kTrailBuckets;
using exact::kWeightedShare;
using exact::kWordsPerExpansion;
using exact::kWordsPerPoll;

namespace {

// Between its runs the weighted search rests, for so many expansions: most searches are over
// before.
constexpr std::int64_t kWeightedRest = 256;
constexpr std::int64_t kWeightedReturn = 4096;
// The expansions of the weighted search before any other, for each cell of the straight distance:
// of the bounding search where there is a target gap, and more on ways so long that the proof takes
// its time; and with the default W where that finds no path (mazes, warehouses, dense noise, small
// gaps).
constexpr double kFirstRun = 1;
constexpr double kLongFirstRun = 4;
constexpr double kSecondRun = 2;
// A target gap above this asks for any path; what is computed with it stays finite.
constexpr double kWidestGap = 1e6;
// What W of the bounding search takes of the target gap; the width of buckets has the rest.
constexpr double kShareOfGap = 0.95;

// How far ahead of a corner's bound its cone is scanned at first: a share of the straight distance
// from start to goal (a larger one where any path in reach will do), and of what the lower bound
// has risen above that distance, which says how crowded the map is. And how often a cone is scanned
// before the horizon is dropped.
constexpr double kHorizon = 1.0 / 1024;
constexpr double kBoundingHorizon = 1.0 / 64;
constexpr double kHorizonOfRise = 4;
constexpr int kMostScans = 4;

}  // namespace

// Expands a corner, and lets the search beside take its turn.
void ExactSearch::step(std::uint32_t index) {
  expand(index);
  poller_->stop_after(kWordsPerExpansion);
  if (beside_ != nullptr) beside_->take_turn(*poller_);
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
  if (corner.scans < kMostScans) {
    const bool any_path = mode_ == Mode::bounded || mode_ >= Mode::bounding;
    const double share = any_path ? kBoundingHorizon : kHorizon;
    const double ahead =
        (share * straight_ + kHorizonOfRise * (lower_ - straight_)) * (1 << 2 * corner.scans);
    horizon_ = std::min(upper_, bound + ahead);
  }
  const double horizon = horizon_;
  const bool cut_off = scan_cone(index);
  if (!cut_off || horizon >= upper_) return;
  Corner& again = corners_[index];
  again.expanded = false;
  again.weighed = false;
  ++again.scans;
  if (mode_ != Mode::improving) frontier_.push(index, horizon);
  if (weighs()) weighted_frontier_.push(index, horizon + (weight_ - 1) * again.to_goal);
}

// Takes the best corner of the frontier; false when none can lead to a shorter path, or stopped.
bool ExactSearch::next_corner(std::uint32_t& index) {
  while (frontier_.advance(*poller_)) {
    lower_ = std::max(lower_, std::min(frontier_.floor(), upper_));
    if (too_long(frontier_.floor())) return false;
    index = frontier_.pop();
    const Corner& corner = corners_[index];
    if (!corner.expanded && !too_long(corner.length + corner.to_goal)) return true;
    if (poller_->stop_after(1)) return false;
  }
  lower_ = upper_;
  return false;
}

// Expands corners by the frontier that weighs the distance to the goal more. What it finds enters
// both frontiers.
void ExactSearch::search_weighted(std::int64_t steps) {
  for (; steps > 0 && upper_ == kInfinity && !poller_->stopped(); --steps) {
    if (!weighted_frontier_.advance(*poller_)) break;
    const std::uint32_t index = weighted_frontier_.pop();
    Corner& corner = corners_[index];
    if (corner.weighed || corner.expanded) continue;
    corner.weighed = true;
    step(index);
  }
  const bool bounding = mode_ == Mode::bounding;
  if (upper_ < kInfinity) mode_ = bounding ? Mode::bounded : Mode::plain;
  // A scan that was stopped may have left out what would come first.
  if (!bounding || poller_->stopped()) return;
  const double least =
      weighted_frontier_.advance(*poller_) ? weighted_frontier_.floor() / weight_ : kInfinity;
  lower_ = std::max(lower_, std::min(least, upper_));
}

// The bounding search has found no path: from here on the lower bound is the frontier's.
void ExactSearch::restore_default_weight() {
  mode_ = Mode::weighted;
  weight_ = kDefaultWeight;
  weighted_frontier_.reset(lower_, kBucketWidth);
  for (std::uint32_t i = 0; i < corners_.size() && !poller_->stop_after(1); ++i) {
    const Corner& corner = corners_[i];
    if (!corner.expanded) weighted_frontier_.push(i, corner.length + weight_ * corner.to_goal);
  }
}

void ExactSearch::run(const ExactOptions& options, const StopCondition& stop) {
  Poller poller(stop, kWordsPerPoll);
  poller_ = &poller;
  beside_ = options.beside;
  frontier_.reset(lower_, kBucketWidth);
  const double gap = std::min(options.target_gap, kWidestGap);
  if (gap > 0) mode_ = Mode::bounding;
  weight_ = gap > 0 ? 1 + kShareOfGap * gap : kDefaultWeight;
  weighted_frontier_.reset(lower_, std::max(kBucketWidth, lower_ * gap / kTrailBuckets));
  expand(CornerTable::kStart);
  const auto first = [&](double a_cell) { search_weighted(std::llround(a_cell * straight_)); };
  const bool long_way = straight_ > exact::kLongWay;
  if (gap > 0 || long_way) first(long_way ? kLongFirstRun : kFirstRun);
  if (mode_ == Mode::bounding) {
    restore_default_weight();
    first(kSecondRun);
  }
  std::int64_t next_weighted = kFirstWeighted;
  std::uint32_t index = 0;
  bool go_on = tell_improvement();
  while (go_on && !poller.stopped() && next_corner(index)) {
    if (upper_ - lower_ <= gap * lower_) break;
    step(index);
    go_on = tell_improvement();
    if (!weighs() || counters_.expansions < next_weighted) continue;
    search_weighted(counters_.expansions / kWeightedShare);
    next_weighted = counters_.expansions * 2;
    if (next_weighted > kWeightedRest) next_weighted = std::max(next_weighted, kWeightedReturn);
  }
  poller_ = nullptr;
  beside_ = nullptr;
  cause_ = go_on ? poller.cause() : StopCondition::Cause::token;
}

bool ExactSearch::tell_improvement() {
  return improvements_.tell(lower_, upper_, poller_, [this](std::vector<Point>& path) {
    trace(path);
    return path_length(path);
  });
}

void ExactSearch::begin(const Grid& grid, Point start, Point goal, Mode mode) {
  mode_ = mode;
  beside_ = nullptr;
  map_ = view_of(grid);
  start_ = exact::QueryEnd(start);
  goal_ = exact::QueryEnd(goal);
  counters_ = {};
  cause_ = StopCondition::Cause::none;
  lower_ = distance(start_.x, start_.y, goal_.x, goal_.y);
  upper_ = kInfinity;
  straight_ = lower_;
  last_ = CornerTable::kStart;
  touched_ = nullptr;
  near_lines_ = exact::kLeastNear;
  barren_tests_ = exact::kFirstBarrenTests;
  ties_ = {};
  root_ = {};
  const kernels::HalfPoint near = start_.near();
  corners_.reset(grid.width(),
                 {near.x, near.y, 0, lower_, CornerTable::kStart, {}, false, true, false, 0});
}

kernels::FinePoint ExactSearch::place(std::uint32_t index) const noexcept {
  if (index == CornerTable::kStart) return start_.fine();
  return kernels::fine({corners_[index].x, corners_[index].y});
}

void ExactSearch::search(const Grid& grid, Point start, Point goal, const ExactOptions& options,
                         const StopCondition& stop, ExactAnswer& answer) {
  begin(grid, start, goal, Mode::weighted);
  improvements_.begin(options);
  if (start_.sees(map_, goal_)) {
    upper_ = lower_;
  } else if (!search_only(options, stop)) {
    const exact::Counters::Ties ties = counters_.ties;
    begin(grid, start, goal, Mode::weighted);
    run(options, stop);
    counters_.ties = ties;
  }
  tell_improvement();  // the last one; nothing is left to stop
  answer.path.clear();
  if (upper_ < kInfinity) trace(answer.path);
  exact::conclude(lower_, upper_, cause_, options.target_gap, answer);
}

void ExactSearch::trace(std::vector<Point>& path) const {
  exact::BackwardPath back(goal_, path);
  for (std::uint32_t i = last_; i != CornerTable::kStart; i = corners_[i].parent)
    back.corner({corners_[i].x, corners_[i].y}, place(corners_[i].parent));
  back.start(start_);
}

std::int64_t ExactSearch::bytes() const noexcept {
  return corners_.bytes() + frontier_.bytes() + weighted_frontier_.bytes() + held_bytes(stack_) +
         improvements_.bytes();
}

}  // namespace lasius
