// Files of stops: tables, lists and GeoJSON.
#pragma once

#include <string>
#include <vector>

#include "lasius/geometry.h"
#include "tools/options/options.h"

namespace lasius::tool {

inline constexpr std::size_t kMostStops = 20'000;

/// The stops of a file: cells by column and row, or metres.
///   .json     [[x, y], ...], or GeoJSON
///   .geojson  its points and multi-points, whatever holds them
///   others    a TSV whose header names x and y among others, split at tabs, or at blanks and
///   commas
///             where the header has no tab; without a header, x and y a line
/// A cell is two whole numbers, or the point in its middle. @throws Error(file_missing,
/// file_broken) naming file and line; UsageError for columns that ask for what is not planned.
std::vector<Point> read_stops(const std::string& file, Frame frame);

}  // namespace lasius::tool
