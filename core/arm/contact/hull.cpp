#include "core/arm/contact/hull.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/arm/contact/gjk.h"
#include "core/base/kernel_choice.h"

namespace lasius::arm {
namespace {

constexpr std::size_t kMostCorners = 128;

Vec3 as_floats(Vec3 p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

kernels::LaneDirection as_direction(Vec3 d) {
  return {static_cast<float>(d.x), static_cast<float>(d.y), static_cast<float>(d.z)};
}

constexpr int padded(std::size_t count) {
  return static_cast<int>((count + kernels::kLanes - 1) / kernels::kLanes) * kernels::kLanes;
}

/// Points that are looked through again and again.
class Cloud {
 public:
  Cloud(const kernels::LaneContact& kernel, std::size_t most)
      : kernel_(kernel), stride_(padded(most)), floats_(static_cast<std::size_t>(3) * stride_) {}

  void add(Vec3 p) {
    // Those that fill up the last vector are this one, too.
    for (int i = count_++; i == count_ - 1 || i % kernels::kLanes != 0; ++i) put(p, i);
  }
  int count() const noexcept { return count_; }
  Vec3 at(int i) const noexcept {
    return {floats_[i], floats_[i + stride_], floats_[i + 2 * stride_]};
  }
  int furthest(Vec3 direction) const noexcept {
    const int filled = padded(static_cast<std::size_t>(count_));
    const kernels::LanePoints points{floats_.data(), stride_, filled};
    return std::min(kernel_.furthest(points, as_direction(direction)).index, count_ - 1);
  }

 private:
  void put(Vec3 p, int i) noexcept {
    floats_[i] = static_cast<float>(p.x);
    floats_[i + stride_] = static_cast<float>(p.y);
    floats_[i + 2 * stride_] = static_cast<float>(p.z);
  }

  const kernels::LaneContact& kernel_;
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

Hull::Hull(std::span<const Vec3> points, double wanted)
    : kernel_(&kernels::lane_contact(chosen_isa())) {
  constexpr std::size_t kFew = 48;
  Cloud corners(*kernel_, std::max(kFew, kMostCorners)), all(*kernel_, points.size());
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
  count_ = padded(static_cast<std::size_t>(corners.count()));
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
  return kernel_->furthest({floats_.data(), count_, count_}, as_direction(direction)).index;
}

Hull::Furthest Hull::furthest(Vec3 first, double first_start, Vec3 second,
                              double second_start) const noexcept {
  const auto [ahead, behind] = kernel_->furthest_two({floats_.data(), count_, count_},
                                                     as_direction(first), as_direction(second));
  if (first_start + ahead.along >= second_start + behind.along) return {ahead.index, false};
  return {behind.index, true};
}

}  // namespace lasius::arm
