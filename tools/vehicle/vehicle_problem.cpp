#include <algorithm>

#include "tools/bitmap/map_ends.h"
#include "tools/bitmap/poses_file.h"
#include "tools/console/values.h"
#include "tools/options/commands.h"
#include "tools/record/problem.h"
#include "tools/record/recorded.h"
#include "tools/vehicle/vehicle_answer.h"
#include "tools/vehicle/vehicle_json.h"
#include "tools/vehicle/vehicle_kind.h"

namespace lasius::tool {
namespace {

/// `plan` of a vehicle.
class VehicleProblem : public ProblemOf<VehicleCommand> {
 public:
  /// @param vehicle   in place of the command's file
  /// @param recorded  the result that is made again: its layers are compared
  explicit VehicleProblem(VehicleCommand command, std::optional<LoadedVehicle> vehicle = {},
                          std::optional<Json> recorded = {})
      : ProblemOf(std::move(command)),
        vehicle_(std::move(vehicle)),
        recorded_(std::move(recorded)) {}

  std::optional<std::int64_t> read(const std::stop_token& token) override {
    RunOptions& run = command_.run;
    on_.emplace(load_vehicle_map(command_, vehicle_, token));
    note_files(*on_, run);
    if (recorded_ && on_->map.costs) check_layers(*on_->map.costs, *recorded_);
    answer_.start = vehicle_end(on_->map, command_.start, run.frame);
    for (const PoseEnd& goal : command_.goals)
      answer_.goals.push_back(vehicle_end(on_->map, goal, run.frame));
    if (run.messages.verbose)
      run.notes.push_back(on_->map.file +
                          printed(": %d x %d cells, read in %.1f ms, ready for the vehicle after "
                                  "%.1f ms",
                                  on_->map.width, on_->map.height, on_->map.read_ms,
                                  on_->map.ready_ms));
    return std::nullopt;
  }
  void plan(const StopCondition& stop, const Watch&) override {
    answer_ = plan_vehicle(*on_, command_, answer_.start, answer_.goals, stop);
  }
  Record record() const override { return vehicle_record(*on_, command_, answer_); }
  Forms show(const Record& run) const override {
    return {.csv =
                [&](auto& out) {
                  write_timed_poses(out, *on_, command_, {&answer_, 1});
                },
            .picture = [&](auto& file) { write_vehicle_picture(file, *on_, command_, answer_); },
            .yaml =
                [&](auto& out) {
                  write_ros_poses(out, *on_, command_, {&answer_, 1});
                },
            .page = [&](auto& out) { write_vehicle_page(out, run, *on_, command_, answer_); }};
  }

 private:
  std::optional<LoadedVehicle> vehicle_;
  std::optional<Json> recorded_;
  std::optional<VehicleMap> on_;
  VehicleAnswer answer_;
};

std::unique_ptr<Problem> vehicle_again(const Recorded& from, const Problem*) {
  const Json& result = from.result;
  VehicleCommand command;
  RunOptions& run = command.run;
  read_recorded(from, find_algorithm("exact"), run);
  run.map.file = from.map_file();
  const Json& parameters = value_at(result, "parameters");
  run.map.unknown_is_free = recorded<std::string>(parameters, "unknown") == "free";
  run.map.costs = recorded_costs(from);
  const bool metres = recorded<std::string>(parameters, "frame") == kFrames[1];
  LoadedVehicle vehicle{.vehicle = recorded_vehicle(parameters),
                        .speeds = recorded_speeds(parameters)};
  vehicle.speeds.steady_curvature = vehicle.vehicle.curvature_rate > 0;
  command.start = recorded_pose(result, metres ? "start_world" : "start");
  command.goals = recorded_goals(result, metres);
  command.heading_tolerance = recorded_real(parameters, "heading_tolerance", 0, kNoLimit);
  command.smooth = recorded<bool>(parameters, "smooth");
  if (parameters.contains("spacing"))
    run.spacing = recorded_real(parameters, "spacing", 0, kNoLimit);
  if (metres) run.frame = Frame::world;
  return std::make_unique<VehicleProblem>(std::move(command), std::move(vehicle), result);
}

}  // namespace

const ProblemKind& vehicle_kind() {
  static const ProblemKind kKind{
      .key = "vehicle_algorithms",
      .title = "Vehicles, by `lasius plan|batch|drive MAP --vehicle FILE`",
      .plans = "for vehicles",
      .advice = "; ask it with --vehicle FILE",
      .algorithms = {&lattice_algorithm(), 1},
      .formulas = [](const Algorithm&) { return std::vector<std::string>{}; },
      .format = kPlanFormat,
      .wrote = of_vehicle,
      .again = vehicle_again};
  return kKind;
}

int run_command(const VehicleCommand& command) {
  if (!command.queries.empty()) return run_vehicle_batch(command);
  VehicleProblem problem(command);
  return run(problem);
}

}  // namespace lasius::tool
