// Component lasius::arm: robots and scenes from files, plans, motions.
#include <pybind11/eigen.h>

#include "lasius/arm/generate.h"
#include "lasius/arm/plan.h"
#include "python/extension/arrays.h"
#include "python/extension/call.h"
#include "python/extension/modules.h"
#include "python/extension/parameter_class.h"
#include "python/extension/progress.h"
#include "python/extension/results.h"

namespace lasius::python {
namespace {

namespace arm = lasius::arm;
using arm::JointVector;

/// Rows in numpy's order of what the library keeps in columns.
Eigen::MatrixXd rows_of(const Eigen::Ref<const Eigen::MatrixXd>& columns) {
  return columns.transpose();
}

arm::Pose pose_from(const Eigen::Matrix4d& matrix) {
  arm::Pose pose;
  pose.matrix() = matrix;
  return pose;
}

/// (questions of positions, of motions, of the motion's making)
py::tuple questions(const arm::Questions& q) {
  return py::make_tuple(q.positions, q.motions, q.trajectory);
}

/// In the order of the fields of lasius.arm.Result.
py::tuple fields(const arm::Result& r) {
  return py::make_tuple(search_fields(r), rows_of(r.joints), rows_of(r.tips), r.trajectory,
                        r.waypoints, r.stops, r.goal, r.direct, r.trees, r.tip_travel,
                        r.joint_travel, r.duration, r.pitch, r.points, questions(r.questions),
                        r.steps, r.notes);
}

py::tuple plan_motion(const arm::Robot& robot, const arm::SceneSensor& sensor,
                      const JointVector& start, const std::vector<arm::Goal>& goals,
                      const arm::Params& params, double target_gap, bool motion, double duration,
                      std::optional<double> time_limit, const py::object& callback) {
  Call call(time_limit);
  const arm::Observer observe = observer<arm::ArmProgress>(call, callback);
  arm::Request request{start, goals, call.condition(), target_gap, motion, duration};
  const arm::Result result =
      call.run([&] { return arm::plan(robot, sensor, request, params, observe); });
  return py::make_tuple(call.error(), fields(result));
}

/// (q, dq, ddq) at each time, (n, joints) each.
py::tuple states(const arm::Trajectory& trajectory, const JointVector& times) {
  if (trajectory.empty()) throw py::value_error("there is no motion: the trajectory is empty");
  const Eigen::Index joints = trajectory.knots().front().q.size();
  Eigen::MatrixXd q(times.size(), joints), dq(times.size(), joints), ddq(times.size(), joints);
  for (Eigen::Index i = 0; i < times.size(); ++i) {
    const arm::Trajectory::State state = trajectory.at(times[i]);
    q.row(i) = state.q.transpose();
    dq.row(i) = state.dq.transpose();
    ddq.row(i) = state.ddq.transpose();
  }
  return py::make_tuple(q, dq, ddq);
}

/// (time, q, ddq) of each knot.
py::tuple knots(const arm::Trajectory& trajectory) {
  py::list all;
  for (const auto& knot : trajectory.knots())
    all.append(py::make_tuple(knot.time, knot.q, knot.ddq));
  return py::tuple(all);
}

arm::Trajectory trajectory_of(const py::tuple& state) {
  std::vector<arm::Trajectory::Knot> knots;
  for (const py::handle& item : state) {
    const auto [time, q, ddq] = item.cast<std::tuple<double, JointVector, JointVector>>();
    knots.push_back({time, q, ddq});
  }
  return knots.empty() ? arm::Trajectory() : arm::Trajectory(std::move(knots));
}

py::tuple rechecked(const arm::Robot& robot, const arm::Scene& scene,
                    const arm::Trajectory& trajectory, int samples) {
  Call call;
  const arm::Recheck r =
      call.run([&] { return arm::recheck(robot, scene, trajectory, samples, call.condition()); });
  return py::make_tuple(call.error(), py::make_tuple(r.samples, r.contacts, r.unproven, r.limits,
                                                     r.nearest, r.tip_error));
}

/// A solid, of a scene or held; corners (3 n, 3) of a mesh.
arm::Obstacle solid_of(const std::string& name, const std::string& shape,
                       const Eigen::Vector3d& size, double radius, double length,
                       const Eigen::Matrix4d& pose, const Eigen::MatrixXd& corners) {
  arm::Obstacle solid;
  for (std::size_t i = 0; i < arm::kShapeNames.size(); ++i)
    if (arm::kShapeNames[i] == shape) solid.shape = static_cast<arm::Solid::Shape>(i);
  solid.name = name;
  solid.size = size;
  solid.radius = radius;
  solid.length = length;
  solid.pose = pose_from(pose);
  arm::Triangles triangles;
  for (Eigen::Index i = 0; i + 2 < corners.rows(); i += 3)
    triangles.push_back({corners.row(i), corners.row(i + 1), corners.row(i + 2)});
  if (!triangles.empty())
    solid.triangles = std::make_shared<const arm::Triangles>(std::move(triangles));
  return solid;
}

arm::Scene scene_of(const std::vector<arm::Obstacle>& obstacles, const std::string& name) {
  arm::Scene scene{.name = name, .obstacles = obstacles};
  arm::validate(scene);
  return scene;
}

arm::Robot holding(const arm::Robot& robot, const std::vector<arm::Obstacle>& solids,
                   const std::string& name, const std::vector<std::string>& may_touch) {
  return arm::holding(robot, name, {solids.begin(), solids.end()}, may_touch);
}

/// (n, joints)
Eigen::MatrixXd inverse(const arm::Robot& robot, const arm::Goal& goal, const JointVector& near,
                        int most, std::uint64_t seed) {
  const std::vector<JointVector> found = arm::inverse_kinematics(robot, goal, near, most, seed);
  Eigen::MatrixXd rows(std::ssize(found), robot.size());
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    rows.row(i) = found[static_cast<std::size_t>(i)].transpose();
  return rows;
}

/// In the order of the fields of lasius.arm.TipLine.
py::tuple tip_line(const arm::Robot& robot, const arm::SceneSensor& sensor,
                   const JointVector& start, const Eigen::Matrix4d& goal, double tolerance,
                   double angle_tolerance, double joint_step, bool motion, double duration,
                   std::optional<double> time_limit) {
  Call call(time_limit);
  const arm::TipLineOptions options{.tolerance = tolerance,
                                    .angle_tolerance = angle_tolerance,
                                    .joint_step = joint_step,
                                    .stop = call.condition(),
                                    .motion = motion,
                                    .duration = duration};
  const arm::TipLine line =
      call.run([&] { return arm::tip_line(robot, sensor, start, pose_from(goal), options); });
  return py::make_tuple(call.error(),
                        py::make_tuple(std::string(to_string(line.status)), rows_of(line.joints),
                                       line.reached, line.error, line.trajectory, line.stops));
}

/// Limits of all joints, in order.
template <double arm::Joint::*kLimit>
JointVector limits(const arm::Robot& robot) {
  JointVector all(robot.size());
  for (int i = 0; i < robot.size(); ++i) all[i] = robot.joints[static_cast<std::size_t>(i)].*kLimit;
  return all;
}

std::vector<std::string> joint_names(const arm::Robot& robot) {
  std::vector<std::string> names;
  for (const arm::Joint& joint : robot.joints) names.push_back(joint.name);
  return names;
}

arm::Robot read_robot(const std::string& path, const std::string& base, const std::string& tip,
                      const std::map<std::string, double>& set_joints, const std::string& srdf,
                      const std::string& joint_limits,
                      const std::map<std::string, std::string>& packages, bool use_visual,
                      bool bodiless) {
  return arm::read_robot(path, {.base = base,
                                .tip = tip,
                                .set_joints = set_joints,
                                .srdf = srdf,
                                .joint_limits = joint_limits,
                                .packages = packages,
                                .use_visual = use_visual,
                                .bodiless = bodiless});
}

void bind_worlds(py::module_& module) {
  py::class_<arm::Robot>(module, "Robot")
      .def_readonly("name", &arm::Robot::name)
      .def_readonly("notes", &arm::Robot::notes)
      .def_readonly("warnings", &arm::Robot::warnings)
      .def_readonly("states", &arm::Robot::states)
      .def("__len__", &arm::Robot::size)
      .def("joint_names", &joint_names)
      .def("low", &limits<&arm::Joint::low>)
      .def("high", &limits<&arm::Joint::high>)
      .def("tip_position",
           [](const arm::Robot& r, const JointVector& q) { return arm::tip_position(r, q); })
      .def("tip_pose", [](const arm::Robot& r, const JointVector& q) {
        return Eigen::Matrix4d(arm::tip_pose(r, q).matrix());
      });
  py::class_<arm::Scene>(module, "Scene")
      .def(py::init<>())
      .def(py::init(&scene_of))
      .def_readonly("name", &arm::Scene::name)
      .def_readonly("warnings", &arm::Scene::warnings)
      .def("__len__", [](const arm::Scene& scene) { return scene.obstacles.size(); });
  py::class_<arm::Obstacle>(module, "Solid").def(py::init(&solid_of));
  module.def("holding", &holding);
  module.def("read_robot", &read_robot);
  module.def("read_scene", [](const std::string& path) { return arm::read_scene(path); });
  module.def("generate_query", [](const arm::Robot& robot, std::uint64_t seed, int obstacles,
                                  double wall, double least_distance) {
    const arm::Query q = arm::generate_query(robot, {seed, obstacles, wall, least_distance});
    return py::make_tuple(q.scene, q.start, q.goal, q.goal_joints);
  });
}

void bind_sensor(py::module_& module) {
  py::class_<arm::SceneSensor>(module, "SceneSensor")
      .def(py::init<const arm::Robot&, const arm::Scene&, double>())
      .def("position_free",
           [](const arm::SceneSensor& s, const JointVector& q) { return s.position_free(q); })
      .def("motion_free", [](const arm::SceneSensor& s, const JointVector& from,
                             const JointVector& to) { return s.motion_free(from, to); })
      .def("distance",
           [](const arm::SceneSensor& s, const JointVector& q) { return s.distance(q); })
      .def("nearest",
           [](const arm::SceneSensor& s, const JointVector& q) {
             const arm::SceneSensor::Nearest found = s.nearest(q);
             return py::make_tuple(found.distance, found.link, found.other);
           })
      .def("contact", [](const arm::SceneSensor& s, const JointVector& q) { return s.contact(q); });
}

void bind_goal(py::module_& module) {
  py::class_<arm::Goal>(module, "Goal")
      .def_static("position", [](const Eigen::Vector3d& p) { return arm::Goal::position(p); })
      .def_static(
          "pose",
          [](const Eigen::Matrix4d& pose, double position_tolerance, double angle_tolerance) {
            return arm::Goal::pose(pose_from(pose), position_tolerance, angle_tolerance);
          })
      .def_static("joints", [](const JointVector& q) { return arm::Goal::joints(q); })
      .attr("tolerance") = arm::Goal::kTolerance;
}

}  // namespace

void bind_arm(py::module_& module) {
  bind_worlds(module);
  bind_sensor(module);
  bind_goal(module);
  py::class_<arm::Trajectory>(module, "Trajectory")
      .def_property_readonly("duration", &arm::Trajectory::duration)
      .def("__bool__", [](const arm::Trajectory& t) { return !t.empty(); })
      .def("states", &states)
      .def(py::pickle(&knots, &trajectory_of));
  bind_parameter_class<arm::Params>(module).def(py::init<const std::string&>());
  bind_progress<arm::ArmProgress>(module, "Progress")
      .def_property_readonly(
          "questions", [](const View<arm::ArmProgress>& v) { return questions(v.get().questions); })
      .def("joints", [](const View<arm::ArmProgress>& v) { return rows_of(v.get().joints()); });
  module.def("algorithms", [] { return described(arm::algorithms()); });
  module.def("plan", &plan_motion);
  module.def("recheck", &rechecked);
  module.def("inverse", &inverse);
  module.def("tip_line", &tip_line);
}

}  // namespace lasius::python
