#include "core/arm/timing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/arm/spline.h"
#include "core/base/special_values.h"

namespace lasius::arm {
namespace {

/// One side of the limits on u, linear in x: u <= at + slope x, or u >= that.
struct Line {
  double at, slope;
};

/// What the limits leave of u at the beginning of a step, and of x.
class StepLimits {
 public:
  StepLimits(const Robot& robot, const PathPiece& piece, double s, double length)
      : length_(length) {
    for (int j = 0; j < robot.size(); ++j) {
      const Joint& joint = robot.joints[j];
      const double curved = piece.straight() ? 0 : piece.bend[j];
      const double rate = piece.along[j] + s * curved;
      most_ = std::min(most_, square(joint.velocity / rate));
      limit(rate, curved, joint.acceleration);
      // At its end x + 2 length u stands for x.
      if (curved != 0) limit(rate + 3 * length * curved, curved, joint.acceleration);
    }
  }

  /// The largest x at the beginning from which one of `after` or less is reached.
  double largest(double after) const {
    // The largest u less the least is concave in x, and not below 0 at x = 0: Newton's way down.
    double x = most_;
    constexpr int kMost = 100;
    for (int i = 0; i < kMost; ++i) {
      const Line high = upper(x, after), low = lower(x);
      const double room = high.at - low.at + (high.slope - low.slope) * x;
      const double slope = high.slope - low.slope;
      if (!(room < 0) || !(slope < 0)) break;
      const double next = (high.at - low.at) / -slope;
      if (!(next < x)) break;
      x = std::max(0.0, next);
    }
    return x;
  }
  /// What x is at the end where u is as large as it can.
  double furthest(double x, double after) const {
    const Line high = upper(x, after);
    return std::clamp(x + 2 * length_ * (high.at + high.slope * x), 0.0, after);
  }

 private:
  static double square(double v) noexcept { return v * v; }
  void limit(double rate, double curved, double most) {
    constexpr double kNone = 1e-12;  // of the acceleration, no u worth the name changes it
    if (std::abs(rate) <= kNone) {
      if (curved != 0) most_ = std::min(most_, most / std::abs(curved));
      return;
    }
    const double slope = -curved / rate, room = most / std::abs(rate);
    lines_[count_++] = {room, slope};
  }
  Line upper(double x, double after) const {
    Line least{after / (2 * length_), -1 / (2 * length_)};
    for (int i = 0; i < count_; ++i) {
      const Line& line = lines_[i];
      if (line.at + line.slope * x < least.at + least.slope * x) least = line;
    }
    return least;
  }
  Line lower(double x) const {
    Line most{0, -1 / (2 * length_)};
    for (int i = 0; i < count_; ++i) {
      const Line line{-lines_[i].at, lines_[i].slope};
      if (line.at + line.slope * x > most.at + most.slope * x) most = line;
    }
    return most;
  }

  double length_, most_ = kInfinity;
  int count_ = 0;
  std::array<Line, std::size_t{2} * Robot::kMaxJoints> lines_;  // above; those below begin at -at
};

/// Pieces of constant acceleration, one after another. Those so short that rounding says how fast
/// they are, are left out.
class Pieces {
 public:
  explicit Pieces(const JointVector& start) : q_(start) {}
  void add(double seconds, const JointVector& to, const JointVector& acceleration) {
    constexpr double kShort = 1e-10;  // of the values
    double moved = 0, large = 0;
    for (Eigen::Index j = 0; j < to.size(); ++j) {
      moved = std::max(moved, std::abs(to[j] - q_[j]));
      large = std::max(large, std::abs(to[j]));
    }
    const bool shown = seconds > 0 && (knots_.empty() || moved > kShort * large);
    if (shown) {
      if (knots_.empty() || knots_.back().ddq != acceleration || knots_.back().q != q_)
        knots_.push_back({time_, q_, acceleration});
      time_ += seconds;
    }
    q_ = to;
    if (shown) knots_.push_back({time_, q_, acceleration});
  }
  double time() const noexcept { return time_; }
  std::vector<Trajectory::Knot> take() {
    knots_.back().q = q_;
    return std::move(knots_);
  }

