#include "core/disc/grown_rows.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "core/disc/arc.h"

namespace lasius::disc {

namespace {

// The most columns with columns^2 + rows^2 < limit^2; -1 for none.
int columns_within(double limit, int rows) {
  int columns = -1;
  while (static_cast<double>((columns + 1) * (columns + 1) + rows * rows) < limit * limit)
    ++columns;
  return columns;
}

}  // namespace

Reach::Reach(double radius) {
  const double limit = radius - kMadeSlack;
  for (int rows = 0; columns_within(limit, rows) >= 0; ++rows)
    covered.push_back(columns_within(limit, rows));
  // Cells beside each other have no gap between them.
  touched.push_back(covered[0] + 1);
  for (const int columns : covered) touched.push_back(columns + 1);
}

GrownRows::GrownRows(const Grid& grid, Reach reach, const Words& part)
    : grid_(grid),
      reach_(std::move(reach)),
      part_(part),
      words_(part.last - part.first),
      touched_(static_cast<std::size_t>(words_) * (part.bottom - part.top)),
      covered_(touched_.size()),
      row_(static_cast<std::size_t>(words_) + 2),
      wider_(row_.size()) {}

bool GrownRows::grow(Poller& poller) {
  const int reach = static_cast<int>(reach_.touched.size()) - 1;
  const int last = std::min(grid_.height(), part_.bottom - 1 + reach);
  for (int y = std::max(-1, part_.top - reach); y <= last; ++y) {
    spread(y);
    if (poller.stop_after(std::int64_t{4} * words_ * (reach_.touched[0] + 1))) return false;
  }
  return true;
}

// What one row of the map, or the outside above or below it, touches and covers. Cells reach less
// than a word: those beyond the words on each side do not matter.
void GrownRows::spread(int y) {
  std::copy_n(grid_.row(y) + part_.first - 1, words_ + 2, row_.data());
  for (int width = 0;; ++width) {
    add(reach_.touched, width, y, touched_);
    add(reach_.covered, width, y, covered_);
    if (width == reach_.touched[0]) return;
    const auto beside = [](std::uint64_t bits) { return bits | bits << 1 | bits >> 1; };
    for (int i = 1; i <= words_; ++i)
      wider_[i] = beside(row_[i]) | row_[i - 1] >> 63 | row_[i + 1] << 63;
    wider_[0] = beside(row_[0]) | row_[1] << 63;
    wider_[words_ + 1] = beside(row_[words_ + 1]) | row_[words_] >> 63;
    row_.swap(wider_);
  }
}

void GrownRows::add(const std::vector<int>& columns, int width, int y, Rows& rows) const {
  const int reach = static_cast<int>(columns.size()) - 1;
  const int last = std::min(part_.bottom - 1, y + reach);
  for (int other = std::max(part_.top, y - reach); other <= last; ++other) {
    if (columns[std::abs(other - y)] != width) continue;
    std::uint64_t* target = rows.data() + at(part_.first, other);
    for (int i = 0; i < words_; ++i) target[i] |= row_[i + 1];
  }
}

}  // namespace lasius::disc
