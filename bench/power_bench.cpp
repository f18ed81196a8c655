// Powers a second, of which rows of weights are made. What walks do with them is measured by
// `lasius_bench colony`.
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "core/base/kernel_choice.h"
#include "kernels/base/raise.h"

namespace lasius::bench {
namespace {

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
