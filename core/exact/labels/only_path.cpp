// Whether a path that labels tell is the only one as short; the proof is in docs/exact.md.
#include <algorithm>

#include "core/exact/labels/label_search.h"

namespace lasius::exact {

namespace {

constexpr std::size_t kMostHubs = 16;  // and chains to one: more are not looked at one by one

}  // namespace

// The hubs over which a path may be as short. False where there are too many.
bool LabelSearch::list_hubs(const End& from, const End& to) {
  const double most = best_ * (1 + kAlike);
  const auto add = [&](std::uint32_t hub) {
    if (std::ranges::find(hubs_, hub) == hubs_.end()) hubs_.push_back(hub);
    return hubs_.size() <= kMostHubs;
  };
  for (const Block& block : to.blocks) {
    if (block.before + distance_to(from, block.corner) > most) continue;
    const std::uint32_t rank = arrays_->corners[block.corner].rank;
    if (block.before + lengths_[rank] <= most && !add(rank)) return false;
    for (std::uint32_t e = block.first; e < block.last; ++e) {
      const std::uint32_t hub = arrays_->hubs[e];
      if (block.before + lengths_[hub] + arrays_->lengths[e] <= most && !add(hub)) return false;
    }
  }
  return true;
}

// Ways from an end to a hub that are no longer than that. False where an entry is tied, or there
// are too many.
bool LabelSearch::list_chains(const End& end, std::uint32_t hub, double most,
                              std::vector<Chain>& chains) const {
  chains.clear();
  for (const Block& block : end.blocks) {
    if (block.before > most) continue;
    if (arrays_->corners[block.corner].rank == hub)
      chains.push_back({block.corner, CornerLabels::kArrived, block.before});
    for (std::uint32_t e = block.first; e < block.last; ++e) {
      const double length = block.before + arrays_->lengths[e];
      if (arrays_->hubs[e] != hub || length > most) continue;
      if (arrays_->steps[e].tied()) return false;
      chains.push_back({block.corner, e, length});
    }
  }
  return chains.size() <= kMostHubs;
}

// All that may be as short goes the same way, and no two corners of it are joined by another one.
bool LabelSearch::is_only() {
  const double most = best_ * (1 + kAlike);
  std::vector<Point>& first = outline_;
  outline(first);
  ties_.clear();
  std::vector<Point> other;
  const auto same = [&] {
    outline(other);
    for (const std::uint32_t corner : corners_)
      if (labels_->has_tie(corner)) ties_.push_back(corner);
    return other == first;
  };
  for (const auto& [corner, length] : bends_) {
    if (length > most) continue;
    corners_.assign(1, corner);
    if (!same()) return false;
  }
  for (const std::uint32_t hub : hubs_) {
    if (!list_chains(start_, hub, most, chains_)) return false;
    if (!list_chains(goal_, hub, most, other_chains_)) return false;
    for (const Chain& a : chains_)
      for (const Chain& b : other_chains_) {
        if (a.length + b.length > most) continue;
        join(a, b);
        if (!same()) return false;
      }
  }
  std::ranges::sort(ties_);
  ties_.erase(std::unique(ties_.begin(), ties_.end()), ties_.end());
  for (std::size_t i = 0; i < ties_.size(); ++i)
    for (std::size_t j = i + 1; j < ties_.size(); ++j)
      if (labels_->tied(ties_[i], ties_[j])) return false;
  return true;
}

bool LabelSearch::search_only(const Grid& grid, const CornerGraph& graph,
                              const CornerLabels& labels, Point start, Point goal,
                              const ExactOptions& options, const StopCondition& stop,
                              ExactAnswer& answer) {
  certify_ = true;
  if (!find(grid, graph, labels, start, goal, stop)) return false;
  const auto told = corners_;
  if (!corners_.empty() && !is_only()) return false;
  corners_ = told;
  write_path(options, answer);
  return true;
}

}  // namespace lasius::exact
