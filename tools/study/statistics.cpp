#include "tools/study/statistics.h"

#include <Random123/philox.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lasius::study {
namespace {

/// Ranks from 1 of the absolute values, doubled so that mean ranks of ties are integers.
std::vector<int> doubled_ranks(std::span<const double> values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](auto a, auto b) { return std::abs(values[a]) < std::abs(values[b]); });
  std::vector<int> ranks(values.size());
  for (std::size_t i = 0; i < order.size();) {
    std::size_t end = i + 1;
    while (end < order.size() && std::abs(values[order[end]]) == std::abs(values[order[i]])) ++end;
    for (std::size_t k = i; k < end; ++k) ranks[order[k]] = static_cast<int>(i + 1 + end);
    i = end;
  }
  return ranks;
}

/// Two-sided p of a doubled rank sum, every sign as likely as the other.
double exact_p(std::span<const int> ranks, int sum) {
  const int total = std::accumulate(ranks.begin(), ranks.end(), 0);
  std::vector<double> share(static_cast<std::size_t>(total) + 1, 0.0);
  share[0] = 1;
  int reach = 0;
  for (const int rank : ranks) {
    reach += rank;
    for (int s = reach; s >= 0; --s) {
      const auto at = static_cast<std::size_t>(s);
      share[at] = (share[at] + (s >= rank ? share[at - static_cast<std::size_t>(rank)] : 0)) / 2;
    }
  }
  const int tail = std::min(sum, total - sum);
  double below = 0;
  for (int s = 0; s <= tail; ++s) below += share[static_cast<std::size_t>(s)];
  return std::min(1.0, 2 * below);
}

/// The same by the normal law, with continuity correction; sums of squared ranks allow for ties.
double normal_p(std::span<const int> ranks, int sum) {
  double mean = 0, variance = 0;
  for (const int rank : ranks) {
    mean += rank / 2.0;
    variance += rank * static_cast<double>(rank) / 4;
  }
  const double z = std::max(0.0, std::abs(sum - mean) - 1) / std::sqrt(variance);
  return std::min(1.0, std::erfc(z / std::sqrt(2.0)));
}

}  // namespace

double quantile(std::span<const double> values, double share) {
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const double rest = at - static_cast<double>(below);
  // Equal neighbours need no arithmetic, which infinite ones do not bear.
  if (rest == 0 || sorted[below] == sorted[below + 1]) return sorted[below];
  return sorted[below] + rest * (sorted[below + 1] - sorted[below]);
}

Summary summarise(std::span<const double> values) {
  Summary s;
  s.count = static_cast<int>(values.size());
  if (values.empty()) return s;
  s.mean = std::accumulate(values.begin(), values.end(), 0.0) / s.count;
  double squares = 0;
  for (const double v : values) squares += (v - s.mean) * (v - s.mean);
  s.sd = s.count > 1 ? std::sqrt(squares / (s.count - 1)) : 0;
  s.least = quantile(values, 0);
  s.median = quantile(values, 0.5);
  s.most = quantile(values, 1);
  return s;
}

Interval mean_interval(std::span<const double> values) {
  constexpr int kResamples = 10000;
  const auto count = static_cast<std::uint32_t>(values.size());
  std::vector<double> means(kResamples);
  for (std::uint32_t r = 0; r < kResamples; ++r) {
    double sum = 0;
    for (std::uint32_t i = 0; i < count; i += 4) {
      const auto words = r123::Philox4x32()({{i, r, 0, 0}}, {{0x6c617369u, 0x75730000u}});
      for (std::uint32_t k = 0; k < 4 && i + k < count; ++k)
        sum += values[std::uint64_t{count} * words[k] >> 32];
    }
    means[r] = sum / count;
  }
  return {quantile(means, 0.025), quantile(means, 0.975)};
}

SignedRank signed_rank(std::span<const double> differences) {
  constexpr int kMostExact = 200;
  std::vector<double> kept;
  for (const double d : differences)
    if (d != 0) kept.push_back(d);
  SignedRank test;
  test.pairs = static_cast<int>(kept.size());
  if (kept.empty()) return test;
  const auto ranks = doubled_ranks(kept);
  int plus = 0, minus = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) (kept[i] > 0 ? plus : minus) += ranks[i];
  test.plus = plus / 2.0;
  test.minus = minus / 2.0;
  test.effect = (test.plus - test.minus) / (test.plus + test.minus);
  test.p = test.pairs <= kMostExact ? exact_p(ranks, plus) : normal_p(ranks, plus);
  return test;
}

std::vector<double> holm(std::span<const double> p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return p[a] < p[b]; });
  std::vector<double> adjusted(p.size());
  double least = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    least = std::max(least, p[order[i]] * static_cast<double>(order.size() - i));
    adjusted[order[i]] = std::min(1.0, least);
  }
  return adjusted;
}

}  // namespace lasius::study
