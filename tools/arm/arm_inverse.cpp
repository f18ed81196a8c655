#include "tools/arm/arm_inverse.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "lasius/arm/plan.h"
#include "tools/console/values.h"

namespace lasius::tool {
namespace {

/// The time of a condition, which remembers whether anybody was told that it is up.
class WatchedTime final : public TimeSource {
 public:
  explicit WatchedTime(const StopCondition& stop) : stop_(stop) {}
  Clock::time_point now() const noexcept override {
    const Clock::time_point time = stop_.now();
    if (time >= stop_.deadline) told_ = true;
    return time;
  }
  bool told() const noexcept { return told_; }

 private:
  StopCondition stop_;
  mutable std::atomic<bool> told_ = false;
};

/// All that is found, the nearest to the start first; what is nearest there is not looked at.
/// Nothing where each goal was refused.
std::optional<std::vector<Reaching>> reaching_all(std::uint64_t seed,
                                                  const arm::SceneSensor& sensor,
                                                  const StopCondition& stop, ArmAnswer& answer) {
  constexpr int kAll = std::numeric_limits<int>::max();
  std::vector<Reaching> all;
  bool asked = false;
  for (std::size_t i = 0; i < answer.goals.size(); ++i)
    asked |= answered(answer.plan, [&] {
      for (arm::JointVector& q :
           arm::inverse_kinematics(answer.robot, answer.goals[i], answer.start, kAll, seed, stop)) {
        const bool free = sensor.position_free(q);
        all.push_back({i, std::move(q), {}, free});
      }
    });
  if (!asked) return std::nullopt;
  std::ranges::stable_sort(
      all, {}, [&](const Reaching& reaching) { return (reaching.q - answer.start).norm(); });
  return all;
}

/// The first `most` of them; one is free if any of all is.
std::vector<Reaching> first_of(std::vector<Reaching> all, int most) {
  if (std::ssize(all) <= most) return all;
  const auto end = all.begin() + most;
  if (std::none_of(all.begin(), end, [](const Reaching& reaching) { return reaching.free; })) {
    const auto free =
        std::find_if(end, all.end(), [](const Reaching& other) { return other.free; });
    if (free != all.end()) std::iter_swap(end - 1, free);
  }
  all.erase(end, all.end());
  return all;
}

}  // namespace

void find_inverse(const ArmCommand& command, const arm::SceneSensor& sensor,
                  const StopCondition& stop, ArmAnswer& answer) {
  const WatchedTime time(stop);
  auto all = reaching_all(command.seed, sensor,
                          {.token = stop.token, .deadline = stop.deadline, .time = &time}, answer);
  if (!all) return;
  arm::Result& plan = answer.plan;
  const auto count = std::ssize(*all);
  answer.inverse = first_of(*std::move(all), command.inverse);
  for (Reaching& reaching : answer.inverse) reaching.nearest = sensor.nearest(reaching.q);
  const bool any_free = std::ranges::any_of(answer.inverse, &Reaching::free);
  if (any_free) plan.length = (answer.inverse.front().q - answer.start).norm();
  plan.error.clear();
  if (stop.token.stop_requested()) {
    plan.status = Status::interrupted;
  } else if (time.told()) {
    plan.status = Status::limit;
    plan.limit = Limit::time;
  } else if (any_free) {
    plan.status = Status::solved;
  } else if (answer.inverse.empty()) {
    plan.status = Status::no_path;
    plan.error = "no joint values were found that reach the goal, which is no proof";
  } else {
    plan.status = Status::invalid;
    plan.fault = Fault::goal_blocked;
    plan.error = "the arm touches something in each of " + counted(count, "posture") +
                 " found: " + sensor.contact(answer.inverse.front().q);
  }
}

}  // namespace lasius::tool
