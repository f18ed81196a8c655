// The blocked cells inside a triangle, as a chain of corners that a taut path bends round.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/poller.h"
#include "kernels/sight/sight.h"
#include "kernels/sight/views.h"

namespace lasius {

/// Of coordinates: how many bits a cell has, and what holds products of two.
template <class P>
struct PointScale;
template <>
struct PointScale<kernels::HalfPoint> {
  using Number = int;
  using Wide = std::int64_t;
  static constexpr int kBits = 1;
};
template <>
struct PointScale<kernels::FinePoint> {
  using Number = std::int64_t;
  __extension__ using Wide = __int128;
  static constexpr int kBits = 44;
};

// The next three: P is HalfPoint or FinePoint.

/// Twice the signed area of abc: positive for a turn to the right (y grows downwards).
template <class P>
typename PointScale<P>::Wide turn(P a, P b, P c) noexcept {
  using Wide = typename PointScale<P>::Wide;
  return Wide{b.x - a.x} * (c.y - b.y) - Wide{b.y - a.y} * (c.x - b.x);
}

/// True when a blocked cell at b reaches into the angle abc, so that the path cannot be shortened
/// at b. Both segments must be valid.
template <class P>
bool bends_round_block(const kernels::BitmapView& map, P a, P b, P c) noexcept;

/// The inner vertices of the shortest way from a to c that can be reached from a - b - c without
/// passing over a blocked cell: the convex chain, on b's side, of the corners of blocked cells
/// inside the triangle. Both segments must be valid, b no taut vertex, and a, b, c not in line.
/// `corners` is scratch. False when told to stop before the chain is known.
template <class P>
bool chain_in_triangle(const kernels::BitmapView& map, P a, P b, P c, Poller& poller,
                       std::vector<P>& corners, std::vector<P>& chain);

}  // namespace lasius
