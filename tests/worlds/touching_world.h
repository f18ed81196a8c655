// Random worlds whose walls touch, share edges, cross and repeat each other and the boundary, some
// of them as text that has to be repaired; what is meant is known by construction.
#pragma once

#include <array>
#include <cstdio>
#include <string>

#include "tests/worlds/random_world.h"

namespace lasius::polygon {

struct TouchingWorld {
  std::string wkt;
  Point origin;                ///< what follows is told from there
  Ring boundary;               ///< convex
  std::vector<Polygon> walls;  ///< the areas that are meant, as far as they lie inside
  double margin = 0;           ///< not in the text
};

class TouchingWorlds {
 public:
  /// Number 0, 1, ..: at the origin, 2 km off and in UTM coordinates; walls are holes of the
  /// boundary, obstacles of their own, or these clipped to the boundary; one in five has a margin.
  static TouchingWorld make(std::uint64_t number) { return TouchingWorlds(number).made(); }

 private:
  enum class Kind { holes, mixed, obstacles, clipped };
  struct Shape {
    Ring ring;
    std::vector<Polygon> meant;  // the ring itself if empty
  };

  explicit TouchingWorlds(std::uint64_t number)
      : dice_(number + 77), kind_(static_cast<Kind>(number / 3 % 4)) {
    constexpr std::array<Point, 3> kOrigins{{{0, 0}, {2000, 2000}, {5e5, 5e6}}};
    world_.origin = kOrigins[number % 3];
    if (number % 5 == 4) world_.margin = dice_.real(0.2, 3);
    turn_ = number % 7 == 0 ? 0 : dice_.real(0, 2 * std::numbers::pi);
  }

  /// Turned, moved, and rounded so; then told from the origin again, which is exact.
  Point placed(Point p) const {
    const double c = std::cos(turn_), s = std::sin(turn_);
    return {c * p.x - s * p.y + 300 + world_.origin.x, s * p.x + c * p.y + 300 + world_.origin.y};
  }
  Ring placed(Ring ring) const {
    for (Point& p : ring) p = placed(p);
    return ring;
  }
  Polygon local(Ring ring) const {
    for (Point& p : ring) p = {p.x - world_.origin.x, p.y - world_.origin.y};
    return {std::move(ring), {}};
  }

  static Point between(Point a, Point b, double share) {
    return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
  }
  std::pair<Point, Point> edge_of(const Ring& ring) {
    const int i = dice_.whole(0, static_cast<int>(ring.size()) - 1);
    return {ring[i], ring[(i + 1) % ring.size()]};
  }
  Ring star(Point centre, double reach, int corners) {
    Ring ring;
    const double turn = dice_.real(0, 2 * std::numbers::pi);
    for (int i = 0; i < corners; ++i) {
      const double angle = turn + 2 * std::numbers::pi * i / corners,
                   r = reach * dice_.real(0.4, 1);
      ring.push_back({centre.x + r * std::cos(angle), centre.y + r * std::sin(angle)});
    }
    return ring;
  }
  Point inside() { return {dice_.real(-40, 40), dice_.real(-30, 30)}; }
  Ring any_star() { return star(inside(), dice_.real(5, 20), dice_.whole(3, 7)); }
  const Shape& earlier() { return shapes_[dice_.whole(0, static_cast<int>(shapes_.size()) - 1)]; }

