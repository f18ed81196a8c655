#include "core/arm/contact/hull.h"

#include <algorithm>
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
    const Floats along = x_ * load(x) + y_ * load(x + count) + z_ * load(x + count + count);
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

/// Points that are looked through again and again.
class Cloud {
 public:
  explicit Cloud(std::size_t most)
      : stride_(static_cast<int>((most + 3) / 4 * 4)),
        floats_(static_cast<std::size_t>(3) * stride_) {}

  void add(Vec3 p) {
    // Those that fill up the last four are this one, too.
    for (int i = count_++; i == count_ - 1 || i % 4 != 0; ++i) put(p, i);
  }
  int count() const noexcept { return count_; }
  Vec3 at(int i) const noexcept {
    return {floats_[i], floats_[i + stride_], floats_[i + 2 * stride_]};
  }
  int furthest(Vec3 direction) const noexcept {
    Scan scan(direction);
    for (int i = 0; i < count_; i += 4) scan.step(floats_.data() + i, stride_, i);
    return std::min(scan.best().first, count_ - 1);
  }

 private:
  void put(Vec3 p, int i) noexcept {
    floats_[i] = static_cast<float>(p.x);
    floats_[i + stride_] = static_cast<float>(p.y);
    floats_[i + 2 * stride_] = static_cast<float>(p.z);
  }

  int stride_, count_ = 0;
  std::vector<float> floats_;
};

/// The way from the hull's nearest point to `p`, as far as it takes to tell it from `near`.
Vec3 way_out(const Cloud& corners, Vec3 p, double near) {
  GjkSimplex simplex;
  Vec3 to = p - corners.at(0);
  double size = length(to);
  constexpr int kMostSteps = 30;
  for (int i = 0; i < kMostSteps && size > near; ++i) {
    const Vec3 next = p - corners.at(corners.furthest(to));
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
  constexpr std::size_t kFew = 48;
  Cloud corners(std::max(kFew, kMostCorners)), all(points.size());
  for (const Vec3 p : points) all.add(p);
  const auto add = [&](Vec3 p) {
    p = as_floats(p);
    for (int i = 0; i < corners.count(); ++i)
      if (corners.at(i) == p) return false;
    corners.add(p);
    return true;
  };
  const auto add_furthest = [&](Vec3 d) { return add(points[all.furthest(d)]); };
  if (points.size() <= kFew) {
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
      add_furthest(d);
      add_furthest(-1.0 * d);
    }
  }
  for (const Vec3 p : points) {
    for (;;) {
      const Vec3 out = way_out(corners, p, wanted);
      const double left = length(out);
      // The point reached is one of the hull: its distance is one that holds.
      if (left > wanted && corners.count() < static_cast<int>(kMostCorners) && add_furthest(out))
        continue;
      margin_ = std::max(margin_, left);
      break;
    }
  }
  count_ = (corners.count() + 3) / 4 * 4;
  floats_.resize(static_cast<std::size_t>(3) * count_);
  double far = 0;
  for (int i = 0; i < count_; ++i) {
    const Vec3 c = corners.at(std::min(i, corners.count() - 1));
    far = std::max(far, length(c));
    floats_[i] = static_cast<float>(c.x);
    floats_[i + count_] = static_cast<float>(c.y);
    floats_[i + 2 * count_] = static_cast<float>(c.z);
  }
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
