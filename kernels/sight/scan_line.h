// Corners along one grid line.
#pragma once

#include "kernels/sight/scan_bits.h"

namespace lasius::kernels {

/// Corners on grid line y that a path sliding along it from the lattice point `root` towards larger
/// u may turn at: around a block that lies behind it on one side, nothing else being blocked there.
/// The line ends where no free cell touches it any more or where it would squeeze between two
/// diagonal blocks; it is not followed further than a window past column limit(), which is asked
/// after the first window. report(u, above) for each, in order. Returns true if it went on past the
/// limit.
template <int S, class Limit, class Report>
bool scan_line(const BitmapView& map, int y, int root, Limit&& limit, Report&& report) {
  using B = Bits<S>;
  const char* above = bytes_of(map.row(y - 1));
  const char* below = bytes_of(map.row(y));
  std::uint64_t wanted = B::from(2);  // not the root itself
  for (int base = root - 1; base < root || base < limit(); base += B::kValid - 1) {
    const std::uint64_t a = B::window(above, base);
    const std::uint64_t b = B::window(below, base);
    const std::uint64_t a1 = B::previous(a);
    const std::uint64_t b1 = B::previous(b);
    const std::uint64_t valid = B::from(1) & B::to(B::kValid - 1);
    const std::uint64_t stop = ((a & b) | (a1 & b) | (a & b1)) & valid;
    std::uint64_t found = ~(a | b) & (a1 ^ b1) & valid & wanted;
    if (stop != 0) found &= B::to(B::first(stop));
    for (; found != 0; found &= ~B::only(B::first(found))) {
      const int i = B::first(found);
      report(base + i, (a1 & B::only(i)) != 0);
    }
    if (stop != 0) return false;
    wanted = B::from(1);
  }
  return true;
}

}  // namespace lasius::kernels