  /// On a part of an edge, or with its tip there.
  Ring standing_on(Point a, Point b, double reach) {
    const double from = dice_.real(0.1, 0.5), to = dice_.real(0.55, 0.9);
    const Point left{-(b.y - a.y), b.x - a.x};
    const double length = std::hypot(left.x, left.y);
    const auto off = [&](Point p, double by) {
      return Point{p.x + by * left.x / length, p.y + by * left.y / length};
    };
    const Point p = between(a, b, from), q = between(a, b, to);
    if (dice_.whole(0, 1) == 0) return {p, q, off(q, dice_.real(0.3, 1) * reach), off(p, reach)};
    const Point tip = between(a, b, dice_.whole(0, 2) == 0 ? 0 : 0.5 * (from + to));
    return {tip, off(q, reach), off(p, dice_.real(0.3, 1) * reach)};
  }
  /// From one edge of the boundary to another.
  Ring across() {
    const int count = static_cast<int>(ring_.size());
    const int i = dice_.whole(0, count - 2), j = dice_.whole(i + 1, count - 1);
    const double t = dice_.real(0.2, 0.7), u = dice_.real(0.2, 0.7);
    const auto on = [&](int edge, double share) {
      return between(ring_[edge], ring_[(edge + 1) % count], share);
    };
    return {on(i, t), on(i, t + 0.05), on(j, u), on(j, u + 0.05)};
  }
  Shape bow_tie() {
    const Point knot = inside();
    const auto off = [&](Point way, double share) {
      return Point{knot.x + share * way.x, knot.y + share * way.y};
    };
    const Point a{dice_.real(4, 15), dice_.real(-6, 2)}, b{dice_.real(4, 15), dice_.real(3, 8)};
    const double s = -dice_.real(0.3, 1), t = -dice_.real(0.3, 1);
    const Ring ring{off(a, 1), off(a, s), off(b, t), off(b, 1)};
    return {ring, {{{ring[0], ring[3], knot}, {}}, {{ring[1], ring[2], knot}, {}}}};
  }
  Shape shape() {
    const auto [a, b] = edge_of(ring_);
    switch (dice_.whole(0, shapes_.empty() ? 5 : 9)) {
      case 0:
        return {any_star(), {}};
      case 1:
      case 2:
        return {standing_on(a, b, dice_.real(8, 40)), {}};
      case 3:
        return {across(), {}};
      case 4:
        return {star(between(a, b, dice_.real(0.1, 0.9)), dice_.real(8, 25), 6), {}};
      case 5:
        return bow_tie();
      case 6:
        return earlier();  // once more
      case 7: {            // within another
        Shape smaller = earlier();
        Point centre;
        for (const Point p : smaller.ring) centre = {centre.x + p.x, centre.y + p.y};
        const auto count = static_cast<double>(smaller.ring.size());
        centre = {centre.x / count, centre.y / count};
        const auto shrink = [&](Ring& ring) {
          for (Point& p : ring) p = between(centre, p, 0.5);
        };
        shrink(smaller.ring);
        for (Polygon& part : smaller.meant) shrink(part.outer);
        return smaller;
      }
      default: {
        const auto [c, d] = edge_of(earlier().ring);
        const bool turned = dice_.whole(0, 1) == 0;
        return {standing_on(turned ? d : c, turned ? c : d, dice_.real(5, 30)), {}};
      }
    }
  }

  static std::string text(const Ring& ring) {
    std::string words = "(";
    for (std::size_t i = 0; i <= ring.size(); ++i) {
      char pair[80];
      const Point p = ring[i % ring.size()];
      std::snprintf(pair, sizeof pair, "%s%.17g %.17g", i > 0 ? ", " : "", p.x, p.y);
      words += pair;
    }
    return words + ")";
  }
  void add_obstacle(const Ring& ring) { obstacles_ += "POLYGON (" + text(ring) + ")\n"; }

  TouchingWorld made() {
    const int corners = dice_.whole(0, 1) == 0 ? 4 : dice_.whole(3, 7);
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 0.5) / corners;
      ring_.push_back({70 * std::cos(angle), 55 * std::sin(angle)});
    }
    const Ring boundary = placed(ring_);
    world_.boundary = local(boundary).outer;
    std::string holes;
    for (int i = dice_.whole(2, 7); i > 0; --i) {
      shapes_.push_back(shape());
      const Ring ring = placed(shapes_.back().ring);
      for (const Polygon& meant : shapes_.back().meant)
        world_.walls.push_back(local(placed(meant.outer)));
      const bool ties = !shapes_.back().meant.empty();
      if (!ties) world_.walls.push_back(local(ring));
      if (kind_ == Kind::holes || (kind_ == Kind::mixed && i % 2 == 0)) {
        holes += ", " + text(ring);
      } else if (kind_ == Kind::clipped && !ties) {
        const auto left = areas_.both(areas_.of({ring, {}}), areas_.of({boundary, {}}));
        for (const Polygon& part : areas_.polygons(left)) add_obstacle(part.outer);
      } else {
        add_obstacle(ring);
      }
    }
    if (kind_ == Kind::obstacles) add_ring_wall();
    world_.wkt = "POLYGON (" + text(boundary) + holes + ")\n" + obstacles_;
    return std::move(world_);
  }
  /// An obstacle with holes: one crosses its outline, and is given twice.
  void add_ring_wall() {
    const Ring outer = placed(any_star());
    const Ring hole = placed(star(ring_.front(), 1, 3)), way = placed(any_star());
    const auto left = areas_.less(areas_.of(local(outer)), areas_.of(local(way)));
    for (Polygon& part : areas_.polygons(left)) world_.walls.push_back(std::move(part));
    obstacles_ +=
        "POLYGON (" + text(outer) + ", " + text(way) + ", " + text(hole) + ", " + text(way) + ")\n";
  }

  Dice dice_;
  Kind kind_;
  double turn_ = 0;
  Areas areas_;
  TouchingWorld world_;
  Ring ring_;  // the boundary before it is turned
  std::vector<Shape> shapes_;
  std::string obstacles_;
};

}  // namespace lasius::polygon
