#include "tests/oracle/disc_paths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>
#include <set>
#include <tuple>

namespace lasius::oracle {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr double kSlack = 1e-9;

double distance(Point a, Point b) {
  const double x = b.x - a.x, y = b.y - a.y;
  return std::sqrt(x * x + y * y);
}

double to_square(Point p, Point square) {
  const double x = std::max({0.0, square.x - p.x, p.x - square.x - 1});
  const double y = std::max({0.0, square.y - p.y, p.y - square.y - 1});
  return std::sqrt(x * x + y * y);
}

double to_segment(Point p, Point a, Point b) {
  const double x = b.x - a.x, y = b.y - a.y, square = x * x + y * y;
  const double share =
      square == 0 ? 0 : std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / square, 0.0, 1.0);
  return distance(p, {a.x + share * x, a.y + share * y});
}

// Does a segment meet a closed square?
bool meets(Point a, Point b, Point square) {
  double enters = 0, leaves = 1;
  const auto cut = [&](double from, double along, double low) {
    if (along == 0) return from >= low && from <= low + 1;
    const double one = (low - from) / along, other = (low + 1 - from) / along;
    enters = std::max(enters, std::min(one, other));
    leaves = std::min(leaves, std::max(one, other));
    return enters <= leaves;
  };
  return cut(a.x, b.x - a.x, square.x) && cut(a.y, b.y - a.y, square.y);
}

double segment_to_square(Point a, Point b, Point square) {
  if (meets(a, b, square)) return 0;
  double least = std::min(to_square(a, square), to_square(b, square));
  for (const double x : {0.0, 1.0}) {
    for (const double y : {0.0, 1.0}) {
      least = std::min(least, to_segment({square.x + x, square.y + y}, a, b));
    }
  }
  return least;
}

Point on_circle(Point centre, double radius, double angle) {
  return {centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)};
}

}  // namespace

DiscPaths::DiscPaths(const Grid& grid, double radius, Lines lines)
    : radius_(radius), limit_(radius - kSlack) {
  std::set<std::pair<int, int>> vertices;
  for (int y = -1; y <= grid.height(); ++y) {
    for (int x = -1; x <= grid.width(); ++x) {
      if (grid.free({x, y})) continue;
      squares_.push_back({1.0 * x, 1.0 * y});
      for (const int i : {0, 1}) {
        for (const int j : {0, 1}) vertices.insert({x + i, y + j});
      }
    }
  }
  if (lines == Lines::none) return;
  for (const auto& [x, y] : vertices) circles_.push_back({1.0 * x, 1.0 * y});
  for (int a = 0; a < static_cast<int>(circles_.size()); ++a) {
    for (int b = a + 1; b < static_cast<int>(circles_.size()); ++b)
      lines_between(touches_, a, circles_[a], radius, b, circles_[b], radius);
  }
}

double DiscPaths::clearance(Point p) const {
  double least = kFar;
  for (const Point square : squares_) least = std::min(least, to_square(p, square));
  return least;
}

bool DiscPaths::clear(Point p) const {
  return std::ranges::all_of(squares_,
                             [&](Point square) { return to_square(p, square) >= limit_; });
}

double DiscPaths::clearance(Point a, Point b) const {
  double least = kFar;
  for (const Point square : squares_) least = std::min(least, segment_to_square(a, b, square));
  return least;
}

// Where an arc is nearest to a square it is so at an end, or opposite to a side or a vertex.
double DiscPaths::arc_clearance(Point centre, double from, double to) const {
  constexpr double kTurn = 2 * std::numbers::pi;
  double least = kFar;
  const auto look = [&](double angle, Point square) {
    double at = from + std::fmod(angle - from, kTurn);
    if (at < from) at += kTurn;
    if (at > to) return;
    least = std::min(least, to_square(on_circle(centre, radius_, at), square));
  };
  for (const Point square : squares_) {
    // Between inside and outside: some points more.
    for (int i = 0; i <= 8; ++i) look(i == 8 ? to : from + (to - from) * i / 8, square);
    for (int i = 0; i < 4; ++i) {
      look(kTurn * i / 4, square);
      look(std::atan2(square.y + i / 2 - centre.y, square.x + i % 2 - centre.x), square);
    }
  }
  return least;
}

