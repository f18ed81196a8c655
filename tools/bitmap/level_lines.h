// Lines of equal values of a proof's potential.
#pragma once

#include <array>
#include <vector>

#include "lasius/cost/proof.h"

namespace lasius::tool {

/// Values at the corners of cells.
struct CornerValues {
  std::vector<Cell> cells = {};
  std::vector<std::array<double, 4>> values = {};  ///< clockwise from the upper left corner
  double most = 0;
};

/// Those of the widest level of a proof, which goes by cells: at most the least costs from there to
/// where the level begins. Empty where the proof has none or is broken.
CornerValues corner_values(const CostProof& proof, const Grid& map);

/// Where the values are multiples of `apart` > 0, as short pieces in cells: on the edges of a cell
/// they are taken as linear, and what crosses them is joined (marching squares).
std::vector<std::array<Point, 2>> level_lines(const CornerValues& corners, double apart);

}  // namespace lasius::tool
