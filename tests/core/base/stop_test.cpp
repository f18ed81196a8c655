#include "lasius/base/stop.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stop_token>
#include <type_traits>

#include "core/base/poller.h"
#include "tests/core/base/counting_time.h"

namespace lasius {
namespace {

using Seconds = std::chrono::duration<double>;

TEST(Deadline, IsSoFarFromNow) {
  const auto before = Clock::now();
  const auto deadline = deadline_in(Seconds(0.5));
  EXPECT_GE(deadline, before + std::chrono::milliseconds(500));
  EXPECT_LE(deadline, Clock::now() + std::chrono::milliseconds(500));
}

TEST(Deadline, TakesAnyNumber) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double time : {3.2e9, 9.2e9, 9.3e9, 1e300, kInfinity, std::nan("")}) {
    EXPECT_EQ(deadline_in(Seconds(time)), Clock::time_point::max()) << time;
  }
  for (const double time : {-0.0, -1.0, -1e300, -kInfinity}) {
    const auto deadline = deadline_in(Seconds(time));
    EXPECT_LE(deadline, Clock::now()) << time;
  }
}

TEST(Deadline, IsSoFarFromAnyTime) {
  const Clock::time_point then{std::chrono::seconds(7)};
  EXPECT_EQ(deadline_in(Seconds(0.5), then), then + std::chrono::milliseconds(500));
  EXPECT_EQ(deadline_in(Seconds(-1), then), then);
  constexpr auto kNever = Clock::time_point::max();
  EXPECT_EQ(deadline_in(Seconds(5), kNever), kNever);
  EXPECT_EQ(deadline_in(Seconds(5), kNever - std::chrono::seconds(4)), kNever);
}

TEST(Poller, LooksOnceABudgetIsSpentAndNeverAgainOnceStopped) {
  const CountingTime time(1);
  const StopCondition stop = time.is_up();
  Poller poller(stop, 10);
  EXPECT_FALSE(poller.stop_after(9));
  EXPECT_EQ(time.polls(), 0);
  EXPECT_FALSE(poller.stop_after(1));
  EXPECT_EQ(time.polls(), 1);
  EXPECT_FALSE(poller.stop_after(9));
  EXPECT_TRUE(poller.stop_after(100));
  EXPECT_TRUE(poller.stop_after(100));
  EXPECT_EQ(time.polls(), 2);
  EXPECT_EQ(poller.cause(), StopCondition::Cause::deadline);
}

TEST(StopCondition, TheTokenCountsBeforeTheClock) {
  const CountingTime time(0);
  StopCondition stop = time.is_up();
  std::stop_source source;
  stop.token = source.get_token();
  EXPECT_EQ(stop.poll(), StopCondition::Cause::deadline);
  source.request_stop();
  EXPECT_EQ(stop.poll(), StopCondition::Cause::token);
  EXPECT_EQ(time.polls(), 1);
}

TEST(Callback, OfWhatAnswersOrReturnsNothing) {
  static_assert(std::is_constructible_v<Callback<int>, Go (*)(int)>);
  static_assert(!std::is_constructible_v<Callback<int>, int (*)(int)>, "no answer of ours");
  static_assert(!std::is_constructible_v<Callback<int>, void (*)(int&&)>,
                "called with what has a name");
  using Watch = Callback<int&, double>;
  EXPECT_FALSE(Watch());
  EXPECT_FALSE(Watch(std::function<void(int&, double)>()));
  EXPECT_FALSE(Watch(Callback<int, double>()));
  int seen = 0;
  const Watch silent = [](int& sum, double more) { sum += static_cast<int>(more); };
  EXPECT_EQ(silent(seen, 2), Go::on);
  EXPECT_EQ(seen, 2);
  Watch counting = [calls = 0](int&, double) mutable { return ++calls < 2 ? Go::on : Go::stop; };
  const Watch copy = counting;
  EXPECT_EQ(counting(seen, 0), Go::on);
  EXPECT_EQ(counting(seen, 0), Go::stop);
  EXPECT_EQ(copy(seen, 0), Go::on) << "its own count";
  counting = {};
  EXPECT_FALSE(counting);
}

}  // namespace
}  // namespace lasius
