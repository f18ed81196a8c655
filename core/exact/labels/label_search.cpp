#include "core/exact/labels/label_search.h"

#include <algorithm>
#include <cmath>

#include "core/base/held_bytes.h"
#include "core/grid/grid_view.h"

namespace lasius::exact {

void LabelSearch::begin(const CornerGraph& graph, const CornerLabels& labels) {
  graph_ = &graph;
  labels_ = &labels;
  arrays_ = &labels.arrays();
  if (lengths_.size() < graph.size()) {
    lengths_.assign(graph.size(), kInfinity);
    marks_.assign(graph.size(), 0);
    stamp_ = 0;
  }
  if (++stamp_ == 0) {
    std::ranges::fill(marks_, 0);
    stamp_ = 1;
  }
  best_ = kInfinity;
  best_hub_ = best_bend_ = kNone;
}

double LabelSearch::distance_to(const End& end, std::uint32_t corner) const noexcept {
  const GraphCorner& c = graph_->corner(corner);
  return exact::distance(end.at.x, end.at.y, 2 * c.x(), 2 * c.y());
}

// Adds the groups of a side that a path from the end can go on along: those before the first whose
// `turn(x, y)` towards its corner is to the wrong side.
template <class Turn>
void LabelSearch::add_taut(std::uint32_t corner, Side side, int bend, double before,
                           const Turn& turn, End& end) const {
  const LabelCorner& label = arrays_->corners[corner];
  const std::uint32_t first = side == kColumn ? label.first : label.middle;
  const std::uint32_t last = side == kColumn ? label.middle : label.last;
  const LabelGroup* const groups = arrays_->groups.data();
  std::uint32_t taut = first;
  while (taut < last && turn(groups[taut].x, groups[taut].y) * bend >= 0) ++taut;
  end.blocks.push_back({groups[first].first, groups[taut].first, corner, before});
  end.entries += groups[taut].first - groups[first].first;
}

// Of an end at a cell's centre.
void LabelSearch::add(const TileCorner& seen, End& end) const {
  const GraphCorner corner = seen.corner();
  const kernels::HalfPoint at = end.at.near();
  const int dx = 2 * corner.x() - at.x, dy = 2 * corner.y() - at.y;
  const Side side = corner.side_from(at.x, at.y);
  const double x = dx, y = dy;
  const auto turn = [&](int to_x, int to_y) {
    return std::int64_t{dx} * (to_y - corner.y()) - std::int64_t{dy} * (to_x - corner.x());
  };
  add_taut(seen.number, side, corner.bend(side), 0.5 * std::sqrt(x * x + y * y), turn, end);
}

// Of any other.
void LabelSearch::add(const SeenCorner& seen, End& end) const {
  const std::uint32_t number = graph_->index(seen.x, seen.y);
  const GraphCorner& corner = graph_->corner(number);
  const auto turn = [&](int to_x, int to_y) {
    return kernels::turn_sign(end.at.fine(), kernels::fine({2 * seen.x, 2 * seen.y}),
                              kernels::fine({2 * to_x, 2 * to_y}));
  };
  add_taut(number, seen.side, corner.bend(seen.side), distance_to(end, number), turn, end);
}

// What an end sees: `dead(corner)` for those at which a path can only end. False if stopped.
template <class Dead>
bool LabelSearch::gather(const kernels::BitmapView& map, End& end, Poller& poller,
                         const Dead& dead) {
  end.blocks.clear();
  end.entries = 0;
  if (!end.at.is_centre()) {
    const auto worth = [](int, int) { return true; };
    EndView(map, end.at, poller).run(worth, [&](const SeenCorner& seen) { add(seen, end); });
    return !poller.stopped();
  }
  const kernels::HalfPoint at = end.at.near();
  const Cell cell{at.x >> 1, at.y >> 1};
  const Tile* const tile = arrays_->tiles.data() + labels_->tile_of(cell);
  const int place = CornerLabels::place_of(cell);
  const std::uint64_t* mask = arrays_->masks.data() + tile->masks;
  const TileCorner* const live = arrays_->live.data();
  for (std::uint32_t i = tile->live_full; i < tile->live_partial; ++i) add(live[i], end);
  for (std::uint32_t i = tile->live_partial; i < tile[1].live_full; ++i, ++mask)
    if ((*mask >> place & 1) != 0) add(live[i], end);
  const std::uint32_t* const numbers = arrays_->dead.data();
  for (std::uint32_t i = tile->dead_full; i < tile->dead_partial; ++i) dead(numbers[i]);
  for (std::uint32_t i = tile->dead_partial; i < tile[1].dead_full; ++i, ++mask)
    if ((*mask >> place & 1) != 0) dead(numbers[i]);
  return true;
}

void LabelSearch::scatter(const End& end) {
  const std::uint32_t* const hubs = arrays_->hubs.data();
  const double* const ways = arrays_->lengths.data();
  double* const lengths = lengths_.data();
  for (const Block& block : end.blocks) {
    double& own = lengths[arrays_->corners[block.corner].rank];
    own = std::min(own, block.before);
    for (std::uint32_t e = block.first; e < block.last; ++e) {
      double& length = lengths[hubs[e]];
      length = std::min(length, block.before + ways[e]);
    }
  }
}

void LabelSearch::clear(const End& end) {
  const std::uint32_t* const hubs = arrays_->hubs.data();
  for (const Block& block : end.blocks) {
    lengths_[arrays_->corners[block.corner].rank] = kInfinity;
    for (std::uint32_t e = block.first; e < block.last; ++e) lengths_[hubs[e]] = kInfinity;
  }
}

// The least sum over common hubs of what was scattered of `from` and the entries of `to`.
void LabelSearch::merge(const End& from, const End& to) {
  const std::uint32_t* const hubs = arrays_->hubs.data();
  const double* const ways = arrays_->lengths.data();
  const double* const lengths = lengths_.data();
  for (const Block& block : to.blocks) {
    if (block.before + distance_to(from, block.corner) >= best_) continue;
    std::uint32_t hub = arrays_->corners[block.corner].rank;
    double least = lengths[hub];
    for (std::uint32_t e = block.first; e < block.last; ++e) {
      const double sum = lengths[hubs[e]] + ways[e];
      hub = sum < least ? hubs[e] : hub;
      least = std::min(least, sum);
    }
    if (block.before + least >= best_) continue;
    best_ = block.before + least;
    best_hub_ = hub;
    best_bend_ = kNone;
  }
}

// How the best path goes from an end to its hub.
LabelSearch::Chain LabelSearch::best_chain(const End& end) const {
  const std::uint32_t* const hubs = arrays_->hubs.data();
  const double* const ways = arrays_->lengths.data();
  Chain best{kNone, CornerLabels::kArrived, kInfinity};
  for (const Block& block : end.blocks) {
    if (block.before >= best.length) continue;
    if (arrays_->corners[block.corner].rank == best_hub_)
      best = {block.corner, CornerLabels::kArrived, block.before};
    for (std::uint32_t e = block.first; e < block.last; ++e)
      if (hubs[e] == best_hub_ && block.before + ways[e] < best.length)
        best = {block.corner, e, block.before + ways[e]};
  }
  return best;
}

// Its corners, the hub the last.
void LabelSearch::follow(const Chain& chain, std::vector<std::uint32_t>& corners) const {
  corners.assign(1, chain.corner);
  for (std::uint32_t entry = chain.entry; entry != CornerLabels::kArrived;) {
    const LabelStep& step = arrays_->steps[entry];
    corners.push_back(step.corner);
    entry = step.entry;
  }
}

// The corners from start to goal.
void LabelSearch::join(const Chain& from_start, const Chain& from_goal) {
  follow(from_start, corners_);
  follow(from_goal, more_);
  corners_.insert(corners_.end(), more_.rbegin() + 1, more_.rend());
}

// Finds the length of the shortest path, and its corners.
bool LabelSearch::find(const Grid& grid, const CornerGraph& graph, const CornerLabels& labels,
                       Point start, Point goal, const StopCondition& stop) {
  const kernels::BitmapView map = view_of(grid);
  start_.at = QueryEnd(start);
  goal_.at = QueryEnd(goal);
  begin(graph, labels);
  corners_.clear();
  if (start_.at.sees(map, goal_.at)) {
    best_ = exact::distance(start_.at.x, start_.at.y, goal_.at.x, goal_.at.y);
    return true;
  }
  Poller poller(stop, kWordsPerPoll);
  const auto mark = [&](std::uint32_t corner) { marks_[corner] = stamp_; };
  const auto bend = [&](std::uint32_t corner) {
    if (marks_[corner] != stamp_) return;
    const double length = distance_to(start_, corner) + distance_to(goal_, corner);
    if (length >= best_) return;
    best_ = length;
    best_bend_ = corner;
  };
  if (!gather(map, start_, poller, mark)) return false;
  for (const Block& block : start_.blocks) mark(block.corner);
  if (!gather(map, goal_, poller, bend)) return false;
  for (const Block& block : goal_.blocks) bend(block.corner);
  // What has fewer entries is written, read and cleared; the other is read once.
  const bool from_goal = goal_.entries < start_.entries;
  const End& from = from_goal ? goal_ : start_;
  const End& to = from_goal ? start_ : goal_;
  scatter(from);
  merge(from, to);
  clear(from);
  if (best_ == kInfinity) return false;
  if (best_bend_ != kNone)
    corners_.assign(1, best_bend_);
  else
    join(best_chain(start_), best_chain(goal_));
  return true;
}

bool LabelSearch::search(const Grid& grid, const CornerGraph& graph, const CornerLabels& labels,
                         Point start, Point goal, const ExactOptions& options,
                         const StopCondition& stop, ExactAnswer& answer) {
  if (!find(grid, graph, labels, start, goal, stop)) return false;
  write_path(options, answer);
  return true;
}

// The path of the corners in hand.
void LabelSearch::outline(std::vector<Point>& path) const {
  BackwardPath back(goal_.at, path);
  for (std::size_t i = corners_.size(); i-- > 0;) {
    const GraphCorner& corner = graph_->corner(corners_[i]);
    const GraphCorner& before = graph_->corner(corners_[i == 0 ? 0 : i - 1]);
    back.corner({2 * corner.x(), 2 * corner.y()},
                i == 0 ? start_.at.fine() : kernels::fine({2 * before.x(), 2 * before.y()}));
  }
  back.start(start_.at);
}

void LabelSearch::write_path(const ExactOptions& options, ExactAnswer& answer) {
  outline(answer.path);
  improvements_.begin(options);
  improvements_.tell(best_, best_, nullptr, [&](std::vector<Point>& path) {
    path = answer.path;
    return path_length(path);
  });
  conclude(best_, best_, StopCondition::Cause::none, options.target_gap, answer);
  answer.stored_legs = true;
}

LabelSearch::View LabelSearch::view(const Grid& grid, const CornerGraph& graph,
                                    const CornerLabels& labels, Point place,
                                    const StopCondition& stop) {
  begin(graph, labels);
  View view{.at = QueryEnd(place), .blocks = {}};
  Poller poller(stop, kWordsPerPoll);
  gather(view_of(grid), view, poller, [&](std::uint32_t corner) { view.dead.push_back(corner); });
  return view;
}

void LabelSearch::lengths_to(const Grid& grid, const CornerGraph& graph, const CornerLabels& labels,
                             const View& start, std::span<const View> targets,
                             std::span<double> lengths) {
  const kernels::BitmapView map = view_of(grid);
  begin(graph, labels);
  for (const Block& block : start.blocks) marks_[block.corner] = stamp_;
  for (const std::uint32_t corner : start.dead) marks_[corner] = stamp_;
  scatter(start);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const View& target = targets[i];
    best_ = kInfinity;
    if (start.at.sees(map, target.at)) {
      lengths[i] = exact::distance(start.at.x, start.at.y, target.at.x, target.at.y);
      continue;
    }
    const auto bend = [&](std::uint32_t corner) {
      if (marks_[corner] != stamp_) return;
      best_ = std::min(best_, distance_to(start, corner) + distance_to(target, corner));
    };
    for (const Block& block : target.blocks) bend(block.corner);
    for (const std::uint32_t corner : target.dead) bend(corner);
    merge(start, target);
    lengths[i] = best_;
  }
  clear(start);
}

std::int64_t LabelSearch::bytes() const noexcept {
  return held_bytes(lengths_, marks_, start_.blocks, goal_.blocks, corners_, more_) +
         improvements_.bytes();
}

}  // namespace lasius::exact
