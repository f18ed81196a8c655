#include "kernels/sight/sight.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lasius::kernels {
namespace {

// Bits [from, from + 64) of a row, from >= -1; what lies past the row's guard word is not read
// unless one of the wanted bits [from, last] is there.
std::uint64_t bits_at(const std::uint64_t* row, int from, int last) noexcept {
  const int word = from >> 6;
  const int shift = from & 63;
  std::uint64_t bits = row[word] >> shift;
  if (shift != 0 && last >> 6 > word) bits |= row[word + 1] << (64 - shift);
  return bits;
}

// Along the grid line between two rows, over the columns [lo, hi]: some column must be free on one
// side, and two neighbouring columns on the same one.
bool sees_along_row_line(const std::uint64_t* above, const std::uint64_t* below, int lo,
                         int hi) noexcept {
  constexpr int kStep = 63;  // 64 bits decide 63 pairs
  for (int x = lo;; x += kStep) {
    const int last = std::min(x + kStep, hi);
    std::uint64_t up = bits_at(above, x, last);
    std::uint64_t down = bits_at(below, x, last);
    const std::uint64_t wanted = ~std::uint64_t{0} >> (63 - (last - x));
    if ((up & down & wanted) != 0) return false;
    up |= up >> 1;
    down |= down >> 1;
    if ((up & down & (wanted >> 1)) != 0) return false;
    if (last == hi) return true;
  }
}

// Along the grid line left of column x, over the rows [lo, hi].
bool sees_along_column_line(const BitmapView& map, int x, int lo, int hi) noexcept {
  bool left = false;
  bool right = false;
  for (int y = lo; y <= hi; ++y) {
    const bool next_left = map.blocked(x - 1, y);
    const bool next_right = map.blocked(x, y);
    if ((left || next_left) && (right || next_right)) return false;
    left = next_left;
    right = next_right;
  }
  return true;
}

// In the interior of a column, over the rows [lo, hi].
bool column_free(const BitmapView& map, int x, int lo, int hi) noexcept {
  const std::uint64_t bit = std::uint64_t{1} << (x & 63);
  const std::uint64_t* word = map.row(lo) + (x >> 6);
  for (int y = lo; y <= hi; ++y, word += map.stride) {
    if ((*word & bit) != 0) return false;
  }
  return true;
}

bool sees_up_and_down(const BitmapView& map, int x, int y0, int y1) noexcept {
  const int lo = y0 >> 1;
  const int hi = ((y1 + 1) >> 1) - 1;
  return (x & 1) == 0 ? sees_along_column_line(map, x >> 1, lo, hi)
                      : column_free(map, x >> 1, lo, hi);
}

bool sees_left_and_right(const BitmapView& map, int x0, int x1, int y) noexcept {
  const int lo = x0 >> 1;
  const int hi = ((x1 + 1) >> 1) - 1;
  if ((y & 1) != 0) return row_free(map.row(y >> 1), lo, hi);
  return sees_along_row_line(map.row((y >> 1) - 1), map.row(y >> 1), lo, hi);
}

// Where the segment crosses a horizontal line: column + part / whole cells, 0 <= part < whole.
struct Crossing {
  int column;
  int part;
};

// The segment from a down to b, b.x > a.x if kRight, else b.x < a.x.
template <bool kRight>
bool sees_downwards(const BitmapView& map, HalfPoint a, HalfPoint b) noexcept {
  const int dx = b.x - a.x;
  const int dy = b.y - a.y;
  const int whole = 2 * dy;
  int slope = dx / dy;  // dx / dy = slope + rest / dy, 0 <= rest < dy
  int rest = dx % dy;
  if (rest < 0) {
    --slope;
    rest += dy;
  }
  const auto advance = [whole](Crossing c, int columns, int parts) noexcept {
    c.column += columns;
    c.part += parts;
    const bool carry = c.part >= whole;
    return Crossing{c.column + carry, c.part - (carry ? whole : 0)};
  };
  const auto row_seen = [](const std::uint64_t* row, Crossing top, Crossing bottom) noexcept {
    return kRight ? row_free(row, top.column, bottom.column - (bottom.part == 0))
                  : row_free(row, bottom.column, top.column - (top.part == 0));
  };
  Crossing top{a.x >> 1, (a.x & 1) * dy};
  int y = a.y >> 1;
  const std::uint64_t* row = map.row(y);
  int rows = ((b.y + 1) >> 1) - y;  // crossed rows left
  bool half = (a.y & 1) != 0;       // the first one, from its middle
  for (; rows > 1; --rows, row += map.stride) {
    const Crossing bottom =
        half ? advance(top, slope >> 1, rest + (slope & 1) * dy) : advance(top, slope, 2 * rest);
    half = false;
    if (!row_seen(row, top, bottom)) return false;
    if (bottom.part == 0) {  // a lattice point: are the two cells beside the segment blocked?
      const int x = bottom.column;
      const int upper = kRight ? x : x - 1;
      const int lower = kRight ? x - 1 : x;
      const std::uint64_t* below = row + map.stride;
      if (((row[upper >> 6] >> (upper & 63)) & (below[lower >> 6] >> (lower & 63)) & 1) != 0) {
        return false;
      }
    }
    top = bottom;
  }
  return row_seen(row, top, {b.x >> 1, b.x & 1});
}

__extension__ using Wide = __int128;

constexpr int kFineBits = 44;
static_assert(kFineCell == std::int64_t{1} << kFineBits);
constexpr std::int64_t kFinePart = kFineCell - 1;

int floor_cell(std::int64_t v) noexcept { return static_cast<int>(v >> kFineBits); }
/// The last cell that an open interval that ends at v meets.
int last_cell(std::int64_t v) noexcept { return floor_cell(v + kFinePart) - 1; }

// A steep or flat segment from a down to b, its crossings with horizontal lines.
class FineSegment {
 public:
  FineSegment(FinePoint a, FinePoint b) noexcept : a_(a), dx_(b.x - a.x), dy_(b.y - a.y) {}

