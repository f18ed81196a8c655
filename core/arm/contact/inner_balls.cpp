#include "core/arm/contact/inner_balls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "kernels/base/random_stream.h"

namespace lasius::arm {
namespace {

constexpr double kShrink = 1e-5;  // of radii, for rounding: metres

/// Balls of one radius side by side along a segment.
void add_row(Vec3 from, Vec3 to, double radius, std::vector<InnerBall>& balls) {
  const double way = distance(from, to);
  const int steps = std::min(12, static_cast<int>(std::ceil(way / std::max(radius, 1e-3))));
  for (int i = 0; i <= steps; ++i) {
    const double share = steps == 0 ? 0 : static_cast<double>(i) / steps;
    balls.push_back({from + share * (to - from), radius - kShrink});
  }
}

/// The square of the distance from the origin to a triangle.
double squared_distance(Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 normal = cross(b - a, c - a);
  const double area = square(normal);
  if (area > 0 && dot(cross(b, c), normal) > 0 && dot(cross(c, a), normal) > 0 &&
      dot(cross(a, b), normal) > 0)
    return dot(a, normal) * dot(a, normal) / area;
  const auto edge = [](Vec3 p, Vec3 q) {
    const Vec3 d = q - p;
    const double whole = square(d);
    const double share = whole > 0 ? std::clamp(-dot(p, d) / whole, 0.0, 1.0) : 0;
    return square(p + share * d);
  };
  return std::min({edge(a, b), edge(b, c), edge(c, a)});
}

/// A closed surface, asked point by point.
class Inside {
 public:
  explicit Inside(const Solid& solid) {
    const Placement at = from_eigen(solid.pose);
    for (const auto& [a, b, c] : *solid.triangles) {
      const Face face{at * Vec3(a), at * Vec3(b), at * Vec3(c), 0};
      faces_.push_back(face);
      faces_.back().longest = std::max(distance(face.a, face.b), distance(face.a, face.c));
      for (const Vec3 p : {face.a, face.b, face.c}) {
        low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
        high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y), std::max(high_.z, p.z)};
      }
    }
  }

  Vec3 low() const { return low_; }
  Vec3 high() const { return high_; }

  /// Whether a surface turns around the point once, as seen along each axis.
  bool holds(Vec3 p) const {
    std::array<int, 3> turns{};
    for (const Face& f : faces_) {
      const Vec3 a = f.a - p, b = f.b - p, c = f.c - p;
      turns[0] += crossing(a.y, a.z, b.y, b.z, c.y, c.z, a.x, b.x, c.x);
      turns[1] += crossing(a.z, a.x, b.z, b.x, c.z, c.x, a.y, b.y, c.y);
      turns[2] += crossing(a.x, a.y, b.x, b.y, c.x, c.y, a.z, b.z, c.z);
    }
    return std::abs(turns[0]) == 1 && turns[0] == turns[1] && turns[1] == turns[2];
  }
  /// Metres to the surface; where that is not above `enough`, some value that is not either.
  double depth(Vec3 p, double enough) const {
    double least = 1e300, root = 1e150;
    for (const Face& f : faces_) {
      const double near = root + f.longest;
      const Vec3 a = f.a - p;
      if (square(a) >= near * near) continue;
      const double found = squared_distance(a, f.b - p, f.c - p);
      if (found >= least) continue;
      least = found;
      root = std::sqrt(least);
      if (root <= enough) return root;
    }
    return root;
  }

 private:
  struct Face {
    Vec3 a, b, c;
    double longest;  // from a
  };

  /// 1 or -1 where the ray from the origin along the third axis passes the triangle, by its side.
  static int crossing(double ax, double ay, double bx, double by, double cx, double cy, double az,
                      double bz, double cz) {
    if (az <= 0 && bz <= 0 && cz <= 0) return 0;
    const auto side = [](double px, double py, double qx, double qy) { return px * qy - py * qx; };
    const double u = side(bx, by, cx, cy), v = side(cx, cy, ax, ay), w = side(ax, ay, bx, by);
    if ((u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0)) {
      const double all = u + v + w;
      if ((u * az + v * bz + w * cz) / all <= 0) return 0;
      return all > 0 ? 1 : -1;
    }
    return 0;
  }

