#include "bench/contenders.h"

#include "bench/peers/bucket_astar.h"
#include "bench/query_set.h"
#include "core/exact/corner_graph.h"
#include "core/exact/exact.h"
#include "core/exact/prepared_search.h"
#include "lasius/path/path.h"
#include "lasius/path/smooth.h"

namespace lasius::bench {
namespace {

using peers::make;
using peers::Optimality;

// The search behind the algorithm `exact` without its request, up to a certified gap in per cent.
template <int kGap>
class Exact final : public peers::QueryPlanner {
 public:
  explicit Exact(const Grid& grid) : grid_(&grid) {}
  double plan(Cell start, Cell goal, std::vector<Point>& path) override {
    search_.search(*grid_, centre(start), centre(goal), {.target_gap = kGap / 100.0}, {}, answer_);
    path.assign(answer_.path.begin(), answer_.path.end());
    return answer_.path.empty() ? peers::kNoPath : answer_.length;
  }

 private:
  const Grid* grid_;
  ExactSearch search_;
  ExactAnswer answer_;
};

// The exact search on a prepared map, or unprepared where preparation takes too much memory.
class Prepared final : public peers::QueryPlanner {
 public:
  explicit Prepared(const Grid& grid) : grid_(&grid) {
    Preparation report;
    graph_ = exact::CornerGraph::make(grid, {.threads = 1}, report);
  }
  double plan(Cell start, Cell goal, std::vector<Point>& path) override {
    if (graph_ != nullptr) {
      search_.search(*grid_, *graph_, centre(start), centre(goal), {}, {}, answer_);
    } else {
      unprepared_.search(*grid_, centre(start), centre(goal), {}, {}, answer_);
    }
    path.assign(answer_.path.begin(), answer_.path.end());
    return answer_.path.empty() ? peers::kNoPath : answer_.length;
  }
  double prepared_bytes() const override {
    return graph_ != nullptr ? static_cast<double>(graph_->bytes()) : kUnknown;
  }

 private:
  const Grid* grid_;
  std::shared_ptr<const exact::CornerGraph> graph_;
  exact::PreparedSearch search_;
  ExactSearch unprepared_;
  ExactAnswer answer_;
};

// What a robotics engineer would run: bucketed A*, its walk pulled straight, then taut.
template <bool kTaut>
class PulledAStar final : public peers::QueryPlanner {
 public:
  explicit PulledAStar(const Grid& grid) : grid_(&grid), search_(grid) {}
  double plan(Cell start, Cell goal, std::vector<Point>& path) override {
    path.clear();
    if (search_.plan_cells(start, goal, cells_) == peers::kNoPath) return peers::kNoPath;
    for (const Cell c : greedy_straighten(*grid_, cells_)) path.push_back(centre(c));
    if (kTaut) path = pull_taut(*grid_, path);
    return path_length(path);
  }

 private:
  const Grid* grid_;
  peers::BucketAStar search_;
  std::vector<Cell> cells_;
};

}  // namespace

std::vector<peers::Peer> all_contenders() {
  std::vector<peers::Peer> all = {{"exact", Optimality::any_angle, make<Exact<0>>},
                                  {"exact-prepared", Optimality::any_angle, make<Prepared>},
                                  {"exact-gap3", Optimality::none, make<Exact<3>>},
                                  {"exact-gap10", Optimality::none, make<Exact<10>>},
                                  {"astar-straight", Optimality::none, make<PulledAStar<false>>},
                                  {"astar-taut", Optimality::none, make<PulledAStar<true>>}};
  const auto peers = peers::all_peers();
  all.insert(all.end(), peers.begin(), peers.end());
  return all;
}

}  // namespace lasius::bench
