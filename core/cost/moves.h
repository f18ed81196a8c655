// The moves of walks over costs.
#pragma once

namespace lasius::cost {

inline constexpr double kDiagonal = 1.4142135623730951;  ///< the length of a diagonal move
/// Along axes, then diagonally, move i between i - 4 and (i - 3) & 3; then as a knight moves.
inline constexpr int kDx[16] = {1, 0, -1, 0, 1, -1, -1, 1, 2, 2, -2, -2, 1, -1, 1, -1};
inline constexpr int kDy[16] = {0, 1, 0, -1, 1, 1, -1, -1, 1, -1, 1, -1, 2, 2, -2, -2};

}  // namespace lasius::cost
