// Reeds & Shepp (1990): formulas 8.1 to 8.11, each with its mirror images in time and in space.
#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "core/vehicle/angle.h"
#include "core/vehicle/word.h"

namespace lasius::vehicle {
namespace {

constexpr double kZero = 1e-10;
constexpr double kRightAngle = kPi / 2;

struct Lengths {
  bool found = false;
  double t = 0, u = 0, v = 0;
};

struct Polar {
  double radius, angle;
};
Polar polar(double x, double y) noexcept { return {std::sqrt(x * x + y * y), direction(y, x)}; }

/// A place with the sine and cosine of its yaw.
struct Seen {
  double x, y, yaw, sine, cosine;
};

Lengths left_straight_left(const Seen& to) noexcept {  // 8.1
  const Polar p = polar(to.x - to.sine, to.y - 1 + to.cosine);
  const double v = half_turned(to.yaw - p.angle);
  return {p.angle >= -kZero && v >= -kZero, p.angle, p.radius, v};
}
Lengths left_straight_right(const Seen& to) noexcept {  // 8.2
  const Polar p = polar(to.x + to.sine, to.y - 1 - to.cosine);
  const double squared = p.radius * p.radius - 4;
  if (squared < -1e-13) return {};
  const double u = std::sqrt(std::max(0.0, squared));
  const double t = half_turned(p.angle + direction(2, u));
  const double v = half_turned(t - to.yaw);
  return {t >= -kZero && v >= -kZero, t, u, v};
}
Lengths left_right_left(const Seen& to) noexcept {  // 8.3, 8.4
  const Polar p = polar(to.x - to.sine, to.y - 1 + to.cosine);
  if (p.radius > 4) return {};
  const double u = -2 * arc_sine(p.radius / 4);
  const double t = half_turned(p.angle + u / 2 + kPi);
  const double v = half_turned(to.yaw - t + u);
  return {t >= -kZero && u <= kZero, t, u, v};
}

/// The first and last turn of four, of which the middle ones are u and v.
Lengths outer_turns(double u, double v, double xi, double eta, double yaw) noexcept {
  const double delta = half_turned(u - v);
  const kernels::SineCosine of_u = kernels::sine_cosine(u);
  const kernels::SineCosine of_v = kernels::sine_cosine(v);
  const kernels::SineCosine of_delta = kernels::sine_cosine(delta);
  const double a = of_u.sine - of_delta.sine;
  const double b = of_u.cosine - of_delta.cosine - 1;
  const double t1 = direction(eta * a - xi * b, xi * a + eta * b);
  const double t2 = 2 * (of_delta.cosine - of_v.cosine - of_u.cosine) + 3;
  const double tau = t2 < 0 ? half_turned(t1 + kPi) : half_turned(t1);
  return {true, tau, u, half_turned(tau - u + v - yaw)};
}
Lengths turns_there_and_back(const Seen& to) noexcept {  // 8.7
  const double xi = to.x + to.sine;
  const double eta = to.y - 1 - to.cosine;
  const double rho = (2 + std::sqrt(xi * xi + eta * eta)) / 4;
  if (rho > 1) return {};
  const double u = arc_cosine(rho);
  Lengths found = outer_turns(u, -u, xi, eta, to.yaw);
  found.found = found.t >= -kZero && found.v <= kZero;
  return found;
}
Lengths turns_back_between(const Seen& to) noexcept {  // 8.8
  const double xi = to.x + to.sine;
  const double eta = to.y - 1 - to.cosine;
  const double rho = (20 - xi * xi - eta * eta) / 16;
  if (rho < 0 || rho > 1) return {};
  const double u = -arc_cosine(rho);
  Lengths found = outer_turns(u, u, xi, eta, to.yaw);
  found.found = found.t >= -kZero && found.v >= -kZero;
  return found;
}
Lengths quarter_to_left(const Seen& to) noexcept {  // 8.9
  const Polar p = polar(to.x - to.sine, to.y - 1 + to.cosine);
  if (p.radius < 2) return {};
  const double r = std::sqrt(p.radius * p.radius - 4);
  const double t = half_turned(p.angle + direction(r, -2));
  const double v = half_turned(to.yaw - kRightAngle - t);
  return {t >= -kZero && 2 - r <= kZero && v <= kZero, t, 2 - r, v};
}
Lengths quarter_to_right(const Seen& to) noexcept {  // 8.10
  const Polar p = polar(1 + to.cosine - to.y, to.x + to.sine);
  if (p.radius < 2) return {};
  const double v = half_turned(p.angle + kRightAngle - to.yaw);
  return {p.angle >= -kZero && v <= kZero, p.angle, 2 - p.radius, v};
}
Lengths two_quarters(const Seen& to) noexcept {  // 8.11
  const double xi = to.x + to.sine;
  const double eta = to.y - 1 - to.cosine;
  const double squared = xi * xi + eta * eta;
  if (squared < 4) return {};
  const double u = 4 - std::sqrt(squared - 4);
  if (u > kZero) return {};
  const double t = half_turned(direction((4 - u) * xi - 2 * eta, -2 * xi + (u - 4) * eta));
  const double v = half_turned(t - to.yaw);
  return {t >= -kZero && v >= -kZero, t, u, v};
}

}  // namespace

/// Enters a formula's words with all their mirror images.
class WordMaker {
 public:
  WordMaker(Words& words, const Place& to, const WordPrices& prices) noexcept
      : words_(words), prices_(prices) {
    const kernels::SineCosine of = kernels::sine_cosine(to.yaw);
    to_ = {to.x, to.y, to.yaw, of.sine, of.cosine};
    // The way back from there, told from its end.
    back_ = {to.x * of.cosine + to.y * of.sine, to.x * of.sine - to.y * of.cosine, to.yaw, of.sine,
             of.cosine};
  }

