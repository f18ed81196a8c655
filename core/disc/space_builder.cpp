#include "core/disc/space_builder.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "core/disc/bit_rows.h"

namespace lasius::disc {

namespace {

// Ends of pieces in neighbouring cells are the same numbers but for rounding.
constexpr double kRounding = 1e-12;

// 64 x 64 bits with rows and columns swapped (Warren: Hacker's Delight, 7-3).
void transpose(std::array<std::uint64_t, 64>& bits) noexcept {
  std::uint64_t mask = 0xffffffff;
  for (unsigned j = 32; j != 0; j >>= 1, mask ^= mask << j) {
    for (unsigned k = 0; k < 64; k = (k + j + 1) & ~j) {
      const std::uint64_t t = (bits[k] >> j ^ bits[k + j]) & mask;
      bits[k] ^= t << j;
      bits[k + j] ^= t;
    }
  }
}

Grid transposed(const Grid& grid) {
  Grid out(grid.height(), grid.width());
  std::vector<std::uint64_t> rows(static_cast<std::size_t>(out.words()) * 64);
  for (int i = 0; i < grid.words(); ++i) {
    for (int j = 0; j < out.words(); ++j) {
      std::array<std::uint64_t, 64> block;
      for (int k = 0; k < 64; ++k) {
        block[k] = grid.row(std::min(64 * j + k, grid.height()))[i];
      }
      transpose(block);
      for (int k = 0; k < 64; ++k) rows[static_cast<std::size_t>(k) * out.words() + j] = block[k];
    }
    for (int k = 0; k < 64 && 64 * i + k < grid.width(); ++k) {
      out.set_row(64 * i + k, rows.data() + static_cast<std::size_t>(k) * out.words());
    }
  }
  return out;
}

// Grows with the angle of a vector in (-pi, pi]: y / (|x| + |y|) and its like, from -2 to 2.
double fraction_of(double x, double y) noexcept {
  if (x >= 0) return y / (x + std::abs(y));
  return y >= 0 ? 1 + x / (x - y) : -1 - x / (x + y);
}

}  // namespace

SpaceBuilder::SpaceBuilder(DiscSpace& space, Poller& poller)
    : space_(space),
      poller_(poller),
      radius_(space.radius()),
      least_square_((radius_ - kMadeSlack) * (radius_ - kMadeSlack)),
      reach_(radius_),
      corners_(space.map()),
      columns_(transposed(space.map())) {}

bool SpaceBuilder::build() {
  GrownRows grown(space_.map(), reach_);
  if (!grown.grow(poller_)) return false;
  for (int y = 0; y < space_.map().height(); y += 8) {
    build_tiles(y, grown);
    if (poller_.stopped()) return false;
  }
  join_pieces();
  return !poller_.stop_after(static_cast<std::int64_t>(pieces_.size()));
}

// A row of tiles, from cells' row y0 on.
void SpaceBuilder::build_tiles(int y0, const GrownRows& grown) {
  const int words = space_.map().words();
  const int rows = std::min(8, space_.map().height() - y0);
  DiscSpace::Tile* tile = &space_.tiles_[static_cast<std::size_t>(y0 >> 3) * space_.tiles_across_];
  for (RowBits& bits : rows_) bits.assign(static_cast<std::size_t>(words) * 8, 0);
  auto& [blocked, band, even, odd] = rows_;
  for (int k = 0; k < rows; ++k) {
    std::copy_n(grown.covered(y0 + k), words, blocked.data() + std::ptrdiff_t{k} * words);
  }
  for (int x0 = 0; x0 < space_.map().width(); x0 += 8, ++tile) {
    tile->first = static_cast<std::uint32_t>(space_.cells_.size());
    bool crowded = false;
    for (int k = 0; k < rows; ++k) {
      const int word = k * words + (x0 >> 6), shift = x0 & 63;
      crowded |= (grown.touched(y0 + k)[x0 >> 6] >> shift & 0xff) != 0;
      const std::uint64_t doubtful = grown.touched(y0 + k)[x0 >> 6] & ~blocked[word];
      for (std::uint64_t left = doubtful >> shift & 0xff; left != 0; left &= left - 1) {
        const int x = x0 + std::countr_zero(left);
        const std::uint64_t here = std::uint64_t{1} << (x & 63);
        if (!build_cell(x, y0 + k)) {
          blocked[word] |= here;
          continue;
        }
        band[word] |= here;
        tile->band |= std::uint64_t{1} << (8 * k + (x & 7));
        for (std::size_t i = space_.cells_.back().first; i < pieces_.size(); ++i) {
          const std::uint32_t type = corners_.corners()[pieces_[i].corner].type;
          (type == 0 || type == 3 ? even : odd)[word] |= here;
        }
      }
    }
    if (crowded) space_.crowded_.set_blocked({x0 >> 3, y0 >> 3});
    poller_.stop_after(std::int64_t{4} * (1 + count_bits(tile->band)));
  }
  for (std::ptrdiff_t k = 0; k < rows; ++k) {
    space_.blocked_.set_row(y0 + static_cast<int>(k), blocked.data() + k * words);
    space_.band_.set_row(y0 + static_cast<int>(k), band.data() + k * words);
    space_.arc_cells_even_.set_row(y0 + static_cast<int>(k), even.data() + k * words);
    space_.arc_cells_odd_.set_row(y0 + static_cast<int>(k), odd.data() + k * words);
  }
}

// Steps to the blocked cells left, above, right and below, 6 bits each.
std::uint32_t SpaceBuilder::steps_to_blocked(int x, int y) const noexcept {
  const auto cut = [&](int steps) {
    return steps < radius_ + 1 ? static_cast<std::uint32_t>(steps) : DiscSpace::kFar;
  };
  const std::uint64_t* row = space_.map().row(y);
  const std::uint64_t* column = columns_.row(x);
  return cut(x - blocked_before(row, x - 1)) | cut(y - blocked_before(column, y - 1)) << 6 |
         cut(blocked_after(row, x + 1) - x) << 12 | cut(blocked_after(column, y + 1) - y) << 18;
}

// Adds a cell and its pieces of arcs; false if no point of it is free.
bool SpaceBuilder::build_cell(int x, int y) {
  const std::size_t before = pieces_.size();
  DiscSpace::BandCell cell{steps_to_blocked(x, y), static_cast<std::uint32_t>(before)};
  const DiscSpace::Box box = space_.box_of(cell, x, y);
  if (box.left > box.right || box.top > box.bottom) return false;
  find_circles(x, y);
  bool free = outside_circles({box.left, box.top}) || outside_circles({box.right, box.top}) ||
              outside_circles({box.left, box.bottom}) || outside_circles({box.right, box.bottom});
  for (const Circle& circle : circles_) free |= add_pieces(circle, box);
  if (!free) return false;
  cell.box_and_count |= static_cast<std::uint32_t>(pieces_.size() - before) << 24;
  space_.cells_.push_back(cell);
  return true;
}

void SpaceBuilder::find_circles(int x, int y) {
  circles_.clear();
  for (std::uint32_t type = 0; type < 4; ++type) {
    const bool left = (type & 1) != 0, up = (type & 2) != 0;
    for (int rows = 0; rows < static_cast<int>(reach_.covered.size()); ++rows) {
      const int columns = reach_.covered[rows];
      const int corner_y = up ? y + 1 + rows : y - rows;
      const int first = left ? x + 1 : x - columns;
      std::uint64_t found =
          corners_.window(type, first, corner_y) & (~std::uint64_t{0} >> (63 - columns));
      for (; found != 0; found &= found - 1) {
        circles_.push_back({first + std::countr_zero(found), corner_y, type});
      }
    }
  }
}

bool SpaceBuilder::outside_circles(Point p) const noexcept {
  return std::ranges::all_of(circles_, [&](const Circle& circle) {
    const double x = p.x - circle.x, y = p.y - circle.y;
    return x * x + y * y >= least_square_;
  });
}

// Where a circle runs in a box of its quadrant, as fractions; low > high: nowhere.
SpaceBuilder::Span SpaceBuilder::span_in(const Circle& circle,
                                         const DiscSpace::Box& box) const noexcept {
  const bool left = (circle.type & 1) != 0, up = (circle.type & 2) != 0;
  const double x0 = left ? circle.x - box.right : box.left - circle.x;
  const double x1 = left ? circle.x - box.left : box.right - circle.x;
  const double y0 = up ? circle.y - box.bottom : box.top - circle.y;
  const double y1 = up ? circle.y - box.top : box.bottom - circle.y;
  const double square = radius_ * radius_;
  if (x0 * x0 + y0 * y0 > square * (1 + kRounding) || x1 * x1 + y1 * y1 < square * (1 - kRounding))
    return {1, 0};
  const auto other = [&](double one) { return std::sqrt(std::max(0.0, square - one * one)); };
  const double low_x = std::min(other(y0), x1);
  const double low_y = low_x < x1 ? y0 : std::max(y0, other(x1));
  const double high_y = std::min(other(x0), y1);
  const double high_x = high_y < y1 ? x0 : std::max(x0, other(y1));
  return {fraction_of(low_x, low_y), fraction_of(high_x, high_y)};
}

// Takes off what another circle covers.
void SpaceBuilder::cut(const Circle& circle, const Circle& other) {
  const double x = (circle.type & 1) != 0 ? circle.x - other.x : other.x - circle.x;
  const double y = (circle.type & 2) != 0 ? circle.y - other.y : other.y - circle.y;
  const double square = x * x + y * y;
  if (square == 0 || (x < 0 && y < 0)) return;
  // The normals at which the circle is radius_ - kMadeSlack away from the other one's centre.
  const double share = (square + 2 * radius_ * kMadeSlack) / (2 * radius_ * square);
  const double cosine_square = share * share * square;
  if (cosine_square >= 1) return;
  const double across = std::sqrt((1 - cosine_square) / square);
  double low = fraction_of(share * x + across * y, share * y - across * x);
  double high = fraction_of(share * x - across * y, share * y + across * x);
  if (high < low) (x < 0 ? high += 4 : low -= 4);
  cut_spans_.clear();
  for (const Span& span : spans_) {
    if (span.low <= std::min(span.high, low))
      cut_spans_.push_back({span.low, std::min(span.high, low)});
    if (std::max(span.low, high) <= span.high && high > low)
      cut_spans_.push_back({std::max(span.low, high), span.high});
  }
  if (std::max(low, 0.0) <= std::min(high, 1.0)) spans_.swap(cut_spans_);
}

bool SpaceBuilder::add_pieces(const Circle& circle, const DiscSpace::Box& box) {
  const Span whole = span_in(circle, box);
  if (whole.low > whole.high + kRounding) return false;
  spans_.assign(1, {whole.low, std::max(whole.low, whole.high)});
  for (const Circle& other : circles_) cut(circle, other);
  if (spans_.empty()) return false;
  const std::uint32_t number = corners_.number(circle.x, circle.y);
  for (const Span& span : spans_) pieces_.push_back({number, span.low, span.high});
  return true;
}

// Pieces of one circle that meet are an arc. Numbers them by tiles of their corners, each circle's
// by the angle.
void SpaceBuilder::join_pieces() {
  const auto& corners = corners_.corners();
  std::vector<std::uint32_t> first(corners.size() + 1);
  for (const Piece& piece : pieces_) ++first[piece.corner + 1];
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  std::vector<std::uint32_t> order(pieces_.size());
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (std::uint32_t i = 0; i < pieces_.size(); ++i) order[next[pieces_[i].corner]++] = i;
  std::vector<std::uint32_t> arcs(pieces_.size());
  for (const std::uint32_t corner : by_tiles()) {
    const auto begin = order.begin() + first[corner], end = order.begin() + first[corner + 1];
    std::stable_sort(begin, end, [this](std::uint32_t i, std::uint32_t j) {
      return pieces_[i].low < pieces_[j].low;
    });
    for (auto i = begin; i != end; ++i) {
      const Piece& piece = pieces_[*i];
      const bool joins = i != begin && piece.low <= space_.arcs_.back().high + kRounding;
      if (joins) {
        space_.arcs_.back().high = std::max(space_.arcs_.back().high, piece.high);
      } else {
        const CornerRows::Corner& c = corners[corner];
        space_.arcs_.push_back({c.x, c.y, c.type, piece.low, piece.high});
      }
      arcs[*i] = static_cast<std::uint32_t>(space_.arcs_.size() - 1);
    }
  }
  for (DiscSpace::BandCell& cell : space_.cells_) {
    const std::uint32_t count = cell.box_and_count >> 24;
    const auto* here = arcs.data() + cell.first;
    cell.first = count == 1 ? *here : static_cast<std::uint32_t>(space_.passing_.size());
    if (count > 1) space_.passing_.insert(space_.passing_.end(), here, here + count);
  }
}

// The corners, which stand row by row, by tiles of 8 x 8 lattice points.
std::vector<std::uint32_t> SpaceBuilder::by_tiles() const {
  const auto& corners = corners_.corners();
  std::vector<std::uint32_t> order(corners.size());
  std::iota(order.begin(), order.end(), 0);
  for (auto begin = order.begin(); begin != order.end();) {
    const int row = corners[*begin].y >> 3;
    const auto end =
        std::find_if(begin, order.end(), [&](std::uint32_t i) { return corners[i].y >> 3 != row; });
    std::stable_sort(begin, end, [&](std::uint32_t i, std::uint32_t j) {
      return corners[i].x >> 3 < corners[j].x >> 3;
    });
    begin = end;
  }
  return order;
}

}  // namespace lasius::disc
