#include "core/vehicle/steering.h"

#include <algorithm>
#include <cmath>

#include "core/vehicle/angle.h"

namespace lasius::vehicle {
namespace {

constexpr double kNothing = 1e-9;

struct Turns {
  double yaw, length, first, last;  ///< yaw while driving; the angles before and after
};
Turns turns(const Pose& from, const Pose& to, int gear) noexcept {
  const double dx = gear * (to.x - from.x);
  const double dy = gear * (to.y - from.y);
  const double length = std::sqrt(dx * dx + dy * dy);
  if (length < kNothing) return {from.yaw, 0, half_turned(to.yaw - from.yaw), 0};
  const double yaw = direction(dy, dx);
  return {yaw, length, half_turned(yaw - from.yaw), half_turned(to.yaw - yaw)};
}

}  // namespace

void append_turns(const Pose& from, const Pose& to, int gear, std::vector<Segment>& way) {
  const Turns t = turns(from, to, gear);
  Pose at = from;
  const auto rotate = [&](double angle) {
    if (std::fabs(angle) < kNothing) return;
    way.push_back({.begin = at, .gear = 0, .angle = angle});
    at = way.back().end();
  };
  rotate(t.first);
  if (t.length > 0) {
    way.push_back({.begin = at, .length = t.length, .gear = gear});
    at = way.back().end();
  }
  rotate(t.last);
}

void append_slide(const Pose& from, const Pose& to, bool turn_first, std::vector<Segment>& way) {
  const double turned = half_turned(to.yaw - from.yaw);
  Pose at = from;
  const auto put = [&](const Segment& s) {
    if (s.extent() < kNothing) return;
    way.push_back(s);
    at = s.end();
  };
  if (turn_first) put({.begin = at, .gear = 0, .angle = turned});
  const double dx = to.x - at.x;
  const double dy = to.y - at.y;
  put({.begin = at,
       .length = std::sqrt(dx * dx + dy * dy),
       .angle = half_turned(direction(dy, dx) - at.yaw)});
  if (!turn_first) put({.begin = at, .gear = 0, .angle = turned});
}

void Steering::add(const Found& found, int most) {
  const auto at = std::find_if(found_.begin(), found_.begin() + size_,
                               [&](const Found& other) { return found.cost < other.cost; });
  if (at - found_.begin() == most) return;
  found_.insert(at, found);
  size_ = std::min(size_ + 1, most);
  found_.resize(size_);
}

void Steering::aim(const Pose& from, const Pose& to, int most) {
  size_ = 0;
  found_.clear();
  from_ = from;
  to_ = to;
  const double radius = vehicle_.turning_radius;
  if (radius > 0) {
    place_ = seen_from(from, to, radius);
    if (vehicle_.reverse) {
      words_.reeds_shepp(place_, {vehicle_.reverse_cost, vehicle_.cusp_cost / radius});
    } else {
      words_.dubins(place_);
    }
    words_.sort(most);
    for (int i = 0; i < words_.size(); ++i) add({words_[i].cost * radius, i, 1}, most);
  }
  if (vehicle_.sideways) {
    const double dx = to.x - from.x;
    const double dy = to.y - from.y;
    const double turned = std::fabs(half_turned(to.yaw - from.yaw));
    const double price = std::sqrt(dx * dx + dy * dy) + turned * vehicle_.rotation_cost;
    add({price, -1, 1}, most);
    if (turned > kNothing) add({price, -1, -1}, most);
    return;
  }
  if (!vehicle_.rotate_in_place) return;
  for (const int gear : {1, -1}) {
    if (gear < 0 && !vehicle_.reverse) continue;
    const Turns t = turns(from, to, gear);
    const double cell = gear < 0 ? vehicle_.reverse_cost : 1;
    add({t.length * cell + (std::fabs(t.first) + std::fabs(t.last)) * vehicle_.rotation_cost, -1,
         gear},
        most);
  }
}

bool Steering::append(int i, std::vector<Segment>& to) const {
  const Found& found = found_[i];
  if (found.word < 0 && vehicle_.sideways) {
    append_slide(from_, to_, found.gear > 0, to);
    return true;
  }
  if (found.word < 0) {
    append_turns(from_, to_, found.gear, to);
    return true;
  }
  if (!ends_at(words_[found.word], place_)) return false;
  vehicle::append(words_[found.word], from_, vehicle_.turning_radius, to);
  return true;
}

double Steering::least(const Pose& from, const Pose& to) {
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const double line = std::sqrt(dx * dx + dy * dy);
  const double radius = vehicle_.turning_radius;
  if (vehicle_.rotate_in_place || radius == 0) return line;
  words_.unpriced(seen_from(from, to, radius), vehicle_.reverse);
  return words_.least() * radius;
}

}  // namespace lasius::vehicle
