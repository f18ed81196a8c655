#include "tools/arm/arm_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>

#include "tools/arm/arm_outline.h"
#include "tools/draw/canvas.h"
#include "tools/draw/chart.h"
#include "tools/draw/colours.h"
#include "tools/draw/line_chart.h"

namespace lasius::tool {
namespace {

using Eigen::Vector3d;

constexpr Colour kPaleGrid{0.9, 0.91, 0.93};
constexpr Colour kObstacle{0.45, 0.48, 0.53};
constexpr Colour kBase{0.3, 0.33, 0.38};
constexpr Colour kGhost{0.45, 0.6, 0.78};
constexpr Colour kTip{0.8, 0.12, 0.12};
constexpr Colour kLattice{0.35, 0.2, 0.5};
constexpr double kMargin = 24, kTitle = 40, kView = 480, kBetween = 24, kCaption = 34;
constexpr double kChart = 400;

/// What a view looks along is left out: coordinates `across` and `up` are shown.
struct View {
  const char* name;
  int across;
  int up;
};
constexpr std::array<View, 3> kViews{View{"from above: x, y", 0, 1},
                                     View{"from the front: x, z", 0, 2},
                                     View{"from the side: y, z", 1, 2}};

/// The part of space that all views show.
struct Bounds {
  Vector3d low = Vector3d::Constant(1e9), high = Vector3d::Constant(-1e9);
  void add(const Vector3d& p, double r = 0) {
    low = low.cwiseMin((p.array() - r).matrix());
    high = high.cwiseMax((p.array() + r).matrix());
  }
  double widest() const { return std::max((high - low).maxCoeff(), 0.01); }
};

/// One view's place on the page: metres to pixels, both axes alike, up is up.
class Frame {
 public:
  Frame(const View& view, const Box& box, const Bounds& bounds)
      : view_(view), scale_(box.width / (1.06 * bounds.widest())) {
    const double across = 0.5 * (bounds.low[view.across] + bounds.high[view.across]);
    const double up = 0.5 * (bounds.low[view.up] + bounds.high[view.up]);
    origin_ = {box.x + box.width / 2 - scale_ * across, box.y + box.height / 2 + scale_ * up};
  }
  Point at(const Vector3d& p) const {
    return {origin_.x + scale_ * p[view_.across], origin_.y - scale_ * p[view_.up]};
  }
  double scale() const { return scale_; }
  Point metres(Point page) const {
    return {(page.x - origin_.x) / scale_, (origin_.y - page.y) / scale_};
  }

