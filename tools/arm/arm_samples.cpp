#include "tools/arm/arm_samples.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <ostream>

#include "tools/console/values.h"
#include "tools/record/json_values.h"

namespace lasius::tool {
namespace {

void write_list(std::ostream& out, const char* key, const arm::JointVector& values) {
  out << key << ": [";
  for (Eigen::Index i = 0; i < values.size(); ++i)
    out << (i > 0 ? ", " : "") << yaml_real(values[i]);
  out << "]\n";
}

}  // namespace

std::vector<std::string> joint_names(const arm::Robot& robot) {
  std::vector<std::string> names;
  for (const arm::Joint& joint : robot.joints)
    names.push_back(joint.name.empty() ? "q" + std::to_string(names.size() + 1) : joint.name);
  return names;
}

std::vector<std::string> link_names(const arm::Robot& robot) {
  std::vector<std::string> names;
  for (const arm::Link& link : robot.links)
    names.push_back(link.name.empty() ? arm::link_name(robot, static_cast<int>(names.size()))
                                      : link.name);
  return names;
}

double sample_rate(const arm::Trajectory& trajectory, double wanted) {
  return trajectory.duration() * wanted <= kMostSamples ? wanted
                                                        : kMostSamples / trajectory.duration();
}

std::vector<double> sample_times(const arm::Trajectory& trajectory, double wanted) {
  const double rate = sample_rate(trajectory, wanted);
  const double count = std::floor(trajectory.duration() * rate);
  std::vector<double> times;
  for (double i = 0; i <= count; ++i) times.push_back(std::min(i / rate, trajectory.duration()));
  if (times.back() < trajectory.duration()) times.push_back(trajectory.duration());
  return times;
}

void write_csv(std::ostream& out, const arm::Robot& robot, const arm::Trajectory& trajectory,
               double rate) {
  out << "t";
  for (const char* what : {"", "_velocity", "_acceleration"})
    for (const std::string& name : joint_names(robot)) out << "," << csv_field(name + what);
  out << ",x,y,z\n";
  if (trajectory.empty()) return;
  for (const double t : sample_times(trajectory, rate)) {
    const auto state = trajectory.at(t);
    out << to_text(t);
    for (const auto* values : {&state.q, &state.dq, &state.ddq})
      for (const double value : *values) out << "," << to_text(value);
    for (const double value : arm::tip_position(robot, state.q)) out << "," << to_text(value);
    out << "\n";
  }
}

void write_ros_trajectory(std::ostream& out, const arm::Robot& robot,
                          const arm::Trajectory& trajectory, double rate) {
  out << "joint_names:\n";
  for (const std::string& name : joint_names(robot)) out << "  - " << dumped(name) << "\n";
  if (trajectory.empty()) {
    out << "points: []\n";
    return;
  }
  out << "points:\n";
  for (const double t : sample_times(trajectory, rate)) {
    const auto state = trajectory.at(t);
    write_list(out, "  - positions", state.q);
    write_list(out, "    velocities", state.dq);
    write_list(out, "    accelerations", state.ddq);
    const auto nanoseconds = static_cast<std::int64_t>(std::llround(t * 1e9));
    out << "    time_from_start: {sec: " << nanoseconds / 1000000000
        << ", nanosec: " << nanoseconds % 1000000000 << "}\n";
  }
}

}  // namespace lasius::tool
