// Sampling planners of OMPL: how long until they are near the optimum.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "lasius/grid/grid.h"

namespace lasius::peers {

/// OMPL's planners in the plane of the map, a point robot, motions checked exactly on the bitmap.
enum class Sampler { rrt_star, informed_rrt_star, bit_star, rrt_connect };
std::span<const std::string_view> sampler_names() noexcept;
/// "OMPL 1.5.2".
std::string ompl_version();

/// The gaps to the optimum whose times are taken.
inline constexpr std::array<double, 3> kGaps = {0.05, 0.01, 0.001};

struct SamplingTrial {
  double first_seconds = 0;         ///< to any path; infinite without one
  std::array<double, 3> seconds{};  ///< to each of kGaps; infinite where not reached
};

/// One run until the length is within 0.1% of `optimum` or `cap_seconds` have passed. The planners
/// have OMPL's default parameters. RRTConnect starts again after each path has been simplified
/// (PathSimplifier::simplifyMax).
SamplingTrial run_sampler(Sampler sampler, const Grid& grid, Cell start, Cell goal, double optimum,
                          double cap_seconds, std::uint32_t seed);

}  // namespace lasius::peers
