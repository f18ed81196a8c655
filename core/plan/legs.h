// A plan through points, leg by leg.
#pragma once

#include <functional>

#include "lasius/grid/grid.h"
#include "lasius/grid/moves.h"
#include "lasius/plan/request.h"
#include "lasius/plan/result.h"

namespace lasius {

/// Answers a request that has Request::via: plans from each of its points to the next by
/// `plan(leg)`, and joins the answers as Result says.
Result plan_legs(const Request& asked, const std::function<Result(const Request&)>& plan);

/// Makes such an answer unreachable where one leg comes to a point, and the next goes on from it,
/// on different sides of two blocked cells that meet there.
void refuse_squeezes(const Grid& grid, const Request& asked, Corners corners, Result& result);

}  // namespace lasius
