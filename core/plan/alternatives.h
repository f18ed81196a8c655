// The ways that a request asks for beside the shortest one.
#pragma once

#include "core/plan/answer.h"
#include "core/plan/plan_ends.h"
#include "core/plan/workspace.h"

namespace lasius {

/// @throws Error(invalid_parameter) where a request asks for more alternatives than there may be,
/// or for some of a plan that has none.
void check_alternatives(const Request& request, const Algorithm& algorithm, Disc robot);

/// Adds Result::alternatives to a shortest path between two places of a point's map. A request that
/// was stopped meanwhile has those found so far, and says so in its status.
void add_alternatives(const PlanningMap& map, const Request& request, const Places& places,
                      WorkspaceMemory& memory, Result& result);

}  // namespace lasius
