#include "bench/peers/peers.h"

#include "bench/peers/anya.h"
#include "bench/peers/bucket_astar.h"

namespace lasius::peers {
namespace {

constexpr Peer kPeers[] = {
    {"astar-bucket", "A*, 8 neighbours, bucket queue", Optimality::octile, make<BucketAStar>},
    {"astar-heap", "A*, 8 neighbours, binary heap", Optimality::octile, heap_astar},
    {"theta", "Theta*", Optimality::none, theta_star},
    {"lazy-theta", "Lazy Theta*", Optimality::none, lazy_theta_star},
#ifdef LASIUS_HAVE_BOOST_GRAPH
    {"astar-boost", "A*, 8 neighbours, Boost.Graph", Optimality::octile, boost_astar},
#endif
    {"anya", "ANYA", Optimality::any_angle, make<Anya>},
};

}  // namespace

std::span<const Peer> all_peers() noexcept { return kPeers; }

}  // namespace lasius::peers
