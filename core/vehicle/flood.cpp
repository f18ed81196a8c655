#include "core/vehicle/flood.h"

#include <algorithm>
#include <cmath>

namespace lasius::vehicle {
namespace {

constexpr int kStepX[8] = {1, 1, 0, -1, -1, -1, 0, 1};
constexpr int kStepY[8] = {0, 1, 1, 1, 0, -1, -1, -1};

}  // namespace

FreeHeadings::FreeHeadings(const Space::Impl& space, const Lattice& lattice, Poller& poller)
    : width_(space.width()) {
  const double around = space.outline().around() + 1e-6;
  const double inside = space.outline().inside() - 1e-6;
  // In half cells.
  const auto all = static_cast<std::int32_t>(4 * around * around) + 1;
  const auto none = static_cast<std::int32_t>(std::max(0.0, 4 * inside * inside));
  bits_.resize(static_cast<std::size_t>(width_) * space.height());
  for (int y = 0; y < space.height(); ++y) {
    if (poller.stop_after(width_)) return;
    const std::size_t row = static_cast<std::size_t>(y) * width_;
    for (int x = 0; x < width_; ++x) {
      const std::int32_t squared = space.field().squared_half_cells[row + x];
      if (squared == 0 || squared < none) continue;
      if (squared >= all) {
        bits_[row + x] = 0xffff;
        continue;
      }
      unsigned bits = 0;
      for (int h = 0; h < Lattice::kHeadings; ++h) {
        if (lattice.masks().free(lattice.footprint(h), space.bits(), x, y)) bits |= 1u << h;
      }
      bits_[row + x] = static_cast<std::uint16_t>(bits);
    }
  }
}

Flood::Flood(const FreeHeadings& free, const Space::Impl& space, const Prices& prices, bool squeeze,
             Memory& memory, Poller& poller)
    : free_(free),
      prices_(prices),
      clearance_(space.field().squared_half_cells),
      squeeze_(squeeze),
      needed_(space.needed_by_disc()),
      width_(space.width()),
      height_(space.height()),
      buckets_(prices.weighted() ? kWeighted * kBuckets : kBuckets),
      memory_(memory),
      poller_(poller) {
  memory_.buckets.resize(buckets_);
  memory_.distance.resize(clearance_.size(), kFar);
  for (const std::uint32_t cell : memory_.touched) memory_.distance[cell] = kFar;
  memory_.touched.clear();
  for (std::vector<std::uint32_t>& bucket : memory_.buckets) bucket.clear();
  const bool reverse = space.vehicle().reverse;
  for (int step = 0; step < 8; ++step) {
    // Heading 2 * step has the direction of the step.
    for (int off = -1; off <= 1; ++off) {
      const int h = (2 * step + off + 16) % 16;
      near_[step] |= static_cast<std::uint16_t>(1u << h);
      if (reverse) near_[step] |= static_cast<std::uint16_t>(1u << ((h + 8) % 16));
    }
    if (space.vehicle().sideways) near_[step] = 0xffff;
  }
}

void Flood::add_source(int x, int y, double cells) {
  sources_.push_back({std::floor(cells * kUnits),
                      static_cast<std::uint32_t>(static_cast<std::size_t>(y) * width_ + x)});
  ++waiting_;
}

void Flood::put(std::size_t cell, std::int32_t distance) {
  std::int32_t& known = memory_.distance[cell];
  if (distance >= known) return;
  if (known == kFar) memory_.touched.push_back(static_cast<std::uint32_t>(cell));
  known = distance;
  memory_.buckets[distance & (buckets_ - 1)].push_back(static_cast<std::uint32_t>(cell));
  ++waiting_;
}

void Flood::begin() {
  std::ranges::sort(sources_);
  first_ = sources_.front().first;
  for (auto& source : sources_) source.first = std::min<double>(source.first - first_, kLast);
}

// One level: the next one where anything is.
void Flood::advance() {
  if (level_ < 0) begin();
  const auto none_before = static_cast<std::int64_t>(sources_.size() - next_source_) == waiting_;
  level_ = none_before ? static_cast<std::int32_t>(sources_[next_source_].first) : level_ + 1;
  for (; next_source_ < sources_.size() && sources_[next_source_].first <= level_; ++next_source_) {
    --waiting_;
    put(sources_[next_source_].second, level_);
  }
  std::vector<std::uint32_t>& bucket = memory_.buckets[level_ & (buckets_ - 1)];
  for (std::size_t i = 0; i < bucket.size(); ++i) {
    const std::uint32_t cell = bucket[i];
    if (memory_.distance[cell] != level_) continue;
    const int x = static_cast<int>(cell) % width_;
    const int y = static_cast<int>(cell) / width_;
    const unsigned here = free_[cell];
    for (int step = 0; step < 8; ++step) {
      // The step leads from the neighbour to here.
      const int nx = x - kStepX[step];
      const int ny = y - kStepY[step];
      if (nx < 0 || ny < 0 || nx >= width_ || ny >= height_) continue;
      const std::size_t next = static_cast<std::size_t>(ny) * width_ + nx;
      std::int32_t length = (step & 1) != 0 ? 41 : kUnits;
      if (std::min(level_ + length, kLast) >= memory_.distance[next]) continue;
      if ((here & near_[step] & free_[next]) == 0) {
        if (!squeeze_ || clearance_[next] < needed_) continue;
        length *= kUnfit;
      }
      if (prices_.weighted()) {
        const double mean = (prices_.weight(x, y) + prices_.weight(nx, ny)) / 2;
        length = static_cast<std::int32_t>(std::min(buckets_ - 1.0, length * mean));
      }
      put(next, std::min(level_ + length, kLast));
    }
  }
  waiting_ -= static_cast<std::int64_t>(bucket.size());
  poller_.stop_after(1 + 8 * static_cast<std::int64_t>(bucket.size()));
  bucket.clear();
}

}  // namespace lasius::vehicle
