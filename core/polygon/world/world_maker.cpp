#include "core/polygon/world/world_maker.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <iterator>

#include "core/base/invalid_parameter.h"
#include "core/polygon/world/geometry_check.h"
#include "core/polygon/world/rings.h"

namespace lasius::polygon {
namespace {

double area(const Ring& ring) { return std::abs(doubled_area(ring)); }

bool is_number(Point p) {
  return std::abs(p.x) <= kMostCoordinate && std::abs(p.y) <= kMostCoordinate;
}

bool all_numbers(const Polygon& polygon) {
  return std::ranges::all_of(
      rings_of(polygon), [](const Ring* ring) { return std::ranges::all_of(*ring, is_number); });
}

/// Names and EPSG codes of the usual systems whose coordinates are longitude and latitude.
constexpr std::array<std::string_view, 26> kInDegrees{
    "CRS84", "CRS84H", "CRS83", "CRS27", "WGS84", "4019", "4148", "4152", "4167",
    "4171",  "4230",   "4258",  "4267",  "4269",  "4277", "4283", "4314", "4322",
    "4326",  "4490",   "4612",  "4617",  "4674",  "4979", "6318", "6668"};

constexpr const char* kPointProblem = "has a coordinate that is no number within 1e12";
constexpr const char* kCorrect = "correct the ring";
constexpr const char* kCorrectLine = "correct the line";
constexpr const char* kRepair = "correct the ring, or read the world with --repair";

}  // namespace

Repair WorldMaker::checked(Polygon polygon, bool is_boundary, const std::string& place) {
  const bool numbers = all_numbers(polygon);
  if (numbers) {
    drop_repeats(polygon.outer);
    for (Ring& hole : polygon.holes) drop_repeats(hole);
  }
  const auto wrong = fault(geos_, polygon);
  if (!wrong) return {{std::move(polygon)}, {}, {}};
  if (!numbers) fail_(place, *wrong, kCorrect);
  if (!options_.repair) fail_(place, *wrong, kRepair);
  Repair repair;
  try {
    repair = repaired(geos_, polygon, is_boundary);
  } catch (const Error& error) {
    fail_(place, error.problem(), error.remedy());
  }
  for (Ring& line : repair.lines)
    if (!wall_fault(line)) add_wall(std::move(line), place);  // else a point
  return repair;
}

void WorldMaker::add_boundary(Polygon polygon, const std::string& place) {
  if (has_boundary_) fail_(place, "is a second boundary", "give one boundary, and obstacles in it");
  auto [parts, holes, walls] = checked(std::move(polygon), true, place);
  if (parts.empty()) fail_(place, "encloses no area", "draw the boundary around the free space");
  world_.boundary = std::move(*std::ranges::max_element(
      parts, [](const Polygon& a, const Polygon& b) { return area(a.outer) < area(b.outer); }));
  std::ranges::move(holes, std::back_inserter(world_.obstacles));
  has_boundary_ = true;
}

void WorldMaker::add_obstacle(Polygon polygon, const std::string& place) {
  auto parts = checked(std::move(polygon), false, place).areas;
  std::ranges::move(parts, std::back_inserter(world_.obstacles));
}

void WorldMaker::add_wall(Ring line, const std::string& place) {
  if (const auto wrong = wall_fault(line)) fail_(place, *wrong, kCorrectLine);
  line.erase(std::unique(line.begin(), line.end()), line.end());
  world_.walls.push_back(std::move(line));
}

Ring WorldMaker::closed(Ring points, const std::string& place) const {
  if (points.size() > 1 && points.front() == points.back())
    points.pop_back();
  else if (!options_.repair)
    fail_(place, "is not closed", "end it with its first point, or read the world with --repair");
  return points;
}

void WorldMaker::set_crs(std::string_view name) {
  // "urn:ogc:def:crs:OGC:1.3:CRS84", "EPSG:4326", "http://www.opengis.net/def/crs/EPSG/0/4326".
  const std::string_view code = name.substr(name.find_last_of(":/#") + 1);
  if (std::ranges::find(kInDegrees, code) == kInDegrees.end() || !world_.notes.empty()) return;
  world_.notes.push_back(
      "the coordinates are degrees (" + std::string(name) +
      "), and a length in degrees is no distance: project them first, to UTM say");
}

void WorldMaker::add_point(std::optional<Point>& to, Point p, const std::string& what,
                           const std::string& place) {
  if (to) fail_(place, "is a second " + what, "give one " + what);
  if (!is_number(p)) fail_(place, kPointProblem, "correct it");
  to = p;
}

void WorldMaker::set_margin(double margin, const std::string& place) {
  if (const auto wrong = margin_fault(margin)) fail_(place, *wrong, kMarginRemedy);
  if (has_margin_) fail_(place, "the margin is given again", "keep one of them");
  has_margin_ = true;
  world_.margin = margin;
}

World WorldMaker::finish() {
  if (!has_boundary_)
    fail_("", "the world has no boundary", "add a polygon with the role \"boundary\"");
  return std::move(world_);
}

void check(const World& world) {
  if (const auto wrong = margin_fault(world.margin)) refuse(*wrong, kMarginRemedy);
  const auto look_at = [&](const std::optional<Point>& p, const std::string& what) {
    if (p && !is_number(*p)) refuse(what + " " + kPointProblem, "correct it");
  };
  look_at(world.start, "start");
  look_at(world.goal, "goal");
  const Geos geos;
  const auto look = [&](const Polygon& polygon, const std::string& what) {
    if (const auto wrong = fault(geos, polygon)) refuse(what + ": " + *wrong, kCorrect);
  };
  look(world.boundary, "boundary");
  for (std::size_t i = 0; i < world.obstacles.size(); ++i)
    look(world.obstacles[i], "obstacle " + std::to_string(i));
  for (std::size_t i = 0; i < world.walls.size(); ++i) {
    if (const auto wrong = wall_fault(world.walls[i]))
      refuse("wall " + std::to_string(i) + ": " + *wrong, kCorrectLine);
  }
}

std::uint64_t hash(const World& world) noexcept {
  std::uint64_t value = 0xcbf29ce484222325u;  // FNV-1a over the bytes of all numbers
  const auto mix = [&](std::uint64_t word) {
    for (int byte = 0; byte < 8; ++byte)
      value = (value ^ (word >> 8 * byte & 0xff)) * 0x100000001b3;
  };
  const auto mix_real = [&](double x) { mix(std::bit_cast<std::uint64_t>(x + 0.0)); };
  const auto mix_ring = [&](const Ring& ring) {
    mix(ring.size());
    for (const Point p : ring) {
      mix_real(p.x);
      mix_real(p.y);
    }
  };
  const auto mix_polygon = [&](const Polygon& p) {
    mix_ring(p.outer);
    mix(p.holes.size());
    for (const Ring& hole : p.holes) mix_ring(hole);
  };
  mix_polygon(world.boundary);
  mix(world.obstacles.size());
  for (const Polygon& p : world.obstacles) mix_polygon(p);
  for (const auto& p : {world.start, world.goal}) {
    mix(p ? 1 : 0);
    mix_real(p ? p->x : 0);
    mix_real(p ? p->y : 0);
  }
  mix_real(world.margin);
  for (const Ring& wall : world.walls) mix_ring(wall);
  return value;
}

}  // namespace lasius::polygon
