#include "core/vehicle/edge_planes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>

namespace lasius::vehicle {
namespace {

constexpr int kSpreads = 7;  ///< over 1, 2, ... 64 columns: a mask's word has no longer run

/// A row of a mask: whether columns first .. first + 2^spread - 1, from its cell, are blocked.
struct Part {
  int y, first, spread;
};

std::vector<Part> parts_of(const Masks& masks, const Masks::Mask& mask) {
  std::vector<Part> parts;
  for (const Masks::Row& run : masks.rows(mask)) {
    const int length = run.last - run.first + 1;
    const int spread = std::bit_width(static_cast<unsigned>(length)) - 1;
    parts.push_back({run.y, run.first, spread});
    if (length != 1 << spread) parts.push_back({run.y, run.last + 1 - (1 << spread), spread});
  }
  return parts;
}

/// A map whose rows have ones around them, its blocked cells spread to the left.
class SpreadMap {
 public:
  SpreadMap(const Space::Impl& space, int beside, int above)
      : above_(above),
        left_((beside / 64 + 1) * 64),
        height_(space.height() + 2 * above),
        words_((2 * left_ + space.width()) / 64 + 2) {
    for (std::vector<std::uint64_t>& plane : planes_)
      plane.assign(static_cast<std::size_t>(height_) * words_, ~std::uint64_t{0});
    for (int y = 0; y < space.height(); ++y) {
      std::uint64_t* to = row(0, y, 0);
      for (int x = 0; x < space.width(); ++x) {
        if (space.field().squared_half_cells[static_cast<std::size_t>(y) * space.width() + x] != 0)
          to[x >> 6] &= ~(std::uint64_t{1} << (x & 63));
      }
    }
    for (int k = 1; k < kSpreads; ++k) {
      const int by = 1 << (k - 1);
      const std::vector<std::uint64_t>& from = planes_[k - 1];
      for (std::size_t i = 0; i + 1 < from.size(); ++i)
        planes_[k][i] = from[i] | (from[i] >> by) | (from[i + 1] << (64 - by));
    }
  }

  /// The words from column x, a multiple of 64, on.
  std::uint64_t* row(int spread, int y, int x) {
    return planes_[spread].data() + static_cast<std::ptrdiff_t>(y + above_) * words_ +
           ((x + left_) >> 6);
  }

 private:
  int above_, left_, height_, words_;
  std::array<std::vector<std::uint64_t>, kSpreads> planes_;
};

}  // namespace

std::int64_t EdgePlanes::bytes(const Space::Impl& space, const Lattice& lattice) noexcept {
  return static_cast<std::int64_t>(lattice.edges().size()) * space.height() *
         ((space.width() + 63) / 64) * 8;
}

std::optional<EdgePlanes> EdgePlanes::make(const Space::Impl& space, const Lattice& lattice,
                                           Poller& poller) {
  const std::vector<Edge>& edges = lattice.edges();
  std::vector<std::vector<Part>> parts;
  int beside = 0;
  int above = 0;
  for (const Edge& edge : edges) {
    parts.push_back(parts_of(lattice.masks(), edge.mask));
    for (const Part& part : parts.back()) {
      beside = std::max(beside, std::abs(part.first) + 64);
      above = std::max(above, std::abs(part.y));
    }
  }
  SpreadMap map(space, beside, above);
  const int words = (space.width() + 63) / 64;
  const std::uint64_t last = ~std::uint64_t{0} >> (64 * words - space.width());
  EdgePlanes made(space.height(), words, edges.size());
  std::uint64_t* to = made.bits_.data();
  for (const std::vector<Part>& edge : parts) {
    for (int y = 0; y < space.height(); ++y, to += words) {
      if (poller.stop_after(static_cast<std::int64_t>(edge.size()) * words / 8 + 1))
        return std::nullopt;
      for (const Part& part : edge) {
        const std::uint64_t* from = map.row(part.spread, y + part.y, part.first & ~63);
        const int shift = part.first & 63;
        for (int w = 0; w < words; ++w)
          to[w] |= (from[w] >> shift) | ((from[w + 1] << 1) << (63 - shift));
      }
      for (int w = 0; w < words; ++w) to[w] = ~to[w];
      to[words - 1] &= last;
    }
  }
  return made;
}

}  // namespace lasius::vehicle
