#include "tools/vehicle/disc_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "lasius/grid/clearance.h"

namespace lasius::tool {
namespace {

constexpr double kSlack = 1e-9;  // of a distance, cells

double length_of(const CurvePiece& piece) {
  return piece.turn == 0 ? std::hypot(piece.to.x - piece.from.x, piece.to.y - piece.from.y)
                         : piece.radius * piece.angle;
}

/// A share of a piece, from `low` to `high` of it.
CurvePiece part_of(const CurvePiece& piece, double low, double high) {
  CurvePiece part = piece;
  const auto at = [&](double share) -> Point {
    if (share == 0) return piece.from;
    if (share == 1) return piece.to;
    if (piece.turn == 0)
      return {piece.from.x + share * (piece.to.x - piece.from.x),
              piece.from.y + share * (piece.to.y - piece.from.y)};
    const double turned = piece.turn * piece.angle * share;
    const Point v{piece.from.x - piece.centre.x, piece.from.y - piece.centre.y};
    const double c = std::cos(turned), s = std::sin(turned);
    return {piece.centre.x + c * v.x - s * v.y, piece.centre.y + s * v.x + c * v.y};
  };
  part.from = at(low);
  part.to = at(high);
  part.angle = piece.angle * (high - low);
  return part;
}

double to_square(Point p, Cell cell) {
  return std::hypot(std::max({cell.x - p.x, 0., p.x - cell.x - 1}),
                    std::max({cell.y - p.y, 0., p.y - cell.y - 1}));
}

std::array<Point, 4> corners_of(Cell cell) {
  const double x = cell.x, y = cell.y;
  return {{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}};
}

/// From a line to a square.
double line_to_square(const CurvePiece& line, Cell cell) {
  const Point a = line.from, b = line.to, along{b.x - a.x, b.y - a.y};
  double enters = 0, leaves = 1;  // the shares of the line that are within both slabs
  const auto cut = [&](double from, double step, double low) {
    if (step == 0) {
      if (from < low || from > low + 1) leaves = -1;
      return;
    }
    const double one = (low - from) / step, other = (low + 1 - from) / step;
    enters = std::max(enters, std::min(one, other));
    leaves = std::min(leaves, std::max(one, other));
  };
  cut(a.x, along.x, cell.x);
  cut(a.y, along.y, cell.y);
  if (enters <= leaves) return 0;
  double least = std::min(to_square(a, cell), to_square(b, cell));
  const double squared = along.x * along.x + along.y * along.y;
  for (const Point c : corners_of(cell)) {
    const double share =
        squared == 0
            ? 0
            : std::clamp(((c.x - a.x) * along.x + (c.y - a.y) * along.y) / squared, 0., 1.);
    least = std::min(least, std::hypot(a.x + share * along.x - c.x, a.y + share * along.y - c.y));
  }
  return least;
}

/// From an arc to a square.
double arc_to_square(const CurvePiece& arc, Cell cell) {
  const Point c = arc.centre, u{arc.from.x - c.x, arc.from.y - c.y};
  const double r = arc.radius;
  const auto on_arc = [&](Point p) {
    const Point v{p.x - c.x, p.y - c.y};
    const double turned = arc.turn * std::atan2(u.x * v.y - u.y * v.x, u.x * v.x + u.y * v.y);
    return (turned < 0 ? turned + 2 * std::numbers::pi : turned) <= arc.angle;
  };
  double least = std::min(to_square(arc.from, cell), to_square(arc.to, cell));
  for (const Point p : corners_of(cell))
    if (on_arc(p)) least = std::min(least, std::abs(std::hypot(p.x - c.x, p.y - c.y) - r));
  // Where the circle is farthest along an axis, and where it crosses the lines of the sides.
  const std::array<Point, 4> extremes{
      {{c.x - r, c.y}, {c.x + r, c.y}, {c.x, c.y - r}, {c.x, c.y + r}}};
  for (const Point p : extremes)
    if (on_arc(p)) least = std::min(least, to_square(p, cell));
  for (int side = 0; side < 2; ++side) {
    for (const double sign : {-1., 1.}) {
      const double up = cell.y + side - c.y, right = cell.x + side - c.x;
      if (std::abs(up) <= r) {
        const Point p{c.x + sign * std::sqrt(r * r - up * up), static_cast<double>(cell.y + side)};
        if (on_arc(p)) least = std::min(least, to_square(p, cell));
      }
      if (std::abs(right) <= r) {
        const Point p{static_cast<double>(cell.x + side),
                      c.y + sign * std::sqrt(r * r - right * right)};
        if (on_arc(p)) least = std::min(least, to_square(p, cell));
      }
    }
  }
  return least;
}

/// The first blocked square nearer than `limit` to a short piece.
std::optional<Cell> near_to(const Grid& grid, double limit, const CurvePiece& piece) {
  const double reach = limit + (piece.turn == 0 ? 0 : length_of(piece) / 2);
  const auto low = [&](double a, double b) {
    return static_cast<int>(std::floor(std::min(a, b) - reach)) - 1;
  };
  const auto high = [&](double a, double b) {
    return static_cast<int>(std::floor(std::max(a, b) + reach)) + 1;
  };
  const Point a = piece.from, b = piece.to;
  for (int y = low(a.y, b.y); y <= high(a.y, b.y); ++y)
    for (int x = low(a.x, b.x); x <= high(a.x, b.x); ++x) {
      const Cell cell{x, y};
      if (grid.free(cell)) continue;
      const double apart =
          piece.turn == 0 ? line_to_square(piece, cell) : arc_to_square(piece, cell);
      if (apart < limit) return cell;
    }
  return std::nullopt;
}

bool inside(const Grid& grid, Point p) {
  return p.x >= 0 && p.y >= 0 && p.x <= grid.width() && p.y <= grid.height();
}

/// The least share of a piece that breaks a rule, of which `breaks` tells for the piece from its
/// begin to a share. Precondition: all of it does.
template <class Breaks>
double first_share(const Breaks& breaks) {
  double kept = 0, broken = 1;
  for (int step = 0; step < 100 && kept < broken; ++step) {
    const double middle = kept + (broken - kept) / 2;
    (breaks(middle) ? broken : kept) = middle;
  }
  return broken;
}

std::string text_of(Cell cell) {
  return "(" + std::to_string(cell.x) + ", " + std::to_string(cell.y) + ")";
}

/// What is met at a point, or where a point leaves `at` for another place.
std::optional<Cell> met_at(const Grid& grid, Point at) {
  const NearestBlocked nearest = nearest_blocked(grid, at, 1);
  return nearest.distance < 1 ? std::optional(nearest.cell) : std::nullopt;
}
std::optional<Cell> met_from(const Grid& grid, Point at, Point towards) {
  const double step = 1e-6 / std::hypot(towards.x - at.x, towards.y - at.y);
  return met_at(grid, {at.x + step * (towards.x - at.x), at.y + step * (towards.y - at.y)});
}

bool is_half(Point p) { return 2 * p.x == std::floor(2 * p.x) && 2 * p.y == std::floor(2 * p.y); }

}  // namespace

lasius::Curve lines_between(std::span<const Point> path) {
  lasius::Curve curve;
  if (path.size() == 1) curve.push_back({.from = path[0], .to = path[0]});
  for (std::size_t i = 1; i < path.size(); ++i)
    curve.push_back({.from = path[i - 1], .to = path[i]});
  return curve;
}

double length_of(const lasius::Curve& curve) {
  double length = 0;
  for (const CurvePiece& piece : curve) length += length_of(piece);
  return length;
}

std::optional<PathFault> point_fault(const Grid& grid, std::span<const Point> path, bool squeezes) {
  const Corners corners = squeezes ? Corners::allow : Corners::forbid;
  std::vector<Point> apart;  // without vertices that repeat the one before
  for (const Point p : path) {
    // Points anywhere may never squeeze, and the search for a fault looks at such: a line between
    // half cells is cut where it may.
    if (squeezes && !apart.empty() && inside(grid, p) && inside(grid, apart.back()) && is_half(p) &&
        is_half(apart.back())) {
      const Point from = apart.back();
      const int x = static_cast<int>(2 * (p.x - from.x)), y = static_cast<int>(2 * (p.y - from.y));
      const int parts = std::gcd(x, y);
      for (int i = 1; i < parts; ++i)
        apart.push_back({from.x + x / parts * i / 2.0, from.y + y / parts * i / 2.0});
    }
    if (apart.empty() || !(apart.back() == p)) apart.push_back(p);
  }
  const auto fault_of = [&](std::initializer_list<Point> part) {
    return path_fault(grid, std::vector<Point>(part), corners);
  };
  if (!inside(grid, apart[0])) return PathFault{.at = apart[0], .why = "begins outside the map"};
  if (apart.size() == 1) {
    if (auto why = fault_of({apart[0]}))
      return PathFault{.at = apart[0], .cell = met_at(grid, apart[0]), .why = *why};
    return std::nullopt;
  }
  double along = 0;
  for (std::size_t i = 0; i + 1 < apart.size(); ++i) {
    const Point a = apart[i], b = apart[i + 1];
    const CurvePiece line{.from = a, .to = b};
    const double length = length_of(line);
    const auto before = [&](double share) { return part_of(line, 0, share).to; };
    // What the library says of ends anywhere holds for two points; of turns it knows those on half
    // cells, and at no others can a path squeeze.
    double share = 1;
    const bool broken = fault_of({a, b}).has_value();
    if (broken)
      share = first_share([&](double to) { return fault_of({a, before(to)}).has_value(); });
    const Point at = before(share);
    if (const Point free = broken ? before(share / 2) : b;
        i > 0 && is_half(a) && free != a && !fault_of({a, free}))
      if (auto why = fault_of({apart[i - 1], a, free}))
        return PathFault{.along = along, .at = a, .cell = met_from(grid, a, free), .why = *why};
    if (broken) {
      const Point end = inside(grid, b) ? b : at;
      return PathFault{.along = along + share * length,
                       .at = at,
                       .cell = met_from(grid, at, {2 * b.x - a.x, 2 * b.y - a.y}),
                       .why = inside(grid, end) ? *fault_of({a, end}) : "leaves the map"};
    }
    along += length;
  }
  return std::nullopt;
}

std::optional<PathFault> disc_fault(const Grid& grid, double radius, const lasius::Curve& curve) {
  constexpr double kPart = 8;  // cells: of longer pieces too many squares would be looked at
  // Nothing in the map is farther than half of it from the outside.
  const double half = std::min(grid.width(), grid.height()) / 2.0;
  const double limit = std::min(radius - std::min(kSlack, radius / 2), half + 1);
  double along = 0;
  for (const CurvePiece& piece : curve) {
    const double length = length_of(piece), parts = std::max(1., std::ceil(length / kPart));
    for (double i = 0; i < parts; ++i) {
      const CurvePiece part = part_of(piece, i / parts, (i + 1) / parts);
      if (!inside(grid, part.from))
        return PathFault{
            .along = along + i / parts * length, .at = part.from, .why = "is outside the map"};
      if (!near_to(grid, limit, part)) continue;
      const double share = first_share(
          [&](double to) { return near_to(grid, limit, part_of(part, 0, to)).has_value(); });
      const Point at = part_of(part, 0, share).to;
      const NearestBlocked nearest = nearest_blocked(grid, at, radius + 1);
      return PathFault{.along = along + (i + share) / parts * length,
                       .at = at,
                       .cell = nearest.cell,
                       .why = (grid.contains(nearest.cell)
                                   ? "comes nearer than the radius to the blocked cell "
                                   : "comes nearer than the radius to the outside, cell ") +
                              text_of(nearest.cell)};
    }
    along += length;
  }
  return std::nullopt;
}

}  // namespace lasius::tool
