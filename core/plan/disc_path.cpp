#include "core/plan/disc_path.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/number_text.h"
#include "core/disc/bit_rows.h"
#include "core/disc/sweep.h"

namespace lasius {
namespace {

double distance(Point a, Point b) noexcept {
  const double x = b.x - a.x, y = b.y - a.y;
  return std::sqrt(x * x + y * y);
}

double distance_to_segment(Point p, Point a, Point b) noexcept {
  const double x = b.x - a.x, y = b.y - a.y;
  const double square = x * x + y * y;
  const double along = square > 0 ? ((p.x - a.x) * x + (p.y - a.y) * y) / square : 0;
  const double t = std::clamp(along, 0.0, 1.0);
  return distance(p, {a.x + t * x, a.y + t * y});
}

/// Blocked cells of one row, side by side: columns `first` to before `end`.
struct Run {
  int first, end;
};

/// The first run from column `from` on, which ends after column `last` at the latest; an empty one
/// where all is free up to there.
Run run_from(const std::uint64_t* row, int from, int last) noexcept {
  const auto first_of = [row, last](int x, std::uint64_t inverted) {
    for (; x <= last; x += 64) {
      const std::uint64_t bits = disc::bits_from(row, x) ^ inverted;
      if (bits != 0) return std::min(x + std::countr_zero(bits), last + 1);
    }
    return last + 1;
  };
  const int first = first_of(from, 0);
  return {first, first_of(first, ~std::uint64_t{0})};
}

/// From a segment to the rectangle of a run in row y, which it does not cross.
double distance_to_run(Run run, int y, Point a, Point b) noexcept {
  const double left = run.first, right = run.end, top = y, bottom = y + 1.0;
  const auto from = [&](Point p) {
    return distance(p, {std::clamp(p.x, left, right), std::clamp(p.y, top, bottom)});
  };
  double least = std::min(from(a), from(b));
  for (const Point corner : {Point{left, top}, {right, top}, {left, bottom}, {right, bottom}})
    least = std::min(least, distance_to_segment(corner, a, b));
  return least;
}

std::string text(Point p) { return pair_text(p.x, p.y); }

/// Names a piece of which a point lies nearer than it may.
class Judge {
 public:
  Judge(const Grid& map, double radius)
      : map_(map), radius_(radius), least_(radius - 2 * disc::kSlack) {}

  std::optional<std::string> straight(Point a, Point b) const {
    for (const Point p : {a, b}) {
      if (!(p.x >= 0 && p.y >= 0 && p.x <= map_.width() && p.y <= map_.height()))
        return "the point " + text(p) + " is outside the map";
    }
    if (disc::sweeps_clear(map_, a, b, least_)) return std::nullopt;
    return "the segment " + text(a) + " - " + text(b) + " comes as near as " +
           number_text(segment_clearance(map_, a, b, radius_)) +
           " to a blocked cell, the radius is " + number_text(radius_);
  }

  std::optional<std::string> arc(const CurvePiece& piece) const {
    const auto off = [&](Point p) { return std::abs(distance(piece.centre, p) - radius_); };
    if (piece.radius != radius_ || off(piece.from) > disc::kSlack || off(piece.to) > disc::kSlack)
      return "the arc about " + text(piece.centre) + " has another radius than the disc";
    for (const Point end : {piece.from, piece.to})
      if (auto fault = straight(end, end)) return fault;
    if (!in_one_quadrant(piece))
      return "the arc about " + text(piece.centre) + " is not one of a quadrant";
    if (disc::turns_clear(map_, piece.centre, piece.from, piece.to, radius_, 2 * disc::kSlack))
      return std::nullopt;
    return "the arc about " + text(piece.centre) + " comes nearer to a blocked cell than " +
           number_text(radius_);
  }

 private:
  static bool in_one_quadrant(const CurvePiece& piece) noexcept {
    const auto aside = [](double centre, double from, double to) {
      const double a = from - centre, b = to - centre;
      return std::min(std::abs(a), std::abs(b)) <= disc::kSlack || (a > 0) == (b > 0);
    };
    return piece.centre.x == std::floor(piece.centre.x) &&
           piece.centre.y == std::floor(piece.centre.y) &&
           aside(piece.centre.x, piece.from.x, piece.to.x) &&
           aside(piece.centre.y, piece.from.y, piece.to.y);
  }

