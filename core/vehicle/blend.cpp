#include "core/vehicle/blend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "core/vehicle/angle.h"

namespace lasius::vehicle {
namespace {

using Offset = std::array<double, 3>;  // x, y, yaw
constexpr std::int64_t kWork = 64;     // of a piece in a round: motions of it and beside it

/// One piece of a part driven in one gear: an arc or a line, as long as it is up to the middles of
/// the clothoids at its ends.
struct Bend {
  double length, curvature;
};

/// Solves m x = b by Cramer's rule; false where that means nothing.
bool solve(const std::array<Offset, 3>& m, const Offset& b, Offset& x) {
  const auto determinant = [](const Offset& u, const Offset& v, const Offset& w) {
    return u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) +
           u[2] * (v[0] * w[1] - v[1] * w[0]);
  };
  const double all = determinant(m[0], m[1], m[2]);
  if (!(std::fabs(all) > 1e-12)) return false;
  x = {determinant(b, m[1], m[2]) / all, determinant(m[0], b, m[2]) / all,
       determinant(m[0], m[1], b) / all};
  return true;
}

/// One part, from rest to rest: nothing is asked of the curvature at its ends.
class Stretch {
 public:
  Stretch(std::span<const Segment> path, const Vehicle& asked)
      : begin_(path.front().begin),
        end_(path.back().end()),
        gear_(path.front().gear),
        rate_(asked.curvature_rate),
        most_(1 / asked.turning_radius) {
    for (const Segment& s : path) pieces_.push_back({s.length, s.curvature});
  }

  /// Whether lengths and curvatures are found that lead to its end.
  bool fit(Poller& poller) {
    if (!make_room()) return false;
    constexpr int kRounds = 40;
    for (int round = 0; round < kRounds; ++round) {
      if (poller.stop_after(kWork * static_cast<std::int64_t>(pieces_.size()))) return false;
      const Course whole = course(0, pieces_.size(), begin_);
      const Offset off{whole.end.x - end_.x, whole.end.y - end_.y,
                       half_turned(whole.end.yaw - end_.yaw)};
      if (std::max({std::fabs(off[0]), std::fabs(off[1]), std::fabs(off[2])}) < 1e-10) return true;
      if (!step(whole, off)) return false;
    }
    return false;
  }

  std::vector<Segment> motions() const { return course(0, pieces_.size(), begin_).motions; }

 private:
  /// The length of the clothoid after a piece.
  double ramp(std::size_t i) const {
    return std::fabs(pieces_[i + 1].curvature - pieces_[i].curvature) / rate_;
  }
  /// What the clothoids take of a piece.
  double needed(std::size_t i) const {
    return ((i > 0 ? ramp(i - 1) : 0) + (i + 1 < pieces_.size() ? ramp(i) : 0)) / 2;
  }

  /// Arcs that are too short are made wider and longer, by the same angle; lines longer.
  bool make_room() {
    constexpr double kWider = 0.95;
    for (int round = 0; round < 100; ++round) {
      bool fits = true;
      for (std::size_t i = 0; i < pieces_.size(); ++i) {
        Bend& piece = pieces_[i];
        if (piece.length >= needed(i) || piece.curvature == 0) continue;
        fits = false;
        piece.curvature *= kWider;
        piece.length /= kWider;
      }
      if (!fits) continue;
      for (std::size_t i = 0; i < pieces_.size(); ++i)
        pieces_[i].length = std::max(pieces_[i].length, needed(i));
      return true;
    }
    return false;
  }

  /// What is driven from the begin of a piece, behind the clothoid there, to before another's.
  struct Course {
    std::vector<Segment> motions;
    std::vector<Pose> before, after;  ///< of each piece, between its clothoids
    Pose end;
  };
  Course course(std::size_t first, std::size_t last, const Pose& begin) const {
    Course made;
    made.end = begin;
    const auto put = [&](double curvature, double rate, double length) {
      if (length < 1e-9) return;
      made.motions.push_back({.begin = made.end,
                              .curvature = curvature,
                              .curvature_rate = gear_ * rate,
                              .length = length,
                              .gear = gear_});
      made.end = made.motions.back().end();
    };
    for (std::size_t i = first; i < last; ++i) {
      made.before.push_back(made.end);
      put(pieces_[i].curvature, 0, pieces_[i].length - needed(i));
      made.after.push_back(made.end);
      if (i + 1 == last) continue;
      const double rise = pieces_[i + 1].curvature - pieces_[i].curvature;
      put(pieces_[i].curvature, rise < 0 ? -rate_ : rate_, ramp(i));
    }
    return made;
  }

