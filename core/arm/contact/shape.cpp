#include "core/arm/contact/shape.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "kernels/base/sine.h"

namespace lasius::arm {
namespace {

constexpr int kMostInHull = 512;  // triangles; of larger covers only the first has one
constexpr double kCover = 0.01;   // of its radius: how near a hull follows what it covers

struct Ball {
  Vec3 centre;
  double radius = 0;
};

/// About the middle of their bounds.
Ball ball_around(std::span<const Vec3> points) {
  Vec3 low = points[0], high = points[0];
  for (const Vec3 p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  Ball ball{0.5 * (low + high)};
  for (const Vec3 p : points) ball.radius = std::max(ball.radius, distance(p, ball.centre));
  return ball;
}

void surround(Shape& shape, std::span<const Vec3> points) {
  const Ball ball = ball_around(points);
  shape.centre = ball.centre;
  shape.radius = ball.radius + shape.round;
  shape.far = std::max(shape.far, length(shape.centre));  // bounds take both
  for (const Vec3 p : points) shape.far = std::max(shape.far, length(p) + shape.round);
}

/// Points whose hull holds the solid's set: all but what `round` adds.
std::vector<Vec3> corners_of(const Shape& s) {
  std::vector<Vec3> points;
  switch (s.kind) {
    case Shape::Kind::box:
      for (int i = 0; i < 8; ++i) {
        points.push_back(s.at * Vec3{i & 1 ? s.half.x : -s.half.x, i & 2 ? s.half.y : -s.half.y,
                                     i & 4 ? s.half.z : -s.half.z});
      }
      break;
    case Shape::Kind::cylinder: {
      constexpr int kSides = 12;
      const double turn = 3.14159265358979323846 / kSides;
      const double out = s.half.x / kernels::sine_cosine(turn).cosine;
      for (int i = 0; i < kSides; ++i) {
        const auto [sine, cosine] = kernels::sine_cosine(2 * turn * i);
        for (const double z : {-s.half.z, s.half.z})
          points.push_back(s.at * Vec3{out * cosine, out * sine, z});
      }
      break;
    }
    case Shape::Kind::segment:
      points = {s.corner[0], s.corner[1]};
      break;
    case Shape::Kind::triangle:
      points.assign(s.corner.begin(), s.corner.end());
      break;
    case Shape::Kind::hull:
      for (int i = 0; i < s.hull.count(); ++i) points.push_back(s.hull.at(i));
      break;
  }
  return points;
}

}  // namespace

struct Shape::Mesh {
  std::vector<Vec3> corners;
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> order;  // of triangles: covers are ranges of it

