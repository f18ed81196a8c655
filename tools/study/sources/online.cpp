#include "tools/study/sources/online.h"

#include <memory>
#include <utility>

#include "bench/peers/dstar_pilot.h"
#include "lasius/drive/drive.h"
#include "lasius/path/shortest_walk.h"
#include "tools/study/sources/online_pilots.h"
#include "tools/study/sources/online_worlds.h"

namespace lasius::study {
namespace {

constexpr std::string_view kDStarLite = "dstar-lite";
constexpr double kSense = 15;
constexpr std::int64_t kMaxTicks = 1000;

/// How a contender drives.
struct Policy {
  bool dstar_lite = false, anew = false;
  NavigatorOptions navigator = {};
  DriveOptions options{.sense = kSense, .max_ticks = kMaxTicks};
};

/// Takes one of the settings that are not the algorithm's; false for all others.
bool take(Policy& policy, const std::string& name, const std::string& value) {
  if (name == "replan") {
    policy.anew = value == "anew";
  } else if (name == "search_on") {
    policy.navigator.search_on = value == "true";
  } else if (name == "tick") {
    const double milliseconds = std::stod(value);
    if (milliseconds > 0) policy.options.seconds_per_tick = milliseconds / 1000;
  } else {
    return false;
  }
  return true;
}

Policy policy_of(Contender contender) {
  Policy policy{.dstar_lite = contender.algorithm == kDStarLite};
  std::erase_if(contender.settings,
                [&](const auto& setting) { return take(policy, setting.first, setting.second); });
  if (policy.dstar_lite) contender.algorithm = "exact";  // whose corner rule it has
  policy.navigator.params = configured(Params(contender.algorithm, contender.preset), contender);
  return policy;
}

std::unique_ptr<Pilot> pilot_of(const OnlineWorld& world, const Policy& policy) {
  const NavigatorOptions& how = policy.navigator;
  if (policy.dstar_lite)
    return std::make_unique<peers::DStarPilot>(world.known, world.start, world.goal);
  if (policy.anew) return std::make_unique<ForgetfulPilot>(world.known, world.goal, how);
  return std::make_unique<Navigator>(world.known, world.goal, how);
}

Run drive_once(const OnlineWorld& world, const Policy& policy, const std::stop_token& stop) {
  const auto pilot = pilot_of(world, policy);
  DriveOptions options = policy.options;
  options.stop.token = stop;
  const DriveResult driven = drive(*pilot, world.truth, world.start, world.changes, options);
  Run run{.status = driven.status,
          .iterations = static_cast<int>(driven.replans.size()),
          .seconds = driven.planning_ms / 1000,
          .limit = 1,
          .steps = driven.ticks};
  if (driven.status == Status::solved)
    run.length =
        driven.length / *shortest_walk(world.truth, world.start, world.goal, Neighbours::eight);
  return run;
}

}  // namespace

OnlineDrives::OnlineDrives(const Study& study, std::filesystem::path maps)
    : maps_(std::move(maps)) {
  for (const Experiment& experiment : study.experiments)
    for (const Question& question : experiment.questions)
      (void)make_online_world(question.map, 1, maps_);  // faults are told before the first run
}

PreparedRun OnlineDrives::prepare(const Question& question, const Contender& contender) const {
  const Policy policy = policy_of(contender);
  const Params& params = policy.navigator.params;
  constexpr std::int64_t kTicks = 200;
  PreparedRun prepared = run_of(question.map + ' ' + contender.algorithm, params,
                                find_algorithm(params.algorithm()).parameters, kTicks);
  for (const auto& [name, value] : contender.settings) prepared.key += ' ' + name + '=' + value;
  prepared.run = [this, &question, policy](std::uint64_t seed, bool pilot,
                                           const std::stop_token& stop, Workspace&) {
    Policy seeded = policy;
    seeded.navigator.params.seed = seeded.options.seed = seed;
    if (pilot) seeded.options.max_ticks = pilot_part(static_cast<int>(kTicks));
    return drive_once(make_online_world(question.map, seed, maps_), seeded, stop);
  };
  return prepared;
}

}  // namespace lasius::study
