// Comparisons as Markdown and as raw data.
#pragma once

#include <ostream>
#include <span>
#include <string>

#include "bench/comparison.h"

namespace lasius::bench {

/// CPU, compiler, version and date: what figures mean nothing without.
std::string machine_line();

/// A number with three significant digits, for tables.
std::string short_number(double value);

/// Mean microseconds a query for each map, geometric means over the maps, ratios to `subject` (the
/// index of a planner: above 1 it is the faster one), medians, gaps, preparation, faults.
void write_markdown(std::ostream& out, std::span<const MapComparison> maps,
                    std::span<const peers::Peer> planners, std::size_t subject,
                    const ComparisonOptions& options, const std::string& seeds);

/// One line a planner and query: map, planner, sx .. gy are left to the tables; microseconds,
/// length, optimum, rounds, fault.
void write_tsv(std::ostream& out, std::span<const MapComparison> maps,
               std::span<const peers::Peer> planners);

/// Number of measurements with a fault.
std::size_t count_faults(std::span<const MapComparison> maps);

}  // namespace lasius::bench
