// Vectors, rotations and placements of three-dimensional space, computed in a fixed order: what
// decides a plan is the same on every machine and with every version of Eigen, whose types are for
// the border only.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "kernels/base/sine.h"
#include "lasius/arm/robot.h"

namespace lasius::arm {

/// Coordinates read from files lie within this, metres.
inline constexpr double kFar = 1000;

/// Converts to and from Eigen's vectors, without arithmetic.
struct Vec3 {
  double x = 0, y = 0, z = 0;

  constexpr Vec3() = default;
  constexpr Vec3(double x_, double y_, double z_) : x(x_), y(y_), z(z_) {}
  Vec3(const Eigen::Vector3d& v) : x(v[0]), y(v[1]), z(v[2]) {}
  operator Eigen::Vector3d() const { return {x, y, z}; }
  friend bool operator==(const Vec3&, const Vec3&) = default;
};

/// A rotation matrix, row by row.
using Rotation = std::array<double, 9>;
inline constexpr Rotation kNoRotation{1, 0, 0, 0, 1, 0, 0, 0, 1};

/// The values behind a reference, valid as long as they are.
inline std::span<const double> as_span(const JointRef& q) noexcept {
  return {q.data(), static_cast<std::size_t>(q.size())};
}

inline Vec3 operator+(Vec3 a, Vec3 b) noexcept { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(Vec3 a, Vec3 b) noexcept { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator*(double s, Vec3 a) noexcept { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(Vec3 a, Vec3 b) noexcept { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(Vec3 a, Vec3 b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double square(Vec3 a) noexcept { return dot(a, a); }
inline double length(Vec3 a) noexcept { return std::sqrt(square(a)); }
inline double distance(Vec3 a, Vec3 b) noexcept { return length(a - b); }
/// To the nearest whole numbers.
inline std::array<int, 3> rounded(Vec3 a) noexcept {
  return {static_cast<int>(std::lround(a.x)), static_cast<int>(std::lround(a.y)),
          static_cast<int>(std::lround(a.z))};
}

[[gnu::always_inline]] inline Vec3 operator*(const Rotation& r, Vec3 a) noexcept {
  return {r[0] * a.x + r[1] * a.y + r[2] * a.z, r[3] * a.x + r[4] * a.y + r[5] * a.z,
          r[6] * a.x + r[7] * a.y + r[8] * a.z};
}
/// The inverse rotation applied.
[[gnu::always_inline]] inline Vec3 rotate_back(const Rotation& r, Vec3 a) noexcept {
  return {r[0] * a.x + r[3] * a.y + r[6] * a.z, r[1] * a.x + r[4] * a.y + r[7] * a.z,
          r[2] * a.x + r[5] * a.y + r[8] * a.z};
}
inline Rotation operator*(const Rotation& a, const Rotation& b) noexcept {
  Rotation c;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      c[3 * i + j] = a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j];
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
struct Placement {
  Rotation rotation = kNoRotation;
  Vec3 position;
};
[[gnu::always_inline]] inline Vec3 operator*(const Placement& placement, Vec3 a) noexcept {
  return placement.rotation * a + placement.position;
}
inline Placement operator*(const Placement& a, const Placement& b) noexcept {
  return {a.rotation * b.rotation, a * b.position};
}

inline Placement inverse(const Placement& p) noexcept {
  const Rotation& r = p.rotation;
  return {{r[0], r[3], r[6], r[1], r[4], r[7], r[2], r[5], r[8]},
          rotate_back(r, -1.0 * p.position)};
}

/// A placement as the public type, and back, without arithmetic.
inline Pose to_eigen(const Placement& placement) {
  Pose pose = Pose::Identity();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) pose(i, j) = placement.rotation[3 * i + j];
  }
  pose.translation() = Eigen::Vector3d(placement.position);
  return pose;
}
inline Placement from_eigen(const Pose& pose) {
  Placement placement{.position = {pose(0, 3), pose(1, 3), pose(2, 3)}};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) placement.rotation[3 * i + j] = pose(i, j);
  }
  return placement;
}

}  // namespace lasius::arm
