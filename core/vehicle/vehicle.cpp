#include "lasius/vehicle/vehicle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/base/invalid_parameter.h"

namespace lasius::vehicle {
namespace {

constexpr int kMostCorners = 256;
constexpr double kFarthest = 1024;

double cross(Point a, Point b, Point c) noexcept {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double distance_to(Point a, Point b) noexcept {  // from the origin to the segment
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double squared = dx * dx + dy * dy;
  const double share = squared > 0 ? std::clamp(-(a.x * dx + a.y * dy) / squared, 0.0, 1.0) : 0;
  const double x = a.x + share * dx;
  const double y = a.y + share * dy;
  return std::sqrt(x * x + y * y);
}

/// Whether two edges meet in a point.
bool meet(Point a, Point b, Point c, Point d) noexcept {
  const auto side = [](double v) { return v > 0 ? 1 : v < 0 ? -1 : 0; };
  const auto between = [](Point p, Point q, Point r) {
    return std::min(p.x, q.x) <= r.x && r.x <= std::max(p.x, q.x) && std::min(p.y, q.y) <= r.y &&
           r.y <= std::max(p.y, q.y);
  };
  const int abc = side(cross(a, b, c)), abd = side(cross(a, b, d));
  const int cda = side(cross(c, d, a)), cdb = side(cross(c, d, b));
  if (abc != abd && cda != cdb && abc * abd <= 0 && cda * cdb <= 0) return true;
  return (abc == 0 && between(a, b, c)) || (abd == 0 && between(a, b, d)) ||
         (cda == 0 && between(c, d, a)) || (cdb == 0 && between(c, d, b));
}

void check_simple(const std::vector<Point>& corners) {
  const std::size_t n = corners.size();
  const auto at = [&](std::size_t i) { return corners[i % n]; };
  for (std::size_t i = 0; i < n; ++i) {
    const bool same = at(i) == at(i + 1);
    const bool back = cross(at(i), at(i + 1), at(i + 2)) == 0 &&
                      (at(i + 1).x - at(i).x) * (at(i + 2).x - at(i + 1).x) +
                              (at(i + 1).y - at(i).y) * (at(i + 2).y - at(i + 1).y) <
                          0;
    bool crossed = false;
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;  // neighbours
      crossed = crossed || meet(at(i), at(i + 1), at(j), at(j + 1));
    }
    if (!same && !back && !crossed) continue;
    throw invalid_parameter("edge " + std::to_string(i + 1) + " of the footprint " +
                                (same   ? "has no length"
                                 : back ? "is gone back by the next one"
                                        : "meets another one"),
                            "give the corners of a simple polygon in order");
  }
}

}  // namespace

Vehicle car(std::vector<Point> footprint, double turning_radius) {
  return {.footprint = std::move(footprint), .turning_radius = turning_radius, .reverse = true};
}

Vehicle differential(std::vector<Point> footprint) {
  return {.footprint = std::move(footprint), .rotate_in_place = true};
}

Vehicle omni(std::vector<Point> footprint) {
  return {.footprint = std::move(footprint), .rotate_in_place = true, .sideways = true};
}

std::vector<Point> rectangle(double back, double front, double half_width) {
  return {{-back, -half_width}, {front, -half_width}, {front, half_width}, {-back, half_width}};
}

void validate(const Vehicle& vehicle) {
  const std::vector<Point>& corners = vehicle.footprint;
  if (corners.size() < 3 || corners.size() > kMostCorners) {
    throw invalid_parameter("the footprint has " + std::to_string(corners.size()) + " corners",
                            "give 3 to " + std::to_string(kMostCorners));
  }
  for (const Point& corner : corners) {
    const double reach = std::sqrt(corner.x * corner.x + corner.y * corner.y);
    require_parameter(reach <= kFarthest, "the distance of a corner of the footprint", reach,
                      "at most 1024 cells from the reference point");
  }
  check_simple(corners);
  const auto in = [](double value, double least, double most) {
    return value >= least && value <= most;
  };
  require_parameter(in(vehicle.turning_radius, 0, kMostTurningRadius), "turning_radius",
                    vehicle.turning_radius, "give 0 to 100000 cells");
  require_parameter(vehicle.turning_radius == 0 || vehicle.turning_radius >= 0.1, "turning_radius",
                    vehicle.turning_radius, "give 0 or at least 0.1 cells");
  require_parameter(vehicle.turning_radius > 0 || vehicle.rotate_in_place, "turning_radius",
                    vehicle.turning_radius,
                    "give one above 0 or let the vehicle rotate in place, else it cannot turn");
  require_parameter(!vehicle.sideways || vehicle.turning_radius == 0, "turning_radius",
                    vehicle.turning_radius, "give none to what drives to any side");
  if (vehicle.sideways && vehicle.reverse)
    throw invalid_parameter("reverse is true",
                            "leave it out: what drives to any side drives back at the same price");
  require_parameter(in(vehicle.reverse_cost, 1, 1000), "reverse_cost", vehicle.reverse_cost,
                    "give 1 to 1000");
  const double radius = vehicle.turning_radius;
  const double slowest = radius > 0 ? 0.01 / (radius * radius) : 0;
  require_parameter(vehicle.curvature_rate == 0 || in(vehicle.curvature_rate, slowest, 1e6),
                    "curvature_rate", vehicle.curvature_rate,
                    "give 0 for no limit, or at least a hundredth of 1 / turning_radius^2");
  require_parameter(in(vehicle.cusp_cost, 0, 1e5), "cusp_cost", vehicle.cusp_cost,
                    "give 0 to 100000 cells");
  require_parameter(in(vehicle.rotation_cost, 0.001, 1e5), "rotation_cost", vehicle.rotation_cost,
                    "give 0.001 to 100000 cells a radian");
}

double circumscribed_radius(const Vehicle& vehicle) noexcept {
  double most = 0;
  for (const Point& p : vehicle.footprint) most = std::max(most, p.x * p.x + p.y * p.y);
  return std::sqrt(most);
}

double inscribed_radius(const Vehicle& vehicle) noexcept {
  const std::vector<Point>& corners = vehicle.footprint;
  double least = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (std::size_t i = 0, n = corners.size(); i < n; ++i) {
    const Point a = corners[i];
    const Point b = corners[(i + 1) % n];
    least = std::min(least, distance_to(a, b));
    if ((a.y > 0) != (b.y > 0) && a.x - a.y * (b.x - a.x) / (b.y - a.y) > 0) inside = !inside;
  }
  return inside ? least : 0;
}

}  // namespace lasius::vehicle
