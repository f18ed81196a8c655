// What is told of a tour's legs and robots: in JSON, tables and ROS paths.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "tools/options/options.h"
#include "tools/record/json_values.h"
#include "tools/record/record.h"
#include "tools/tour/tour_answer.h"

namespace lasius::tool {

/// The paths along all legs, one a robot, in cells, or metres from stop to stop as these were
/// given; of a robot that stays its place. None without a tour.
std::vector<std::vector<Point>> tour_paths(const TourAnswer& answer, bool metres);

/// [{from, to, length, path}, ...], over costs with cost, in metres with path_world.
Json legs_json(const TourAnswer& answer, bool metres);
/// [{start, order, legs, length}, ...] of robots; `legs` are indices of the tour's legs.
Json tours_json(const TourAnswer& answer, bool metres);
/// "2 of 3 robots, "; empty of one alone.
std::string robots_text(const TourResult& tour);

/// robot,x,y or robot,x_m,y_m: the paths of several robots, counted from 0.
void write_robot_table(std::ostream& out, const TourAnswer& answer, bool metres);

/// The page of a tour: a view "tour" with what map_view_json says of the map, and what
/// vehicle_view_json says of a vehicle's legs.
void write_tour_page(std::ostream& out, const Record& record, const TourAnswer& answer,
                     const RunOptions& run, const Json& vehicle = {});

/// The poses along the tour as nav_msgs/Path; of several robots a document each, in their order.
void write_tour_poses(std::ostream& out, const TourAnswer& answer, const RunOptions& run);

}  // namespace lasius::tool