 private:
  double time_ = 0;
  JointVector q_;
  std::vector<Trajectory::Knot> knots_;
};

/// An edge, from x0 to x1: as quick as `most` and `force` allow, which bound x and u.
void add_edge(Pieces& pieces, const PathPiece& edge, double x0, double x1, double most,
              double force) {
  const double peak = std::max({x0, x1, std::min(most, 0.5 * (x0 + x1) + force * edge.length)});
  const double up = (peak - x0) / (2 * force), down = (peak - x1) / (2 * force);
  const double v0 = std::sqrt(x0), v1 = std::sqrt(x1), v = std::sqrt(peak);
  const double even = std::max(0.0, edge.length - up - down);
  pieces.add((v - v0) / force, edge.at(up), force * edge.along);
  const JointVector none = JointVector::Zero(edge.along.size());
  pieces.add(even / v, edge.at(up + even), none);
  pieces.add((v - v1) / force, edge.at(edge.length), none - force * edge.along);
}

/// A step of a parabola, from s and x0 to x1.
void add_step(Pieces& pieces, const PathPiece& piece, double s, double length, double x0,
              double x1) {
  const double v0 = std::sqrt(x0), v1 = std::sqrt(x1), seconds = 2 * length / (v0 + v1);
  const JointVector from = piece.at(s), to = piece.at(s + length);
  const JointVector dq0 = v0 * piece.direction(s), dq1 = v1 * piece.direction(s + length);
  // a0 and a1, each for half of the time: what they make of velocity and place is as it must be.
  const double half = 0.5 * seconds;
  const JointVector sum = (dq1 - dq0) / half;
  const JointVector a0 = (to - from - seconds * dq0) / (half * half) - 0.5 * sum;
  const JointVector a1 = sum - a0;
  pieces.add(half, from + half * (dq0 + 0.5 * half * a0), a0);
  pieces.add(half, to, a1);
}

/// The mean over the last `window` seconds.
Trajectory mean_over(const Trajectory& motion, double window) {
  const auto& knots = motion.knots();
  std::vector<double> times;
  for (const auto& knot : knots) {
    times.push_back(knot.time);
    times.push_back(knot.time + window);
  }
  std::ranges::sort(times);
  const double last = times.back();
  std::vector<Trajectory::Knot> smooth;
  JointVector q = knots.front().q, dq = JointVector::Zero(q.size());
  for (const double t : times) {
    if (!smooth.empty() && !(t - smooth.back().time > 1e-9 * last)) continue;
    const JointVector ddq = (motion.at(t).dq - motion.at(t - window).dq) / window;
    if (!smooth.empty()) {
      const auto& before = smooth.back();
      const double h = t - before.time;
      q += h * (dq + h / 6 * (2 * before.ddq + ddq));
      dq += h / 2 * (before.ddq + ddq);
    }
    smooth.push_back({t, q, ddq});
  }
  smooth.back().ddq.setZero();
  // What rounding left to the end, evenly over the motion.
  const JointVector off = (knots.back().q - smooth.back().q) / smooth.back().time;
  for (auto& knot : smooth) knot.q += knot.time * off;
  smooth.back().q = knots.back().q;
  return Trajectory(std::move(smooth));
}

TimedRun slower(const TimedRun& run, double factor) {
  TimedRun slow{stretched(run.motion, factor), run.blends};
  for (auto& [begin, end] : slow.blends) begin *= factor, end *= factor;
  return slow;
}

/// As it is where limits hold, or as much slower as it takes.
TimedRun slow_enough(const Robot& robot, TimedRun run) {
  constexpr double kRounding = 1e-12;
  const double need = needed_stretch(robot, run.motion);
  return need > 1 + kRounding ? slower(run, need) : std::move(run);
}

/// The largest jerk, in what the limits allow.
double jerk_used(const Robot& robot, const Trajectory& motion) {
  double most = 0;
  const auto& knots = motion.knots();
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const double h = knots[i + 1].time - knots[i].time;
    for (int j = 0; j < robot.size(); ++j) {
      if (robot.joints[j].jerk > 0)
        most = std::max(
            most, std::abs(knots[i + 1].ddq[j] - knots[i].ddq[j]) / (h * robot.joints[j].jerk));
    }
  }
  return most;
}

/// The mean over the shortest window that keeps to the limits of jerk, or nearly; where stopped
/// over a shorter one.
Trajectory mean_within_jerk(const Robot& robot, const Trajectory& motion,
                            const std::function<bool()>& stopped) {
  double window = 0;  // of the first change of acceleration, from rest
  for (const auto& knot : motion.knots()) {
    for (int j = 0; j < robot.size(); ++j) {
      if (robot.joints[j].jerk > 0)
        window = std::max(window, std::abs(knot.ddq[j]) / robot.joints[j].jerk);
    }
  }
  if (!(window > 0)) return motion;
  constexpr double kShort = 1e-6;  // of the motion: rounding says what happens in less
  window = std::max(window, kShort * motion.duration());
  constexpr double kMargin = 1 + 1e-9;  // for rounding
  constexpr int kMost = 20;
  Trajectory smooth = mean_over(motion, window);
  for (int i = 0; i < kMost; ++i) {
    const double used = jerk_used(robot, smooth);
    if (used <= kMargin || stopped()) break;
    window *= used;
    smooth = mean_over(motion, window);
  }
  return smooth;
}

}  // namespace

