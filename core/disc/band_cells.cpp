#include "core/disc/band_cells.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace lasius::disc {

namespace {

// Ends of pieces in neighbouring cells are the same numbers but for rounding.
constexpr double kRounding = 1e-12;

// Grows with the angle of a vector in (-pi, pi]: y / (|x| + |y|) and its like, from -2 to 2.
double fraction_of(double x, double y) noexcept {
  if (x >= 0) return y / (x + std::abs(y));
  return y >= 0 ? 1 + x / (x - y) : -1 - x / (x + y);
}

}  // namespace

BandCells::BandCells(DiscSpace& space, const Words& part)
    : space_(space),
      radius_(space.radius()),
      least_square_((radius_ - kMadeSlack) * (radius_ - kMadeSlack)),
      covered_(Reach(radius_).covered),
      corners_(space.map(), part) {
  // Room that is not used is not mapped.
  pieces_.reserve(4 * corners_.corners().size());
}

BandCells::Bits BandCells::add_word(const GrownRows& grown, int word, int y, std::uint64_t cells) {
  Bits bits{.blocked = grown.covered(word, y) & cells};
  for (std::uint64_t left = grown.touched(word, y) & ~bits.blocked & cells; left != 0;
       left &= left - 1) {
    const std::uint64_t here = left & (0 - left);
    if (!add(64 * word + std::countr_zero(left), y)) {
      bits.blocked |= here;
      continue;
    }
    bits.band |= here;
    for (const Piece& piece : pieces(size() - 1)) {
      const std::uint32_t type = corners_.corners()[piece.corner].type;
      (type == 0 || type == 3 ? bits.even : bits.odd) |= here;
    }
  }
  return bits;
}

bool BandCells::add(int x, int y) {
  const DiscSpace::Box box = space_.box_of(space_.walls(x, y), x, y);
  if (box.left > box.right || box.top > box.bottom) return false;
  find_circles(x, y);
  bool free = outside_circles({box.left, box.top}) || outside_circles({box.right, box.top}) ||
              outside_circles({box.left, box.bottom}) || outside_circles({box.right, box.bottom});
  for (const Circle& circle : circles_) free |= add_pieces(circle, box);
  if (free) firsts_.push_back(static_cast<std::uint32_t>(pieces_.size()));
  return free;
}

void BandCells::find_circles(int x, int y) {
  circles_.clear();
  for (std::uint32_t type = 0; type < 4; ++type) {
    const bool left = (type & 1) != 0, up = (type & 2) != 0;
    for (int rows = 0; rows < static_cast<int>(covered_.size()); ++rows) {
      const int columns = covered_[rows];
      const int corner_y = up ? y + 1 + rows : y - rows;
      const int first = left ? x + 1 : x - columns;
      std::uint64_t found =
          corners_.window(type, first, corner_y) & (~std::uint64_t{0} >> (63 - columns));
      for (; found != 0; found &= found - 1)
        circles_.push_back({first + std::countr_zero(found), corner_y, type});
    }
  }
}

bool BandCells::outside_circles(Point p) const noexcept {
  return std::ranges::all_of(circles_, [&](const Circle& circle) {
    const double x = p.x - circle.x, y = p.y - circle.y;
    return x * x + y * y >= least_square_;
  });
}

// Where a circle runs in a box of its quadrant, as fractions; low > high: nowhere.
BandCells::Span BandCells::span_in(const Circle& circle, const DiscSpace::Box& box) const noexcept {
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
void BandCells::cut(const Circle& circle, const Circle& other) {
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

bool BandCells::add_pieces(const Circle& circle, const DiscSpace::Box& box) {
  const Span whole = span_in(circle, box);
  if (whole.low > whole.high + kRounding) return false;
  spans_.assign(1, {whole.low, std::max(whole.low, whole.high)});
  for (const Circle& other : circles_) cut(circle, other);
  if (spans_.empty()) return false;
  const std::uint32_t number = corners_.number(circle.x, circle.y);
  for (const Span& span : spans_) pieces_.push_back({number, 0, span.low, span.high});
  return true;
}

void BandCells::join(const std::vector<char>& only, std::vector<std::uint32_t>& spare,
                     Poller& poller) {
  const auto& corners = corners_.corners();
  std::vector<std::uint32_t> ends(corners.size() + 1);  // of the corners' pieces; then their begins
  for (const Piece& piece : pieces_) ++ends[piece.corner];
  for (std::size_t i = 1; i < ends.size(); ++i) ends[i] += ends[i - 1];
  std::vector<std::uint32_t> order(pieces_.size());
  for (std::size_t i = pieces_.size(); i > 0; --i)
    order[--ends[pieces_[i - 1].corner]] = static_cast<std::uint32_t>(i - 1);
  for (std::size_t corner = 0; corner < corners.size(); ++corner) {
    if (ends[corner] == ends[corner + 1] || (!only.empty() && only[corner] == 0)) continue;
    const std::span here(order.data() + ends[corner], order.data() + ends[corner + 1]);
    if (poller.stop_after(std::ssize(here))) return;
    for (std::size_t i = 1; i < here.size(); ++i) {  // few, and nearly sorted
      const std::uint32_t number = here[i];
      std::size_t to = i;
      for (; to > 0 && pieces_[number].low < pieces_[here[to - 1]].low; --to)
        here[to] = here[to - 1];
      here[to] = number;
    }
    const CornerRows::Corner& c = corners[corner];
    std::uint32_t arc = 0;
    for (std::size_t i = 0; i < here.size(); ++i) {
      Piece& piece = pieces_[here[i]];
      if (i > 0 && piece.low <= space_.arcs_[arc].high + kRounding) {
        space_.arcs_[arc].high = std::max(space_.arcs_[arc].high, piece.high);
      } else {
        if (spare.empty()) {
          arc = static_cast<std::uint32_t>(space_.arcs_.size());
          space_.arcs_.emplace_back();
        } else {
          arc = spare.back();
          spare.pop_back();
        }
        space_.arcs_[arc] = {c.x, c.y, c.type, piece.low, piece.high};
      }
      piece.arc = arc;
    }
  }
}

std::uint32_t BandCells::kept(std::size_t cell) {
  const std::span<const Piece> here = pieces(cell);
  if (here.size() == 1) return here[0].arc;
  if (here.empty()) return DiscSpace::kSeveral;
  const auto list = static_cast<std::uint32_t>(space_.passing_.size());
  space_.passing_.push_back(static_cast<std::uint32_t>(here.size()));
  for (const Piece& piece : here) space_.passing_.push_back(piece.arc);
  return DiscSpace::kSeveral + list;
}

}  // namespace lasius::disc
