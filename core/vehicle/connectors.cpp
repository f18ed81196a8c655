#include "core/vehicle/connectors.h"

#include <algorithm>
#include <cmath>

#include "core/vehicle/angle.h"
#include "core/vehicle/steering.h"

namespace lasius::vehicle {
namespace {

class Maker {
 public:
  Maker(const Space::Impl& space, const Lattice& lattice, const Pose& pose, bool towards,
        const ConnectorReach& reach, std::int64_t& checked)
      : space_(space),
        lattice_(lattice),
        pose_(pose),
        towards_(towards),
        reach_(reach),
        checked_(checked) {}

  /// All that lead to a cell.
  void connect(int x, int y) {
    const double dx = x + 0.5 - pose_.x;
    const double dy = y + 0.5 - pose_.y;
    const double squared = dx * dx + dy * dy;
    if (squared > reach_.cells * reach_.cells) return;
    const bool far = squared > reach_.dense * reach_.dense;
    if (far && ((x | y) & 1) != 0) return;
    if (space_.clearance(x + 0.5, y + 0.5) < space_.outline().inside() - 1e-6) return;
    const double distance = std::sqrt(squared);
    const double bearing = distance > 0 ? direction(dy, dx) : pose_.yaw;
    const Vehicle& vehicle = space_.vehicle();
    if (vehicle.turning_radius > 0) {
      by_words(x, y, distance, bearing, 1);
      if (vehicle.reverse && distance > 1e-9) by_words(x, y, distance, bearing, -1);
    }
    if (vehicle.sideways)
      by_slides(x, y);
    else if (vehicle.rotate_in_place)
      by_turns(x, y, distance, bearing);
  }

  std::vector<Connector> found;

 private:
  void by_words(int x, int y, double distance, double bearing, int gear) {
    constexpr double kWidest = 1.3;  // between the line of sight and either heading
    // Along the line of sight the vehicle drives away from the end or towards it.
    const double along = towards_ ? bearing + kPi : bearing;
    const double ahead = gear > 0 ? along : along + kPi;
    if (distance > 1e-9 && std::fabs(half_turned(pose_.yaw - ahead)) > kWidest) return;
    const Vehicle& vehicle = space_.vehicle();
    const double most = reach_.detour * distance + 0.5;
    for (int h = 0; h < Lattice::kHeadings; ++h) {
      if (distance > 1e-9 && std::fabs(half_turned(lattice_.yaw(h) - ahead)) > kWidest) continue;
      const Pose node = lattice_.pose(x, y, h);
      const double length = words_.aim(towards_ ? node : pose_, towards_ ? pose_ : node,
                                       vehicle.turning_radius, gear);
      if (length > most || !words_.motions(motions_) || !free()) continue;
      const int told = motions_.empty() ? 0 : gear;
      found.push_back(
          {x, y, h, gear < 0 ? length * vehicle.reverse_cost : length, told, motions_, 0});
    }
  }

  void by_turns(int x, int y, double distance, double bearing) {
    const Vehicle& vehicle = space_.vehicle();
    for (const int gear : {1, -1}) {
      if (gear < 0 && (!vehicle.reverse || distance < 1e-9)) continue;
      const double along = towards_ ? bearing + kPi : bearing;
      const double yaw = distance < 1e-9 ? pose_.yaw : gear > 0 ? along : along + kPi;
      for (int h = 0; h < Lattice::kHeadings; ++h) {
        // Others are a rotation on the lattice away.
        if (std::fabs(half_turned(lattice_.yaw(h) - yaw)) > kPi / 7) continue;
        const Pose node = lattice_.pose(x, y, h);
        motions_.clear();
        append_turns(towards_ ? node : pose_, towards_ ? pose_ : node, gear, motions_);
        if (!free()) continue;
        const int told = driven_length(motions_) > 0 ? gear : 0;
        found.push_back({x, y, h, cost(vehicle, motions_), told, motions_, 0});
      }
    }
  }

  void by_slides(int x, int y) {
    for (int h = 0; h < Lattice::kHeadings; ++h) {
      // Others are a rotation on the lattice away.
      if (std::fabs(half_turned(lattice_.yaw(h) - pose_.yaw)) > kPi / 7) continue;
      const Pose node = lattice_.pose(x, y, h);
      for (const bool turn_first : {true, false}) {
        motions_.clear();
        append_slide(towards_ ? node : pose_, towards_ ? pose_ : node, turn_first, motions_);
        if (!free()) continue;
        const int told = driven_length(motions_) > 0 ? 1 : 0;
        found.push_back({x, y, h, cost(space_.vehicle(), motions_), told, motions_, 0});
        break;
      }
    }
  }

  bool free() {
    // Far from the end it is likelier to fail.
    return space_.all_free(motions_, Space::Impl::kCoarse, !towards_, checked_) &&
           (!motions_.empty() || space_.free_at(pose_, 0));
  }

  const Space::Impl& space_;
  const Lattice& lattice_;
  Pose pose_;
  bool towards_;
  ConnectorReach reach_;
  std::int64_t& checked_;
  GearWords words_;
  std::vector<Segment> motions_;
};

}  // namespace

std::vector<Connector> connectors(const Space::Impl& space, const Lattice& lattice,
                                  const Pose& pose, bool towards, const ConnectorReach& reach,
                                  std::int64_t& checked, Poller& poller) {
  Maker maker(space, lattice, pose, towards, reach, checked);
  const int left = std::max(0, static_cast<int>(pose.x - reach.cells - 1));
  const int right = std::min(space.width() - 1, static_cast<int>(pose.x + reach.cells + 1));
  const int top = std::max(0, static_cast<int>(pose.y - reach.cells - 1));
  const int bottom = std::min(space.height() - 1, static_cast<int>(pose.y + reach.cells + 1));
  for (int y = top; y <= bottom; ++y) {
    for (int x = left; x <= right; ++x) {
      maker.connect(x, y);
      if (poller.stop_after(256)) return std::move(maker.found);
    }
  }
  return std::move(maker.found);
}

std::vector<Connector> tolerated(const Space::Impl& space, const Lattice& lattice, const Pose& goal,
                                 double far, double turned, Poller& poller) {
  std::vector<Connector> made;
  if (far <= 0) return made;
  for (int y = std::max(0, floor_of(goal.y - far)); y <= goal.y + far && y < space.height(); ++y) {
    if (poller.stop_after(static_cast<std::int64_t>(64 * far))) return made;
    for (int x = std::max(0, floor_of(goal.x - far)); x <= goal.x + far && x < space.width(); ++x) {
      const double dx = x + 0.5 - goal.x;
      const double dy = y + 0.5 - goal.y;
      if (dx * dx + dy * dy > far * far) continue;
      for (int h = 0; h < Lattice::kHeadings; ++h) {
        if (std::fabs(half_turned(lattice.yaw(h) - goal.yaw)) > turned + 1e-12) continue;
        if (!lattice.masks().free(lattice.footprint(h), space.bits(), x, y)) continue;
        made.push_back({.x = x, .y = y, .heading = h, .motions = {}});
      }
    }
  }
  return made;
}

}  // namespace lasius::vehicle
