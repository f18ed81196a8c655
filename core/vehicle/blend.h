// Paths whose curvature does not jump: clothoids where arcs and lines meet.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/poller.h"
#include "core/vehicle/sweep.h"

namespace lasius::vehicle {

/// The vehicle that the search and the smoothing plan for: one whose curvature may change so fast
/// alone is given turns a tenth wider, to have something left for the clothoids.
Vehicle with_room(Vehicle vehicle);

/// A path with the same ends, cusps and turns in place. Where arcs and lines meet the curvature
/// changes along clothoids; their lengths, and the curvature of arcs, are changed by as little as
/// leads to the same end. A part where that is not found, or is not certified, is halved: the path
/// keeps the corner there. Once stopped it keeps all that are left.
/// @param asked  the vehicle, its curvature_rate above 0
std::vector<Segment> blended(const Space::Impl& space, const Vehicle& asked,
                             const std::vector<Segment>& path, std::int64_t& checked,
                             Poller& poller);

}  // namespace lasius::vehicle
