#include "tools/study/tune/race.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/base/special_values.h"

namespace lasius::study {
namespace {

double difference(double a, double b) { return a == b ? 0 : a - b; }  // infinite ones, too

}  // namespace

double chi_square_above(double x, int freedom) {
  if (x <= 0) return 1;
  if (!std::isfinite(x)) return 0;
  // Abramowitz and Stegun 26.4.4 and 26.4.5: finite sums for whole degrees of freedom.
  const bool odd = freedom % 2 == 1;
  double term = odd ? std::sqrt(2 * x / std::numbers::pi) * std::exp(-x / 2) : std::exp(-x / 2);
  double sum = odd ? std::erfc(std::sqrt(x / 2)) : 0;
  for (int k = odd ? 1 : 0; k < freedom - 1; k += 2) {
    sum += term;
    term *= x / (k + 2);
  }
  return std::min(1.0, sum);
}

double student_beyond(double t, int freedom) {
  if (!std::isfinite(t)) return 0;
  // Abramowitz and Stegun 26.7.3 and 26.7.4.
  const double angle = std::atan(std::abs(t) / std::sqrt(static_cast<double>(freedom)));
  const double sine = std::sin(angle), square = std::cos(angle) * std::cos(angle);
  const bool odd = freedom % 2 == 1;
  double term = odd ? sine * std::cos(angle) : sine, sum = 0;
  for (int k = odd ? 3 : 2; k <= freedom; k += 2) {
    sum += term;
    term *= square * (k - 1) / k;
  }
  const double within = odd ? 2 / std::numbers::pi * (angle + sum) : sum;
  return std::clamp(1 - within, 0.0, 1.0);
}

double student_quantile(double p, int freedom) {
  double low = 0, high = 1;
  while (student_beyond(high, freedom) > p && high < 1e12) high *= 2;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (student_beyond(middle, freedom) > p ? low : high) = middle;
  }
  return (low + high) / 2;
}

Friedman friedman(std::span<const std::vector<double>> blocks, double level) {
  const std::size_t candidates = blocks.front().size();
  const auto n = static_cast<double>(blocks.size()), m = static_cast<double>(candidates);
  Friedman test{.rank_sums = std::vector<double>(candidates, 0)};
  double spread = -n * m * (m + 1) * (m + 1) / 4;  // of squared ranks, were all equal
  for (const auto& block : blocks) {
    const auto ranks = doubled_ranks(block);
    for (std::size_t c = 0; c < candidates; ++c) {
      test.rank_sums[c] += ranks[c] / 2.0;
      spread += ranks[c] * ranks[c] / 4.0;
    }
  }
  if (spread <= 1e-9) {  // every block ties
    test.critical = kInfinity;
    return test;
  }
  double between = 0;
  for (const double sum : test.rank_sums) {
    const double off = sum - n * (m + 1) / 2;
    between += off * off;
  }
  test.statistic = (m - 1) * between / spread;
  test.p = chi_square_above(test.statistic, static_cast<int>(candidates) - 1);
  const int freedom = static_cast<int>((blocks.size() - 1) * (candidates - 1));
  const double rest = std::max(0.0, 1 - test.statistic / (n * (m - 1)));
  test.critical = student_quantile(level, freedom) *
                  std::sqrt(2 * n * rest * spread / static_cast<double>(freedom));
  return test;
}

SignedRanks signed_ranks(std::span<const double> a, std::span<const double> b) {
  constexpr std::size_t kMostExact = 60;
  std::vector<double> sizes;
  std::vector<bool> above;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double d = difference(a[i], b[i]);
    if (d == 0) continue;
    sizes.push_back(std::abs(d));
    above.push_back(d > 0);
  }
  if (sizes.empty()) return {};
  const auto ranks = doubled_ranks(std::move(sizes));
  std::size_t sum = 0, total = 0;
  double squares = 0;
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    const auto doubled = static_cast<std::size_t>(ranks[i]);
    total += doubled;
    squares += static_cast<double>(doubled * doubled);
    if (above[i]) sum += doubled;
  }
  const std::size_t tail = std::min(sum, total - sum);
  SignedRanks test{.p = 1, .above = 2 * sum > total};
  if (ranks.size() > kMostExact) {
    test.p = std::erfc((static_cast<double>(total) / 2 - static_cast<double>(tail)) /
                       std::sqrt(squares / 2));
    return test;
  }
  std::vector<double> law(total + 1, 0);
  law[0] = 1;
  for (const int r : ranks) {
    const auto doubled = static_cast<std::size_t>(r);
    for (std::size_t s = total + 1; s-- > 0;)
      law[s] = law[s] / 2 + (s >= doubled ? law[s - doubled] / 2 : 0);
  }
  test.p = std::min(
      1.0,
      2 * std::accumulate(law.begin(), law.begin() + static_cast<std::ptrdiff_t>(tail) + 1, 0.0));
  return test;
}

