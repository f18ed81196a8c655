// Files of stops: tables, lists and GeoJSON.
#pragma once

#include <string>

#include "tools/options/options.h"

namespace lasius::tool {

inline constexpr std::size_t kMostStops = 20'000;

/// The stops of a file: cells by column and row, or metres; where they have them their names,
/// loads, groups and those that come before them.
///   .json     [[x, y] or {"x", "y", "name", "after", "load", "group"}, ...], or GeoJSON
///   .geojson  its points and multi-points, whatever holds them, with the features' properties
///   others    a TSV whose header names x and y among others, split at tabs, or where the header
///   has
///             none at blanks and commas; without a header, x and y a line
/// `poses`: also yaws, of a column or member "yaw", or as a third number of a list; radians, or as
/// in 90deg. A cell is two whole numbers; with decimals it is a point, and so are metres. @throws
/// Error(file_missing, file_broken) naming file and line.
TourStops read_stops(const std::string& file, Frame frame, bool poses = false);

}  // namespace lasius::tool