  Vec3 middle(int t) const {
    const auto& [a, b, c] = triangles[t];
    return (1.0 / 3) * (corners[a] + corners[b] + corners[c]);
  }
};

ShapeStore::ShapeStore() = default;
ShapeStore::~ShapeStore() = default;

Shape& ShapeStore::make() const {
  Shape& shape = shapes_.emplace_back();
  shape.store = this;
  return shape;
}

const Shape* ShapeStore::add_mesh(const Triangles& given, const Placement& at, int number) {
  Shape::Mesh& mesh = *meshes_.emplace_back(std::make_unique<Shape::Mesh>());
  // Corners that are one are kept once: the same triangles in any file make the same hulls.
  std::vector<int> by_place(3 * given.size());
  const auto place = [&](int i) -> const Eigen::Vector3d& { return given[i / 3][i % 3]; };
  for (std::size_t i = 0; i < by_place.size(); ++i) by_place[i] = static_cast<int>(i);
  std::ranges::sort(by_place, [&](int a, int b) {
    const auto &p = place(a), &q = place(b);
    return std::tie(p[0], p[1], p[2], a) < std::tie(q[0], q[1], q[2], b);
  });
  mesh.triangles.resize(given.size());
  for (std::size_t i = 0; i < by_place.size(); ++i) {
    const int corner = by_place[i];
    if (i == 0 || place(corner) != place(by_place[i - 1]))
      mesh.corners.push_back(at * Vec3(place(corner)));
    mesh.triangles[corner / 3][corner % 3] = static_cast<int>(mesh.corners.size()) - 1;
  }
  mesh.order.resize(given.size());
  for (std::size_t t = 0; t < given.size(); ++t) mesh.order[t] = static_cast<int>(t);
  return cover(mesh, 0, static_cast<int>(given.size()), number, true);
}

const Shape* ShapeStore::add(const Solid& solid, int number) {
  const Placement at = from_eigen(solid.pose);
  if (solid.shape == Solid::Shape::mesh) {
    if (solid.triangles == nullptr || solid.triangles->empty()) return nullptr;
    return add_mesh(*solid.triangles, at, number);
  }
  Shape& shape = make();
  shape.exact = true;
  shape.solid = number;
  shape.at = at;
  switch (solid.shape) {
    case Solid::Shape::box:
      shape.kind = Shape::Kind::box;
      shape.half = 0.5 * Vec3(solid.size);
      break;
    case Solid::Shape::cylinder:
      shape.kind = Shape::Kind::cylinder;
      shape.half = {solid.radius, 0, 0.5 * solid.length};
      break;
    default:  // a ball is a capsule of no length
      shape.kind = Shape::Kind::segment;
      shape.round = solid.radius;
      shape.corner = {at.position,
                      solid.shape == Solid::Shape::capsule ? at * Vec3(solid.size) : at.position};
  }
  surround(shape, corners_of(shape));
  if (shape.kind == Shape::Kind::cylinder) {
    shape.centre = at.position;
    shape.radius = std::sqrt(shape.half.x * shape.half.x + shape.half.z * shape.half.z);
  }
  return &shape;
}

const Shape* ShapeStore::cover(Shape::Mesh& mesh, int first, int count, int number,
                               bool root) const {
  Shape& shape = make();
  shape.solid = number;
  if (count == 1) {
    const auto& triangle = mesh.triangles[mesh.order[first]];
    shape.exact = true;
    shape.kind = Shape::Kind::triangle;
    for (int i = 0; i < 3; ++i) shape.corner[i] = mesh.corners[triangle[i]];
    surround(shape, shape.corner);
    return &shape;
  }
  shape.mesh = &mesh;
  shape.first = first;
  shape.count = count;
  const bool hull = root || count <= kMostInHull;
  std::vector<Vec3> points;
  if (root) {
    points = mesh.corners;
  } else {
    std::vector<int> used;
    used.reserve(static_cast<std::size_t>(3) * count);
    for (int i = first; i < first + count; ++i)
      for (const int corner : mesh.triangles[mesh.order[i]]) used.push_back(corner);
    if (hull) {  // each once
      std::ranges::sort(used);
      used.erase(std::unique(used.begin(), used.end()), used.end());
    }
    points.reserve(used.size());
    for (const int corner : used) points.push_back(mesh.corners[corner]);
  }
  surround(shape, points);
  if (hull) {
    shape.hull = Hull(points, kCover * shape.radius);
    shape.round = shape.hull.margin();
  }
  return &shape;
}

const Shape* ShapeStore::join(std::span<const Shape* const> shapes) {
  if (shapes.size() == 1) return shapes[0];
  std::vector<const Shape*> sorted(shapes.begin(), shapes.end());
  std::vector<Vec3> points;
  double round = 0;
  for (const Shape* const s : sorted) {
    const std::vector<Vec3> corners = corners_of(*s);
    points.insert(points.end(), corners.begin(), corners.end());
    round = std::max(round, s->round);
  }
  const auto spread = [&](double Vec3::*axis) {
    const auto [least, most] =
        std::ranges::minmax(sorted, {}, [axis](const Shape* s) { return s->centre.*axis; });
    return most->centre.*axis - least->centre.*axis;
  };
  double Vec3::*longest = &Vec3::x;
  for (double Vec3::*const axis : {&Vec3::y, &Vec3::z})
    if (spread(axis) > spread(longest)) longest = axis;
  std::ranges::stable_sort(sorted, {}, [longest](const Shape* s) { return s->centre.*longest; });
  const std::size_t half = sorted.size() / 2;
  const std::span all(sorted);
  const Shape::Parts parts{join(all.first(half)), join(all.subspan(half))};

  Shape& shape = make();
  shape.round = round;
  surround(shape, points);
  shape.hull = Hull(points, kCover * shape.radius);
  shape.round = round + shape.hull.margin();
  shape.parts = &parts_.emplace_back(parts);
  return &shape;
}

const Shape::Parts& ShapeStore::make_parts(const Shape& shape) const {
  const std::scoped_lock lock(making_);
  if (const Shape::Parts* known = shape.parts.load(std::memory_order_acquire)) return *known;
  Shape::Mesh& mesh = *shape.mesh;
  const auto begin = mesh.order.begin() + shape.first, end = begin + shape.count;
  Vec3 low = mesh.middle(*begin), high = low;
  for (auto t = begin; t != end; ++t) {
    const Vec3 p = mesh.middle(*t);
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const Vec3 size = high - low;
  double Vec3::*axis = &Vec3::x;
  if (size.y > size.*axis) axis = &Vec3::y;
  if (size.z > size.*axis) axis = &Vec3::z;
  const double middle = 0.5 * (low.*axis + high.*axis);
  auto cut =
      std::stable_partition(begin, end, [&](int t) { return mesh.middle(t).*axis < middle; });
  // Halved by number where by place one side would get next to nothing.
  if (8 * std::min(cut - begin, end - cut) < end - begin) {
    cut = begin + (end - begin) / 2;
    std::nth_element(begin, cut, end, [&](int a, int b) {
      const double p = mesh.middle(a).*axis, q = mesh.middle(b).*axis;
      return std::tie(p, a) < std::tie(q, b);
    });
  }
  const int first = static_cast<int>(cut - begin);
  const Shape* const one = cover(mesh, shape.first, first, shape.solid, false);
  const Shape* const two =
      cover(mesh, shape.first + first, shape.count - first, shape.solid, false);
  const Shape::Parts& made = parts_.emplace_back(Shape::Parts{one, two});
  shape.parts.store(&made, std::memory_order_release);
  return made;
}

Vec3 PlacedShape::operator()(Vec3 direction) const noexcept {
  switch (shape_.kind) {
    case Shape::Kind::hull:
      return body_ * shape_.hull.at(shape_.hull.furthest(rotate_back(body_.rotation, direction)));
    case Shape::Kind::box: {
      const Vec3 d = rotate_back(solid_.rotation, direction), half = shape_.half;
      return solid_ * Vec3{d.x < 0 ? -half.x : half.x, d.y < 0 ? -half.y : half.y,
                           d.z < 0 ? -half.z : half.z};
    }
    case Shape::Kind::cylinder: {
      const Vec3 d = rotate_back(solid_.rotation, direction);
      Vec3 p{0, 0, d.z < 0 ? -shape_.half.z : shape_.half.z};
      const double across = std::sqrt(d.x * d.x + d.y * d.y);
      if (across > 0) {
        p.x = shape_.half.x / across * d.x;
        p.y = shape_.half.x / across * d.y;
      }
      return solid_ * p;
    }
    case Shape::Kind::segment:
    case Shape::Kind::triangle:
      break;
  }
  const Vec3 d = rotate_back(body_.rotation, direction);
  const int corners = shape_.kind == Shape::Kind::triangle ? 3 : 2;
  int best = 0;
  double most = dot(shape_.corner[0], d);
  for (int i = 1; i < corners; ++i) {
    const double along = dot(shape_.corner[i], d);
    if (along > most) most = along, best = i;
  }
  return body_ * shape_.corner[best];
}

Vec3 PlacedShape::nearest(Vec3 p) const noexcept {
  const auto clamp = [](Vec3 a, Vec3 most) {
    return Vec3{std::clamp(a.x, -most.x, most.x), std::clamp(a.y, -most.y, most.y),
                std::clamp(a.z, -most.z, most.z)};
  };
  switch (shape_.kind) {
    case Shape::Kind::box:
      return solid_ * clamp(rotate_back(solid_.rotation, p - solid_.position), shape_.half);
    case Shape::Kind::cylinder: {
      Vec3 local = rotate_back(solid_.rotation, p - solid_.position);
      const double across = std::sqrt(local.x * local.x + local.y * local.y);
      const double share = across > shape_.half.x ? shape_.half.x / across : 1;
      return solid_ * Vec3{share * local.x, share * local.y,
                           std::clamp(local.z, -shape_.half.z, shape_.half.z)};
    }
    case Shape::Kind::segment: {
      const Vec3 from = body_ * shape_.corner[0], way = body_ * shape_.corner[1] - from;
      const double whole = dot(way, way);
      const double share = whole > 0 ? std::clamp(dot(p - from, way) / whole, 0.0, 1.0) : 0;
      return from + share * way;
    }
    default: {
      // Of the ball around it.
      const Vec3 middle = centre();
      const double away = distance(p, middle), radius = shape_.radius - shape_.round;
      return away > radius ? middle + (radius / away) * (p - middle) : p;
    }
  }
}

Vec3 SweptShape::operator()(Vec3 direction) const noexcept {
  // e.(p +- h v) = (e +- e x hW).p +- e.hV
  const Vec3 across = cross(direction, turn_);
  const double along = dot(direction, shift_);
  const Vec3 ahead = direction + across, behind = direction - across;
  const Shape& shape = placed_.shape_;
  Vec3 p;
  bool back = false;
  if (shape.kind == Shape::Kind::hull) {
    const Placement& body = placed_.body_;
    const auto [index, second] =
        shape.hull.furthest(rotate_back(body.rotation, ahead), dot(ahead, body.position) + along,
                            rotate_back(body.rotation, behind), dot(behind, body.position) - along);
    p = body * shape.hull.at(index);
    back = second;
  } else {
    p = placed_(ahead);
    const Vec3 q = placed_(behind);
    back = dot(q, behind) - along > dot(p, ahead) + along;
    if (back) p = q;
  }
  const Vec3 way = cross(turn_, p) + shift_;
  return back ? p - way : p + way;
}

}  // namespace lasius::arm
