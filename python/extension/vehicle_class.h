// What VehiclePlanner, VehicleNavigator, tours and drives of vehicles share.
#pragma once

#include <vector>

#include "lasius/vehicle/planner.h"
#include "python/extension/arrays.h"

namespace lasius::python {

/// Rows x, y, yaw.
std::vector<vehicle::Pose> poses_from(const Rows& rows, const char* name);
py::array_t<double> pose_rows(const std::vector<vehicle::Pose>& poses);
/// Rows as of lasius.VehicleResult.segments.
py::array_t<double> segment_rows(const std::vector<vehicle::Segment>& segments);
/// The fields of lasius.VehicleResult.
py::tuple vehicle_fields(const vehicle::Result& found);

}  // namespace lasius::python
