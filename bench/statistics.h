// What tables say about many measurements.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace lasius::bench {

/// The value that `share` of the values lie below; the largest for 1. Not for empty vectors.
inline double quantile(std::vector<double> values, double share) {
  const auto last = static_cast<double>(values.size() - 1);
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * last + 0.5);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

inline double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

inline double largest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

}  // namespace lasius::bench
