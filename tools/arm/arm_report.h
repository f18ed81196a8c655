// The page of a run of `lasius arm`: the arm in space, to be turned, its motion in time.
#pragma once

#include <iosfwd>

#include "tools/arm/arm_answer.h"
#include "tools/record/record.h"

namespace lasius::tool {

/// Adds to run_json: solids [{body, shape, size, radius, length, triangles, pose}], body -1 of
/// obstacles, 0 the base; motion {times, joints, poses, tips, names}: joints packed by time, poses
/// of bodies 0.. as 12 numbers each (rows of 3 x 4), likewise; lattice [[x, y, z]...]; goals.
void write_arm_report(std::ostream& out, const Record& run, const ArmCommand& command,
                      const ArmAnswer& answer);

}  // namespace lasius::tool