  // Column and whether it is met at its left edge; of a line between the ends. In floating point
  // unless that is near an edge: there it is off by less than 2^-30.
  std::pair<int, bool> at(int line) const noexcept {
    constexpr double kUnit = 1.0 / static_cast<double>(kFineCell);
    const std::int64_t down = line * kFineCell - a_.y;
    const double x =
        kUnit * static_cast<double>(a_.x) +
        kUnit * static_cast<double>(dx_) * (static_cast<double>(down) / static_cast<double>(dy_));
    const double edge = std::nearbyint(x);
    if (std::abs(x - edge) > 0x1p-30) return {static_cast<int>(std::floor(x)), false};
    const int column = static_cast<int>(edge);
    const Wide side = Wide{a_.x - column * kFineCell} * dy_ + Wide{dx_} * down;
    return {side < 0 ? column - 1 : column, side == 0};
  }

 private:
  FinePoint a_;
  std::int64_t dx_, dy_;
};

bool sees_fine_downwards(const BitmapView& map, FinePoint a, FinePoint b) noexcept {
  const bool right = b.x > a.x;
  const FineSegment segment(a, b);
  const int last = last_cell(b.y);
  std::pair<int, bool> top{floor_cell(a.x), (a.x & kFinePart) == 0};
  for (int y = floor_cell(a.y);; ++y) {
    const std::pair<int, bool> bottom =
        y < last ? segment.at(y + 1) : std::pair{floor_cell(b.x), (b.x & kFinePart) == 0};
    const bool free = right ? row_free(map.row(y), top.first, bottom.first - bottom.second)
                            : row_free(map.row(y), bottom.first, top.first - top.second);
    if (!free) return false;
    if (y == last) return true;
    const int x = bottom.first;
    if (bottom.second && map.blocked(right ? x : x - 1, y) &&
        map.blocked(right ? x - 1 : x, y + 1)) {
      return false;
    }
    top = bottom;
  }
}

// The quadrants around a lattice point, clockwise from the top left, that a direction lies in.
unsigned quadrants_towards(HalfPoint from, HalfPoint to) noexcept {
  const bool left = to.x <= from.x;
  const bool right = to.x >= from.x;
  const bool up = to.y <= from.y;
  const bool down = to.y >= from.y;
  return unsigned{left && up} | unsigned{right && up} << 1 | unsigned{right && down} << 2 |
         unsigned{left && down} << 3;
}

}  // namespace

