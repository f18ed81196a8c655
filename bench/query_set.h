// The maps and queries of a comparison.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "lasius/grid/generate.h"
#include "lasius/grid/grid.h"

namespace lasius::bench {

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

struct Query {
  Cell start, goal;
  double optimum = kUnknown;  ///< exact any-angle length, where a table gives it
};

struct QuerySet {
  std::string name;
  Grid grid;
  std::vector<Query> queries;
};

/// Queries of a TSV (header names sx sy gx gy, optionally euclid) or a MovingAI .scen.
/// @throws Error(file_missing, file_broken) with the line.
std::vector<Query> read_queries(const std::string& path);

/// One thing to load: a map file and its queries, or a generated map.
struct QuerySource {
  std::string name;
  std::string map = {}, table = {};  ///< files; empty for generated maps
  MapKind kind = MapKind::open;
  GenerateOptions options = {};
};

/// The maps named by files and folders: a .map with the .tsv or .scen beside it, a table with its
/// map, or all tables of a folder (.tsv before .scen for the same map).
/// @throws Error(file_missing) for a name that is none of these.
std::vector<QuerySource> find_sources(const std::vector<std::string>& names);

/// Generated maps of all kinds (random at 10, 20, 30 and 40%) at the given sides.
std::vector<QuerySource> generated_sources(const std::vector<int>& sides, std::uint64_t seed);

/// Maps of isolated blocked cells at the given sides, from 0.5 to 40% of them.
std::vector<QuerySource> noise_sources(const std::vector<int>& sides, std::uint64_t seed);

/// Loads one; a table gives at most `count` queries, spread evenly (0: all), and a map without one
/// gets `count` between random cells that are joined (0: 30).
QuerySet load(const QuerySource& source, std::size_t count);

}  // namespace lasius::bench
