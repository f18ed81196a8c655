// What is tested against what: solids, triangles, and hierarchies of hulls over them, whose parts
// are made when they are first asked for.
#pragma once

#include <atomic>
#include <deque>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "core/arm/contact/hull.h"
#include "core/arm/robot/vec3.h"
#include "lasius/arm/robot.h"

namespace lasius::arm {

/// A solid, a triangle of one, or a cover of several, in the frame of the body that it moves with.
struct Shape {
  enum class Kind { hull, box, cylinder, segment, triangle };
  Kind kind = Kind::hull;
  bool exact = false;          // no cover: all of it is solid
  Vec3 centre;                 // of a ball around all of it
  double radius = 0;           // of that ball
  double far = 0;              // no point of it is further from the body's origin
  double round = 0;            // it reaches so far around the set of its kind
  Placement at;                // box, cylinder
  Vec3 half;                   // box; cylinder: half.x its radius, half.z half its length
  std::array<Vec3, 3> corner;  // segment: two of them
  Hull hull;
  int solid = 0;  // of an exact shape: the number that was given with the solid
  const class ShapeStore* store = nullptr;  // that keeps it

  /// False of a cover without a hull: only its ball is known.
  bool hull_or_exact() const noexcept { return exact || hull.count() > 0; }

  struct Mesh;
  Mesh* mesh = nullptr;      // of which it covers triangles
  int first = 0, count = 0;  // of the mesh's order
  using Parts = std::array<const Shape*, 2>;
  mutable std::atomic<const Parts*> parts = nullptr;
};

/// Makes shapes and keeps them. Thread-safe once all solids were added.
class ShapeStore {
 public:
  ShapeStore();
  ~ShapeStore();

  /// The solid, which is told by `number`; null for a mesh without triangles.
  const Shape* add(const Solid& solid, int number);
  /// A cover of all of them. Precondition: there are some.
  const Shape* join(std::span<const Shape* const> shapes);

 private:
  friend const Shape::Parts& parts_of(const Shape& shape);
  Shape& make() const;
  const Shape* add_mesh(const Triangles& given, const Placement& at, int number);
  const Shape::Parts& make_parts(const Shape& shape) const;
  const Shape* cover(Shape::Mesh& mesh, int first, int count, int number, bool root) const;

  mutable std::mutex making_;
  mutable std::deque<Shape> shapes_;
  mutable std::deque<Shape::Parts> parts_;
  std::vector<std::unique_ptr<Shape::Mesh>> meshes_;
};

/// What together makes a shape. Precondition: it is not exact.
inline const Shape::Parts& parts_of(const Shape& shape) {
  const Shape::Parts* known = shape.parts.load(std::memory_order_acquire);
  return known != nullptr ? *known : shape.store->make_parts(shape);
}

/// What it takes to open a shape, in tests of a pair: much where its parts have yet to be made.
inline int work_of_parts(const Shape& shape) noexcept {
  return shape.parts.load(std::memory_order_relaxed) == nullptr ? 64 : 1;
}

/// A shape in the world, as the search for a separating plane asks.
class PlacedShape {
 public:
  PlacedShape(const Shape& shape, const Placement& body) noexcept
      : shape_(shape), body_(body), solid_(body) {
    if (shape.kind == Shape::Kind::box || shape.kind == Shape::Kind::cylinder)
      solid_ = body * shape.at;
  }
  /// The furthest point of its set along a direction.
  Vec3 operator()(Vec3 direction) const noexcept;
  /// Of the ball around it.
  Vec3 centre() const noexcept { return body_ * shape_.centre; }
  /// The point of the set that is nearest to `p`, which is itself where it is inside; of a hull one
  /// that need not be so near.
  Vec3 nearest(Vec3 p) const noexcept;

 private:
  friend class SweptShape;
  const Shape& shape_;
  const Placement& body_;
  Placement solid_;
};

/// All that a set passes while its points go straight from p - h v to p + h v, v = W x p + V.
class SweptShape {
 public:
  SweptShape(const PlacedShape& placed, Vec3 turn, Vec3 shift) noexcept
      : placed_(placed), turn_(turn), shift_(shift) {}
  Vec3 operator()(Vec3 direction) const noexcept;

 private:
  const PlacedShape& placed_;
  Vec3 turn_, shift_;  // h W, h V
};

}  // namespace lasius::arm
