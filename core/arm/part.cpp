#include "core/arm/part.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace lasius::arm {
namespace {

/// About the middle of their bounds.
Ball ball_around(const std::vector<Triangle>& triangles) {
  if (triangles.empty()) return {};
  const auto [low, high] = bounds_of(triangles);
  Ball ball{0.5 * (low + high)};
  for (const Triangle& triangle : triangles) {
    for (const Vec3 c : triangle) ball.radius = std::max(ball.radius, distance(c, ball.centre));
  }
  return ball;
}

}  // namespace

Part::Part(const Solid& solid)
    : shape_(solid.shape), pose_(from_eigen(solid.pose)), radius_(solid.radius) {
  switch (shape_) {
    case Solid::Shape::box:
      half_ = 0.5 * Vec3(solid.size);
      ball_.radius = 0.5 * length(solid.size);
      break;
    case Solid::Shape::cylinder:
      half_ = {0, 0, 0.5 * solid.length};
      ball_.radius = std::sqrt(radius_ * radius_ + 0.25 * solid.length * solid.length);
      break;
    case Solid::Shape::sphere:
      axis_ = {pose_.position, pose_.position};
      ball_.radius = radius_;
      break;
    case Solid::Shape::capsule:
      axis_ = {pose_.position, pose_ * solid.size};
      ball_.radius = 0.5 * length(axis_.to - axis_.from) + radius_;
      break;
    case Solid::Shape::mesh: {
      std::vector<Triangle> triangles;
      if (solid.triangles != nullptr) {
        for (const auto& [a, b, c] : *solid.triangles) triangles.push_back({a, b, c});
      }
      ball_ = ball_around(triangles);
      mesh_ = std::make_shared<const MeshTree>(std::move(triangles));
      break;
    }
  }
}

Part::Placed Part::place(const Placement& body) const noexcept {
  Placed placed;
  placed.part = this;
  placed.ball.radius = ball_.radius;
  if (round()) {
    placed.axis = {body * axis_.from, body * axis_.to};
    placed.ball.centre = 0.5 * (placed.axis.from + placed.axis.to);
  } else {
    placed.pose = body * pose_;
    placed.ball.centre = placed.pose * ball_.centre;
  }
  return placed;
}

Block Part::block(const Placement& at) const noexcept {
  return {at, half_, shape_ == Solid::Shape::cylinder ? radius_ : 0};
}

double Part::distance_to(const Segment& axis, double limit) const noexcept {
  if (shape_ == Solid::Shape::box) return distance_to_box(axis, half_);
  if (shape_ == Solid::Shape::cylinder) return distance_to_cylinder(axis, radius_, half_.z);
  return mesh_->distance(axis, limit);
}

double Part::distance_to(const Placed& round, const Placed& other, double enough) noexcept {
  const Part &a = *round.part, &b = *other.part;
  if (b.shape_ == Solid::Shape::sphere) {
    return distance_to_point(round.axis, other.axis.from) - b.radius_ - a.radius_;
  }
  if (b.shape_ == Solid::Shape::capsule) {
    return distance_to_segment(round.axis, other.axis) - a.radius_ - b.radius_;
  }
  const auto local = [&](Vec3 p) {
    return rotate_back(other.pose.rotation, p - other.pose.position);
  };
  const Segment axis{local(round.axis.from), local(round.axis.to)};
  const double limit = enough + a.radius_, apart = b.distance_to(axis, limit);
  // Not by subtraction: rounding would make less of it than is enough.
  return b.mesh_ != nullptr && apart >= limit ? enough : apart - a.radius_;
}

double distance_between(const Part::Placed& a, const Part::Placed& b, double enough) noexcept {
  if (a.part->round()) return Part::distance_to(a, b, enough);
  if (b.part->round()) return Part::distance_to(b, a, enough);
  if (a.part->mesh_ == nullptr && b.part->mesh_ == nullptr) {
    return distance_between(a.part->block(a.pose), b.part->block(b.pose), enough);
  }
  if (a.part->mesh_ == nullptr) return distance_between(b, a, enough);
  const Placement local = inverse(a.pose) * b.pose;
  if (b.part->mesh_ != nullptr) return a.part->mesh_->distance(*b.part->mesh_, local, enough);
  return a.part->mesh_->distance(b.part->block(local), enough);
}

}  // namespace lasius::arm
