// Points of a space of parameters: every combination, random ones, or a Latin hypercube.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/study/study.h"

namespace lasius::study {

/// One parameter that is varied: a list of values, or a range.
struct Factor {
  std::string name;
  std::vector<std::string> values = {};  ///< empty: the range
  double from = 0, to = 1;
  bool logarithmic = false;
  bool whole = false;  ///< values of the range are rounded
  int levels = 0;      ///< that a grid takes of the range, evenly, both ends among them
};

/// How the points are chosen.
enum class Design {
  grid,    ///< every combination, the last factor fastest
  random,  ///< independent draws
  latin,   ///< a Latin hypercube (McKay, Beckman, Conover 1979): each factor's range is cut into as
           ///< many parts as there are points, and each part holds one
};

/// Numbers from 0 to below 1, `count` for each of `dimensions`, by point. From a counter-based
/// stream: equal arguments give equal points on every machine. Design: random or latin.
std::vector<std::vector<double>> unit_points(Design design, int count, std::size_t dimensions,
                                             std::uint64_t seed);

/// The factor's value at `share` in [0, 1) of its range, to four digits, as on the command line; of
/// a list that at this share of its length.
std::string value_at(const Factor& factor, double share);

/// All points in their order, each with a value for every factor; a repeated point is left out.
/// `count` and `seed` are those of random and latin. Precondition: a grid's ranges have `levels`.
std::vector<Settings> design_points(Design design, const std::vector<Factor>& factors, int count,
                                    std::uint64_t seed);

/// Points of a grid, repeated ones counted; at most 2^62.
std::int64_t grid_size(const std::vector<Factor>& factors);

}  // namespace lasius::study
