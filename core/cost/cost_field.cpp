#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

#include "core/base/invalid_parameter.h"
#include "core/base/number_text.h"
#include "core/base/poller.h"
#include "core/cost/inflation.h"
#include "core/grid/clearance.h"
#include "kernels/base/power.h"
#include "lasius/cost/field.h"

namespace lasius {
namespace {

std::string in_cell(std::size_t i, int width) {
  return " in cell (" + std::to_string(i % width) + ", " + std::to_string(i / width) + ")";
}

void check_count(std::size_t count, int width, int height) {
  if (count == static_cast<std::size_t>(width) * height) return;
  refuse("there are " + std::to_string(count) + " values for a map of " + size_text(width, height),
         "give one value for each cell, row by row");
}

void check_in(double value, double least, double most, const char* name) {
  if (value >= least && value <= most) return;
  refuse(std::string(name) + " is " + number_text(value),
         "use " + number_text(least) + " to " + number_text(most));
}

}  // namespace

CostField::CostField(int width, int height) : width_(width), height_(height) {
  if (std::min(width, height) < 1 || std::max(width, height) > Grid::kMaxSide)
    refuse("costs for a map of " + size_text(width, height),
           "use sides of 1 to " + std::to_string(Grid::kMaxSide) + " cells");
  weights_.assign(static_cast<std::size_t>(width) * height, 1.0);
}

CostField::CostField(int width, int height, std::span<const double> weights)
    : CostField(width, height) {
  check_count(weights.size(), width, height);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (!(weights[i] >= kLeast && weights[i] <= kMost))
      refuse("the weight" + in_cell(i, width) + " is " + number_text(weights[i]),
             "use " + number_text(kLeast) + " to " + number_text(kMost));
  }
  std::ranges::copy(weights, weights_.begin());
}

void CostField::add(std::span<const double> values, double factor) {
  check_count(values.size(), width_, height_);
  check_in(factor, 0, kMost, "the factor of a layer of costs");
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!(values[i] >= 0 && std::isfinite(values[i])))
      refuse("the cost" + in_cell(i, width_) + " is " + number_text(values[i]),
             "use finite values of at least 0");
    if (const double sum = weights_[i] + factor * values[i]; !(sum <= kMost))
      refuse("the weight" + in_cell(i, width_) + " would be " + number_text(sum),
             "use a smaller factor: weights are at most " + number_text(kMost));
  }
  for (std::size_t i = 0; i < values.size(); ++i) weights_[i] += factor * values[i];
}

void cost::check_inflation(const Inflation& inflation) {
  check_in(inflation.radius, 0, 20000, "the inflation's radius");
  check_in(inflation.scaling, 0, 1000, "the inflation's scaling");
  check_in(inflation.weight, 0, CostField::kMost, "the inflation's weight");
  check_in(inflation.inscribed, 0, 20000, "the inflation's inscribed radius");
}

void cost::check_sum(std::span<const double> weights, const Inflation& inflation) {
  if (const double most = *std::ranges::max_element(weights) + inflation.weight;
      !(most <= CostField::kMost))
    refuse("costs and inflation together may weigh " + number_text(most),
           "use smaller ones: weights are at most " + number_text(CostField::kMost));
}

double cost::inflated(const Inflation& inflation, std::int32_t squared_half_cells) noexcept {
  constexpr double kPerLn2 = 1.4426950408889634074;
  const double d = std::sqrt(static_cast<double>(squared_half_cells)) / 2;
  if (d > inflation.radius || d == 0) return 0;  // in a blocked cell nothing goes
  const double inscribed = std::max(1.0, inflation.inscribed);
  if (d <= inscribed) return inflation.weight;
  const double exponent = inflation.scaling * (d - inscribed) * kPerLn2;
  return exponent < 900 ? inflation.weight * kernels::power(2, -exponent) : 0;
}

void CostField::add(const Grid& grid, const Inflation& inflation) {
  check_size(grid);
  cost::check_inflation(inflation);
  const StopCondition never;
  Poller poller(never);
  const auto field = clearance(grid, ClearanceOf::blocked_centres, poller);
  std::vector<double> values(weights_.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = cost::inflated(inflation, field->squared_half_cells[i]);
  add(values);
}

CostField::Range CostField::range(const Grid& grid) const {
  check_size(grid);
  Range range{kMost, kLeast};
  for (int y = 0; y < height_; ++y) {
    const std::uint64_t* words = grid.row(y);
    const double* row = weights_.data() + std::ptrdiff_t{y} * width_;
    for (int x = 0; x < width_; ++x) {
      if ((words[x >> 6] >> (x & 63) & 1) != 0) continue;
      range.least = std::min(range.least, row[x]);
      range.most = std::max(range.most, row[x]);
    }
  }
  return range.least <= range.most ? range : Range{};
}

std::uint64_t CostField::hash() const noexcept {
  std::uint64_t sum = 0x9e3779b97f4a7c15ULL ^ (static_cast<std::uint64_t>(width_) << 32 | height_);
  for (const double weight : weights_) {
    sum = (sum ^ std::bit_cast<std::uint64_t>(weight)) * 0xff51afd7ed558ccdULL;
    sum ^= sum >> 32;
  }
  return sum;
}

void CostField::check_size(const Grid& grid) const {
  if (grid.width() == width_ && grid.height() == height_) return;
  refuse("the costs are for a map of " + size_text(width_, height_) + ", the map has " +
             size_text(grid.width(), grid.height()) + " cells",
         "use costs of the map's size");
}

std::vector<double> slope(int width, int height, std::span<const double> heights) {
  (void)CostField(width, height);  // throws
  check_count(heights.size(), width, height);
  for (std::size_t i = 0; i < heights.size(); ++i)
    if (!std::isfinite(heights[i]))
      refuse("a height is " + number_text(heights[i]) + in_cell(i, width), "use finite ones");
  const auto at = [&](int x, int y) { return heights[static_cast<std::size_t>(y) * width + x]; };
  std::vector<double> slopes;
  slopes.reserve(heights.size());
  for (int y = 0; y < height; ++y) {
    const int up = std::max(y - 1, 0), down = std::min(y + 1, height - 1);
    for (int x = 0; x < width; ++x) {
      const int left = std::max(x - 1, 0), right = std::min(x + 1, width - 1);
      const double dx = left < right ? (at(right, y) - at(left, y)) / (right - left) : 0;
      const double dy = up < down ? (at(x, down) - at(x, up)) / (down - up) : 0;
      slopes.push_back(std::sqrt(dx * dx + dy * dy));
    }
  }
  return slopes;
}

Costmap read_costmap(int width, int height, std::span<const std::uint8_t> values, double weight,
                     bool unknown_is_free) {
  constexpr int kInscribed = 253, kUnknown = 255;
  CostField costs(width, height);
  check_count(values.size(), width, height);
  check_in(weight, 0, CostField::kMost, "the weight of a costmap");
  Grid grid(width, height);
  std::vector<double> shares(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] < kInscribed)
      shares[i] = values[i] / 252.0;
    else if (values[i] < kUnknown || !unknown_is_free)
      grid.set_blocked({static_cast<int>(i % width), static_cast<int>(i / width)});
  }
  costs.add(shares, weight);
  return {std::move(grid), std::move(costs)};
}

}  // namespace lasius
