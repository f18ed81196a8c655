#include "bench/peers/peers.h"

#include "bench/peers/anya.h"
#include "bench/peers/bucket_astar.h"

namespace lasius::peers {
namespace {

constexpr Peer kPeers[] = {
    {"astar-bucket", Optimality::octile, make<BucketAStar>},
    {"astar-heap", Optimality::octile, heap_astar},
    {"theta", Optimality::none, theta_star},
    {"lazy-theta", Optimality::none, lazy_theta_star},
#ifdef LASIUS_HAVE_BOOST_GRAPH
    {"astar-boost", Optimality::octile, boost_astar},
#endif
    {"anya", Optimality::any_angle, make<Anya>},
};

}  // namespace

std::span<const Peer> all_peers() noexcept { return kPeers; }

}  // namespace lasius::peers
