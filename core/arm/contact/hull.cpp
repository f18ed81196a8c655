#include "core/arm/contact/hull.h"

#include <limits>

#include "core/arm/contact/gjk.h"

namespace lasius::arm {
namespace {

constexpr std::size_t kMostCorners = 128;

Vec3 as_floats(Vec3 p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

std::size_t furthest_of(std::span<const Vec3> points, Vec3 direction) {
  std::size_t best = 0;
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double along = dot(points[i], direction);
    if (along > most) most = along, best = i;
  }
  return best;
}

/// The way from the hull's nearest point to `p`, as far as it takes to tell it from `near`.
Vec3 way_out(std::span<const Vec3> corners, Vec3 p, double near) {
  GjkSimplex simplex;
  Vec3 to = p - corners[0];
  double size = length(to);
  constexpr int kMostSteps = 30;
  for (int i = 0; i < kMostSteps && size > near; ++i) {
    const Vec3 next = p - corners[furthest_of(corners, to)];
    if (size - dot(next, to) / size <= 1e-3 * size) break;
    bool known = false;
    for (int k = 0; k < simplex.count; ++k) known = known || simplex.point[k] == next;
    if (known) break;
    simplex.point[simplex.count++] = next;
    const Vec3 nearer = nearest_point(simplex);
    const double smaller = length(nearer);
    if (i > 0 && !(smaller < size)) break;
    to = nearer;
    size = smaller;
    if (simplex.count == 4) break;
  }
  return to;
}

}  // namespace

Hull::Hull(std::span<const Vec3> points, double wanted) {
  std::vector<Vec3> corners;
  const auto add = [&](Vec3 p) {
    p = as_floats(p);
    if (std::ranges::find(corners, p) != corners.end()) return false;
    corners.push_back(p);
    return true;
  };
  if (points.size() <= 12) {
    for (const Vec3 p : points) add(p);
  } else {
    constexpr double kDiagonal = 0.577;
    for (const Vec3 d :
         {Vec3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {kDiagonal, kDiagonal, kDiagonal},
          {kDiagonal, kDiagonal, -kDiagonal}, {kDiagonal, -kDiagonal, kDiagonal},
          {-kDiagonal, kDiagonal, kDiagonal}}) {
      add(points[furthest_of(points, d)]);
      add(points[furthest_of(points, -1.0 * d)]);
    }
  }
  for (const Vec3 p : points) {
    for (;;) {
      const Vec3 out = way_out(corners, p, wanted);
      const double left = length(out);
      // The point reached is one of the hull: its distance is one that holds.
      if (left > wanted && corners.size() < kMostCorners &&
          add(points[furthest_of(points, out)]))
        continue;
      margin_ = std::max(margin_, left);
      break;
    }
  }
  const std::size_t filled = (corners.size() + 3) / 4 * 4;
  corners.resize(filled, corners.back());
  count_ = static_cast<int>(filled);
  floats_.reserve(3 * filled);
  double far = 0;
  for (const Vec3 c : corners) far = std::max(far, length(c));
  for (const Vec3 c : corners) floats_.push_back(static_cast<float>(c.x));
  for (const Vec3 c : corners) floats_.push_back(static_cast<float>(c.y));
  for (const Vec3 c : corners) floats_.push_back(static_cast<float>(c.z));
  margin_ += kFloat * far;
}

int Hull::furthest(Vec3 direction) const noexcept {
  const auto dx = static_cast<float>(direction.x), dy = static_cast<float>(direction.y),
             dz = static_cast<float>(direction.z);
  const float* const x = floats_.data();
  const float* const y = x + count_;
  const float* const z = y + count_;
  // Four at a time: compilers make vectors of it.
  std::array<float, 4> most;
  std::array<int, 4> best{0, 1, 2, 3};
  for (int l = 0; l < 4; ++l) most[l] = dx * x[l] + dy * y[l] + dz * z[l];
  for (int i = 4; i < count_; i += 4) {
    for (int l = 0; l < 4; ++l) {
      const float along = dx * x[i + l] + dy * y[i + l] + dz * z[i + l];
      best[l] = along > most[l] ? i + l : best[l];
      most[l] = along > most[l] ? along : most[l];
    }
  }
  int lane = 0;
  for (int l = 1; l < 4; ++l)
    if (most[l] > most[lane]) lane = l;
  return best[lane];
}

Hull::Furthest Hull::furthest(Vec3 first, double first_start, Vec3 second,
                              double second_start) const noexcept {
  const auto ax = static_cast<float>(first.x), ay = static_cast<float>(first.y),
             az = static_cast<float>(first.z), bx = static_cast<float>(second.x),
             by = static_cast<float>(second.y), bz = static_cast<float>(second.z);
  const float* const x = floats_.data();
  const float* const y = x + count_;
  const float* const z = y + count_;
  std::array<float, 4> most, other;
  std::array<int, 4> best{0, 1, 2, 3}, others{0, 1, 2, 3};
  for (int l = 0; l < 4; ++l) {
    most[l] = ax * x[l] + ay * y[l] + az * z[l];
    other[l] = bx * x[l] + by * y[l] + bz * z[l];
  }
  for (int i = 4; i < count_; i += 4) {
    for (int l = 0; l < 4; ++l) {
      const float along = ax * x[i + l] + ay * y[i + l] + az * z[i + l];
      best[l] = along > most[l] ? i + l : best[l];
      most[l] = along > most[l] ? along : most[l];
      const float across = bx * x[i + l] + by * y[i + l] + bz * z[i + l];
      others[l] = across > other[l] ? i + l : others[l];
      other[l] = across > other[l] ? across : other[l];
    }
  }
  int lane = 0, lane_other = 0;
  for (int l = 1; l < 4; ++l) {
    if (most[l] > most[lane]) lane = l;
    if (other[l] > other[lane_other]) lane_other = l;
  }
  if (first_start + most[lane] >= second_start + other[lane_other]) return {best[lane], false};
  return {others[lane_other], true};
}

}  // namespace lasius::arm
