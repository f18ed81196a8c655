// Answers by what was prepared of a map before it was edited, where they are still right.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/exact/corner_graph.h"
#include "core/exact/exact_answer.h"
#include "core/exact/labels/corner_labels.h"
#include "core/exact/labels/label_search.h"
#include "core/exact/prepared_search.h"
#include "lasius/base/stop.h"
#include "lasius/grid/grid.h"

namespace lasius {

/// A map, and what was prepared of it.
struct PreparedMap {
  Grid grid;
  std::shared_ptr<const exact::CornerGraph> graph;
  std::shared_ptr<const exact::CornerLabels> labels = {};  ///< null: none
};

/// A prepared map and how a later one differs from it. The shortest path of the older map is one of
/// the later map, too, where it is a path there still and no way through what has become free is
/// shorter: cells that were blocked since only take ways away. A way that enters freed cells goes
/// to the first and from the last of them by the older map, so it is at least as long as
///   d(start, first) + |first, last| + d(last, goal),
/// d by the older map's labels. A cell for which the straight distances are too long together needs
/// no look. Immutable.
class StaleAnswers {
 public:
  /// `changed`: cells of `now` that may differ from the older map.
  StaleAnswers(std::shared_ptr<const PreparedMap> older, const Grid& now,
               std::span<const Cell> changed);
  /// Of a later version; `changed` since the one before.
  StaleAnswers(const StaleAnswers& before, const Grid& now, std::span<const Cell> changed);

  /// Memory for searches, one a thread.
  struct Memory {
    exact::LabelSearch& labels;
    exact::PreparedSearch& prepared;
  };
  /// A shortest path on `now`, the map of this version, between two points of free cells. False
  /// where the older map does not tell, or stopped. Without labels not asked where the call may be
  /// stopped, nor where a better path is to be told or a gap is enough: only the ordinary search
  /// has some path early.
  bool search(Memory memory, const Grid& now, Point from, Point to, const ExactOptions& options,
              const StopCondition& stop, ExactAnswer& answer) const;

  const PreparedMap& older() const noexcept { return *older_; }
  std::int64_t bytes() const noexcept;  ///< memory held, beside what was prepared
  /// False once so many cells are free that it tells nothing any more, of later versions, too.
  bool tells() const noexcept { return tells_; }

 private:
  /// A cell that has become free, and the cells beside it that were free before: their centres are
  /// at most kReach from where a way comes to it.
  struct Freed {
    Cell cell;
    std::vector<exact::LabelSearch::View> beside = {};
  };
  static constexpr double kReach = 0.70711;  ///< half a cell's diagonal

  void take(const Grid& now, std::span<const Cell> changed);
  Freed freed(Cell cell, exact::LabelSearch& search) const;
  bool none_shorter(Memory memory, Point from, Point to, double length) const;

  std::shared_ptr<const PreparedMap> older_;
  std::vector<std::shared_ptr<const Freed>> freed_;  ///< by row and column
  bool tells_ = true;
};

}  // namespace lasius
