// Few points whose convex hull, grown by a margin, holds many.
#pragma once

#include <span>
#include <vector>

#include "core/arm/robot/vec3.h"

namespace lasius::arm {

/// Points, as floats side by side: all x, all y, all z, each a multiple of four by repetition of
/// the last.
class Hull {
 public:
  Hull() = default;
  /// No point of `points` is further than margin() from the hull, which is about `wanted`, metres,
  /// where so many corners as there may be are enough. Precondition: there are some.
  Hull(std::span<const Vec3> points, double wanted);

  int count() const noexcept { return count_; }
  double margin() const noexcept { return margin_; }

  /// Which of its points is furthest along the direction; in float, so within
  /// kFloat |direction| of the largest distance of a point from the origin.
  int furthest(Vec3 direction) const noexcept;
  /// The furthest along two directions, where each has its start.
  struct Furthest {
    int index;
    bool second;
  };
  Furthest furthest(Vec3 first, double first_start, Vec3 second,
                    double second_start) const noexcept;
  Vec3 at(int index) const noexcept {
    return {floats_[index], floats_[index + count_], floats_[index + 2 * count_]};
  }
  static constexpr double kFloat = 6e-7;

 private:
  std::vector<float> floats_;
  int count_ = 0;  // padded
  double margin_ = 0;
};

}  // namespace lasius::arm
