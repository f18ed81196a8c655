#include "tools/arm/arm_picture.h"

#include <algorithm>
#include <array>
#include <utility>

#include "tools/arm/arm_outline.h"
#include "tools/arm/arm_samples.h"
#include "tools/console/values.h"
#include "tools/draw/canvas.h"
#include "tools/draw/colours.h"
#include "tools/draw/line_chart.h"
#include "tools/draw/page.h"

namespace lasius::tool {
namespace {

using Eigen::Vector3d;

constexpr Colour kObstacle{0.45, 0.48, 0.53};
constexpr Colour kBase{0.45, 0.3, 0.15};
constexpr Colour kGhost{0.45, 0.6, 0.78};
constexpr Colour kTip{0.8, 0.12, 0.12};
constexpr Colour kLatticeLine{0.35, 0.2, 0.5};

/// What a view looks along is left out: coordinates `across` and `up` are shown.
struct Aspect {
  const char* name;
  int across;
  int up;
};
constexpr std::array<Aspect, 3> kViews{Aspect{"from above", 0, 1}, Aspect{"from the front", 0, 2},
                                       Aspect{"from the side", 1, 2}};

/// One view's place on the page, in metres, both axes alike.
struct View3 {
  const Aspect& view;
  Axes axes;

  View3(const Aspect& seen, const Box& box, const Eigen::AlignedBox3d& bounds)
      : view(seen), axes{.box = box, .x = {}, .y = {}} {
    const double room = 0.53 * std::max(bounds.sizes().maxCoeff(), 0.01);
    const auto around = [&](int axis) {
      const double middle = bounds.center()[axis];
      return Range{middle - room, middle + room};
    };
    axes.x = around(view.across);
    axes.y = around(view.up);
  }
  Point at(const Vector3d& p) const { return axes.at(p[view.across], p[view.up]); }
  double scale() const { return axes.box.width / (axes.x.high - axes.x.low); }
};

void draw_solid(Canvas& canvas, const View3& frame, const arm::Solid& solid, Colour colour,
                double opacity) {
  if (solid.shape == arm::Solid::Shape::capsule) {
    const Point ends[] = {frame.at(solid.pose.translation()), frame.at(solid.pose * solid.size)};
    canvas.stroke(ends, colour, std::max(2.0, 2 * solid.radius * frame.scale()), opacity);
    return;
  }
  std::vector<Point> flat;
  for (const Vector3d& p : outline(solid)) flat.push_back(frame.at(p));
  canvas.area(hull(std::move(flat)), colour, opacity);
}

/// What moves of it.
void draw_arm(Canvas& canvas, const View3& frame, const arm::Robot& robot,
              const arm::JointVector& q, Colour colour, double opacity) {
  for (const arm::Link& link : arm::place_links(robot, q)) {
    if (link.body == 0) continue;
    for (const arm::Solid& solid : link.solids) draw_solid(canvas, frame, solid, colour, opacity);
  }
}

/// A line through the joints and the tip.
void draw_bones(Canvas& canvas, const View3& frame, const arm::Robot& robot,
                const arm::JointVector& q, Colour colour) {
  std::vector<Point> bones;
  const auto bodies = body_poses(robot, q);
  for (std::size_t i = 0; i < robot.joints.size(); ++i)
    bones.push_back(frame.at((bodies[i] * robot.joints[i].frame).translation()));
  bones.push_back(frame.at(bodies.back() * robot.tip.translation()));
  canvas.stroke(bones, colour, 2.5, 1);
}

/// Poses to show, evenly in time: first and last are start and goal.
std::vector<arm::JointVector> poses(const ArmAnswer& answer) {
  constexpr int kPoses = 7;
  const arm::Trajectory& trajectory = answer.plan.trajectory;
  if (trajectory.empty()) return {answer.start};
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

bool in_lattice(const ArmAnswer& answer) { return !answer.plan.direct && !answer.plan.trees; }

void draw_view(Canvas& canvas, const Box& box, const Aspect& view,
               const Eigen::AlignedBox3d& bounds, const ArmAnswer& answer) {
  const View3 frame(view, box, bounds);
  static constexpr const char* kNames[] = {"x, m", "y, m", "z, m"};
  draw_axes(canvas, frame.axes, kNames[view.across], kNames[view.up], true);
  canvas.clip(box);
  for (const auto& o : answer.scene.obstacles) draw_solid(canvas, frame, o, kObstacle, 0.35);
  for (const arm::Link& link : answer.robot.links)
    if (link.body == 0)
      for (const arm::Solid& solid : link.solids) draw_solid(canvas, frame, solid, kBase, 0.5);
  const auto shown = poses(answer);
  for (std::size_t i = 1; i + 1 < shown.size(); ++i)
    draw_arm(canvas, frame, answer.robot, shown[i], kGhost, 0.16);
  draw_arm(canvas, frame, answer.robot, shown.front(), kStart, 0.35);
  draw_bones(canvas, frame, answer.robot, shown.front(), kStart);
  if (shown.size() > 1) {
    draw_arm(canvas, frame, answer.robot, shown.back(), kGoal, 0.35);
    draw_bones(canvas, frame, answer.robot, shown.back(), kGoal);
  }
  const auto line = [&](const auto& points, Colour colour, double width) {
    std::vector<Point> flat;
    for (const auto& p : points) flat.push_back(frame.at(p));
    if (flat.size() > 1) canvas.stroke(flat, colour, width, 1);
  };
  if (in_lattice(answer)) line(answer.plan.tips.colwise(), kLatticeLine, 1.5);
  line(tip_path(answer), kTip, 3);
  for (const arm::Goal& goal : answer.goals)
    canvas.diamond(frame.at(tip_of(answer.robot, goal)), 10, kGoal);
  canvas.ring(frame.at(arm::tip_position(answer.robot, shown[0])), 7, kStart);
  canvas.unclip();
  canvas.frame(box, kInk, 1);
}

std::vector<Key> keys_of(const ArmAnswer& answer) {
  const auto pale = [](Colour colour, double opacity) { return blend({1, 1, 1}, colour, opacity); };
  std::vector<Key> keys{
      start_key("tip at the start"),
      goal_key(answer.goals.size() == 1 ? "goal of the tip" : "goals of the tip")};
  keys.push_back(area_key("arm at the start", pale(kStart, 0.5)));
  if (!answer.plan.trajectory.empty()) {
    keys.push_back(area_key("arm at the end", pale(kGoal, 0.5)));
    keys.push_back(area_key("between, evenly in time", pale(kGhost, 0.35)));
    keys.push_back(line_key("way of the tip", kTip, 3));
  }
  if (in_lattice(answer) && answer.plan.tips.cols() > 1)
    keys.push_back(line_key("lattice path", kLatticeLine, 1.5));
  keys.push_back(area_key("base", pale(kBase, 0.5)));
  if (!answer.scene.obstacles.empty()) keys.push_back(area_key("obstacle", pale(kObstacle, 0.5)));
  return keys;
}

LineChart joint_chart(const ArmAnswer& answer) {
  constexpr int kSamples = 300;
  LineChart chart{.title = "joints",
                  .x_label = "time, s",
                  .y_label = "value, rad or m",
                  .curves = {},
                  .lengths = false};
  const arm::Trajectory& trajectory = answer.plan.trajectory;
  const auto names = joint_names(answer.robot);
  for (int j = 0; j < answer.robot.size(); ++j) {
    Curve curve{.label = names[j], .colour = palette(static_cast<std::size_t>(j))};
    for (int i = 0; i <= kSamples; ++i) {
      const double t = trajectory.duration() * i / kSamples;
      curve.x.push_back(t);
      curve.y.push_back(trajectory.at(t).q[j]);
    }
    chart.curves.push_back(std::move(curve));
  }
  return chart;
}

/// So far, by iteration: a step from the start of each to its end. Precondition: there is one.
LineChart question_chart(const std::vector<arm::Questions>& asked) {
  Curve positions{.label = "positions", .colour = palette(1)};
  Curve motions{.label = "motions", .colour = palette(0)};
  const auto add = [&](double x, const arm::Questions& count) {
    positions.x.push_back(x);
    motions.x.push_back(x);
    positions.y.push_back(static_cast<double>(count.positions));
    motions.y.push_back(static_cast<double>(count.motions));
  };
  add(0, {});
  for (std::size_t i = 0; i < asked.size(); ++i) add(static_cast<double>(i), asked[i]);
  add(static_cast<double>(asked.size()), asked.back());
  return {.title = "questions asked",
          .x_label = "iteration",
          .y_label = "questions so far",
          .curves = {positions, motions},
          .lengths = false};
}

/// What came of it, below or beside the title.
std::string figures_text(const ArmAnswer& answer) {
  if (answer.plan.tips.cols() == 0) return std::string(to_string(answer.plan.status));
  return printed("%s %.3g %s, %lld positions and %lld motions asked, takes %.2f s",
                 answer.plan.direct  ? "straight in joint space,"
                 : answer.plan.trees ? "two trees met,"
                                     : "lattice path",
                 answer.plan.length, unit_of(answer.parameters.objective),
                 static_cast<long long>(answer.plan.questions.positions),
                 static_cast<long long>(answer.plan.questions.motions),
                 answer.plan.trajectory.duration());
}

}  // namespace

Eigen::AlignedBox3d bounds_of(const ArmAnswer& answer) {
  Eigen::AlignedBox3d bounds;
  for (const auto& q : poses(answer))
    for (const arm::Link& link : arm::place_links(answer.robot, q))
      for (const arm::Solid& solid : link.solids)
        for (const Vector3d& p : outline(solid)) bounds.extend(p);
  for (const Eigen::Vector3d p : answer.plan.tips.colwise()) bounds.extend(p);
  for (const arm::Goal& goal : answer.goals) bounds.extend(tip_of(answer.robot, goal));
  // Obstacles far from the arm may be cut off.
  const Vector3d room = Vector3d::Constant(0.3 * std::max(bounds.sizes().maxCoeff(), 0.01));
  const Eigen::AlignedBox3d near(bounds.min() - room, bounds.max() + room);
  for (const auto& o : answer.scene.obstacles)
    for (const Vector3d& p : outline(o)) bounds.extend(p.cwiseMax(near.min()).cwiseMin(near.max()));
  return bounds;
}

std::string arm_title(const ArmCommand& command, const ArmAnswer& answer) {
  return std::string(answer.parameters.algorithm()) + ": " + file_name(command.robot) + " in " +
         file_name(command.scene) + ", seed " + std::to_string(command.seed);
}

void write_arm_picture(const std::string& file, const ArmCommand& command,
                       const ArmAnswer& answer) {
  const arm::Result& plan = answer.plan;
  const bool moves = !plan.trajectory.empty() && plan.trajectory.duration() > 0;
  const Eigen::AlignedBox3d bounds = bounds_of(answer);
  std::vector<Panel> views, charts;
  for (const Aspect& view : kViews)
    views.push_back({view.name, [&](Canvas& canvas, const Box& box) {
                       draw_view(canvas, box, view, bounds, answer);
                     }});
  const auto add = [&](const auto& draw_chart) { charts.push_back({"", draw_chart, true}); };
  if (moves) add([&](Canvas& canvas, const Box& box) { draw(canvas, box, joint_chart(answer)); });
  if (!plan.curves.best.empty())
    add([&](Canvas& canvas, const Box& box) {
      Convergence convergence{.best = {"best lattice path so far", plan.curves.best},
                              .tours = {{"mean tour of the ants", plan.curves.mean}},
                              .unit = unit_of(answer.parameters.objective)};
      if (plan.lower_bound) convergence.levels = {{"lower bound", *plan.lower_bound}};
      draw_convergence(canvas, box, convergence);
    });
  if (!plan.asked.empty())
    add([&](Canvas& canvas, const Box& box) { draw(canvas, box, question_chart(plan.asked)); });
  Page page{.title = arm_title(command, answer) + ": " + figures_text(answer),
            .legend = keys_of(answer),
            .cells = false,
            .bands = {{.rows = {std::move(views)}, .small = true, .columns = 3}}};
  if (!charts.empty())
    page.bands.push_back({.rows = {std::move(charts)}, .small = true, .columns = 3});
  write_page(file, page);
}

}  // namespace lasius::tool
