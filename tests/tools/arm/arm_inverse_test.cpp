#include "tools/arm/arm_inverse.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/arm/robot/arms.h"
#include "tests/core/base/counting_time.h"

namespace lasius::tool {
namespace {

/// Two goals of an arm: where its tip is at the start, and away from there.
class Inverse : public testing::Test {
 protected:
  Inverse() {
    question_.robot = arm::shipped("industrial6");
    question_.start = arm::joints({0.3, 0.4, 0.7, 0.2, 0.6, 0.1});
    const arm::JointVector away = arm::joints({2.7, 0.4, 0.7, 0.2, 0.6, 0.1});
    for (const arm::JointVector& q : {question_.start, away})
      question_.goals.push_back(arm::Goal::position(arm::tip_position(question_.robot, q)));
  }
  /// Something is in the way at the first goal.
  void block() {
    const Eigen::Vector3d at = arm::tip_position(question_.robot, question_.start);
    question_.scene.obstacles = {arm::ball(at, 0.2)};
  }
  ArmAnswer found(int most, const StopCondition& stop = {}) const {
    ArmCommand command;
    command.inverse = most;
    ArmAnswer answer = question_;
    find_inverse(command, arm::SceneSensor(answer.robot, answer.scene), stop, answer);
    return answer;
  }
  /// How often the clock is looked at until all goals are done.
  int looks(int most) const {
    const CountingTime time(1000000);
    EXPECT_EQ(found(most, time.is_up()).plan.status, Status::solved);
    return time.polls();
  }
  static bool any_free(const ArmAnswer& answer) {
    return std::ranges::any_of(answer.inverse, &Reaching::free);
  }

  ArmAnswer question_;
};

TEST_F(Inverse, AFreeOneBehindBlockedOnesIsListed) {
  block();
  const ArmAnswer all = found(ArmCommand::kMostInverse);
  ASSERT_TRUE(any_free(all));
  const auto first = std::ranges::find(all.inverse, true, &Reaching::free) - all.inverse.begin();
  ASSERT_GE(first, 2);  // what the test is about
  for (int most = 1; most <= first + 2; ++most) {
    const ArmAnswer some = found(most);
    EXPECT_EQ(some.plan.status, Status::solved) << most;
    ASSERT_EQ(std::ssize(some.inverse), std::min<std::ptrdiff_t>(most, std::ssize(all.inverse)));
    for (std::ptrdiff_t i = 0; i < std::ssize(some.inverse); ++i) {
      const bool last = i + 1 == most && most <= first;
      const auto& expected = all.inverse[static_cast<std::size_t>(last ? first : i)];
      const auto& one = some.inverse[static_cast<std::size_t>(i)];
      EXPECT_EQ(one.q, expected.q) << most << " " << i;
      EXPECT_EQ(one.goal, expected.goal);
      EXPECT_EQ(one.free, expected.free);
      EXPECT_EQ(one.nearest.distance, expected.nearest.distance);
    }
    EXPECT_EQ(some.plan.length, (some.inverse.front().q - question_.start).norm());
  }
}

TEST_F(Inverse, OnlyBlockedOnesAreInvalid) {
  block();
  question_.goals.pop_back();
  const ArmAnswer answer = found(2);
  EXPECT_EQ(answer.plan.status, Status::invalid);
  EXPECT_EQ(answer.inverse.size(), 2U);
  EXPECT_FALSE(std::isfinite(answer.plan.length));
  EXPECT_NE(answer.plan.error.find("in each of"), std::string::npos) << answer.plan.error;
}

TEST_F(Inverse, ALimitKeepsWhatWasFound) {
  const int all = looks(3);
  ASSERT_GT(all, 2);
  for (const int looked : {0, 2, all / 2, all - 1}) {
    const CountingTime time(looked);
    const ArmAnswer answer = found(3, time.is_up());
    EXPECT_EQ(answer.plan.status, Status::limit) << looked;
    EXPECT_EQ(answer.plan.limit, Limit::time);
    EXPECT_EQ(answer.inverse.empty(), looked == 0);
    EXPECT_EQ(std::isfinite(answer.plan.length), any_free(answer));
    EXPECT_EQ(any_free(answer), looked > 0) << "nothing is in the way";
  }
}

TEST_F(Inverse, ASignalKeepsWhatWasFound) {
  for (const int looked : {0, 2, looks(3) - 1}) {  // seen at the next look
    const FiringTime time(looked);
    const ArmAnswer answer = found(3, time.fires());
    EXPECT_EQ(answer.plan.status, Status::interrupted) << looked;
    EXPECT_TRUE(any_free(answer));
    EXPECT_TRUE(std::isfinite(answer.plan.length));
  }
  const ArmAnswer none = found(3, fired());
  EXPECT_EQ(none.plan.status, Status::interrupted);
  EXPECT_FALSE(std::isfinite(none.plan.length));
}

TEST_F(Inverse, ALimitAfterTheLastGoalIsNone) {
  const CountingTime time(looks(3));
  const ArmAnswer answer = found(3, time.is_up());
  EXPECT_EQ(answer.plan.status, Status::solved);
  EXPECT_EQ(answer.plan.length, found(3).plan.length);
}

TEST_F(Inverse, JointValuesAskForNoTime) {
  question_.goals = {arm::Goal::joints(question_.start)};
  const CountingTime time(0);
  const ArmAnswer answer = found(1, time.is_up());
  EXPECT_EQ(answer.plan.status, Status::solved);
  EXPECT_EQ(answer.plan.length, 0);
}

}  // namespace
}  // namespace lasius::tool
