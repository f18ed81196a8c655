#include "tools/study/statistics.h"

#include <Random123/philox.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <numeric>

#include "tools/draw/text.h"

namespace lasius::study {
namespace {

using tool::fixed;

/// Doubled ranks of one question, those of a first, and what follows from them.
struct Stratum {
  std::vector<int> ranks;
  std::size_t count;  ///< of a
  explicit Stratum(const Pair& pair) : count(pair.a.size()) {
    std::vector<double> all = pair.a;
    all.insert(all.end(), pair.b.begin(), pair.b.end());
    ranks = doubled_ranks(std::move(all));
  }
  int sum() const { return std::accumulate(ranks.begin(), ranks.begin() + at(count), 0); }
  double mean() const { return static_cast<double>(count) * static_cast<double>(ranks.size() + 1); }
  /// Of the doubled sum, over all choices of `count` ranks.
  double variance() const {
    const auto size = static_cast<double>(ranks.size()), n = static_cast<double>(count);
    double spread = 0;
    for (const int r : ranks) spread += (r - size - 1) * (r - size - 1);
    return size < 2 ? 0 : n * (size - n) / (size * (size - 1)) * spread;
  }
  /// Share of the choices of `count` ranks with each doubled sum.
  std::vector<double> law() const {
    const auto total = std::accumulate(ranks.begin(), ranks.end(), 0);
    std::vector<std::vector<double>> ways(count + 1, std::vector<double>(at(total) + 1, 0));
    ways[0][0] = 1;
    std::size_t seen = 0;
    for (const int r : ranks) {
      ++seen;
      for (std::size_t k = std::min(seen, count); k > 0; --k)
        for (int s = total; s >= r; --s) ways[k][at(s)] += ways[k - 1][at(s - r)];
    }
    const double all = std::accumulate(ways[count].begin(), ways[count].end(), 0.0);
    for (double& w : ways[count]) w /= all;
    return std::move(ways[count]);
  }
  static std::size_t at(std::integral auto i) { return static_cast<std::size_t>(i); }
};

std::vector<double> convolved(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> sum(a.size() + b.size() - 1, 0);
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] > 0)
      for (std::size_t k = 0; k < b.size(); ++k) sum[i + k] += a[i] * b[k];
  return sum;
}

/// Share of pairs in which the value of a is less, from a's doubled rank sum.
double share_less_of(const Stratum& s) {
  const auto n = static_cast<double>(s.count), m = static_cast<double>(s.ranks.size()) - n;
  return 1 - (s.sum() / 2.0 - n * (n + 1) / 2) / (n * m);
}

double log_choose(int n, int k) {
  return std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0);
}

/// The p at which a tail that rises or falls with p is 2.5%.
template <class Tail>
double solve(const Tail& tail, bool rises) {
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    ((tail(middle) < 0.025) == rises ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace

std::vector<int> doubled_ranks(std::vector<double> values) {
  for (double& v : values)
    if (std::isfinite(v)) v = std::round(v * 1e7);
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return values[a] < values[b]; });
  std::vector<int> ranks(values.size());
  for (std::size_t i = 0; i < order.size();) {
    std::size_t end = i + 1;
    while (end < order.size() && values[order[end]] == values[order[i]]) ++end;
    for (std::size_t k = i; k < end; ++k) ranks[order[k]] = static_cast<int>(i + 1 + end);
    i = end;
  }
  return ranks;
}

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

std::string interval_text(const Interval& interval, int decimals) {
  return " [" + fixed(interval.low, decimals) + ", " + fixed(interval.high, decimals) + "]";
}

double share_less(std::span<const Pair> questions) {
  double sum = 0;
  for (const Pair& pair : questions) sum += share_less_of(Stratum(pair));
  return sum / static_cast<double>(questions.size());
}

RankTest rank_test(std::span<const Pair> questions) {
  constexpr std::size_t kMostExact = 120;
  RankTest test;
  if (questions.empty()) return test;
  std::size_t values = 0;
  int sum = 0;
  double mean = 0, variance = 0;
  std::vector<Stratum> strata;
  for (const Pair& pair : questions) {
    const Stratum& s = strata.emplace_back(pair);
    values += s.ranks.size();
    sum += s.sum();
    mean += s.mean();
    variance += s.variance();
  }
  test.effect = share_less(questions);
  if (values <= kMostExact) {
    std::vector<double> law{1};
    for (const Stratum& s : strata) law = convolved(law, s.law());
    const auto at = law.begin() + sum;
    test.less = std::min(1.0, std::accumulate(law.begin(), at + 1, 0.0));
    test.greater = std::min(1.0, std::accumulate(at, law.end(), 0.0));
  } else if (variance > 0) {
    const auto tail = [&](double beyond) {  // with continuity correction
      return std::erfc((beyond - 1) / std::sqrt(2 * variance)) / 2;
    };
    test.less = tail(mean - sum);
    test.greater = tail(sum - mean);
  }
  return test;
}

double least_rank_p(int questions, int seeds) {
  return std::min(1.0, 2 * std::exp(-questions * log_choose(2 * seeds, seeds)));
}

double binomial_below(int k, int n, double p) {
  if (p <= 0 || p >= 1) return p <= 0 || k >= n ? 1 : 0;
  double sum = 0;
  for (int i = 0; i <= k; ++i)
    sum += std::exp(log_choose(n, i) + i * std::log(p) + (n - i) * std::log1p(-p));
  return std::min(1.0, sum);
}

double binomial_above(int k, int n, double p) { return binomial_below(n - k, n, 1 - p); }

Interval share_interval(int k, int n) {
  return {k == 0 ? 0 : solve([&](double p) { return binomial_above(k, n, p); }, true),
          k == n ? 1 : solve([&](double p) { return binomial_below(k, n, p); }, false)};
}

Interval resampled_interval(std::span<const Pair> questions, const Figure95& figure) {
  constexpr std::uint32_t kResamplings = 2000;
  std::vector<Pair> drawn(questions.begin(), questions.end());
  std::vector<double> figures;
  for (std::uint32_t r = 0; r < kResamplings; ++r) {
    std::uint32_t draws = 0;
    const auto draw = [&](const std::vector<double>& from, std::vector<double>& to) {
      for (double& value : to) {
        const r123::Philox4x32::ctr_type random =
            r123::Philox4x32()({{draws++, r, 0, 0}}, {{0x5EED, 0}});
        value = from[std::uint64_t{random[0]} * from.size() >> 32];
      }
    };
    for (std::size_t q = 0; q < questions.size(); ++q) {
      draw(questions[q].a, drawn[q].a);
      draw(questions[q].b, drawn[q].b);
    }
    if (const double value = figure(drawn); !std::isnan(value)) figures.push_back(value);
  }
  if (figures.empty()) return {std::nan(""), std::nan("")};
  return {quantile(figures, 0.025), quantile(figures, 0.975)};
}

double median_ratio(std::span<const Pair> questions) {
  double sum = 0;
  for (const Pair& pair : questions) {
    const double a = quantile(pair.a, 0.5), b = quantile(pair.b, 0.5);
    if (!(a > 0 && b > 0 && std::isfinite(a) && std::isfinite(b))) return std::nan("");
    sum += std::log(a / b);
  }
  return std::exp(sum / static_cast<double>(questions.size()));
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
