// What proves a lower bound of the cost of every path: values on the edges of cells, that anybody
// can check against the map and its weights without a search. See docs/costs.md.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lasius/cost/field.h"
#include "lasius/export.h"
#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"

namespace lasius {

/// No path from the centre of `start` to that of `goal` costs less than `lower_bound`.
struct CostProof {
  /// Values from one end, linear on intervals of the edges of cells.
  struct Level {
    bool from_start = true;  ///< the values' end; else the goal
    int block = 1;           ///< cells a side that the level takes as one: 8 on the first, then 1
    int intervals = 2;       ///< an edge: a power of two; 2 on the first, then more with each level
    /// The cells of the level, or its blocks: y, the first x and how many from there on, three
    /// numbers a run, row by row from the top left. Each level's are cells of the one before.
    std::vector<int> runs = {};
    /// Cell by cell in the order of the runs, each cell's clockwise from its upper left corner, 4
    /// `intervals` of them, save those on an edge that it shares with the cell above or left of it.
    std::vector<double> values = {};
    friend bool operator==(const Level&, const Level&) = default;
  };

  Cell start;                    ///< where paths begin, at its centre
  Cell goal;                     ///< where they end
  double lower_bound = 0;        ///< of their costs
  std::uint64_t map_hash = 0;    ///< Grid::hash
  std::uint64_t costs_hash = 0;  ///< CostField::hash
  /// From the start over blocks, then from the goal and from the start in turn; none where the
  /// straight way at the least weight proves the bound.
  std::vector<Level> levels = {};
  friend bool operator==(const CostProof&, const CostProof&) = default;
};

/// Nothing where the proof holds for this map and these costs, else the first fault, as a sentence.
/// Looks at every cell of every level and searches nothing. Takes 32 bytes a cell and interval.
/// @throws Error(invalid_parameter) for costs of another size than the grid's.
LASIUS_EXPORT std::optional<std::string> check_proof(const Grid& grid, const CostField& costs,
                                                     const CostProof& proof);

}  // namespace lasius