 private:
  const View& view_;
  double scale_;
  Point origin_{};
};

std::string short_text(double value) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%g", std::abs(value) < 1e-9 ? 0.0 : value);
  return text.data();
}

void draw_grid(Canvas& canvas, const Box& box, const Frame& frame) {
  const Point low = frame.metres({box.x, box.y + box.height});
  const Point high = frame.metres({box.x + box.width, box.y});
  const Point zero = frame.at(Vector3d::Zero());
  for (const double x : ticks(low.x, high.x, 6)) {
    const double at = zero.x + (x * frame.scale());
    canvas.line({at, box.y}, {at, box.y + box.height}, kPaleGrid, 1);
    canvas.text({at + 3, box.y + box.height - 5}, short_text(x), 12, Align::left, kInk);
  }
  for (const double y : ticks(low.y, high.y, 6)) {
    const double at = zero.y - (y * frame.scale());
    canvas.line({box.x, at}, {box.x + box.width, at}, kPaleGrid, 1);
    canvas.text({box.x + 4, at - 3}, short_text(y), 12, Align::left, kInk);
  }
}

void draw_capsule(Canvas& canvas, const Frame& frame, const arm::Capsule& capsule, Colour colour,
                  double opacity) {
  const Point ends[] = {frame.at(capsule.from), frame.at(capsule.to)};
  canvas.stroke(ends, colour, std::max(2.0, 2 * capsule.radius * frame.scale()), opacity);
}

/// What moves of it.
void draw_arm(Canvas& canvas, const Frame& frame, const arm::Robot& robot,
              const arm::JointVector& q, Colour colour, double opacity) {
  const auto capsules = arm::place_capsules(robot, q);
  for (std::size_t i = robot.base.size(); i < capsules.size(); ++i)
    draw_capsule(canvas, frame, capsules[i], colour, opacity);
}

/// A line through the middles of the links and the tip.
void draw_bones(Canvas& canvas, const Frame& frame, const arm::Robot& robot,
                const arm::JointVector& q, Colour colour) {
  std::vector<Point> bones;
  for (const arm::Capsule& c : arm::place_capsules(robot, q)) {
    bones.push_back(frame.at(c.from));
    bones.push_back(frame.at(c.to));
  }
  bones.push_back(frame.at(arm::tip_position(robot, q)));
  canvas.stroke(bones, colour, 2.5, 1);
}

/// Poses to show, evenly in time: first and last are start and goal.
std::vector<arm::JointVector> poses(const ArmAnswer& answer, const ArmCommand& command) {
  constexpr int kPoses = 7;
  const arm::Trajectory& trajectory = answer.plan.trajectory;
  if (trajectory.empty()) {
    if (command.start.size() == answer.robot.joints.size()) return {joint_vector(command.start)};
    return {};
  }
  std::vector<arm::JointVector> list;
  for (int i = 0; i < kPoses; ++i)
    list.push_back(trajectory.at(trajectory.duration() * i / (kPoses - 1)).q);
  return list;
}

std::vector<Vector3d> tip_path(const ArmAnswer& answer) {
  constexpr int kSamples = 300;
  std::vector<Vector3d> path;
  const arm::Trajectory& trajectory = answer.plan.trajectory;
  for (int i = 0; i <= kSamples && !trajectory.empty(); ++i)
    path.push_back(
        arm::tip_position(answer.robot, trajectory.at(trajectory.duration() * i / kSamples).q));
  return path;
}

void draw_view(Canvas& canvas, const Box& box, const View& view, const Bounds& bounds,
               const ArmCommand& command, const ArmAnswer& answer) {
  const Frame frame(view, box, bounds);
  draw_grid(canvas, box, frame);
  for (const auto& o : answer.scene.obstacles) {
    std::vector<Point> flat;
    for (const Vector3d& p : outline(o)) flat.push_back(frame.at(p));
    canvas.area(hull(std::move(flat)), kObstacle, 0.35);
  }
  for (const arm::Capsule& c : answer.robot.base) draw_capsule(canvas, frame, c, kBase, 0.5);
  const auto shown = poses(answer, command);
  for (std::size_t i = 1; i + 1 < shown.size(); ++i)
    draw_arm(canvas, frame, answer.robot, shown[i], kGhost, 0.16);
  if (!shown.empty()) {
    draw_arm(canvas, frame, answer.robot, shown.front(), kStart, 0.35);
    draw_bones(canvas, frame, answer.robot, shown.front(), kStart);
  }
  if (shown.size() > 1) {
    draw_arm(canvas, frame, answer.robot, shown.back(), kGoal, 0.35);
    draw_bones(canvas, frame, answer.robot, shown.back(), kGoal);
  }
  const auto line = [&](const auto& points, Colour colour, double width) {
    std::vector<Point> flat;
    for (const auto& p : points) flat.push_back(frame.at(p));
    if (flat.size() > 1) canvas.stroke(flat, colour, width, 1);
  };
  line(answer.plan.tips.colwise(), kLattice, 1.5);
  line(tip_path(answer), kTip, 3);
  if (!shown.empty()) canvas.disc(frame.at(arm::tip_position(answer.robot, shown[0])), 6, kStart);
  canvas.diamond(frame.at({command.goal[0], command.goal[1], command.goal[2]}), 8, kGoal);
  canvas.frame(box, kInk, 1);
}

study::LineChart joint_chart(const ArmAnswer& answer) {
  constexpr int kSamples = 300;
  study::LineChart chart{.title = "joints",
                         .x_label = "time, s",
                         .y_label = "value, rad or m",
                         .curves = {},
                         .lengths = false};
  const arm::Trajectory& trajectory = answer.plan.trajectory;
  for (int j = 0; j < answer.robot.size(); ++j) {
    const std::string& name = answer.robot.joints[j].name;
    study::Curve curve{
        .label = name.empty() ? std::string("q").append(std::to_string(j + 1)) : name,
        .colour = study::palette(static_cast<std::size_t>(j))};
    for (int i = 0; i <= kSamples; ++i) {
      const double t = trajectory.duration() * i / kSamples;
      curve.x.push_back(t);
      curve.y.push_back(trajectory.at(t).q[j]);
    }
    chart.curves.push_back(std::move(curve));
  }
  return chart;
}

Bounds bounds_of(const ArmCommand& command, const ArmAnswer& answer) {
  Bounds bounds;
  for (const auto& q : poses(answer, command))
    for (const auto& c : arm::place_capsules(answer.robot, q)) {
      bounds.add(c.from, c.radius);
      bounds.add(c.to, c.radius);
    }
  for (const Eigen::Vector3d p : answer.plan.tips.colwise()) bounds.add(p);
  bounds.add({command.goal[0], command.goal[1], command.goal[2]});
  // Obstacles far from the arm may be cut off.
  const Bounds arm = bounds;
  const double room = arm.widest();
  for (const auto& o : answer.scene.obstacles)
    for (const Vector3d& p : outline(o)) {
      const Vector3d low = arm.low.array() - 0.3 * room, high = arm.high.array() + 0.3 * room;
      bounds.add(p.cwiseMax(low).cwiseMin(high));
    }
  return bounds;
}

std::string title(const ArmCommand& command, const ArmAnswer& answer) {
  const auto base = [](const std::string& file) {
    return std::filesystem::path(file).filename().string();
  };
  std::string text = std::string(answer.parameters.algorithm()) + ": " + base(command.robot) +
                     " in " + base(command.scene) + ", seed " + std::to_string(command.seed) + ": ";
  if (answer.plan.tips.cols() == 0) return text + std::string(to_string(answer.plan.status));
  std::array<char, 160> figures;
  std::snprintf(
      figures.data(), figures.size(), "lattice path %.3g m, %lld + %lld questions, motion %.2f s",
      answer.plan.length, static_cast<long long>(answer.plan.questions.positions),
      static_cast<long long>(answer.plan.questions.motions), answer.plan.trajectory.duration());
  return text + figures.data();
}

}  // namespace

