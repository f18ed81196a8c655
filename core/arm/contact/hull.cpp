#include "core/arm/contact/hull.h"

#include <cstring>
#include <limits>
#include <utility>

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

// Four points at a time, in the vectors that compilers make of this: the same additions in the same
// order on every machine.
using Floats [[gnu::vector_size(16)]] = float;
using Ints [[gnu::vector_size(16)]] = int;

/// The furthest along a direction so far, of each fourth point.
class Scan {
 public:
  explicit Scan(Vec3 d) noexcept : x_(all(d.x)), y_(all(d.y)), z_(all(d.z)) {}

  /// The four points from number `at` on: x behind `x`, y `count` further on, z again.
  void step(const float* x, int count, int at) noexcept {
    const Floats along = x_ * load(x) + y_ * load(x + count) + z_ * load(x + 2 * count);
    const Ints more = along > most_;
    most_ = reinterpret_cast<Floats>((more & reinterpret_cast<Ints>(along)) |
                                     (~more & reinterpret_cast<Ints>(most_)));
    best_ = (more & (Ints{at, at, at, at} + Ints{0, 1, 2, 3})) | (~more & best_);
  }
  /// Its number, and how far along it is.
  std::pair<int, float> best() const noexcept {
    int lane = 0;
    for (int l = 1; l < 4; ++l)
      if (most_[l] > most_[lane]) lane = l;
    return {best_[lane], most_[lane]};
  }

 private:
  static Floats all(double v) noexcept {
    const auto f = static_cast<float>(v);
    return Floats{f, f, f, f};
  }
  static Floats load(const float* from) noexcept {
    Floats four;
    std::memcpy(&four, from, sizeof four);
    return four;
  }

  static constexpr float kLow = -std::numeric_limits<float>::max();
  Floats x_, y_, z_;
  Floats most_{kLow, kLow, kLow, kLow};
  Ints best_{};
};

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
    for (const Vec3 d : {Vec3{1, 0, 0},
                         {0, 1, 0},
                         {0, 0, 1},
                         {kDiagonal, kDiagonal, kDiagonal},
                         {kDiagonal, kDiagonal, -kDiagonal},
                         {kDiagonal, -kDiagonal, kDiagonal},
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
      if (left > wanted && corners.size() < kMostCorners && add(points[furthest_of(points, out)]))
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
  Scan scan(direction);
  for (int i = 0; i < count_; i += 4) scan.step(floats_.data() + i, count_, i);
  return scan.best().first;
}

Hull::Furthest Hull::furthest(Vec3 first, double first_start, Vec3 second,
                              double second_start) const noexcept {
  Scan ahead(first), behind(second);
  for (int i = 0; i < count_; i += 4) {
    ahead.step(floats_.data() + i, count_, i);
    behind.step(floats_.data() + i, count_, i);
  }
  const auto [index, along] = ahead.best();
  const auto [other, across] = behind.best();
  if (first_start + along >= second_start + across) return {index, false};
  return {other, true};
}

}  // namespace lasius::arm
