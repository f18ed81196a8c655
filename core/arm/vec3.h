// Vectors, rotations and poses of three-dimensional space.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "kernels/base/sine.h"
#include "lasius/arm.h"

namespace lasius::arm {

/// Coordinates read from files lie within this, metres.
inline constexpr double kFar = 1000;

inline Vec3 operator+(Vec3 a, Vec3 b) noexcept { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(Vec3 a, Vec3 b) noexcept { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator*(double s, Vec3 a) noexcept { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(Vec3 a, Vec3 b) noexcept { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(Vec3 a, Vec3 b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Vec3 a) noexcept { return std::sqrt(dot(a, a)); }
inline double distance(Vec3 a, Vec3 b) noexcept { return length(a - b); }

inline Vec3 operator*(const Rotation& r, Vec3 a) noexcept {
  return {r[0] * a.x + r[1] * a.y + r[2] * a.z, r[3] * a.x + r[4] * a.y + r[5] * a.z,
          r[6] * a.x + r[7] * a.y + r[8] * a.z};
}
/// The inverse rotation applied.
inline Vec3 rotate_back(const Rotation& r, Vec3 a) noexcept {
  return {r[0] * a.x + r[3] * a.y + r[6] * a.z, r[1] * a.x + r[4] * a.y + r[7] * a.z,
          r[2] * a.x + r[5] * a.y + r[8] * a.z};
}
inline Rotation operator*(const Rotation& a, const Rotation& b) noexcept {
  Rotation c;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      c[3 * i + j] = a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j];
    }
  }
  return c;
}

/// Turns by `angle` about the unit vector `axis` (Rodrigues).
inline Rotation rotation_about(Vec3 axis, double angle) noexcept {
  const auto [s, c] = kernels::sine_cosine(angle);
  const double v = 1 - c;
  return {c + v * axis.x * axis.x,          v * axis.x * axis.y - s * axis.z,
          v * axis.x * axis.z + s * axis.y, v * axis.x * axis.y + s * axis.z,
          c + v * axis.y * axis.y,          v * axis.y * axis.z - s * axis.x,
          v * axis.x * axis.z - s * axis.y, v * axis.y * axis.z + s * axis.x,
          c + v * axis.z * axis.z};
}

/// Roll about x, then pitch about y, then yaw about z, all fixed axes, as in URDF.
inline Rotation roll_pitch_yaw(Vec3 rpy) noexcept {
  return rotation_about({0, 0, 1}, rpy.z) * rotation_about({0, 1, 0}, rpy.y) *
         rotation_about({1, 0, 0}, rpy.x);
}

/// Where a frame is in another one.
struct Pose {
  Rotation rotation = kNoRotation;
  Vec3 position;
};
inline Vec3 operator*(const Pose& pose, Vec3 a) noexcept {
  return pose.rotation * a + pose.position;
}
inline Pose operator*(const Pose& a, const Pose& b) noexcept {
  return {a.rotation * b.rotation, a * b.position};
}

}  // namespace lasius::arm
