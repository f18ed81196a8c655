// The planners of a comparison: ours first, then the peers.
#pragma once

#include <vector>

#include "bench/peers/peers.h"

namespace lasius::bench {

std::vector<peers::Peer> all_contenders();

}  // namespace lasius::bench
