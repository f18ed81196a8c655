// Ant steps a second: the textbook, the bare ceiling and lasius, on 400 x 200 cells. Powers a
// second, of which rows of weights are made.
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "bench/colony_figures.h"
#include "bench/peers/row_ceiling.h"
#include "bench/peers/textbook_ants.h"
#include "core/base/kernel_choice.h"
#include "core/plan/workspace.h"
#include "kernels/base/raise.h"
#include "lasius/planner.h"

namespace lasius::bench {
namespace {

void count_steps(benchmark::State& state, std::int64_t steps) {
  state.counters["steps"] =
      benchmark::Counter(static_cast<double>(steps), benchmark::Counter::kIsRate);
}

void textbook_ants(benchmark::State& state) {
  peers::TextbookAnts ants(fan_course().grid, fan_course().start, fan_course().goal, {});
  for (auto _ : state) ants.iterate();
  count_steps(state, ants.steps());
}
BENCHMARK(textbook_ants)->Unit(benchmark::kMillisecond);

void row_ceiling(benchmark::State& state, peers::RowCeiling::Path path) {
  peers::RowCeiling ceiling(400, 200);
  constexpr std::int64_t kSteps = 1 << 20;
  const auto walkers = static_cast<int>(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(ceiling.walk(path, walkers, kSteps));
  count_steps(state, kSteps * static_cast<std::int64_t>(state.iterations()));
}
BENCHMARK_CAPTURE(row_ceiling, walk, peers::RowCeiling::Path::walk)
    ->ArgName("walkers")
    ->Arg(1)
    ->Arg(4)
    ->Arg(8)
    ->Arg(16)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(row_ceiling, jump, peers::RowCeiling::Path::jump)
    ->ArgName("walkers")
    ->Arg(1)
    ->Arg(4)
    ->Arg(8)
    ->Arg(16)
    ->Unit(benchmark::kMillisecond);

// A whole plan, updates and straightening included.
void plan_steps(benchmark::State& state, const char* algorithm, Neighbours neighbours) {
  const Planner planner(fan_course().grid);
  Workspace workspace;
  Params params = defaults(algorithm);
  params.neighbours = neighbours;
  params.threads = 1;
  params.ants = 64;
  params.iterations = 20;
  std::int64_t steps = 0;
  const auto observer = [&](const Progress&) {
    for (const Ant& ant : workspace.impl().colony.ants) steps += ant.steps;
  };
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        planner.plan({fan_course().start, fan_course().goal}, params, &workspace, observer));
    ++params.seed;
  }
  count_steps(state, steps);
}
BENCHMARK_CAPTURE(plan_steps, as, "as", Neighbours::eight)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan_steps, fan2004, "fan2004", Neighbours::four)->Unit(benchmark::kMillisecond);

void raise_with_libm(double* values, int count, double exponent) noexcept {
  for (int i = 0; i < count; ++i) values[i] = std::pow(values[i], exponent);
}

void powers(benchmark::State& state, kernels::RaiseFn raise) {
  std::vector<double> values(256);
  double share = 1;
  for (auto _ : state) {
    for (double& value : values) value = share *= share < 1e-30 ? 1e30 : 0.83;
    raise(values.data(), static_cast<int>(values.size()), 1.8);
    benchmark::DoNotOptimize(values.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(values.size()));
}
BENCHMARK_CAPTURE(powers, libm, raise_with_libm);
BENCHMARK_CAPTURE(powers, reference, kernels::raise_row(kernels::Isa::scalar));
BENCHMARK_CAPTURE(powers, lasius, kernels::raise_row(chosen_isa()));

}  // namespace
}  // namespace lasius::bench
