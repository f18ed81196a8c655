#include "core/polygon/world_maker.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>

#include "core/base/invalid_parameter.h"
#include "core/polygon/geometry_check.h"
#include "core/polygon/rings.h"

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

constexpr const char* kPointProblem = "has a coordinate that is no number within 1e12";
constexpr const char* kCorrect = "correct the ring";
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
  if (repair.lines.empty()) return repair;
  const auto& line = repair.lines.front();
  fail_(place, "has a part without width, from " + text(line.front()) + " to " + text(line.back()),
        "give it a width, or take it out");
  return repair;
}

void WorldMaker::add_boundary(Polygon polygon, const std::string& place) {
  if (has_boundary_) fail_(place, "is a second boundary", "give one boundary, and obstacles in it");
  auto [parts, holes, lines] = checked(std::move(polygon), true, place);
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
  if (!has_boundary_) {
    fail_("", "the world has no boundary", "add a polygon with the role \"boundary\"");
  }
  return std::move(world_);
}

void check(const World& world) {
  const auto refuse = [](const std::string& problem, const std::string& remedy) {
    throw invalid_parameter(problem, remedy);
  };
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
  for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
    look(world.obstacles[i], "obstacle " + std::to_string(i));
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
  return value;
}

}  // namespace lasius::polygon
