#include "tests/oracle/vehicle/footprint_judge.h"

#include <algorithm>
#include <cmath>

namespace lasius::oracle {
namespace {

double cross(Point o, Point a, Point b) {
  return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

bool holds(const std::array<Point, 3>& t, Point p) {
  return cross(t[0], t[1], p) >= 0 && cross(t[1], t[2], p) >= 0 && cross(t[2], t[0], p) >= 0;
}

/// Ears are cut off until a triangle is left.
std::vector<std::array<Point, 3>> triangles_of(std::vector<Point> polygon) {
  double area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    area += cross({0, 0}, polygon[i], polygon[(i + 1) % polygon.size()]);
  if (area < 0) std::ranges::reverse(polygon);
  std::vector<std::array<Point, 3>> triangles;
  while (polygon.size() >= 3) {
    const std::size_t n = polygon.size();
    std::size_t ear = n;
    for (std::size_t i = 0; i < n && ear == n; ++i) {
      const std::array<Point, 3> t{polygon[(i + n - 1) % n], polygon[i], polygon[(i + 1) % n]};
      if (cross(t[0], t[1], t[2]) < 0) continue;
      const bool free = std::ranges::none_of(polygon, [&](Point p) {
        return !(p == t[0]) && !(p == t[1]) && !(p == t[2]) && holds(t, p);
      });
      if (free) ear = i;
    }
    if (ear == n) ear = 0;  // of a polygon that crosses itself, which nobody judges
    triangles.push_back({polygon[(ear + n - 1) % n], polygon[ear], polygon[(ear + 1) % n]});
    polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  return triangles;
}

/// How deep a triangle is in a unit square, by the axis along which that is least; below 0 apart.
double depth(const std::array<Point, 3>& triangle, Cell cell) {
  const double x = cell.x, y = cell.y;
  const std::array<Point, 4> square{{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}};
  double least = 1e9;
  const auto along = [&](Point axis) {
    const double size = std::hypot(axis.x, axis.y);
    if (size == 0) return;
    const auto extent = [&](const auto& corners) {
      double low = 1e18, high = -1e18;
      for (const Point p : corners) {
        const double at = (p.x * axis.x + p.y * axis.y) / size;
        low = std::min(low, at);
        high = std::max(high, at);
      }
      return std::array<double, 2>{low, high};
    };
    const auto a = extent(triangle), b = extent(square);
    least = std::min({least, a[1] - b[0], b[1] - a[0]});
  };
  along({1, 0});
  along({0, 1});
  for (std::size_t i = 0; i < 3; ++i) {
    const Point p = triangle[i], q = triangle[(i + 1) % 3];
    along({q.y - p.y, p.x - q.x});
  }
  return least;
}

}  // namespace

FootprintJudge::FootprintJudge(const Grid& grid, const std::vector<Point>& footprint)
    : grid_(grid), triangles_(triangles_of(footprint)) {
  for (const Point p : footprint) reach_ = std::max(reach_, std::hypot(p.x, p.y));
}

std::optional<Cell> FootprintJudge::touched(double x, double y, double yaw) const {
  constexpr double kDeep = 1e-9;
  const double c = std::cos(yaw), s = std::sin(yaw);
  for (const Triangle& triangle : triangles_) {
    Triangle at;
    for (std::size_t i = 0; i < 3; ++i)
      at[i] = {x + c * triangle[i].x - s * triangle[i].y,
               y + s * triangle[i].x + c * triangle[i].y};
    const auto columns = std::minmax({at[0].x, at[1].x, at[2].x});
    const auto rows = std::minmax({at[0].y, at[1].y, at[2].y});
    for (int row = static_cast<int>(std::floor(rows.first)) - 1; row <= rows.second; ++row)
      for (int column = static_cast<int>(std::floor(columns.first)) - 1; column <= columns.second;
           ++column) {
        const Cell cell{column, row};
        if (grid_.blocked(cell) && depth(at, cell) > kDeep) return cell;
      }
  }
  return std::nullopt;
}

std::array<double, 3> FootprintJudge::pose_at(const Motion& m, double share) {
  if (m.gear == 0) return {m.x, m.y, m.yaw + share * m.angle};
  const double far = m.gear * share * m.length;
  const double yaw = m.yaw + m.curvature * far + m.rate * far * far / 2;
  if (m.rate != 0) {
    // Simpson's rule.
    constexpr int kParts = 500;
    std::array<double, 3> at{m.x, m.y, yaw};
    for (int i = 0; i <= kParts; ++i) {
      const double s = far * i / kParts, turned = m.yaw + m.curvature * s + m.rate * s * s / 2;
      const double share_of = (i == 0 || i == kParts ? 1 : i % 2 == 1 ? 4 : 2) * far / kParts / 3;
      at[0] += share_of * std::cos(turned);
      at[1] += share_of * std::sin(turned);
    }
    return at;
  }
  if (m.angle != 0 && m.curvature == 0)
    return {m.x + far * std::cos(m.yaw + m.angle), m.y + far * std::sin(m.yaw + m.angle), yaw};
  if (std::abs(m.curvature * far) < 1e-7)
    return {m.x + far * std::cos((m.yaw + yaw) / 2), m.y + far * std::sin((m.yaw + yaw) / 2), yaw};
  return {m.x + (std::sin(yaw) - std::sin(m.yaw)) / m.curvature,
          m.y - (std::cos(yaw) - std::cos(m.yaw)) / m.curvature, yaw};
}

std::optional<Touch> FootprintJudge::first_touch(std::span<const Motion> path, double step) {
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Motion& m = path[i];
    const double extent = m.gear == 0 ? std::abs(m.angle) * std::max(reach_, 1.) : m.length;
    const int parts = std::max(1, static_cast<int>(std::ceil(extent / step)));
    for (int part = 0; part <= parts; ++part) {
      const auto [x, y, yaw] = pose_at(m, static_cast<double>(part) / parts);
      ++poses_;
      if (const auto cell = touched(x, y, yaw)) return Touch{i, x, y, yaw, *cell};
    }
  }
  return std::nullopt;
}

}  // namespace lasius::oracle