  /// @param turns   of a word that begins with a turn to the left
  /// @param pieces  makes the lengths of its pieces
  template <class Formula, class Pieces>
  void enter(Formula formula, std::initializer_list<signed char> turns, Pieces pieces,
             bool backwards = false) noexcept {
    const Seen& place = backwards ? back_ : to_;
    for (const int time : {1, -1}) {
      for (const int side : {1, -1}) {
        const double turn = time * side;
        const Seen seen{time * place.x, side * place.y, turn * place.yaw, turn * place.sine,
                        place.cosine};
        const Lengths lengths = formula(seen);
        if (!lengths.found) continue;
        Word word;
        word.count = static_cast<int>(turns.size());
        const std::array<double, 5> made = pieces(lengths);
        for (int i = 0; i < word.count; ++i) {
          const int from = backwards ? word.count - 1 - i : i;
          word.length[i] = time * made[from];
          word.turn[i] = static_cast<signed char>(side * turns.begin()[from]);
        }
        price(word);
        words_.add(word);
      }
    }
  }

  void all() noexcept {
    const auto three = [](const Lengths& l) { return std::array<double, 5>{l.t, l.u, l.v}; };
    const auto quarter = [](const Lengths& l) {
      return std::array<double, 5>{l.t, -kRightAngle, l.u, l.v};
    };
    enter(left_straight_left, {1, 0, 1}, three);
    enter(left_straight_right, {1, 0, -1}, three);
    enter(left_right_left, {1, -1, 1}, three);
    enter(left_right_left, {1, -1, 1}, three, true);
    enter(turns_there_and_back, {1, -1, 1, -1}, [](const Lengths& l) {
      return std::array<double, 5>{l.t, l.u, -l.u, l.v};
    });
    enter(turns_back_between, {1, -1, 1, -1}, [](const Lengths& l) {
      return std::array<double, 5>{l.t, l.u, l.u, l.v};
    });
    for (const bool backwards : {false, true}) {
      enter(quarter_to_left, {1, -1, 0, 1}, quarter, backwards);
      enter(quarter_to_right, {1, -1, 0, -1}, quarter, backwards);
    }
    enter(two_quarters, {1, -1, 0, 1, -1}, [](const Lengths& l) {
      return std::array<double, 5>{l.t, -kRightAngle, l.u, -kRightAngle, l.v};
    });
  }

 private:
  void price(Word& word) const noexcept {
    int gear = 0;
    for (int i = 0; i < word.count; ++i) {
      const double length = word.length[i];
      if (std::fabs(length) < kZero) continue;
      const int now = length < 0 ? -1 : 1;
      word.cost += now < 0 ? -length * prices_.backwards : length;
      if (gear != 0 && now != gear) word.cost += prices_.cusp;
      gear = now;
    }
  }

  Words& words_;
  WordPrices prices_;
  Seen to_{}, back_{};
};

void Words::reeds_shepp(const Place& to, const WordPrices& prices) noexcept {
  clear();
  WordMaker(*this, to, prices).all();
}

}  // namespace lasius::vehicle
