#include "kernels/sight/sight_cone.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

namespace lasius::kernels {
namespace {

// a is a smaller slope than b; dy > 0. Below 2^35.
bool less(std::int64_t a_dx, std::int64_t a_dy, std::int64_t b_dx, std::int64_t b_dy) noexcept {
  return a_dx * b_dy < b_dx * a_dy;
}

}  // namespace

void SightCone::start(const BitmapView& map, int x, int y, int lo, int hi) {
  map_ = &map;
  x_ = x;
  y_ = y;
  lo_ = lo;
  hi_ = hi;
  if (rows_.empty()) rows_.resize(64);
  rows_[0] = {run_at(x, y), {-1, 0}, {1, 0}};  // every slope is between these
  depth_ = 0;
}

SightCone::Run SightCone::run_at(int x, int y) noexcept {
  const std::uint64_t* row = map_->row(y);
  Run run{lo_, hi_};
  ++work_;
  int word = x >> 6;
  // Blocked bits at the columns up to x, then from x on.
  std::uint64_t bits = row[word] & (~std::uint64_t{0} >> (63 - (x & 63)));
  while (bits == 0 && word * 64 > lo_) {
    bits = row[--word];
    ++work_;
  }
  if (bits != 0) run.lo = std::max(lo_, word * 64 + 64 - std::countl_zero(bits));
  word = x >> 6;
  bits = row[word] & (~std::uint64_t{0} << (x & 63));
  while (bits == 0 && word * 64 + 63 < hi_) {
    bits = row[++word];
    ++work_;
  }
  if (bits != 0) run.hi = std::min(hi_, word * 64 + std::countr_zero(bits) - 1);
  return run;
}

// Enters row k, that of y, for the first time or anew, at column x.
bool SightCone::open_row(int x, int y, std::size_t k) {
  const Row& before = rows_[k - 1];
  const Run run = run_at(x, y);
  const int lo = std::max(before.run.lo, run.lo);
  const int hi = std::min(before.run.hi, run.hi);
  if (lo > hi) return false;  // they meet in a point at most: a squeeze
  const auto dy = static_cast<std::int32_t>(2 * k - 1);
  const Slope left{2 * (lo - x_) - 1, dy};
  const Slope right{2 * (hi - x_) + 1, dy};
  Row row{run, before.left, before.right};
  if (less(row.left.dx, row.left.dy, left.dx, left.dy)) row.left = left;
  if (less(right.dx, right.dy, row.right.dx, row.right.dy)) row.right = right;
  if (k == rows_.size()) rows_.resize(2 * k);
  rows_[k] = row;
  depth_ = k;
  return true;
}

bool SightCone::sees_next(int x, int y) {
  ++work_;
  const int dy = std::abs(y - y_);
  const auto k = static_cast<std::size_t>(dy);
  if (k > depth_) {
    if (!open_row(x, y, k)) return false;
  } else {
    depth_ = k;
  }
  const Row& row = rows_[k];
  if (x < row.run.lo || x > row.run.hi) return false;
  if (k == 0) return true;
  const int dx = x - x_;
  return !less(dx, dy, row.left.dx, row.left.dy) && !less(row.right.dx, row.right.dy, dx, dy);
}

}  // namespace lasius::kernels
