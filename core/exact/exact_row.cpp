// All corners near a question's ends, by the search that stores nothing of a map.
#include <limits>

#include "core/exact/exact.h"

namespace lasius {

using exact::CornerTable;
using exact::TautRow;

bool ExactSearch::row(const Grid& grid, Point from, Point to, double bound,
                      const StopCondition& stop, TautRow& row) {
  begin(grid, from, to);
  row.corners.clear();
  upper_ = bound;
  passes_goal_ = true;
  run_plain(stop, std::numeric_limits<std::int64_t>::max());
  for (std::uint32_t i = 1; i < corners_.size(); ++i) {
    const exact::Corner& corner = corners_[i];
    const std::uint32_t parent =
        corner.parent == CornerTable::kStart ? TautRow::kEnd : corner.parent - 1;
    row.corners.push_back({corner.x / 2, corner.y / 2, corner.length, parent});
  }
  return cause_ != StopCondition::Cause::none;
}

}  // namespace lasius
