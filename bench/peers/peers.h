// The list of comparators, by name.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "bench/peers/query_planner.h"

namespace lasius::peers {

/// What a planner's answer is the shortest of.
enum class Optimality {
  octile,     ///< shortest over 8 neighbours
  any_angle,  ///< shortest in the plane
  none,       ///< any-angle, no promise
};

template <class Planner>
std::unique_ptr<QueryPlanner> make(const Grid& grid) {
  return std::make_unique<Planner>(grid);
}

struct Peer {
  std::string_view name;
  Optimality optimality;
  std::unique_ptr<QueryPlanner> (*make)(const Grid&);
};

std::span<const Peer> all_peers() noexcept;

// The peers of which nobody needs more than a QueryPlanner: each is in the source of its name.
std::unique_ptr<QueryPlanner> heap_astar(const Grid& grid);
std::unique_ptr<QueryPlanner> theta_star(const Grid& grid);
std::unique_ptr<QueryPlanner> lazy_theta_star(const Grid& grid);  ///< in theta_star.cpp
std::unique_ptr<QueryPlanner> boost_astar(const Grid& grid);      ///< only with Boost.Graph

}  // namespace lasius::peers
