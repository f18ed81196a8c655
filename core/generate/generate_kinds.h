// The makers of generated maps: integers and Philox only.
#pragma once

#include <cstdint>

#include "core/base/poller.h"
#include "core/generate/map_random.h"
#include "lasius/grid/grid.h"

namespace lasius {

/// A share of blocked cells, in 2^-32.
using BlockedShare = std::uint32_t;

/// Each makes `grid` (given all free) into a map with about the share of blocked cells; into a part
/// of one where the poller, which is told of cells, says stop.
void make_blobs(Grid& grid, BlockedShare share, const MapRandom& random, Poller& poller);
void make_open(Grid& grid, BlockedShare share, const MapRandom& random, Poller& poller);
void make_random(Grid& grid, BlockedShare share, const MapRandom& random, Poller& poller);
void make_maze(Grid& grid, BlockedShare share, const MapRandom& random, Poller& poller);
void make_rooms(Grid& grid, BlockedShare share, const MapRandom& random, Poller& poller);
void make_city(Grid& grid, BlockedShare share, const MapRandom& random, Poller& poller);

/// floor(sqrt(n)).
std::uint32_t integer_sqrt(std::uint64_t n) noexcept;

}  // namespace lasius