bool DiscPaths::keeps(Point a, Point b) const {
  return std::ranges::all_of(squares_, [&](Point square) {
    const double reach = radius_ + 1;
    if (square.x > std::max(a.x, b.x) + reach || square.x < std::min(a.x, b.x) - reach - 1 ||
        square.y > std::max(a.y, b.y) + reach || square.y < std::min(a.y, b.y) - reach - 1)
      return true;
    return segment_to_square(a, b, square) >= limit_;
  });
}

// All lines that touch two circles, which may be points.
void DiscPaths::lines_between(std::vector<Touch>& touches, int a, Point ca, double ra, int b,
                              Point cb, double rb) const {
  const double x = cb.x - ca.x, y = cb.y - ca.y, d = std::hypot(x, y);
  const double towards = std::atan2(y, x);
  for (const int side : {1, -1}) {
    for (const int same : {1, -1}) {
      if ((ra == 0 && side < 0) || (rb == 0 && same < 0)) continue;
      const double cosine = d == 0 ? 2 : (ra - same * rb) / d;
      if (std::abs(cosine) > 1 + 4 * kSlack / d) continue;
      const double angle = towards + side * std::acos(std::clamp(cosine, -1.0, 1.0));
      const Point pa = on_circle(ca, ra, angle), pb = on_circle(cb, same * rb, angle);
      if (!clear(pa) || !clear(pb) || !keeps(pa, pb)) continue;
      const int first = static_cast<int>(touches.size());
      const double length = distance(pa, pb);
      // What lies to the left of the line is turned around by growing angle.
      const int at_a = ra == 0 ? 0 : -side, at_b = rb == 0 ? 0 : -side * same;
      touches.push_back({a, angle, pa, {{first + 1, length, at_a, at_b}}});
      touches.push_back(
          {b, same > 0 ? angle : angle + std::numbers::pi, pb, {{first, length, -at_b, -at_a}}});
    }
  }
}

std::optional<double> DiscPaths::shortest(Point start, Point goal, const Price& at_start,
                                          const Price& at_goal) {
  if (keeps(start, goal)) return distance(start, goal);
  std::vector<Touch> touches = touches_;
  const int circles = static_cast<int>(circles_.size());
  for (int i = 0; i < circles; ++i) {
    lines_between(touches, circles, start, 0, i, circles_[i], radius_);
    lines_between(touches, circles + 1, goal, 0, i, circles_[i], radius_);
  }
  std::vector<std::vector<int>> on(circles + 2);
  for (int i = 0; i < static_cast<int>(touches.size()); ++i) on[touches[i].circle].push_back(i);
  for (int c = 0; c < circles; ++c) {
    for (const int i : on[c]) {
      touches[i].angle = std::remainder(touches[i].angle, 2 * std::numbers::pi);
    }
    std::ranges::sort(on[c], {}, [&](int i) { return touches[i].angle; });
    for (std::size_t k = 0; k < on[c].size(); ++k) {
      const int i = on[c][k], j = on[c][(k + 1) % on[c].size()];
      const double from = touches[i].angle;
      const double to = touches[j].angle + (k + 1 == on[c].size() ? 2 * std::numbers::pi : 0);
      if (i == j || arc_clearance(circles_[c], from, to) < limit_) continue;
      touches[i].ways.push_back({j, radius_ * (to - from), 1, 1});
      touches[j].ways.push_back({i, radius_ * (to - from), -1, -1});
    }
  }
  // Of each touch by which turn it is come to.
  std::vector<std::array<double, 3>> length(touches.size(), {kFar, kFar, kFar});
  using Item = std::tuple<double, int, int>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> open;
  for (const int i : on[circles]) open.emplace(length[i][1] = 0, i, 0);
  const auto price = [](const Price& of, Point from, Point to) {
    return of ? of({to.x - from.x, to.y - from.y}) : 0.0;
  };
  while (!open.empty()) {
    const auto [known, i, turn] = open.top();
    open.pop();
    const Touch& here = touches[i];
    if (known > length[i][turn + 1]) continue;
    if (here.circle == circles + 1) return known;
    for (const Way& way : here.ways) {
      if (turn != way.leaves) continue;
      const Touch& there = touches[way.to];
      double sum = known + way.length;
      if (here.circle == circles) sum += price(at_start, start, there.at);
      if (there.circle == circles + 1) sum += price(at_goal, goal, here.at);
      double& least = length[way.to][way.arrives + 1];
      if (sum < least) open.emplace(least = sum, way.to, way.arrives);
    }
  }
  return std::nullopt;
}

}  // namespace lasius::oracle