std::vector<std::size_t> Race::left() const {
  std::vector<std::size_t> there;
  for (std::size_t c = 0; c < runners_.size(); ++c)
    if (runners_[c].left_after == 0) there.push_back(c);
  return there;
}

std::vector<std::vector<double>> Race::values_of(std::span<const std::size_t> candidates) const {
  std::vector<std::vector<double>> blocks(static_cast<std::size_t>(blocks_));
  for (std::size_t b = 0; b < blocks.size(); ++b)
    for (const std::size_t c : candidates) blocks[b].push_back(runners_[c].values[b]);
  return blocks;
}

void Race::leave(std::size_t candidate, double p) {
  runners_[candidate].left_after = blocks_;
  runners_[candidate].p = p;
}

void Race::add(std::span<const double> values) {
  const auto there = left();
  for (std::size_t i = 0; i < there.size(); ++i) runners_[there[i]].values.push_back(values[i]);
  ++blocks_;
  if (there.size() < 2 || blocks_ < std::max(2, rules_.first_test)) return;
  const std::size_t best_one = best();
  if (there.size() == 2) {
    const std::size_t other = there[0] == best_one ? there[1] : there[0];
    const SignedRanks test = signed_ranks(runners_[other].values, runners_[best_one].values);
    if (test.p < rules_.level) leave(test.above ? other : best_one, test.p);
    return;
  }
  const Friedman test = friedman(values_of(there), rules_.level);
  if (test.p >= rules_.level) return;
  const double least =
      test.rank_sums[static_cast<std::size_t>(std::ranges::find(there, best_one) - there.begin())];
  for (std::size_t i = 0; i < there.size(); ++i)
    if (test.rank_sums[i] - least > test.critical) leave(there[i], test.p);
}

std::size_t Race::best() const { return standings().front().candidate; }

std::size_t Race::rival() const {
  for (const Standing& s : standings())
    if (s.candidate != 0) return s.candidate;
  std::size_t found = 1;
  const auto median = [&](std::size_t c) { return quantile(runners_[c].values, 0.5); };
  for (std::size_t c = 2; c < runners_.size(); ++c) {
    const int after = runners_[c].left_after, so_far = runners_[found].left_after;
    if (after > so_far || (after == so_far && median(c) < median(found))) found = c;
  }
  return found;
}

std::vector<Race::Standing> Race::standings() const {
  const auto there = left();
  const auto blocks = values_of(there);
  std::vector<Standing> all;
  double critical = kInfinity;
  std::vector<double> sums(there.size(), 0);
  if (there.size() > 1 && blocks.size() > 1) {
    Friedman test = friedman(blocks, rules_.level);
    sums = std::move(test.rank_sums);
    critical = test.critical;
  } else {
    for (const auto& block : blocks) {
      const auto ranks = doubled_ranks(block);
      for (std::size_t i = 0; i < ranks.size(); ++i) sums[i] += ranks[i] / 2.0;
    }
  }
  const double count = std::max(1.0, static_cast<double>(blocks.size()));
  for (std::size_t i = 0; i < there.size(); ++i) {
    const auto& values = runners_[there[i]].values;
    all.push_back({.candidate = there[i],
                   .mean_rank = sums[i] / count,
                   .median = values.empty() ? kInfinity : quantile(values, 0.5),
                   .behind = {}});
  }
  std::ranges::stable_sort(all, [](const Standing& a, const Standing& b) {
    return a.mean_rank < b.mean_rank || (a.mean_rank == b.mean_rank && a.median < b.median);
  });
  for (Standing& s : all) {
    const double behind = s.mean_rank - all.front().mean_rank;
    s.behind = {behind - critical / count, behind + critical / count};
  }
  return all;
}

}  // namespace lasius::study
