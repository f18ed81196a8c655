#include "core/vehicle/flood.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/vehicle/edge_planes.h"

namespace lasius::vehicle {
namespace {

constexpr int kStepX[8] = {1, 1, 0, -1, -1, -1, 0, 1};
constexpr int kStepY[8] = {0, 1, 1, 1, 0, -1, -1, -1};

/// Of each byte its bits, one a cell.
constexpr auto kBitsOfByte = [] {
  std::array<std::array<std::uint16_t, 8>, 256> bits{};
  for (unsigned byte = 0; byte < 256; ++byte)
    for (unsigned i = 0; i < 8; ++i) bits[byte][i] = static_cast<std::uint16_t>(byte >> i & 1);
  return bits;
}();

/// Bits of 64 cells, as bit h of each.
void add_heading(std::uint64_t free, int h, std::array<std::uint16_t, 64>& cells) {
  for (int byte = 0; byte < 8; ++byte) {
    const std::array<std::uint16_t, 8>& bits = kBitsOfByte[free >> (8 * byte) & 0xff];
    for (int i = 0; i < 8; ++i)
      cells[8 * byte + i] = static_cast<std::uint16_t>(cells[8 * byte + i] | bits[i] << h);
  }
}

}  // namespace

FreeHeadings::FreeHeadings(const Space::Impl& space, const Lattice& lattice, Poller& poller)
    : width_(space.width()), bits_(static_cast<std::size_t>(width_) * space.height()) {
  const double around = space.outline().around() + 1e-6;
  // From there on in half cells all headings are free.
  const auto all = static_cast<std::int32_t>(4 * around * around) + 1;
  std::array<Masks::Mask, Lattice::kHeadings> footprints;
  for (int h = 0; h < Lattice::kHeadings; ++h) footprints[h] = lattice.footprint(h);
  const MaskRows rows(space, lattice.masks(), footprints);
  const std::int64_t words = rows.words();
  std::vector<std::uint64_t> free(words * Lattice::kHeadings);
  for (int y = 0; y < space.height(); ++y) {
    if (poller.stop_after(width_)) return;
    const std::size_t row = static_cast<std::size_t>(y) * width_;
    const std::int32_t* clear = space.field().squared_half_cells.data() + row;
    int first = rows.words(), last = 0;  // words where a heading may be free, and another not
    for (int w = 0; w < rows.words(); ++w) {
      const std::int64_t begin = std::int64_t{64} * w;
      const std::int64_t end = std::min<std::int64_t>(width_, begin + 64);
      const auto [least, most] = std::minmax_element(clear + begin, clear + end);
      if (*least >= all) std::fill_n(bits_.data() + row + begin, end - begin, 0xffff);
      if (*least >= all || *most == 0) continue;
      first = std::min(first, w);
      last = w + 1;
    }
    if (first >= last) continue;
    for (int h = 0; h < Lattice::kHeadings; ++h)
      rows.free(h, y, first, last, free.data() + h * words);
    for (int w = first; w < last; ++w) {
      std::array<std::uint16_t, 64> cells{};
      for (int h = 0; h < Lattice::kHeadings; ++h)
        add_heading(free[h * words + w - first], h, cells);
      const std::int64_t begin = std::int64_t{64} * w;
      std::copy_n(cells.begin(), std::min<std::int64_t>(width_ - begin, 64),
                  bits_.data() + row + begin);
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
