#include "core/polygon/route.h"

#include <algorithm>

#include "core/base/special_values.h"
#include "lasius/path/path.h"

namespace lasius::polygon {
namespace {

void append(std::vector<Point>& path, Point p) {
  if (path.empty() || path.back() != p) path.push_back(p);
}

/// A vertex of a funnel's path, and the gate that it ends: -1 the start, gates.size() the goal.
struct Bend {
  LatticePoint at;
  int gate;
};

std::vector<Bend> funnel(const Route& route) {
  const int goal = static_cast<int>(route.gates.size());
  const auto left_of = [&](int i) { return i == goal ? route.goal.at : route.gates[i].left; };
  const auto right_of = [&](int i) { return i == goal ? route.goal.at : route.gates[i].right; };
  std::vector<Bend> bends{{route.start.at, -1}};
  Bend left = bends[0], right = bends[0];
  const auto restart = [&](const Bend& apex) {
    bends.push_back(apex);
    left = right = apex;
    return apex.gate;
  };
  for (int i = 0; i <= goal; ++i) {
    const LatticePoint apex = bends.back().at, l = left_of(i), r = right_of(i);
    if (side(apex, right.at, r) >= 0) {
      if (right.at == apex || side(apex, left.at, r) < 0 || left.at == apex) {
        right = {r, i};
      } else {
        i = restart(left);
        continue;
      }
    }
    if (side(apex, left.at, l) <= 0) {
      if (left.at == apex || side(apex, right.at, l) > 0 || right.at == apex)
        left = {l, i};
      else
        i = restart(right);
    }
  }
  bends.push_back({route.goal.at, goal});
  return bends;
}

/// Where the segment from p to q meets the line of a gate, as a value of it.
double meeting(const Gate& gate, Point p, Point q) {
  const double dx = gate.b.x - gate.a.x, dy = gate.b.y - gate.a.y;
  const double from = dx * (p.y - gate.a.y) - dy * (p.x - gate.a.x);
  const double to = dx * (q.y - gate.a.y) - dy * (q.x - gate.a.x);
  const double share = from == to ? 0 : from / (from - to);
  const double x = p.x + share * (q.x - p.x) - gate.a.x, y = p.y + share * (q.y - p.y) - gate.a.y;
  return std::clamp((x * dx + y * dy) / (dx * dx + dy * dy), 0.0, 1.0);
}

}  // namespace

Crossing cross_at(const Route& route, std::vector<double> values) {
  Crossing crossing;
  append(crossing.path, route.start.given);
  for (std::size_t i = 0; i < route.gates.size(); ++i) {
    crossing.lines.push_back(route.gates[i].link);
    append(crossing.path, route.gates[i].at(values[i]));
  }
  append(crossing.path, route.goal.given);
  crossing.values = std::move(values);
  crossing.length = path_length(crossing.path);
  return crossing;
}

std::optional<Crossing> discrete_optimum(const Route& route, int values, Poller& poller) {
  const auto h = [values](int k) { return static_cast<double>(k) / (values - 1); };
  const int gates = static_cast<int>(route.gates.size());
  // Backwards: the shortest way to the goal from each value of a gate, and the next value on it.
  std::vector<double> ahead(values, 0), here(values, 0);
  std::vector<int> next(static_cast<std::size_t>(gates) * values, 0);
  for (int g = gates - 1; g >= 0; --g) {
    for (int k = 0; k < values; ++k) {
      const Point p = route.gates[g].at(h(k));
      if (g == gates - 1) {
        here[k] = distance(p, route.goal.given);
        continue;
      }
      if (poller.stop_after(values)) return std::nullopt;
      here[k] = kInfinity;
      for (int j = 0; j < values; ++j) {
        const double length = distance(p, route.gates[g + 1].at(h(j))) + ahead[j];
        if (!(length < here[k])) continue;
        here[k] = length;
        next[static_cast<std::size_t>(g) * values + k] = j;
      }
    }
    ahead.swap(here);
  }
  std::vector<double> chosen;
  if (gates > 0) {
    int best = 0;
    const auto from_start = [&](int k) {
      return distance(route.start.given, route.gates[0].at(h(k))) + ahead[k];
    };
    for (int k = 1; k < values; ++k)
      if (from_start(k) < from_start(best)) best = k;
    for (int g = 0; g < gates; ++g) {
      chosen.push_back(h(best));
      best = next[static_cast<std::size_t>(g) * values + best];
    }
  }
  return cross_at(route, std::move(chosen));
}

Crossing sequence_optimum(const Route& route, const FreeSpace& space) {
  const int goal = static_cast<int>(route.gates.size());
  const auto bends = funnel(route);
  const auto point_of = [&](const Bend& bend) {
    if (bend.gate < 0) return route.start.given;
    return bend.gate == goal ? route.goal.given : space.point(bend.at);
  };
  Crossing crossing;
  std::size_t at = 0;  // the last bend at or before the gate
  for (int g = 0; g < goal; ++g) {
    const Gate& gate = route.gates[g];
    crossing.lines.push_back(gate.link);
    while (bends[at + 1].gate <= g) ++at;
    const LatticePoint bend = bends[at].at;
    if (bend == gate.left || bend == gate.right)
      crossing.values.push_back((bend == gate.left) == gate.a_is_left ? 0.0 : 1.0);
    else
      crossing.values.push_back(meeting(gate, point_of(bends[at]), point_of(bends[at + 1])));
  }
  for (const Bend& bend : bends) append(crossing.path, point_of(bend));
  crossing.length = path_length(crossing.path);
  return crossing;
}

}  // namespace lasius::polygon
