// The blocked cells inside a triangle, as a chain of corners that a taut path bends round.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/poller.h"
#include "kernels/sight/sight.h"
#include "kernels/sight/views.h"

namespace lasius {

/// Twice the signed area of abc: positive for a turn to the right (y grows downwards).
inline std::int64_t turn(kernels::HalfPoint a, kernels::HalfPoint b,
                         kernels::HalfPoint c) noexcept {
  return static_cast<std::int64_t>(b.x - a.x) * (c.y - b.y) -
         static_cast<std::int64_t>(b.y - a.y) * (c.x - b.x);
}

/// True when a blocked cell at b reaches into the angle abc, so that the path cannot be shortened
/// at b. Both segments must be valid.
bool bends_round_block(const kernels::BitmapView& map, kernels::HalfPoint a, kernels::HalfPoint b,
                       kernels::HalfPoint c) noexcept;

/// The inner vertices of the shortest way from a to c that can be reached from a - b - c without
/// passing over a blocked cell: the convex chain, on b's side, of the corners of blocked cells
/// inside the triangle. Both segments must be valid, b no taut vertex, and a, b, c not in line.
/// `corners` is scratch. False when told to stop before the chain is known.
bool chain_in_triangle(const kernels::BitmapView& map, kernels::HalfPoint a, kernels::HalfPoint b,
                       kernels::HalfPoint c, Poller& poller,
                       std::vector<kernels::HalfPoint>& corners,
                       std::vector<kernels::HalfPoint>& chain);

}  // namespace lasius
