#include "tools/study/sources/goritov2020.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "lasius/arm/generate.h"
#include "lasius/base/error.h"

namespace lasius::study {
namespace {

constexpr int kSide = 12;  // lattice points a side
constexpr int kObstacles = 12;

arm::GenerateOptions options_of(const std::string& source) {
  std::istringstream words(source);
  std::string scene;
  arm::GenerateOptions options{.obstacles = kObstacles};
  words >> scene >> options.seed >> options.wall;
  if (!words || scene != "scene")
    throw Error(ErrorCode::invalid_parameter, "no scene is made by \"" + source + "\"",
                "say scene SEED WALL");
  return options;
}

arm::Params parameters_for(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const double widest =
      std::max({std::abs(from[0] - to[0]), std::abs(from[1] - to[1]), std::abs(from[2] - to[2])});
  arm::Params parameters("goritov2020");
  parameters.side = kSide;
  parameters.pitch = widest / (0.6 * kSide);
  parameters.threads = 1;
  return parameters;
}

}  // namespace

struct ArmScenes::Case {
  arm::Scene scene;
  arm::Request request;
  arm::Params parameters;
  arm::SceneSensor sensor;
  ArmGround ground;

  Case(const arm::Robot& robot, const arm::GenerateOptions& options)
      : Case(robot, arm::generate_query(robot, options)) {}

 private:
  Case(const arm::Robot& robot, arm::Query query)
      : scene(std::move(query.scene)),
        request{.start = std::move(query.start), .goals = {query.goal}, .motion = false},
        parameters(parameters_for(arm::tip_position(robot, request.start), query.goal)),
        sensor(robot, scene) {
    const arm::Result best = arm::shortest_lattice_way(robot, sensor, request, parameters);
    const arm::Result straight = arm::straight_lattice_way(robot, sensor, request, parameters);
    const Eigen::Vector3d from = arm::tip_position(robot, request.start), to = query.goal;
    const auto moves = [&](double a, double b) {
      return std::round(std::abs(a - b) / parameters.pitch);
    };
    const double nearest =
        parameters.pitch * (moves(from[0], to[0]) + moves(from[1], to[1]) + moves(from[2], to[2]));
    ground = {best.length, best.length / nearest, straight.status == Status::solved};
  }
};

ArmScenes::ArmScenes(const Study& study, const std::filesystem::path& maps)
    : robot_(arm::read_robot((maps / "arms" / "industrial6.json").string())) {
  for (const Experiment& experiment : study.experiments)
    for (const Question& question : experiment.questions)
      if (auto& entry = cases_[question.map]; !entry)
        entry = std::make_unique<const Case>(robot_, options_of(question.map));
}

ArmScenes::~ArmScenes() = default;

const ArmGround& ArmScenes::ground(const Question& question) const {
  return cases_.at(question.map)->ground;
}

PreparedRun ArmScenes::prepare(const Question& question, const Contender& contender) const {
  const Case& scene = *cases_.at(question.map);
  const arm::Params params = configured(scene.parameters, contender);
  PreparedRun prepared =
      run_of(question.map, params, arm::find_algorithm(params.algorithm()).parameters, 3 * kSide);
  prepared.run = [this, &scene, params](std::uint64_t seed, bool pilot, const std::stop_token& stop,
                                        Workspace&) {
    arm::Params seeded = params;
    seeded.seed = seed;
    if (pilot) seeded.iterations = pilot_part(params.iterations);
    arm::Request request = scene.request;
    request.stop.token = stop;
    const double begin = thread_seconds();
    arm::Result result = arm::plan(robot_, scene.sensor, request, seeded);
    Run run{.status = result.status,
            .length = result.length / scene.ground.optimum,
            .iterations = result.curves.iterations,
            .seconds = thread_seconds() - begin,
            .best = std::move(result.curves.best),
            .mean = std::move(result.curves.mean),
            .limit = 1,
            .steps = result.steps,
            .checks = result.questions.positions + result.questions.motions};
    for (auto* curve : {&run.best, &run.mean})
      for (double& length : *curve) length /= scene.ground.optimum;
    return run;
  };
  return prepared;
}

std::optional<double> ArmScenes::optimum(const Question&, const Optimum&,
                                         const StopCondition&) const {
  return 1;  // lengths are shares of it
}

}  // namespace lasius::study