TimedRun in_least_time(const Robot& robot, const PathRun& run, int steps) {
  std::vector<StepLimits> all;
  const auto count = [&](const PathPiece& piece) { return piece.straight() ? 1 : steps; };
  all.reserve(run.size() * static_cast<std::size_t>(steps));
  for (const PathPiece& piece : run) {
    const double length = piece.length / count(piece);
    for (int k = 0; k < count(piece); ++k) all.emplace_back(robot, piece, k * length, length);
  }
  std::vector<double> x(all.size() + 1, 0);
  for (std::size_t k = all.size(); k-- > 1;) x[k] = all[k].largest(x[k + 1]);
  for (std::size_t k = 0; k + 1 < x.size(); ++k) x[k + 1] = all[k].furthest(x[k], x[k + 1]);

  Pieces pieces(run.front().start);
  std::vector<std::array<double, 2>> blends;
  std::size_t k = 0;
  for (const PathPiece& piece : run) {
    if (piece.straight()) {
      double most = kInfinity, force = kInfinity;
      for (int j = 0; j < robot.size(); ++j) {
        const double rate = std::abs(piece.along[j]);
        most = std::min(most, robot.joints[j].velocity / rate);
        force = std::min(force, robot.joints[j].acceleration / rate);
      }
      add_edge(pieces, piece, x[k], x[k + 1], most * most, force);
      ++k;
      continue;
    }
    const double length = piece.length / steps, begin = pieces.time();
    for (int step = 0; step < steps; ++step, ++k)
      add_step(pieces, piece, step * length, length, x[k], x[k + 1]);
    blends.push_back({begin, pieces.time()});
  }
  return slow_enough(robot, {Trajectory(pieces.take()), std::move(blends)});
}

TimedRun smoothed(const Robot& robot, const TimedRun& run, const std::function<bool()>& stopped) {
  constexpr double kSlower = 1.1;
  TimedRun slow = run;
  Trajectory best = mean_within_jerk(robot, run.motion, stopped);
  while (!stopped()) {
    TimedRun next = slower(slow, kSlower);
    Trajectory mean = mean_within_jerk(robot, next.motion, stopped);
    if (stopped() || !(mean.duration() < best.duration())) break;
    best = std::move(mean);
    slow = std::move(next);
  }
  const double window = best.duration() - slow.motion.duration();
  for (auto& [begin, end] : slow.blends) end += window;
  return slow_enough(robot, {std::move(best), std::move(slow.blends)});
}

}  // namespace lasius::arm
