#include "core/vehicle/lattice.h"

#include <algorithm>
#include <cmath>

#include "core/vehicle/angle.h"

namespace lasius::vehicle {
namespace {

constexpr int kQuarter = Lattice::kHeadings / 4;
struct Direction {
  int p, q;
};
/// Of the first quarter of a turn.
constexpr Direction kDirections[kQuarter] = {{1, 0}, {2, 1}, {1, 1}, {1, 2}};

Direction direction_of(int heading) noexcept {
  Direction d = kDirections[heading % kQuarter];
  for (int turns = heading / kQuarter; turns > 0; --turns) d = {-d.q, d.p};
  return d;
}

double yaw_of(int heading) noexcept {
  const Direction d = direction_of(heading);
  return direction(d.q, d.p);
}

/// Cells about the origin by distance.
std::vector<Direction> nearest_cells(int reach) {
  std::vector<Direction> cells;
  for (int q = -reach; q <= reach; ++q) {
    for (int p = -reach; p <= reach; ++p) {
      if (p * p + q * q <= reach * reach && (p != 0 || q != 0)) cells.push_back({p, q});
    }
  }
  std::ranges::sort(cells, [](Direction a, Direction b) {
    const int da = a.p * a.p + a.q * a.q;
    const int db = b.p * b.p + b.q * b.q;
    return da != db ? da < db : a.q != b.q ? a.q < b.q : a.p < b.p;
  });
  return cells;
}

}  // namespace

Lattice::Lattice(const Vehicle& vehicle, const Outline& outline)
    : radius_(vehicle.turning_radius), from_(kHeadings), to_(kHeadings) {
  for (int h = 0; h < kHeadings; ++h) {
    yaws_.push_back(yaw_of(h));
    std::vector<Masks::Row> rows;
    outline.visit_cells(pose(0, 0, h), 0, [&](int row, int first, int last) {
      rows.push_back({row, first, last});
      return false;
    });
    footprints_.push_back(masks_.add(rows));
  }
  const auto place = [&](Edge edge) { add_edge(edge, outline, vehicle); };
  for (int h = 0; h < kHeadings; ++h) {
    const Direction d = direction_of(h);
    const double length = std::sqrt(static_cast<double>(d.p * d.p + d.q * d.q));
    const double straight = radius_ > 0 ? length / radius_ : length;
    // What drives to any side does so at each heading.
    for (int at = 0; at < kHeadings; ++at) {
      if (at != h && !vehicle.sideways) continue;
      place({.from = at,
             .to = at,
             .dx = d.p,
             .dy = d.q,
             .cost = static_cast<float>(length),
             .angle = at == h ? 0 : half_turned(yaw_of(h) - yaw_of(at)),
             .mask = {},
             .word = {{straight}, {}, 1, straight}});
    }
  }
  if (radius_ > 0) {
    // The shortest word from a heading to each that is near, and to each side; headings a quarter
    // of a turn on have the same.
    constexpr double kWidest = 0.9;
    constexpr double kDetour = 1.6;
    constexpr double kFarthest = 160;  // wider turns have no words
    const double most = std::max(2 * radius_, 6.0);
    const std::vector<Direction> cells =
        nearest_cells(static_cast<int>(std::min({most, 1.5 * radius_ + 6, kFarthest})));
    Words words;
    for (int h = 0; h < kQuarter; ++h) {
      for (int t = 0; t < kHeadings; ++t) {
        if (std::fabs(half_turned(yaws_[t] - yaws_[h])) > kWidest) continue;
        const int sides = t == h ? 2 : 1;
        for (int side = 0; side < sides; ++side) {
          Edge best{.from = h, .to = t, .mask = {}, .word = {}};
          double shortest = most;
          for (const Direction& cell : cells) {
            const double chord = std::sqrt(static_cast<double>(cell.p * cell.p + cell.q * cell.q));
            if (chord >= shortest) break;
            const Place to =
                seen_from({0, 0, yaws_[h]}, {1.0 * cell.p, 1.0 * cell.q, yaws_[t]}, radius_);
            if (to.x <= std::fabs(to.y) || (t == h && (side == 0 ? to.y < 1e-9 : to.y > -1e-9)))
              continue;
            words.dubins(to);
            const double length = words.least() * radius_;
            if (length >= shortest || length > kDetour * chord) continue;
            words.sort(1);
            shortest = length;
            best.dx = cell.p;
            best.dy = cell.q;
            best.cost = static_cast<float>(length);
            best.word = words[0];
          }
          if (best.dx == 0 && best.dy == 0) continue;
          for (int turn = 0; turn < 4; ++turn) {
            place(best);
            best.from = (best.from + kQuarter) % kHeadings;
            best.to = (best.to + kQuarter) % kHeadings;
            const int dx = best.dx;
            best.dx = -best.dy;
            best.dy = dx;
          }
        }
      }
    }
  }
  if (vehicle.rotate_in_place) add_rotations(vehicle, outline);
  for (int i = 0; i < static_cast<int>(edges_.size()); ++i) {
    from_[edges_[i].from].push_back(i);
    to_[edges_[i].to].push_back(i);
  }
}

void Lattice::add_edge(Edge edge, const Outline& outline, const Vehicle& vehicle) {
  std::vector<Segment> motion;
  append(edge, 0, 0, motion);
  edge.mask = sweep(motion, outline);
  edges_.push_back(edge);
  if (!vehicle.reverse) return;
  Edge back = edge;
  std::swap(back.from, back.to);
  back.dx = -edge.dx;
  back.dy = -edge.dy;
  back.gear = -1;
  back.cost = static_cast<float>(edge.cost * vehicle.reverse_cost);
  back.mask = masks_.moved(edge.mask, edge.dx, edge.dy);
  edges_.push_back(back);
}

void Lattice::add_rotations(const Vehicle& vehicle, const Outline& outline) {
  for (int h = 0; h < kHeadings; ++h) {
    for (const int step : {1, kHeadings - 1}) {
      Edge edge{.from = h, .to = (h + step) % kHeadings, .gear = 0, .mask = {}, .word = {}};
      const double angle = half_turned(yaws_[edge.to] - yaws_[h]);
      edge.cost = static_cast<float>(std::fabs(angle) * vehicle.rotation_cost);
      std::vector<Segment> motion;
      append(edge, 0, 0, motion);
      edge.mask = sweep(motion, outline);
      edges_.push_back(edge);
    }
  }
}

Masks::Mask Lattice::sweep(const std::vector<Segment>& motion, const Outline& outline) {
  constexpr double kPiece = 0.06;  // by which a point of the footprint moves, cells
  std::vector<Masks::Row> rows;
  for (const Segment& s : motion) {
    const double extent = s.extent();
    const double turned = s.gear == 0 ? extent : extent * std::fabs(s.curvature);
    const double moved = (s.gear == 0 ? 0 : extent) + turned * outline.around();
    const int pieces = std::max(1, static_cast<int>(std::ceil(moved / kPiece)));
    for (int i = 0; i < pieces; ++i) {
      outline.visit_cells(s.pose(extent * (i + 0.5) / pieces), moved / pieces / 2,
                          [&](int row, int first, int last) {
                            rows.push_back({row, first, last});
                            return false;
                          });
    }
  }
  return masks_.add(rows);
}

void Lattice::append(const Edge& edge, int x, int y, std::vector<Segment>& to) const {
  const Pose begin = pose(x, y, edge.from);
  if (edge.gear == 0) {
    to.push_back(
        {.begin = begin, .gear = 0, .angle = half_turned(yaws_[edge.to] - yaws_[edge.from])});
    return;
  }
  const double radius = radius_ > 0 ? radius_ : 1;
  const std::size_t first = to.size();
  if (edge.gear > 0) {
    vehicle::append(edge.word, begin, radius, to);
    if (edge.angle != 0) to.back().angle = edge.angle;
    return;
  }
  vehicle::append(edge.word, pose(x + edge.dx, y + edge.dy, edge.to), radius, to);
  for (std::size_t i = first; i < to.size(); ++i) {
    to[i].begin = to[i].end();
    to[i].gear = -1;
  }
  std::reverse(to.begin() + static_cast<std::ptrdiff_t>(first), to.end());
}

}  // namespace lasius::vehicle
