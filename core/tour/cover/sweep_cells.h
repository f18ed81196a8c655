// The boustrophedon decomposition of a tool's free space (Choset & Pignol 1998).
#pragma once

#include <vector>

#include "core/base/poller.h"
#include "core/tour/cover/tool_lines.h"

namespace lasius::tour {

/// What a sweeping line meets between two of its places at which the stretches it crosses part,
/// join, begin, end or leap: there one stretch, whose ends move.
struct SweepCell {
  double from = 0, to = 0;                        ///< the sweeping line's c
  bool wall_before = false, wall_behind = false;  ///< at most half of it goes on in other cells
  struct Slice {
    double c = 0;
    Stretch stretch;
  };
  std::vector<Slice> slices;  ///< by rising c, at least one
};

/// The cells of a sweep across a heading: along an axis all that happens is found, else what
/// happens between lines an eighth of a width apart. A leap is of more than a width, and a third of
/// the stretch.
/// Stopped, the cells so far.
std::vector<SweepCell> sweep_cells(const ToolLines& lines, const Heading& heading, double width,
                                   Poller& poller);

}  // namespace lasius::tour
