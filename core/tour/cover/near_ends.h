// Which ends of swaths are near to each other around what is blocked, without any leg planned.
#pragma once

#include <span>
#include <vector>

#include "core/tour/cover/tool_lines.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"

namespace lasius::tour {

/// Two ends that the tool can go between, and about how far, cells.
struct EndLink {
  int a, b;
  double length;
};

/// Pairs of stops whose places meet, where each takes the cells that are nearest to it by moves to
/// the four beside: all that can be gone to by clear cells is joined by chains of links. Stops
/// that have no clear cell beside them have none.
/// @param clear  the map whose free cells the tool's centre may be in the middle of
std::vector<EndLink> near_ends(const Grid& clear, const ToolLines& lines,
                               std::span<const Point> stops);

/// All stops, the ends of each swath side by side.
struct SwathChain {
  std::vector<int> order;
  double length = 0;  ///< of the closed tour between swaths, about: as those of links
};
/// Greedily by links and chains of links and swaths, the shortest first; where there are none
/// straight to the nearest. Stops 2 i and 2 i + 1 are the ends of swath i.
SwathChain chained(int swaths, std::span<const Point> stops, std::span<const EndLink> links);

}  // namespace lasius::tour
