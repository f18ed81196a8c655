#include "core/disc/curve.h"

#include <cmath>

namespace lasius::disc {

namespace {

/// The sides of a polygon around an arc, as long as they keep clear.
class ArcSides {
 public:
  ArcSides(const DiscSpace& space, Point centre, std::vector<Point>& path) noexcept
      : space_(space), centre_(centre), path_(path) {}

  // Between two unit vectors less than half a turn apart: the point where the tangents meet, if
  // both keep clear, else more of them.
  void add(Point from, Point to, int depth) {
    const double x = from.x + to.x, y = from.y + to.y;
    const double size = std::sqrt(x * x + y * y);
    const Point middle{x / size, y / size};
    const double half = 0.5 * size;  // the cosine of half the angle
    if (half >= kCoarsest || depth == kDeepest) {
      const Point vertex = on(middle, space_.radius() / half);
      const bool keeps = depth == kDeepest || (space_.reaches(on(from, space_.radius()), vertex) &&
                                               space_.sees(vertex, on(to, space_.radius())));
      if (keeps) {
        path_.push_back(vertex);
        return;
      }
    }
    add(from, middle, depth + 1);
    add(middle, to, depth + 1);
  }

 private:
  // Sides that turn by an angle d are longer than the arc by a share of d^2 / 12: here by 0.09%.
  static constexpr double kCoarsest = 0.99865;
  static constexpr int kDeepest = 16;

  Point on(Point normal, double radius) const noexcept {
    return {centre_.x + radius * normal.x, centre_.y + radius * normal.y};
  }

  const DiscSpace& space_;
  Point centre_;
  std::vector<Point>& path_;
};

}  // namespace

double curve_length(std::span<const CurvePiece> curve) noexcept {
  double length = 0;
  for (const CurvePiece& piece : curve)
    length += piece.turn == 0 ? distance(piece.from, piece.to) : piece.angle * piece.radius;
  return length;
}

std::vector<Point> polyline_of(const Curve& curve, const DiscSpace& space) {
  std::vector<Point> path;
  if (curve.empty()) return path;
  path.push_back(curve.front().from);
  for (const CurvePiece& piece : curve) {
    if (piece.turn == 0) continue;  // ends of arcs lie on the sides around them
    const double per_radius = 1 / space.radius();
    const auto normal = [&](Point p) -> Point {
      return {(p.x - piece.centre.x) * per_radius, (p.y - piece.centre.y) * per_radius};
    };
    ArcSides(space, piece.centre, path).add(normal(piece.from), normal(piece.to), 0);
  }
  path.push_back(curve.back().to);
  return path;
}

}  // namespace lasius::disc
