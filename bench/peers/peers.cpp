#include "bench/peers/peers.h"

#include "bench/peers/anya.h"
#ifdef LASIUS_HAVE_BOOST_GRAPH
#include "bench/peers/boost_astar.h"
#endif
#include "bench/peers/bucket_astar.h"
#include "bench/peers/heap_astar.h"
#include "bench/peers/theta_star.h"

namespace lasius::peers {
namespace {

template <typename T>
std::unique_ptr<QueryPlanner> make(const Grid& grid) {
  return std::make_unique<T>(grid);
}

template <ThetaStar::Kind kind>
std::unique_ptr<QueryPlanner> make_theta(const Grid& grid) {
  return std::make_unique<ThetaStar>(grid, kind);
}

constexpr Peer kPeers[] = {
    {"astar-bucket", "A*, 8 neighbours, bucket queue", Optimality::octile, make<BucketAStar>},
    {"astar-heap", "A*, 8 neighbours, binary heap", Optimality::octile, make<HeapAStar>},
    {"theta", "Theta*", Optimality::none, make_theta<ThetaStar::Kind::basic>},
    {"lazy-theta", "Lazy Theta*", Optimality::none, make_theta<ThetaStar::Kind::lazy>},
#ifdef LASIUS_HAVE_BOOST_GRAPH
    {"astar-boost", "A*, 8 neighbours, Boost.Graph", Optimality::octile, make<BoostAStar>},
#endif
    {"anya", "ANYA", Optimality::any_angle, make<Anya>},
};

}  // namespace

std::span<const Peer> all_peers() noexcept { return kPeers; }

}  // namespace lasius::peers
