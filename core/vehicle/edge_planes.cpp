#include "core/vehicle/edge_planes.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

namespace lasius::vehicle {
std::vector<MaskRows::Part> MaskRows::parts_of(const Masks& masks, const Masks::Mask& mask) {
  std::vector<Part> parts;
  for (const Masks::Row& run : masks.rows(mask)) {
    const int length = run.last - run.first + 1;
    const int spread = std::bit_width(static_cast<unsigned>(length)) - 1;
    parts.push_back({run.y, run.first, spread});
    if (length != 1 << spread) parts.push_back({run.y, run.last + 1 - (1 << spread), spread});
  }
  return parts;
}

MaskRows::MaskRows(const Space::Impl& space, const Masks& masks, std::span<const Masks::Mask> of)
    : width_(space.width()) {
  int beside = 0, most = 0;
  parts_.reserve(of.size());
  for (const Masks::Mask& mask : of) {
    parts_.push_back(parts_of(masks, mask));
    for (const Part& part : parts_.back()) {
      beside = std::max(beside, std::abs(part.first) + 64);
      above_ = std::max(above_, std::abs(part.y));
      most = std::max(most, part.spread);
    }
  }
  left_ = (beside / 64 + 1) * 64;
  stride_ = (2 * left_ + width_) / 64 + 2;
  const auto size = static_cast<std::size_t>(space.height() + 2 * above_) * stride_;
  planes_[0].assign(size, ~std::uint64_t{0});
  for (int y = 0; y < space.height(); ++y) {
    std::uint64_t* to = planes_[0].data() + at(y, 0);
    for (int w = 0; w < words(); ++w) to[w] = *space.bits().from(64 * w, y);
    to[words() - 1] |= ~(~std::uint64_t{0} >> (64 * words() - width_));
  }
  for (int k = 1; k <= most; ++k) {
    const int by = 1 << (k - 1);
    const std::vector<std::uint64_t>& from = planes_[k - 1];
    planes_[k].resize(size, ~std::uint64_t{0});
    for (std::size_t i = 0; i + 1 < size; ++i)
      planes_[k][i] = from[i] | (from[i] >> by) | (from[i + 1] << (64 - by));
  }
}

void MaskRows::free(int mask, int y, int first, int last, std::uint64_t* to) const {
  const int count = last - first;
  std::fill_n(to, count, 0);
  for (const Part& part : parts_[mask]) {
    const std::uint64_t* from =
        planes_[part.spread].data() + at(y + part.y, (part.first & ~63) + 64 * first);
    const int shift = part.first & 63;
    for (int w = 0; w < count; ++w)
      to[w] |= (from[w] >> shift) | ((from[w + 1] << 1) << (63 - shift));
  }
  for (int w = 0; w < count; ++w) to[w] = ~to[w];
  if (last == words()) to[count - 1] &= ~std::uint64_t{0} >> (64 * words() - width_);
}

std::int64_t EdgePlanes::bytes(const Space::Impl& space, const Lattice& lattice) noexcept {
  return static_cast<std::int64_t>(lattice.edges().size()) * space.height() *
         ((space.width() + 63) / 64) * 8;
}

std::optional<EdgePlanes> EdgePlanes::make(const Space::Impl& space, const Lattice& lattice,
                                           Poller& poller) {
  const std::vector<Edge>& edges = lattice.edges();
  std::vector<Masks::Mask> masks;
  masks.reserve(edges.size());
  for (const Edge& edge : edges) masks.push_back(edge.mask);
  const MaskRows rows(space, lattice.masks(), masks);
  EdgePlanes made(space.height(), rows.words(), edges.size());
  std::uint64_t* to = made.bits_.data();
  for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
    for (int y = 0; y < space.height(); ++y, to += rows.words()) {
      if (poller.stop_after(rows.parts(e) * rows.words() / 8 + 1)) return std::nullopt;
      rows.free(e, y, 0, rows.words(), to);
    }
  }
  return made;
}

}  // namespace lasius::vehicle
