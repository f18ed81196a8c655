#include "lasius/clearance.h"

#include <algorithm>
#include <cmath>

#include "core/base/poller.h"

namespace lasius {
namespace {

// A cell's centre has odd coordinates in half cells, edges of cells have even ones. Straight up or
// down, a centre is 2k - 1 half cells from the edge of the blocked cell k rows away.
std::int32_t edge_distance(std::int32_t rows) noexcept { return std::max(0, 2 * rows - 1); }

// Half cells from every centre straight up or down to a blocked cell or the outside, row by row;
// false when stopped. `field` is empty before, with room for all of them.
bool measure_columns(const Grid& grid, std::vector<std::int32_t>& field, Poller& poller) {
  const int width = grid.width();
  std::vector<std::int32_t> rows(width, 0);  // to the nearest blocked cell met so far
  const auto sweep = [&](int y, auto&& put) {
    const std::uint64_t* words = grid.row(y);
    std::int32_t* target = field.data() + std::ptrdiff_t{y} * width;
    for (int x = 0; x < width; ++x) {
      rows[x] = (words[x >> 6] >> (x & 63) & 1) != 0 ? 0 : rows[x] + 1;
      put(target[x], edge_distance(rows[x]));
    }
  };
  for (int y = 0; y < grid.height(); ++y) {
    field.resize(field.size() + static_cast<std::size_t>(width));
    sweep(y, [](std::int32_t& to, std::int32_t from) { to = from; });
    if (poller.stop_after(width)) return false;
  }
  std::ranges::fill(rows, 0);
  for (int y = grid.height() - 1; y >= 0; --y) {
    sweep(y, [](std::int32_t& to, std::int32_t from) { to = std::min(to, from); });
    if (poller.stop_after(width)) return false;
  }
  return true;
}

// Turns one row of column distances into squared distances. The nearest point outside a centre's
// own column lies on the edge of a column, at an even abscissa 2i, and the distance to it is a
// parabola about 2i: (2x + 1 - 2i)^2 + h(i)^2, with h(i) the lesser distance of the columns that
// meet there. Column -1 and column `width` are blocked.
class RowTransform {
 public:
  explicit RowTransform(int width)
      : width_(width), height_(width + 1), edge_(width + 1), start_(width + 1) {}

  void apply(std::int32_t* row) {
    for (int i = 0; i <= width_; ++i) {
      const std::int64_t h = std::min(i > 0 ? row[i - 1] : 0, i < width_ ? row[i] : 0);
      height_[i] = h * h;
    }
    build_envelope();
    for (int x = 0, k = 0; x < width_; ++x) {
      while (k < last_ && start_[k + 1] <= x) ++k;
      const std::int64_t own = std::int64_t{row[x]} * row[x];
      row[x] = static_cast<std::int32_t>(std::min(own, value(edge_[k], x)));
    }
  }

 private:
  std::int64_t value(int i, int x) const noexcept {
    const std::int64_t d = 2 * (std::int64_t{x} - i) + 1;
    return d * d + height_[i];
  }
  // The first x at which the parabola of j > i is at most that of i.
  int crossing(std::int64_t i, std::int64_t j) const noexcept {
    const std::int64_t n = 4 * (j * j - i * i) + height_[j] - height_[i] - 4 * (j - i);
    const std::int64_t d = 8 * (j - i);
    const std::int64_t up = n > 0 ? (n + d - 1) / d : -(-n / d);
    return static_cast<int>(std::clamp<std::int64_t>(up, 0, width_));
  }
  void build_envelope() {
    last_ = -1;
    for (int j = 0; j <= width_; ++j) {
      while (last_ >= 0 && value(j, start_[last_]) <= value(edge_[last_], start_[last_])) --last_;
      const int from = last_ < 0 ? 0 : crossing(edge_[last_], j);
      if (from >= width_) continue;
      ++last_;
      edge_[last_] = j;
      start_[last_] = from;
    }
  }

  int width_;
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
  std::optional field = ClearanceField{grid.width(), grid.height(), {}};
  auto& values = field->squared_half_cells;
  values.reserve(static_cast<std::size_t>(grid.width()) * grid.height());
  Poller poller(stop, Poller::kWords - grid.width());  // one row more is not too much
  if (!measure_columns(grid, values, poller)) return std::nullopt;
  RowTransform transform(grid.width());
  for (int y = 0; y < grid.height(); ++y) {
    transform.apply(values.data() + std::ptrdiff_t{y} * grid.width());
    if (poller.stop_after(grid.width())) return std::nullopt;
  }
  return field;
}

}  // namespace lasius
