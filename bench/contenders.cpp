#include "bench/contenders.h"

#include "exact.h"

namespace lasius::bench {
namespace {

using peers::Optimality;

// The search behind the algorithm `exact`, without the request around it.
class Exact final : public peers::QueryPlanner {
 public:
  explicit Exact(const Grid& grid) : grid_(&grid) {}
  double plan(Cell start, Cell goal, std::vector<Point>& path) override {
    search_.search(*grid_, start, goal, {}, {}, answer_);
    path.assign(answer_.path.begin(), answer_.path.end());
    return answer_.path.empty() ? peers::kNoPath : answer_.length;
  }

 private:
  const Grid* grid_;
  ExactSearch search_;
  ExactAnswer answer_;
};

template <typename T>
std::unique_ptr<peers::QueryPlanner> make(const Grid& grid) {
  return std::make_unique<T>(grid);
}

}  // namespace

std::vector<peers::Peer> all_contenders() {
  std::vector<peers::Peer> all = {
      {"exact", "lasius: exact any-angle search", Optimality::any_angle, make<Exact>}};
  const auto peers = peers::all_peers();
  all.insert(all.end(), peers.begin(), peers.end());
  return all;
}

}  // namespace lasius::bench
