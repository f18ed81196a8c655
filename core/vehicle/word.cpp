#include "core/vehicle/word.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/vehicle/angle.h"

namespace lasius::vehicle {

Place seen_from(const Pose& from, const Pose& to, double radius) noexcept {
  const auto [sine, cosine] = kernels::sine_cosine(from.yaw);
  const double dx = (to.x - from.x) / radius;
  const double dy = (to.y - from.y) / radius;
  return {dx * cosine + dy * sine, dy * cosine - dx * sine, half_turned(to.yaw - from.yaw)};
}

void Words::clear() noexcept {
  size_ = 0;
  least_ = std::numeric_limits<double>::infinity();
}

void Words::add(const Word& word) noexcept {
  order_[size_] = size_;
  words_[size_++] = word;
  least_ = std::min(least_, word.cost);
}

void Words::sort(int most) noexcept {
  const auto before = [&](int a, int b) {
    return words_[a].cost != words_[b].cost ? words_[a].cost < words_[b].cost : a < b;
  };
  const int kept = std::min(most, size_);
  std::partial_sort(order_.begin(), order_.begin() + kept, order_.begin() + size_, before);
  size_ = kept;
}

// Shkel & Lumelsky (2001), with the centres of the two circles in place of their cosines' rule.
void Words::dubins(const Place& to) noexcept {
  clear();
  const auto put = [&](double t, double p, double q, int first, int middle, int last) {
    const auto turn = [](int side) { return static_cast<signed char>(side); };
    add({{t, p, q}, {turn(first), turn(middle), turn(last)}, 3, t + p + q});
  };
  const auto [sine, cosine] = kernels::sine_cosine(to.yaw);
  for (const int side : {1, -1}) {
    // As if the first turn were to the left: else all is mirrored.
    const double y = side * to.y;
    const double yaw = side * to.yaw;
    const double s = side * sine;
    const double same_x = to.x - s;  // from the first circle's centre to the last one's
    const double same_y = y + cosine - 1;
    const double same = same_x * same_x + same_y * same_y;
    // Of one circle alone any bearing would do: the first turn is left out.
    const double bearing = same < 1e-16 ? 0 : direction(same_y, same_x);
    const double t = turned(bearing);
    put(t, std::sqrt(same), turned(yaw - t), side, 0, side);
    if (same <= 16) {
      const double turn = kTurn - arc_cosine(1 - same / 8);
      const double first = turned(bearing + turn / 2);
      put(first, turn, turned(yaw - first + turn), side, -side, side);
    }
    const double other_x = to.x + s;
    const double other_y = y - cosine - 1;
    const double other = other_x * other_x + other_y * other_y;
    if (other >= 4 - 1e-13) {
      const double straight = std::sqrt(std::max(0.0, other - 4));
      const double heading = direction(other_y, other_x) + direction(2, straight);
      put(turned(heading), straight, turned(heading - yaw), side, 0, -side);
    }
  }
}

void Words::unpriced(const Place& to, bool reverse) noexcept {
  if (reverse) {
    reeds_shepp(to, {});
  } else {
    dubins(to);
  }
}

void append(const Word& word, const Pose& from, double radius, std::vector<Segment>& to) {
  Pose at = from;
  for (int i = 0; i < word.count; ++i) {
    const double length = std::fabs(word.length[i]) * radius;
    if (length < 1e-9) continue;
    to.push_back({.begin = at,
                  .curvature = word.turn[i] / radius,
                  .length = length,
                  .gear = word.length[i] < 0 ? -1 : 1});
    at = to.back().end();
  }
}

bool ends_at(const Word& word, const Place& to) noexcept {
  Pose at;
  for (int i = 0; i < word.count; ++i) {
    at = Segment{.begin = at,
                 .curvature = static_cast<double>(word.turn[i]),
                 .length = std::fabs(word.length[i]),
                 .gear = word.length[i] < 0 ? -1 : 1}
             .end();
  }
  return std::fabs(at.x - to.x) <= 1e-9 && std::fabs(at.y - to.y) <= 1e-9 &&
         std::fabs(half_turned(at.yaw - to.yaw)) <= 1e-9;
}

double GearWords::aim(const Pose& from, const Pose& to, double radius, int gear) noexcept {
  const double flip = gear < 0 ? kPi : 0;
  from_ = {from.x, from.y, from.yaw + flip};
  place_ = seen_from(from_, {to.x, to.y, to.yaw + flip}, radius);
  radius_ = radius;
  gear_ = gear;
  words_.dubins(place_);
  return words_.least() * radius;
}

bool GearWords::motions(std::vector<Segment>& to) {
  words_.sort(1);
  to.clear();
  append(words_[0], from_, radius_, to);
  if (gear_ < 0) {
    for (Segment& s : to) {
      s.begin.yaw -= kPi;
      s.curvature = -s.curvature;
      s.gear = -1;
    }
  }
  return ends_at(words_[0], place_);
}

double free_length(const Pose& from, const Pose& to, double radius, bool reverse) {
  Words words;
  words.unpriced(seen_from(from, to, radius), reverse);
  return words.least() * radius;
}

std::vector<Segment> free_way(const Pose& from, const Pose& to, double radius, bool reverse) {
  Words words;
  const Place place = seen_from(from, to, radius);
  words.unpriced(place, reverse);
  words.sort(48);
  std::vector<Segment> way;
  int i = 0;
  while (i + 1 < words.size() && !ends_at(words[i], place)) ++i;
  append(words[i], from, radius, way);
  return way;
}

}  // namespace lasius::vehicle