  std::vector<Face> faces_;
  Vec3 low_{1e300, 1e300, 1e300}, high_{-1e300, -1e300, -1e300};
};

std::vector<InnerBall> balls_of_mesh(const Solid& solid) {
  constexpr int kPoints = 64, kMoves = 2;
  constexpr double kLeast = 2e-3;  // metres
  constexpr std::size_t kMostBalls = 10;
  std::vector<InnerBall> balls;
  if (solid.triangles == nullptr || solid.triangles->empty()) return balls;
  const Inside inside(solid);
  const Vec3 size = inside.high() - inside.low();
  kernels::RandomStream words(1, 0, 0);
  const auto share = [&] { return (words.next() + 0.5) * 0x1p-32; };
  std::vector<InnerBall> found;
  for (int i = 0; i < kPoints; ++i) {
    const double x = share(), y = share(), z = share();
    Vec3 p = inside.low() + Vec3{x * size.x, y * size.y, z * size.z};
    const bool within = std::ranges::any_of(
        found, [&](const InnerBall& b) { return distance(p, b.centre) < 0.4 * b.radius; });
    if (within || !inside.holds(p)) continue;
    double depth = inside.depth(p, kLeast);
    // Deeper in: the first of a few tries each way that is.
    for (int m = 0; m < kMoves; ++m) {
      Vec3 best = p;
      for (const Vec3 way :
           {Vec3{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}) {
        const Vec3 next = p + 0.7 * depth * way;
        const double deeper = inside.depth(next, 1.05 * depth);
        if (deeper > 1.05 * depth) {
          best = next;
          depth = deeper;
          break;
        }
      }
      if (best == p) break;
      p = best;
    }
    if (depth > kLeast) found.push_back({p, depth - kShrink, true});
  }
  // The largest first, none whose middle is well inside of one before it.
  std::ranges::stable_sort(found, std::greater<>(), &InnerBall::radius);
  for (const InnerBall& ball : found) {
    const bool within = std::ranges::any_of(balls, [&](const InnerBall& b) {
      return distance(ball.centre, b.centre) < 0.6 * b.radius;
    });
    if (!within && balls.size() < kMostBalls) balls.push_back(ball);
  }
  return balls;
}

}  // namespace

std::vector<InnerBall> inner_balls(const Solid& solid) {
  const Placement at = from_eigen(solid.pose);
  std::vector<InnerBall> balls;
  switch (solid.shape) {
    case Solid::Shape::mesh:
      return balls_of_mesh(solid);
    case Solid::Shape::sphere:
      balls.push_back({at.position, solid.radius - kShrink});
      break;
    case Solid::Shape::capsule:
      add_row(at.position, at * Vec3(solid.size), solid.radius, balls);
      break;
    case Solid::Shape::cylinder: {
      const double radius = std::min(solid.radius, 0.5 * solid.length);
      const Vec3 end{0, 0, 0.5 * solid.length - radius};
      add_row(at * (-1.0 * end), at * end, radius, balls);
      break;
    }
    case Solid::Shape::box: {
      const Vec3 half = 0.5 * Vec3(solid.size);
      const double radius = std::min({half.x, half.y, half.z});
      const double most = std::max({half.x, half.y, half.z}) - radius;
      const Vec3 end = half.x - radius == most   ? Vec3{most, 0, 0}
                       : half.y - radius == most ? Vec3{0, most, 0}
                                                 : Vec3{0, 0, most};
      add_row(at * (-1.0 * end), at * end, radius, balls);
      break;
    }
  }
  std::erase_if(balls, [](const InnerBall& b) { return !(b.radius > 0); });
  return balls;
}

}  // namespace lasius::arm