  /// Newton's step of least change: of lengths by what they have, of curvatures by a tenth. A piece
  /// changes what is driven from the one before it to the one after it; the rest is moved.
  bool step(const Course& whole, const Offset& off) {
    constexpr double kSmall = 1e-6, kBend = 0.1;
    struct Way {
      std::size_t piece;
      bool length;
      double share;
      Offset slope;
    };
    std::vector<Way> ways;
    std::array<Offset, 3> m{};
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const std::size_t first = i > 0 ? i - 1 : 0;
      const std::size_t last = std::min(i + 2, pieces_.size());
      const Pose& after = whole.after[last - 1];
      const double x = whole.end.x - after.x, y = whole.end.y - after.y;
      for (const bool length : {true, false}) {
        double& value = length ? pieces_[i].length : pieces_[i].curvature;
        if (!length && value == 0) continue;
        const double change =
            length ? 0.1 + pieces_[i].length - needed(i) : kBend * std::fabs(value);
        const double small = length ? kSmall : kSmall * most_;
        const double before = value;
        value += small;
        const Pose there = course(first, last, whole.before[first]).end;
        value = before;
        const kernels::SineCosine turn = kernels::sine_cosine(there.yaw - after.yaw);
        const Way way{i,
                      length,
                      change * change,
                      {(there.x + turn.cosine * x - turn.sine * y - whole.end.x) / small,
                       (there.y + turn.sine * x + turn.cosine * y - whole.end.y) / small,
                       (there.yaw - after.yaw) / small}};
        for (int a = 0; a < 3; ++a)
          for (int b = 0; b < 3; ++b) m[a][b] += way.share * way.slope[a] * way.slope[b];
        ways.push_back(way);
      }
    }
    Offset pull;
    if (!solve(m, off, pull)) return false;
    for (const Way& way : ways) {
      double change = 0;
      for (int k = 0; k < 3; ++k) change -= way.share * way.slope[k] * pull[k];
      Bend& piece = pieces_[way.piece];
      if (way.length)
        piece.length += change;
      else
        piece.curvature = std::clamp(piece.curvature + change, -most_, most_);
    }
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      pieces_[i].length = std::max(pieces_[i].length, needed(i));
    return true;
  }

  Pose begin_, end_;
  int gear_;
  double rate_, most_;
  std::vector<Bend> pieces_;
};

/// Parts of a path, each from rest to rest.
class Blender {
 public:
  Blender(const Space::Impl& space, const Vehicle& asked, std::int64_t& checked, Poller& poller)
      : space_(space), asked_(asked), checked_(checked), poller_(poller) {}

  std::vector<Segment> run(std::span<const Segment> path) {
    halve(path);
    // Some halves go together with what was cut off them.
    for (std::size_t i = 1; i < parts_.size();) {
      Told& before = parts_[i - 1];
      const std::span both(before.path.data(), before.path.size() + parts_[i].path.size());
      std::vector<Segment> motions;
      if (corners(std::span(parts_[i].path.data() - 1, 2)) > 0 && fit(both, motions)) {
        before = {both, std::move(motions)};
        parts_.erase(parts_.begin() + static_cast<std::ptrdiff_t>(i));
      } else {
        ++i;
      }
    }
    std::vector<Segment> made;
    for (const Told& part : parts_)
      made.insert(made.end(), part.motions.begin(), part.motions.end());
    return made;
  }

 private:
  struct Told {
    std::span<const Segment> path;
    std::vector<Segment> motions;
  };

  void halve(std::span<const Segment> path) {
    std::vector<Segment> motions;
    const bool stopped = poller_.stopped();
    if (stopped) motions.assign(path.begin(), path.end());
    if (stopped || fit(path, motions)) {
      parts_.push_back({path, std::move(motions)});
      return;
    }
    halve(path.first(path.size() / 2));
    halve(path.subspan(path.size() / 2));
  }

  bool fit(std::span<const Segment> path, std::vector<Segment>& motions) {
    if (corners(path) == 0) {
      motions.assign(path.begin(), path.end());
      return true;
    }
    Stretch part(path, asked_);
    if (!part.fit(poller_)) return false;
    motions = part.motions();
    return space_.all_free(motions, Space::Impl::kCoarse, false, checked_);
  }

  const Space::Impl& space_;
  const Vehicle& asked_;
  std::int64_t& checked_;
  Poller& poller_;
  std::vector<Told> parts_;
};

}  // namespace

Vehicle with_room(Vehicle vehicle) {
  if (vehicle.curvature_rate > 0)
    vehicle.turning_radius = std::min(1.1 * vehicle.turning_radius, kMostTurningRadius);
  return vehicle;
}

std::vector<Segment> blended(const Space::Impl& space, const Vehicle& asked,
                             const std::vector<Segment>& path, std::int64_t& checked,
                             Poller& poller) {
  std::vector<Segment> made;
  for (std::size_t i = 0; i < path.size();) {
    std::size_t next = i + 1;
    while (path[i].gear != 0 && next < path.size() && path[next].gear == path[i].gear) ++next;
    Blender blender(space, asked, checked, poller);
    const std::vector<Segment> part = blender.run(std::span(path).subspan(i, next - i));
    made.insert(made.end(), part.begin(), part.end());
    i = next;
  }
  return made;
}

}  // namespace lasius::vehicle
