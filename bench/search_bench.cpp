// Bucketed A*: nanoseconds an expansion, in cache and out of it.
#include <benchmark/benchmark.h>

#include "bench/peers/bucket_astar.h"
#include "bench/query_set.h"

namespace lasius::bench {
namespace {

void bucket_astar(benchmark::State& state) {
  const int side = static_cast<int>(state.range(0));
  const QuerySet set =
      load({"blobs", {}, {}, MapKind::blobs, {.width = side, .height = side, .seed = 1}}, 30);
  peers::BucketAStar planner(set.grid);
  std::vector<Cell> cells;
  const std::int64_t before = planner.expansions();
  for (auto _ : state) {
    for (const Query& q : set.queries) {
      benchmark::DoNotOptimize(planner.plan_cells(q.start, q.goal, cells));
    }
  }
  const auto expansions = static_cast<double>(planner.expansions() - before);
  state.counters["seconds an expansion"] =
      benchmark::Counter(expansions, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(bucket_astar)->ArgName("side")->Arg(256)->Arg(1024)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lasius::bench
