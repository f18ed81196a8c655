// A plan through points, leg by leg.
#pragma once

#include <functional>

#include "lasius/request.h"
#include "lasius/result.h"

namespace lasius {

/// Answers a request that has Request::via: plans from each of its points to the next by
/// `plan(leg)`, and joins the answers as Result says.
Result plan_legs(const Request& asked, const std::function<Result(const Request&)>& plan);

}  // namespace lasius
