// Paths made cheaper: certified shortcuts, then their joints moved as long as that helps.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/poller.h"
#include "core/vehicle/prices.h"
#include "core/vehicle/sweep.h"

namespace lasius::vehicle {

/// A path with the same ends that costs no more. Stopped: the best so far.
/// @param checked  counts motions that were certified or refused
std::vector<Segment> smoothed(const Space::Impl& space, const Prices& prices,
                              std::vector<Segment> path, std::int64_t& checked, Poller& poller);

}  // namespace lasius::vehicle
