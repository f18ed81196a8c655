#include "tools/vehicle/vehicle_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tools/console/values.h"
#include "tools/vehicle/path_file.h"

namespace lasius::tool {
namespace {

using vehicle::Segment;

double length_of(const DrivenPath::Piece& piece) {
  return piece.motion ? piece.motion->length
                      : std::hypot(piece.to.x - piece.from.x, piece.to.y - piece.from.y);
}

double turned(const vehicle::Pose& from, const vehicle::Pose& to) {
  return std::remainder(to.yaw - from.yaw, 2 * std::numbers::pi);
}

/// How far from one of the map's own cells.
std::string cell_text(const Grid& grid, Cell cell) {
  return (grid.contains(cell) ? "the blocked cell (" : "the outside of the map, cell (") +
         std::to_string(cell.x) + ", " + std::to_string(cell.y) + ")";
}

/// The clothoid of that curvature at `from`, whose chord is as long as theirs and which turns as
/// they do; nothing where it ends elsewhere.
std::optional<Segment> clothoid_between(const vehicle::Pose& from, const vehicle::Pose& to,
                                        int gear, double curvature) {
  const double turned = std::remainder(to.yaw - from.yaw, 2 * std::numbers::pi);
  const double chord = std::hypot(to.x - from.x, to.y - from.y);
  Segment motion{.begin = from, .curvature = curvature, .length = chord, .gear = gear};
  // The chord is nearly all of the length: each round leaves a small part of what is missing.
  for (int round = 0; round < 10; ++round) {
    const double s = gear * motion.length;
    motion.curvature_rate = 2 * (turned - curvature * s) / (s * s);
    const vehicle::Pose end = motion.end();
    motion.length *= chord / std::hypot(end.x - from.x, end.y - from.y);
    if (!(motion.length < 2 * chord)) return std::nullopt;
  }
  const vehicle::Pose end = motion.end();
  if (!(std::hypot(end.x - to.x, end.y - to.y) <= kOnePlace)) return std::nullopt;
  return motion;
}

}  // namespace

std::optional<Segment> motion_between(const vehicle::Pose& from, const vehicle::Pose& to,
                                      const std::optional<TwoCurvatures>& told) {
  constexpr double kStill = 1e-9;  // cells
  Segment motion{.begin = from};
  const double x = to.x - from.x, y = to.y - from.y;
  const double turned = std::remainder(to.yaw - from.yaw, 2 * std::numbers::pi);
  if (std::hypot(x, y) <= kStill) {
    motion.gear = turned == 0 ? 1 : 0;
    motion.angle = turned;
    return motion;
  }
  // An arc's chord looks half way between its ends.
  const double middle = from.yaw + turned / 2;
  const double along = x * std::cos(middle) + y * std::sin(middle);
  const double across = y * std::cos(middle) - x * std::sin(middle);
  if (std::abs(across) > kOnePlace) {
    if (!told) return std::nullopt;
    const int gear = along < 0 ? -1 : 1;
    if (auto clothoid = clothoid_between(from, to, gear, told->from)) return clothoid;
    // From its end, driven the other way.
    auto back = clothoid_between(to, from, -gear, told->to);
    if (!back) return std::nullopt;
    back->curvature = back->curvature_at(back->length);
    back->begin = from;
    back->gear = gear;
    return back;
  }
  const double half = turned / 2;
  const double stretch = std::abs(half) < 1e-6 ? 1 + half * half / 6 : half / std::sin(half);
  motion.gear = along < 0 ? -1 : 1;
  motion.length = std::abs(along) * stretch;
  if (motion.length <= kStill) return std::nullopt;
  motion.curvature = motion.gear * turned / motion.length;
  return motion;
}

DrivenPath driven(std::span<const Segment> segments) {
  DrivenPath path;
  for (const Segment& segment : segments) {
    path.pieces.push_back({segment.begin, segment.end(), segment});
    path.length += segment.length;
  }
  return path;
}

DrivenPath driven(std::span<const vehicle::Pose> poses, std::span<const double> curvatures) {
  DrivenPath path{.pieces = {}, .sampled = true};
  if (poses.size() == 1) path.pieces.push_back({poses[0], poses[0], Segment{.begin = poses[0]}});
  for (std::size_t i = 1; i < poses.size(); ++i) {
    std::optional<TwoCurvatures> told;
    if (!curvatures.empty()) told = {curvatures[i - 1], curvatures[i]};
    path.pieces.push_back({poses[i - 1], poses[i], motion_between(poses[i - 1], poses[i], told)});
    path.length += length_of(path.pieces.back());
    if (!path.pieces.back().motion) ++path.assumed_straight;
  }
  return path;
}

std::optional<VehicleFault> contact_fault(const Grid& grid, const vehicle::Space& space,
                                          const DrivenPath& path) {
  double along = 0;
  for (const DrivenPath::Piece& piece : path.pieces) {
    const std::array<vehicle::Pose, 2> ends{piece.from, piece.to};
    const auto met = piece.motion ? space.first_contact(std::span(&*piece.motion, 1))
                                  : space.first_contact(std::span<const vehicle::Pose>(ends));
    const double length = length_of(piece);
    if (met) {
      const double driven = !piece.motion             ? met->at * length
                            : piece.motion->gear == 0 ? 0
                                                      : met->at;
      VehicleFault fault;
      fault.along = along + driven;
      fault.at = {met->pose.x, met->pose.y};
      fault.cell = met->cell;
      fault.pose = met->pose;
      fault.why = (met->proven ? "the footprint meets " : "the footprint may meet ") +
                  cell_text(grid, met->cell);
      return fault;
    }
    along += length;
  }
  return std::nullopt;
}

std::optional<VehicleFault> motion_fault(const vehicle::Vehicle& vehicle, const DrivenPath& path,
                                         std::span<const double> curvatures) {
  // Tables hold rounded poses: of two so far apart, a curvature is known no better.
  constexpr double kShare = 1e-2, kRounding = 1e-4;  // of the curvature; cells, and radians
  constexpr double kExact = 1e-9;
  const double most = vehicle.turning_radius > 0 ? 1 / vehicle.turning_radius : 0;
  double along = 0;
  for (std::size_t i = 0; i < path.pieces.size(); ++i) {
    const DrivenPath::Piece& piece = path.pieces[i];
    const double length = length_of(piece), angle = turned(piece.from, piece.to);
    const auto fault = [&](const std::string& why) {
      VehicleFault found;
      found.along = along;
      found.at = {piece.from.x, piece.from.y};
      found.pose = piece.from;
      found.why = why;
      return found;
    };
    if (!path.sampled && i > 0) {
      const vehicle::Pose& before = path.pieces[i - 1].to;
      const double jump = std::hypot(piece.from.x - before.x, piece.from.y - before.y);
      constexpr double kJump = 1e-6;
      if (jump > kJump || std::abs(turned(before, piece.from)) > kJump)
        return fault("the path jumps by " + to_text(jump) + " cells and " +
                     to_text(std::abs(turned(before, piece.from))) + " radians");
    }
    if (vehicle.sideways) {
      along += length;
      continue;
    }
    const bool aside = piece.motion && piece.motion->gear != 0 && piece.motion->angle != 0;
    if (!piece.motion || aside) return fault("the vehicle would slip aside");
    const Segment& motion = *piece.motion;
    if (motion.gear == 0 && !vehicle.rotate_in_place && std::abs(angle) > kRounding)
      return fault("it turns in place, which the vehicle does not");
    if (motion.gear < 0 && !vehicle.reverse && length > kRounding)
      return fault("it drives backwards, which the vehicle does not");
    if (!path.sampled && vehicle.curvature_rate > 0 &&
        std::abs(motion.curvature_rate) > vehicle.curvature_rate * (1 + kExact))
      return fault("its curvature changes faster than the vehicle's can: by " +
                   to_text(std::abs(motion.curvature_rate)) + " a cell, " +
                   to_text(vehicle.curvature_rate) + " is its most");
    if (motion.gear != 0) {
      const double room = path.sampled ? kShare * most + kRounding / std::max(length, kRounding)
                                       : kExact * std::max(most, 1.);
      double sharpest = motion.sharpest();
      if (i < curvatures.size()) sharpest = std::max(sharpest, std::abs(curvatures[i]));
      if (sharpest > most + room)
        return fault("it turns sharper than the vehicle can: on a radius of " +
                     rounded_text(1 / sharpest, 4) + " cells, " +
                     (most == 0 ? "and it drives straight only"
                                : rounded_text(vehicle.turning_radius, 4) + " is its least"));
    }
    along += length;
  }
  return std::nullopt;
}

}  // namespace lasius::tool
