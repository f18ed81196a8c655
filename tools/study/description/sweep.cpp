#include "tools/study/description/sweep.h"

#include <Random123/philox.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "tools/console/values.h"

namespace lasius::study {
namespace {

/// Numbers drawn for one factor.
class FactorDraws {
 public:
  FactorDraws(std::uint64_t seed, std::size_t dimension)
      : key_{{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}},
        dimension_(static_cast<std::uint32_t>(dimension)) {}

  std::uint32_t bits() { return r123::Philox4x32()({{next_++, dimension_, 0x5EEB, 0}}, key_)[0]; }
  double share() { return bits() * 0x1p-32; }
  std::size_t below(std::size_t count) { return std::uint64_t{bits()} * count >> 32; }

 private:
  r123::Philox4x32::key_type key_;
  std::uint32_t dimension_, next_ = 0;
};

/// One coordinate of every point.
std::vector<double> coordinates(Design design, int count, FactorDraws draws) {
  const auto size = static_cast<std::size_t>(count);
  std::vector<double> all(size, 0);
  if (design == Design::latin) {
    std::iota(all.begin(), all.end(), 0.0);
    for (std::size_t i = size; i > 1; --i) std::swap(all[i - 1], all[draws.below(i)]);
  }
  for (double& at : all)
    at = design == Design::latin ? (at + draws.share()) / count : draws.share();
  return all;
}

std::size_t levels_of(const Factor& factor) {
  return factor.values.empty() ? static_cast<std::size_t>(factor.levels) : factor.values.size();
}

std::string range_value(const Factor& factor, double share) {
  const auto between = [&](double low, double high) { return low + share * (high - low); };
  const double value = factor.logarithmic
                           ? std::exp(between(std::log(factor.from), std::log(factor.to)))
                           : between(factor.from, factor.to);
  if (factor.whole) return tool::to_text(std::round(value));
  const double rounded = tool::parse_real(tool::printed("%.4g", value)).value_or(value);
  return tool::to_text(std::clamp(rounded, factor.from, factor.to));
}

std::vector<Settings> grid(const std::vector<Factor>& factors) {
  std::vector<Settings> points{{}};
  for (const Factor& factor : factors) {
    std::vector<Settings> longer;
    const std::size_t levels = levels_of(factor);
    for (const Settings& point : points) {
      for (std::size_t i = 0; i < levels; ++i) {
        const double share =
            levels > 1 ? static_cast<double>(i) / static_cast<double>(levels - 1) : 0;
        longer.push_back(point);
        longer.back().emplace_back(
            factor.name, factor.values.empty() ? range_value(factor, share) : factor.values[i]);
      }
    }
    points = std::move(longer);
  }
  return points;
}

}  // namespace

std::vector<std::vector<double>> unit_points(Design design, int count, std::size_t dimensions,
                                             std::uint64_t seed) {
  std::vector<std::vector<double>> points(static_cast<std::size_t>(count));
  for (std::size_t d = 0; d < dimensions; ++d) {
    const auto all = coordinates(design, count, FactorDraws(seed, d));
    for (std::size_t i = 0; i < all.size(); ++i) points[i].push_back(all[i]);
  }
  return points;
}

std::string value_at(const Factor& factor, double share) {
  if (factor.values.empty()) return range_value(factor, share);
  return factor.values[static_cast<std::size_t>(share * static_cast<double>(factor.values.size()))];
}

std::vector<Settings> design_points(Design design, const std::vector<Factor>& factors, int count,
                                    std::uint64_t seed) {
  std::vector<Settings> all;
  if (design == Design::grid) {
    all = grid(factors);
  } else {
    for (const auto& shares : unit_points(design, count, factors.size(), seed)) {
      Settings& point = all.emplace_back();
      for (std::size_t f = 0; f < factors.size(); ++f)
        point.emplace_back(factors[f].name, value_at(factors[f], shares[f]));
    }
  }
  std::vector<Settings> points;
  std::set<Settings> seen;
  for (Settings& point : all)
    if (seen.insert(point).second) points.push_back(std::move(point));
  return points;
}

std::int64_t grid_size(const std::vector<Factor>& factors) {
  constexpr double kMost = 0x1p62;
  double size = 1;
  for (const Factor& factor : factors) size *= static_cast<double>(levels_of(factor));
  return static_cast<std::int64_t>(std::min(size, kMost));
}

}  // namespace lasius::study
