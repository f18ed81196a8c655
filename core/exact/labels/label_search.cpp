#include "core/exact/labels/label_search.h"

#include <algorithm>
#include <cmath>

#include "core/base/held_bytes.h"
#include "core/grid/grid_view.h"

namespace lasius::exact {

void LabelSearch::begin(const CornerGraph& graph, const CornerLabels& labels) {
  graph_ = &graph;
  labels_ = &labels.arrays();
  owner_ = &labels;
  if (lengths_.size() < labels_->corners.size()) {
    lengths_.assign(labels_->corners.size(), kInfinity);
    marks_.assign(labels_->corners.size(), 0);
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

void LabelSearch::add(const TileCorner& seen, End& end) {
  const GraphCorner corner = seen.corner();
  const LabelCorner& label = labels_->corners[seen.number];
  const Side side = corner.side_from(end.at.x, end.at.y);
  const std::uint32_t first = side == kColumn ? label.first : label.middle;
  const std::uint32_t last = side == kColumn ? label.middle : label.last;
  const int bend = corner.bend(side);
  const int dx = 2 * corner.x() - end.at.x, dy = 2 * corner.y() - end.at.y;
  std::uint32_t taut = first;
  for (; taut < last; ++taut) {
    const LabelGroup& group = labels_->groups[taut];
    const std::int64_t turn = std::int64_t{dx} * (group.y - corner.y()) -
                              std::int64_t{dy} * (group.x - corner.x());
    if (turn * bend < 0) break;
  }
  const double x = dx, y = dy;
  const double before = 0.5 * std::sqrt(x * x + y * y);
  const LabelGroup* groups = labels_->groups.data();
  end.blocks.push_back({groups[first].first, groups[taut].first, seen.number, before});
  end.entries += groups[taut].first - groups[first].first;
}

// What an end sees: `dead(corner)` for those at which a path can only end.
template <class Dead>
void LabelSearch::gather(Cell cell, End& end, const Dead& dead) {
  end.at = {2 * cell.x + 1, 2 * cell.y + 1};
  end.blocks.clear();
  end.entries = 0;
  const Tile* tile = labels_->tiles.data() + owner_->tile_of(cell);
  const int place = CornerLabels::place_of(cell);
  const std::uint64_t* mask = labels_->masks.data() + tile->masks;
  const TileCorner* live = labels_->live.data();
  for (std::uint32_t i = tile->live_full; i < tile->live_partial; ++i) add(live[i], end);
  for (std::uint32_t i = tile->live_partial; i < tile[1].live_full; ++i, ++mask)
    if ((*mask >> place & 1) != 0) add(live[i], end);
  const std::uint32_t* numbers = labels_->dead.data();
  for (std::uint32_t i = tile->dead_full; i < tile->dead_partial; ++i) dead(numbers[i]);
  for (std::uint32_t i = tile->dead_partial; i < tile[1].dead_full; ++i, ++mask)
    if ((*mask >> place & 1) != 0) dead(numbers[i]);
}

void LabelSearch::scatter(const End& end) {
  const std::uint32_t* hubs = labels_->hubs.data();
  const double* ways = labels_->lengths.data();
  double* lengths = lengths_.data();
  for (const Block& block : end.blocks) {
    double& own = lengths[labels_->corners[block.corner].rank];
    own = std::min(own, block.before);
    for (std::uint32_t e = block.first; e < block.last; ++e) {
      double& length = lengths[hubs[e]];
      length = std::min(length, block.before + ways[e]);
    }
  }
}

void LabelSearch::clear(const End& end) {
  const std::uint32_t* hubs = labels_->hubs.data();
  for (const Block& block : end.blocks) {
    lengths_[labels_->corners[block.corner].rank] = kInfinity;
    for (std::uint32_t e = block.first; e < block.last; ++e) lengths_[hubs[e]] = kInfinity;
  }
}

// The least sum over common hubs of what was scattered of `from` and the entries of `to`.
bool LabelSearch::merge(const End& from, const End& to) {
  const std::uint32_t* hubs = labels_->hubs.data();
  const double* ways = labels_->lengths.data();
  const double* lengths = lengths_.data();
  for (const Block& block : to.blocks) {
    if (block.before + distance_to(from, block.corner) >= best_) continue;
    const std::uint32_t rank = labels_->corners[block.corner].rank;
    double least = lengths[rank];
    std::uint32_t hub = rank;
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
  return best_ < kInfinity;
}

// The corners from an end to a hub, the hub the last.
void LabelSearch::trace(const End& end, std::uint32_t hub, double,
                        std::vector<std::uint32_t>& corners) const {
  const std::uint32_t* hubs = labels_->hubs.data();
  const double* ways = labels_->lengths.data();
  double least = kInfinity;
  std::uint32_t first = kNone, entry = kNone;
  for (const Block& block : end.blocks) {
    if (labels_->corners[block.corner].rank == hub && block.before < least) {
      least = block.before;
      first = block.corner;
      entry = CornerLabels::kArrived;
    }
    for (std::uint32_t e = block.first; e < block.last; ++e) {
      if (hubs[e] != hub || block.before + ways[e] >= least) continue;
      least = block.before + ways[e];
      first = block.corner;
      entry = e;
    }
  }
  corners.assign(1, first);
  while (entry != CornerLabels::kArrived) {
    const LabelStep& step = labels_->steps[entry];
    corners.push_back(step.corner);
    entry = step.entry;
  }
}

bool LabelSearch::search(const Grid& grid, const CornerGraph& graph, const CornerLabels& labels,
                         Cell start, Cell goal, const ExactOptions& options, ExactAnswer& answer) {
  const kernels::BitmapView map = view_of(grid);
  const kernels::HalfPoint from{2 * start.x + 1, 2 * start.y + 1};
  const kernels::HalfPoint to{2 * goal.x + 1, 2 * goal.y + 1};
  begin(graph, labels);
  corners_.clear();
  if (kernels::sees(map, from, to)) {
    best_ = exact::distance(from.x, from.y, to.x, to.y);
  } else {
    gather(start, start_, [&](std::uint32_t corner) { marks_[corner] = stamp_; });
    for (const Block& block : start_.blocks) marks_[block.corner] = stamp_;
    goal_.at = to;
    const auto bend = [&](std::uint32_t corner) {
      if (marks_[corner] != stamp_) return;
      const double length = distance_to(start_, corner) + distance_to(goal_, corner);
      if (length >= best_) return;
      best_ = length;
      best_bend_ = corner;
    };
    gather(goal, goal_, bend);
    for (const Block& block : goal_.blocks) bend(block.corner);
    const bool swap = start_.entries > goal_.entries;
    const End& near = swap ? goal_ : start_;
    const End& far = swap ? start_ : goal_;
    scatter(near);
    merge(near, far);
    clear(near);
    if (best_ == kInfinity) return false;
    if (best_bend_ != kNone) {
      corners_.assign(1, best_bend_);
    } else {
      trace(start_, best_hub_, 0, corners_);
      trace(goal_, best_hub_, 0, more_);
      for (std::size_t i = more_.size() - 1; i-- > 0;) corners_.push_back(more_[i]);
    }
  }
  answer.path.clear();
  const QueryEnd begin_at(centre(start));
  BackwardPath back(QueryEnd(centre(goal)), answer.path);
  const auto place = [&](std::uint32_t c) {
    return kernels::HalfPoint{2 * graph.corner(c).x(), 2 * graph.corner(c).y()};
  };
  for (std::size_t i = corners_.size(); i-- > 0;)
    back.corner(place(corners_[i]), i == 0 ? begin_at.fine() : kernels::fine(place(corners_[i - 1])));
  back.start(begin_at);
  improvements_.begin(options);
  improvements_.tell(best_, best_, nullptr, [&](std::vector<Point>& path) {
    path = answer.path;
    return path_length(path);
  });
  conclude(best_, best_, StopCondition::Cause::none, options.target_gap, answer);
  return true;
}

std::int64_t LabelSearch::bytes() const noexcept {
  return held_bytes(lengths_, marks_, start_.blocks, goal_.blocks, corners_, more_, path_) +
         improvements_.bytes();
}

}  // namespace lasius::exact
