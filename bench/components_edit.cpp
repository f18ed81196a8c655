// Components kept up to date under edits: processor time of ten cells close together.
#include <benchmark/benchmark.h>

#include <random>
#include <vector>

#include "bench/clocks.h"
#include "bench/statistics.h"
#include "core/grid/components.h"
#include "lasius/generate.h"

namespace lasius::bench {
namespace {

void components_edit(benchmark::State& state, MapKind kind) {
  const int side = static_cast<int>(state.range(0));
  Grid grid = generate(kind, {.width = side, .height = side});
  Components components(grid, Components::Connectivity::four);
  std::mt19937 random(1);
  const auto below = [&random](int most) { return static_cast<int>(random() % most); };
  std::vector<double> times;
  for (auto _ : state) {
    const Rectangle part{below(side - 4), below(side - 1), 5, 2};
    grid.fill(part, random() % 2 == 0);
    const ThreadStopwatch watch;
    benchmark::DoNotOptimize(components.update(grid, {&part, 1}));
    times.push_back(1e6 * watch.seconds());
    state.SetIterationTime(1e-6 * times.back());
  }
  state.counters["median us"] = median(times);
  state.counters["p99 us"] = quantile(times, 0.99);
  state.counters["worst us"] = largest(times);
}

void sides(benchmark::internal::Benchmark* bench) {
  bench->ArgName("side")->Arg(4096)->Arg(16384)->Iterations(1000)->UseManualTime();
}
BENCHMARK_CAPTURE(components_edit, blobs, MapKind::blobs)->Apply(sides);
BENCHMARK_CAPTURE(components_edit, city, MapKind::city)->Apply(sides);
BENCHMARK_CAPTURE(components_edit, noise, MapKind::random)->Apply(sides);

}  // namespace
}  // namespace lasius::bench
