// The terminal index of a cell: how far the goal is by the best walk known (Li, Wang & Ma).
#pragma once

#include <cstdint>
#include <vector>

#include "core/colony/field.h"
#include "core/colony/update.h"
#include "kernels/base/moves.h"
#include "lasius/params/params.h"

namespace lasius {

/// After an iteration (section 2.2): backwards along every successful path
/// K(c) <- min(K(c), K(next) + step), the smaller value carried on.
void update_terminal_index(Field& field, const GridTours& tours);

/// The generation's answer of the terminal index: from the start always along the largest gradient,
/// as `reading` has it, ties to the first move (Li, Wang & Ma, section 2.2). Empty while the start
/// has no index.
void best_known_way(Field& field, const kernels::Moves& moves, Cell start, Cell goal,
                    IndexAnswer reading, std::vector<std::uint8_t>& way);

/// Fits the terminal index to cells of `part` that were blocked or freed: forgets every K(c) that
/// no way holds up any more, that is, but for the goal's, where no move that exists leads to a c'
/// with K(c') + step <= K(c); so what led through blocked cells goes, from cell to cell. Work grows
/// with `part` and what is forgotten.
void forget_lost_ways(Field& field, const Grid& grid, Corners corners, const kernels::Moves& moves,
                      Cell goal, const Rectangle& part);

}  // namespace lasius
