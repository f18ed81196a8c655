// Lengths from one place to many, by labels.
#include <algorithm>

#include "core/exact/labels/label_search.h"
#include "core/grid/grid_view.h"

namespace lasius::exact {

LabelSearch::View LabelSearch::view(const Grid& grid, const CornerGraph& graph,
                                    const CornerLabels& labels, Cell cell) {
  begin(graph, labels);
  View view{.at = QueryEnd(centre(cell)), .blocks = {}};
  const StopCondition never;
  Poller poller(never);
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

}  // namespace lasius::exact
