#include "core/disc/grown_rows.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/disc/arc.h"

namespace lasius::disc {

namespace {

constexpr std::uint64_t kAll = ~std::uint64_t{0};

// The most columns with columns^2 + rows^2 < limit^2; -1 for none.
int columns_within(double limit, int rows) {
  int columns = -1;
  while (static_cast<double>((columns + 1) * (columns + 1) + rows * rows) < limit * limit) {
    ++columns;
  }
  return columns;
}

}  // namespace

Reach::Reach(double radius) {
  const double limit = radius - kMadeSlack;
  for (int rows = 0; columns_within(limit, rows) >= 0; ++rows) {
    covered.push_back(columns_within(limit, rows));
  }
  // Cells beside each other have no gap between them.
  touched.push_back(covered[0] + 1);
  for (const int columns : covered) touched.push_back(columns + 1);
}

GrownRows::GrownRows(const Grid& grid, const Reach& reach)
    : grid_(grid),
      reach_(reach),
      touched_(static_cast<std::size_t>(grid.words()) * grid.height()),
      covered_(touched_.size()),
      row_(static_cast<std::size_t>(grid.words()) + 2),
      wider_(row_.size(), kAll) {}

bool GrownRows::grow(Poller& poller) {
  for (int y = -1; y <= grid_.height(); ++y) {
    spread(y);
    if (poller.stop_after(std::int64_t{4} * grid_.words() * (reach_.touched[0] + 1))) return false;
  }
  return true;
}

// What one row of the map, or the outside above or below it, touches and covers.
void GrownRows::spread(int y) {
  const int words = grid_.words();
  std::copy_n(grid_.row(y) - 1, words + 2, row_.data());
  for (int width = 0;; ++width) {
    add(reach_.touched, width, y, touched_);
    add(reach_.covered, width, y, covered_);
    if (width == reach_.touched[0]) return;
    for (int i = 1; i <= words; ++i) {
      wider_[i] = row_[i] | row_[i] << 1 | row_[i] >> 1 | row_[i - 1] >> 63 | row_[i + 1] << 63;
    }
    wider_[0] = wider_[words + 1] = kAll;
    row_.swap(wider_);
  }
}

void GrownRows::add(const std::vector<int>& columns, int width, int y, Words& rows) const {
  const int reach = static_cast<int>(columns.size()) - 1;
  const int words = grid_.words();
  const int last = std::min(grid_.height() - 1, y + reach);
  for (int other = std::max(0, y - reach); other <= last; ++other) {
    if (columns[std::abs(other - y)] != width) continue;
    std::uint64_t* target = rows.data() + at(other);
    for (int i = 0; i < words; ++i) target[i] |= row_[i + 1];
  }
}

}  // namespace lasius::disc