  const Grid& map_;
  double radius_, least_;
};

}  // namespace

std::optional<Cell> nearest_clear(const disc::DiscSpace& space, Cell c, Poller& poller,
                                  const std::optional<Point>& other) {
  const Grid& blocked = space.blocked_cells();
  std::vector<std::uint64_t> row(static_cast<std::size_t>(blocked.words()));
  const auto clear_row = [&](int y) {
    for (int i = 0; i < blocked.words(); ++i) {
      row[i] = blocked.row(y)[i];
      for (std::uint64_t left = space.band_cells().row(y)[i] & ~row[i]; left != 0;
           left &= left - 1) {
        if (!space.clear(centre({64 * i + std::countr_zero(left), y}))) row[i] |= left & (0 - left);
      }
    }
    return row.data();
  };
  std::function<bool(Cell)> joined;
  if (other) joined = [&](Cell at) { return space.joined(centre(at), *other); };
  return nearest_free(blocked, c, poller, joined, clear_row);
}

// Row by row, run by run of blocked cells: those beside the part of the segment that is near the
// row.
double segment_clearance(const Grid& map, Point a, Point b, double most) noexcept {
  if (a.y > b.y) std::swap(a, b);
  const double slope = b.y > a.y ? (b.x - a.x) / (b.y - a.y) : 0;
  const auto at = [&](double height) {
    if (height <= a.y) return a.x;
    return height >= b.y ? b.x : a.x + slope * (height - a.y);
  };
  // Columns of what lies between two heights.
  const auto across = [&](double from, double to) {
    if (a.y == b.y) return std::minmax({a.x, b.x});
    return std::minmax({at(from), at(to)});
  };
  double least = most;
  const int last_row = std::min(map.height(), static_cast<int>(std::floor(b.y + most)));
  for (int y = std::max(-1, static_cast<int>(std::floor(a.y - most)) - 1); y <= last_row; ++y) {
    const auto [low, high] = across(y - least, y + 1 + least);
    const int last = std::min(map.width(), static_cast<int>(std::floor(high + least)));
    int x = std::max(-1, static_cast<int>(std::floor(low - least)) - 1);
    const bool meets_row = a.y <= y + 1 && b.y >= y;
    const auto [left, right] = across(y, y + 1.0);
    while (x <= last) {
      const Run run = run_from(map.row(y), x, last);
      if (run.first > last) break;
      if (meets_row && left <= run.end && right >= run.first) return 0;
      least = std::min(least, distance_to_run(run, y, a, b));
      x = run.end;
    }
  }
  return least;
}

// Piece by piece from a on: what is in the way is mostly near.
bool keeps_clearance(const Grid& map, Point a, Point b, double clearance) noexcept {
  const int pieces = 1 + static_cast<int>(distance(a, b) / 8);
  Point from = a;
  for (int i = 1; i <= pieces; ++i) {
    const double t = 1.0 * i / pieces;
    const Point to = i < pieces ? Point{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)} : b;
    if (segment_clearance(map, from, to, clearance) < clearance - disc::kSlack) return false;
    from = to;
  }
  return true;
}

std::optional<std::string> disc_path_fault(const Grid& map, double radius,
                                           std::span<const Point> path,
                                           std::span<const CurvePiece> curve) {
  if (path.empty()) return "the path is empty";
  const Judge judge(map, radius);
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (auto fault = judge.straight(path[i - 1], path[i])) return fault;
    length += distance(path[i - 1], path[i]);
  }
  if (curve.empty()) return std::nullopt;
  double curve_length = 0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const CurvePiece& piece = curve[i];
    if (i > 0 && distance(curve[i - 1].to, piece.from) > disc::kSlack)
      return "the curve is broken at " + text(piece.from);
    if (auto fault = piece.turn == 0 ? judge.straight(piece.from, piece.to) : judge.arc(piece))
      return fault;
    curve_length += piece.turn == 0 ? distance(piece.from, piece.to) : piece.angle * radius;
  }
  if (distance(path.front(), curve.front().from) > 0 || distance(path.back(), curve.back().to) > 0)
    return "the curve's ends are not the path's";
  if (length < curve_length * (1 - disc::kSlack) || length > curve_length * 1.001)
    return "the path's length is " + number_text(length) + ", the curve's " +
           number_text(curve_length);
  return std::nullopt;
}

}  // namespace lasius
