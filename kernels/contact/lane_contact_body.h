// What lane_contact.h promises, written once and compiled for each instruction set: after lanes.h.

#include <cstdint>

#include "kernels/base/horner.h"
#include "kernels/contact/lane_contact.h"

namespace lasius::kernels {
namespace {

/// Where a body is in the middle of each part.
struct LanePose {
  std::array<Lanes, 9> turn;
  Lanes3 origin;
};

LASIUS_LANES Lanes3 turned(const LanePose& pose, const std::array<float, 3>& v) noexcept {
  const auto& r = pose.turn;
  const Lanes x = all(v[0]), y = all(v[1]), z = all(v[2]);
  return {r[0] * x + r[1] * y + r[2] * z, r[3] * x + r[4] * y + r[5] * z,
          r[6] * x + r[7] * y + r[8] * z};
}

/// Sines and cosines, to 1e-7: turned by quarters in double, then Taylor's series.
LASIUS_LANES void sines(const double* x, Lanes& sine, Lanes& cosine) noexcept {
  constexpr double kShift = 0x1.8p52;
  alignas(32) float rest[kLanes], s[kLanes], c[kLanes];
  int quarter[kLanes];
  for (int l = 0; l < kLanes; ++l) {
    const double turns = (x[l] * 0.63661977236758134308 + kShift) - kShift;
    const double r = (x[l] - turns * 1.57079632673412561417) - turns * 6.07710050630396597660e-11;
    rest[l] = static_cast<float>(r);
    quarter[l] = static_cast<int>(turns);
  }
  const Lanes r = load(rest), z = r * r;
  const Lanes odd =
      all(-1.0F / 6) + z * (all(1.0F / 120) + z * (all(-1.0F / 5040) + z * all(1.0F / 362880)));
  const Lanes even = all(1.0F / 24) + z * (all(-1.0F / 720) + z * all(1.0F / 40320));
  store(s, r + r * z * odd);
  store(c, all(1) - all(0.5F) * z + z * z * even);
  for (int l = 0; l < kLanes; ++l) {
    const bool crossed = (quarter[l] & 1) != 0;
    const float a = crossed ? c[l] : s[l], b = crossed ? s[l] : c[l];
    s[l] = (quarter[l] & 2) != 0 ? -a : a;
    c[l] = ((quarter[l] + 1) & 2) != 0 ? -b : b;
  }
  sine = load(s);
  cosine = load(c);
}

LASIUS_LANES void place(const LaneRobot& robot, const LaneMotion& motion,
                        LanePose* poses) noexcept {
  const int joints = static_cast<int>(robot.joints.size());
  for (int k = 0; k < joints; ++k) {
    const LaneJoint& joint = robot.joints[k];
    const double way = motion.to[k] - motion.from[k], part = way / motion.parts;
    const double first = motion.from[k] + (motion.first + 0.5) * part;
    double q[kLanes];
    for (int l = 0; l < kLanes; ++l) q[l] = first + l * part;
    std::array<Lanes, 9> own;
    Lanes3 position = all(joint.position);
    if (joint.slides) {
      alignas(32) float value[kLanes];
      for (int l = 0; l < kLanes; ++l) value[l] = static_cast<float>(q[l]);
      position = position + load(value) * all(joint.along);
      for (int i = 0; i < 9; ++i) own[i] = all(joint.fixed[i]);
    } else {
      Lanes sine, cosine;
      sines(q, sine, cosine);
      for (int i = 0; i < 9; ++i) {
        own[i] = all(joint.fixed[i]) + cosine * all(joint.with_cosine[i]) +
                 sine * all(joint.with_sine[i]);
      }
    }
    LanePose& pose = poses[k];
    if (k == 0) {
      pose = {own, position};
      continue;
    }
    const LanePose& before = poses[k - 1];
    const auto& r = before.turn;
    for (int row = 0; row < 9; row += 3) {
      for (int j = 0; j < 3; ++j) {
        pose.turn[row + j] = r[row] * own[j] + r[row + 1] * own[3 + j] + r[row + 2] * own[6 + j];
      }
    }
    const Lanes3 rows[3] = {{r[0], r[1], r[2]}, {r[3], r[4], r[5]}, {r[6], r[7], r[8]}};
    pose.origin = before.origin +
                  Lanes3{dot(rows[0], position), dot(rows[1], position), dot(rows[2], position)};
  }
}

LASIUS_LANES Lanes3 into(const LaneObstacle& o, Lanes3 v) noexcept {
  const auto& r = o.rotation;  // its inverse
  return {all(r[0]) * v.x + all(r[3]) * v.y + all(r[6]) * v.z,
          all(r[1]) * v.x + all(r[4]) * v.y + all(r[7]) * v.z,
          all(r[2]) * v.x + all(r[5]) * v.y + all(r[8]) * v.z};
}

/// From the point of the box or cylinder that is nearest to `p` to it, in its frame.
LASIUS_LANES Lanes3 away(const LaneObstacle& o, Lanes3 p) noexcept {
  const Lanes3 local = into(o, p - all(o.position));
  const Lanes half = all(o.half[2]);
  const Lanes z = local.z - most(all(0) - half, least(half, local.z));
  if (!o.cylinder) {
    const Lanes wide = all(o.half[0]), deep = all(o.half[1]);
    return {local.x - most(all(0) - wide, least(wide, local.x)),
            local.y - most(all(0) - deep, least(deep, local.y)), z};
  }
  const Lanes across = root(local.x * local.x + local.y * local.y);
  const Lanes share = most(all(0), across - all(o.half[0])) / most(across, all(1e-20F));
  return {share * local.x, share * local.y, z};
}

LASIUS_LANES Lanes square(Lanes a) noexcept { return a * a; }

constexpr float kUp = 1.00001F;

LASIUS_LANES_TARGET bool touches(const LaneRobot& robot, std::span<const LaneObstacle> obstacles,
                                 const LaneMotion& motion) {
  constexpr std::size_t kKept = 32;
  std::array<LanePose, kMostLaneJoints> poses;
  place(robot, motion, poses.data());
  for (int k = static_cast<int>(robot.bodies.size()) - 1; k >= 0; --k) {
    const LaneBody& body = robot.bodies[k];
    if (body.inner.empty()) continue;
    const LanePose& pose = poses[k];
    const LaneBall& whole = body.outer[0];
    const Lanes3 middle = pose.origin + turned(pose, whole.centre);
    std::array<Lanes3, kKept> centres;
    std::size_t known = 0;  // of centres
    for (const LaneObstacle& o : obstacles) {
      if (!o.solid) continue;
      const Lanes3 apart = middle - all(o.position);
      const Lanes far = dot(apart, apart);
      const float reach = kUp * whole.radius + o.margin, both = reach + kUp * o.radius;
      if (less(far, all(both * both)) == 0) continue;
      const Lanes3 off = away(o, middle);
      if (less(dot(off, off), all((whole.radius + o.round) * (whole.radius + o.round))) == 0)
        continue;
      // What is smaller than the body may be all inside of a mesh, which is free.
      const unsigned out = less(all(reach * reach), far + all(o.radius * o.radius));
      for (std::size_t b = 0; b < body.inner.size(); ++b) {
        const LaneBall& ball = body.inner[b];
        const float radius = ball.radius - o.margin;
        if (!(radius > 0)) break;  // the largest are first
        if (b == known && b < kKept) centres[known++] = pose.origin + turned(pose, ball.centre);
        const Lanes3 near =
            away(o, b < known ? centres[b] : pose.origin + turned(pose, ball.centre));
        unsigned hit = less(dot(near, near), all((radius + o.round) * (radius + o.round)));
        if (ball.hollow) hit &= out;
        if (hit != 0) return true;
      }
    }
  }
  return false;
}

// The bounds are those of core/arm/contact/motion_bound.h, of a half part's change of the joints.
LASIUS_LANES_TARGET void sweep(const LaneRobot& robot, std::span<const LaneObstacle> obstacles,
                               const LaneMotion& motion, std::vector<LaneMiss>& misses) {
  std::array<LanePose, kMostLaneJoints> poses;
  place(robot, motion, poses.data());
  const int joints = static_cast<int>(robot.joints.size());
  std::array<double, kMostLaneJoints> rate, twice;
  double rates = 0, sliding = 0;
  Lanes3 turn = all({0, 0, 0}), shift = turn;
  for (int k = 0; k < joints; ++k) {
    const LaneJoint& joint = robot.joints[k];
    const double change = 0.5 * (motion.to[k] - motion.from[k]) / motion.parts;
    rate[k] = std::abs(change);
    const Lanes3 axis = all(static_cast<float>(change)) * turned(poses[k], joint.axis);
    if (joint.slides) {
      twice[k] = 0;
      sliding += 2 * rate[k] * rates;
      shift = shift + axis;
    } else {
      twice[k] = rate[k] * (rate[k] + 2 * rates);
      rates += rate[k];
      turn = turn + axis;
      shift = shift + cross(poses[k].origin, axis);
    }
    const LaneBody& body = robot.bodies[k];
    if (body.outer.empty()) continue;
    Lanes far = all(static_cast<float>(sliding));
    double reach = 0, moved = 0;  // of the body's origin, by the joints behind
    for (int l = k; l >= 0; --l) {
      const Lanes3 way = poses[k].origin - poses[l].origin;
      if (twice[l] > 0) {
        far = far + all(static_cast<float>(twice[l])) *
                        (root(dot(way, way)) + all(static_cast<float>(moved)));
      }
      moved += rate[l] * (robot.joints[l].slides ? 1 : reach);
      reach += robot.joints[l].length;
    }
    const auto spread = static_cast<float>(rates * rates);
    std::array<Lanes3, kMostOuterBalls> at, velocity;
    std::array<Lanes, kMostOuterBalls> need, curved;
    const int balls = static_cast<int>(body.outer.size());
    for (int b = 0; b < balls; ++b) {
      const LaneBall& ball = body.outer[b];
      at[b] = poses[k].origin + turned(poses[k], ball.centre);
      velocity[b] = cross(turn, at[b]) + shift;
      curved[b] = all(0.5F * kUp) * (far + all(spread * ball.far));
      curved[b] = curved[b] + all(kUp * ball.radius + static_cast<float>(motion.clearance) * kUp);
      need[b] = curved[b] + all(kUp) * root(dot(velocity[b], velocity[b]));
    }
    for (int o = 0; o < static_cast<int>(obstacles.size()); ++o) {
      const LaneObstacle& obstacle = obstacles[o];
      const Lanes extra = all(obstacle.round + obstacle.margin);
      unsigned open = (1U << kLanes) - 1;
      for (int b = 0; b < balls; ++b) {
        const Lanes3 off = away(obstacle, at[b]);
        const Lanes squared = dot(off, off);
        unsigned missed = open & ~less(square(need[b] + extra), squared);
        if (missed == 0) {
          if (b == 0) break;
          continue;
        }
        // The plane through the nearest point keeps the ball off: what goes across it counts.
        const Lanes distance = root(squared);
        const Lanes across = size_of(dot(off, into(obstacle, velocity[b])));
        missed &= ~less((curved[b] + extra) * distance + all(kUp) * across, squared);
        if (b == 0) open = missed;
        if (missed == 0 && b == 0) break;
        if (missed != 0 && (b > 0 || balls == 1)) misses.push_back({k, b, o, missed});
      }
    }
  }
}

constexpr LaneContact kContact{touches, sweep};

}  // namespace
}  // namespace lasius::kernels
