#include "core/grid/clearance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lasius {
namespace {

/// More rows than any map has: what lies outside is not blocked.
constexpr std::int32_t kFar = 3 * Grid::kMaxSide;

// A cell's centre has odd coordinates in half cells, edges of cells have even ones. Straight up or
// down, a centre is 2k - 1 half cells from the edge of the blocked cell k rows away, and a whole
// cell 2k - 2.
std::int32_t edge_distance(std::int32_t rows, ClearanceOf of) noexcept {
  if (of == ClearanceOf::blocked_centres) return 2 * rows;
  return std::max(0, 2 * rows - (of == ClearanceOf::centres ? 1 : 2));
}

// Half cells from every cell straight up or down to a blocked cell or the outside, row by row;
// false when stopped. `field` is empty before, with room for all of them.
bool measure_columns(const Grid& grid, ClearanceOf of, std::vector<std::int32_t>& field,
                     Poller& poller) {
  const int width = grid.width();
  const std::int32_t outside = of == ClearanceOf::blocked_centres ? kFar : 0;
  std::vector<std::int32_t> rows(width, outside);  // to the nearest blocked cell met so far
  const auto sweep = [&](int y, auto&& put) {
    const std::uint64_t* words = grid.row(y);
    std::int32_t* target = field.data() + std::ptrdiff_t{y} * width;
    for (int x = 0; x < width; ++x) {
      rows[x] = (words[x >> 6] >> (x & 63) & 1) != 0 ? 0 : rows[x] + 1;
      put(target[x], edge_distance(rows[x], of));
    }
  };
  for (int y = 0; y < grid.height(); ++y) {
    field.resize(field.size() + static_cast<std::size_t>(width));
    sweep(y, [](std::int32_t& to, std::int32_t from) { to = from; });
    if (poller.stop_after(width)) return false;
  }
  std::ranges::fill(rows, outside);
  for (int y = grid.height() - 1; y >= 0; --y) {
    sweep(y, [](std::int32_t& to, std::int32_t from) { to = std::min(to, from); });
    if (poller.stop_after(width)) return false;
  }
  return true;
}

// Turns one row of column distances into squared distances. The nearest point outside a centre's
// own column lies on the edge of a column, at an even abscissa 2i, and the distance to it is a
// parabola about 2i: (2x + 1 - 2i)^2 + h(i)^2, with h(i) the lesser distance of the columns that
// meet there. From whole cells, column i counts in the columns beside it, too, and the parabolas
// are about centres: (2x - 2i)^2 + h(i)^2, h(i) the least of three; to blocked centres h(i) is the
// column's own. Column -1 and column `width` are blocked, but as centres not.
class RowTransform {
 public:
  RowTransform(int width, ClearanceOf of)
      : width_(width),
        of_(of),
        shift_(of == ClearanceOf::centres ? 1 : 0),
        height_(width + shift_),
        edge_(width + shift_),
        start_(width + shift_) {}

  void apply(std::int32_t* row) {
    const auto in = [&](int i) { return i >= 0 && i < width_ ? row[i] : 0; };
    for (int i = 0; i < width_ + shift_; ++i) {
      std::int64_t h = std::min(in(i - 1), in(i));
      if (of_ == ClearanceOf::blocked_centres) h = row[i];
      if (of_ == ClearanceOf::cells) h = std::min<std::int64_t>(h, in(i + 1));
      height_[i] = h * h;
    }
    build_envelope();
    for (int x = 0, k = 0; x < width_; ++x) {
      while (k < last_ && start_[k + 1] <= x) ++k;
      const std::int64_t own = std::int64_t{row[x]} * row[x];
      const std::int64_t most = std::numeric_limits<std::int32_t>::max();
      row[x] = static_cast<std::int32_t>(std::min({own, value(edge_[k], x), most}));
    }
  }

 private:
  std::int64_t value(int i, int x) const noexcept {
    const std::int64_t d = 2 * (std::int64_t{x} - i) + shift_;
    return d * d + height_[i];
  }
  // The first x at which the parabola of j > i is at most that of i.
  int crossing(std::int64_t i, std::int64_t j) const noexcept {
    const std::int64_t n = 4 * (j * j - i * i) + height_[j] - height_[i] - (j - i) * 4 * shift_;
    const std::int64_t d = 8 * (j - i);
    const std::int64_t up = n > 0 ? (n + d - 1) / d : -(-n / d);
    return static_cast<int>(std::clamp<std::int64_t>(up, 0, width_));
  }
  void build_envelope() {
    last_ = -1;
    for (int j = 0; j < width_ + shift_; ++j) {
      while (last_ >= 0 && value(j, start_[last_]) <= value(edge_[last_], start_[last_])) --last_;
      const int from = last_ < 0 ? 0 : crossing(edge_[last_], j);
      if (from >= width_) continue;
      ++last_;
      edge_[last_] = j;
      start_[last_] = from;
    }
  }

  int width_;
  ClearanceOf of_;
  int shift_;                         // of a parabola's place, in half cells
  std::vector<std::int64_t> height_;  // h(i)^2
  std::vector<int> edge_;             // of the envelope's parabolas, from left to right
  std::vector<int> start_;            // the first x of each
  int last_ = -1;
};

}  // namespace

double ClearanceField::at(Cell c) const noexcept {
  const auto squared = squared_half_cells[static_cast<std::size_t>(c.y) * width + c.x];
  return std::sqrt(static_cast<double>(squared)) / 2;
}

ClearanceField clearance(const Grid& grid) { return *clearance(grid, {}); }

std::optional<ClearanceField> clearance(const Grid& grid, const StopCondition& stop) {
  Poller poller(stop, Poller::kWords - grid.width());  // one row more is not too much
  return clearance(grid, ClearanceOf::centres, poller);
}

std::optional<ClearanceField> clearance(const Grid& grid, ClearanceOf of, Poller& poller) {
  std::optional field = ClearanceField{grid.width(), grid.height(), {}};
  auto& values = field->squared_half_cells;
  values.reserve(static_cast<std::size_t>(grid.width()) * grid.height());
  if (!measure_columns(grid, of, values, poller)) return std::nullopt;
  RowTransform transform(grid.width(), of);
  for (int y = 0; y < grid.height(); ++y) {
    transform.apply(values.data() + std::ptrdiff_t{y} * grid.width());
    if (poller.stop_after(grid.width())) return std::nullopt;
  }
  return field;
}

}  // namespace lasius