void write_arm_picture(const std::string& file, const ArmCommand& command,
                       const ArmAnswer& answer) {
  const bool moves = !answer.plan.trajectory.empty() && answer.plan.trajectory.duration() > 0;
  const bool charts = moves || !answer.plan.best.empty();
  const double width = 2 * kMargin + 3 * kView + 2 * kBetween;
  const double height = 2 * kMargin + kTitle + kView + kCaption + (charts ? kChart + kBetween : 0);
  Canvas canvas(static_cast<int>(width), static_cast<int>(height));
  canvas.text({width / 2, kMargin + 20}, title(command, answer), 19, Align::centre, kInk, true);

  const Bounds bounds = bounds_of(command, answer);
  for (std::size_t i = 0; i < kViews.size(); ++i) {
    const Box box{kMargin + static_cast<double>(i) * (kView + kBetween), kMargin + kTitle, kView,
                  kView};
    canvas.clip(box);
    draw_view(canvas, box, kViews[i], bounds, command, answer);
    canvas.unclip();
    canvas.text({box.x + kView / 2, box.y + kView + 23}, kViews[i].name, 16, Align::centre, kInk);
  }
  if (charts) {
    const double half = (width - 2 * kMargin - kBetween) / 2;
    const double top = kMargin + kTitle + kView + kCaption + kBetween / 2;
    if (moves) study::draw(canvas, {kMargin, top, half, kChart}, joint_chart(answer));
    if (!answer.plan.best.empty()) {
      draw_convergence(
          canvas, {kMargin + half + kBetween, top, half, kChart},
          {answer.plan.best, answer.plan.mean, answer.plan.lower_bound, "m", "lower bound"});
    }
  }
  canvas.save(file);
}

}  // namespace lasius::tool
