// What pictures of vehicles have in common.
#pragma once

#include <span>

#include "lasius/vehicle/vehicle.h"
#include "tools/draw/axes.h"
#include "tools/draw/canvas.h"
#include "tools/draw/legend.h"

namespace lasius::tool {

/// Footprints along poses, so far apart that they tell where it looks, and at both ends.
void draw_sweep(Canvas& canvas, const Axes& axes, const vehicle::Vehicle& vehicle,
                std::span<const vehicle::Pose> poses, const vehicle::Pose& start,
                const vehicle::Pose& goal);
Key sweep_key();

}  // namespace lasius::tool
