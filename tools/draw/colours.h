// The colours that mean the same in every picture.
#pragma once

#include "tools/draw/raster.h"

namespace lasius::tool {

inline constexpr Colour kInk{0.15, 0.17, 0.2};  ///< text and frames
inline constexpr Colour kGrid{0.88, 0.89, 0.91};
inline constexpr Colour kFree{1, 1, 1};
inline constexpr Colour kWall{0.58, 0.605, 0.64};        ///< blocked cells
inline constexpr Colour kGrown{0.83, 0.84, 0.856};       ///< blocked for a robot with a radius
inline constexpr Colour kUnknownCell{0.86, 0.79, 0.66};  ///< that a ROS map does not know
inline constexpr Colour kPaleWall{0.72, 0.74, 0.77};     ///< where other things matter more
inline constexpr Colour kPath{0.85, 0.12, 0.12};
inline constexpr Colour kOtherPath{0.93, 0.58, 0.55};
inline constexpr Colour kStart{0.1, 0.6, 0.25};
inline constexpr Colour kGoal{0.9, 0.45, 0.05};

}  // namespace lasius::tool
