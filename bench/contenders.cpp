#include "bench/contenders.h"

namespace lasius::bench {

std::vector<peers::Peer> all_contenders() {
  const auto peers = peers::all_peers();
  return {peers.begin(), peers.end()};
}

}  // namespace lasius::bench