bool squeezes(const BitmapView& map, HalfPoint a, HalfPoint v, HalfPoint b) noexcept {
  const int x = v.x >> 1;
  const int y = v.y >> 1;
  const unsigned free = unsigned{!map.blocked(x - 1, y - 1)} |
                        unsigned{!map.blocked(x, y - 1)} << 1 | unsigned{!map.blocked(x, y)} << 2 |
                        unsigned{!map.blocked(x - 1, y)} << 3;
  unsigned reached = quadrants_towards(v, a) & free;
  for (int i = 0; i < 3; ++i) {
    reached |= (reached << 1 | reached >> 3 | reached >> 1 | reached << 3) & free;
  }
  return (reached & quadrants_towards(v, b)) == 0;
}

bool sees(const BitmapView& map, HalfPoint a, HalfPoint b) noexcept {
  if (a == b) {
    const int x1 = a.x >> 1;
    const int y1 = a.y >> 1;
    const int x0 = (a.x - 1) >> 1;
    const int y0 = (a.y - 1) >> 1;
    return !(map.blocked(x0, y0) && map.blocked(x1, y0) && map.blocked(x0, y1) &&
             map.blocked(x1, y1));
  }
  if (a.y > b.y) std::swap(a, b);
  if (a.y == b.y) return sees_left_and_right(map, std::min(a.x, b.x), std::max(a.x, b.x), a.y);
  if (a.x == b.x) return sees_up_and_down(map, a.x, a.y, b.y);
  return a.x < b.x ? sees_downwards<true>(map, a, b) : sees_downwards<false>(map, a, b);
}

FinePoint fine(double x, double y) noexcept {
  return {std::llround(x * static_cast<double>(kFineCell)),
          std::llround(y * static_cast<double>(kFineCell))};
}

int turn_sign(FinePoint a, FinePoint b, FinePoint c) noexcept {
  const Wide turn = Wide{b.x - a.x} * (c.y - b.y) - Wide{b.y - a.y} * (c.x - b.x);
  return (turn > 0) - (turn < 0);
}

bool sees_fine(const BitmapView& map, FinePoint a, FinePoint b) noexcept {
  if (a == b) {
    const int x0 = floor_cell(a.x - 1), x1 = floor_cell(a.x);
    const int y0 = floor_cell(a.y - 1), y1 = floor_cell(a.y);
    return !(map.blocked(x0, y0) && map.blocked(x1, y0) && map.blocked(x0, y1) &&
             map.blocked(x1, y1));
  }
  if (a.y > b.y) std::swap(a, b);
  if (a.y == b.y) {
    const int lo = floor_cell(std::min(a.x, b.x)), hi = last_cell(std::max(a.x, b.x));
    const int y = floor_cell(a.y);
    return (a.y & kFinePart) != 0 ? row_free(map.row(y), lo, hi)
                                  : sees_along_row_line(map.row(y - 1), map.row(y), lo, hi);
  }
  if (a.x == b.x) {
    const int lo = floor_cell(a.y), hi = last_cell(b.y);
    const int x = floor_cell(a.x);
    return (a.x & kFinePart) != 0 ? column_free(map, x, lo, hi)
                                  : sees_along_column_line(map, x, lo, hi);
  }
  return sees_fine_downwards(map, a, b);
}

}  // namespace lasius::kernels
