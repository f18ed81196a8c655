#include "core/plan/disc_path.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/number_text.h"
#include "core/disc/curve.h"
#include "core/disc/sweep.h"
#include "lasius/path/path.h"

namespace lasius {
namespace {

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
    return "the segment " + text(a) + " - " + text(b) + " comes nearer to a blocked cell than " +
           number_text(radius_);
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
  static constexpr double kRounding = 1e-7;  // of an end where a quadrant ends

  static bool in_one_quadrant(const CurvePiece& piece) noexcept {
    const auto aside = [](double centre, double from, double to) {
      const double a = from - centre, b = to - centre;
      return std::min(std::abs(a), std::abs(b)) <= kRounding || (a > 0) == (b > 0);
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

std::optional<Cell> nearest_clear(const disc::DiscSpace& space, Spot spot, Poller& poller,
                                  const std::optional<Point>& other) {
  const Grid& blocked = space.blocked_cells();
  std::vector<std::uint64_t> row(static_cast<std::size_t>(blocked.words()));
  const auto words = static_cast<std::int64_t>(2 * space.radius()) + 2;  // looked at for a cell
  const auto clear_row = [&](int y) {
    for (int i = 0; i < blocked.words(); ++i) {
      row[i] = blocked.row(y)[i];
      for (std::uint64_t left = space.band_cells().row(y)[i] & ~row[i]; left != 0;
           left &= left - 1) {
        if (poller.stop_after(words)) return row.data();
        if (!space.clear(centre({64 * i + std::countr_zero(left), y}))) row[i] |= left & (0 - left);
      }
    }
    return row.data();
  };
  std::function<bool(Cell)> joined;
  if (other) joined = [&](Cell at) { return space.joined(centre(at), *other); };
  return nearest_free(blocked, spot, poller, joined, clear_row);
}

std::optional<std::string> disc_path_fault(const Grid& map, double radius,
                                           std::span<const Point> path,
                                           std::span<const CurvePiece> curve) {
  if (path.empty()) return "the path is empty";
  const Judge judge(map, radius);
  for (std::size_t i = 1; i < path.size(); ++i)
    if (auto fault = judge.straight(path[i - 1], path[i])) return fault;
  if (curve.empty()) return std::nullopt;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const CurvePiece& piece = curve[i];
    if (i > 0 && distance(curve[i - 1].to, piece.from) > disc::kSlack)
      return "the curve is broken at " + text(piece.from);
    if (auto fault = piece.turn == 0 ? judge.straight(piece.from, piece.to) : judge.arc(piece))
      return fault;
  }
  if (distance(path.front(), curve.front().from) > 0 || distance(path.back(), curve.back().to) > 0)
    return "the curve's ends are not the path's";
  const double length = path_length(path), curve_length = disc::curve_length(curve);
  // Where pieces meet, points are off by some of the slack, however short the curve is.
  if (length < curve_length - disc::kSlack * (1 + curve_length) || length > curve_length * 1.001)
    return "the path's length is " + number_text(length) + ", the curve's " +
           number_text(curve_length);
  return std::nullopt;
}

}  // namespace lasius
