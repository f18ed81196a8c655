#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "lasius/tour/tour.h"
#include "tests/core/base/refusal.h"
#include "tests/core/tour/rooms.h"

namespace lasius {
namespace {

// Picks, each before the stop where it is delivered.
TEST(Tours, KeepAnOrderGivenInPart) {
  const Planner planner(rooms());
  for (const int count : {8, 12, 14, 40, 120})
    for (const int kind : {0, 1, 2, 3}) {
      if (count == 120 && kind % 3 != 0) continue;  // these take longest
      TourRequest request = ask(some_stops(planner.grid(), count));
      request.open = kind > 1;
      if (kind % 2 == 1) request.start = 0;
      if (kind == 3) request.goal = count - 1;
      request.after.resize(count);
      request.load.assign(count, 0);
      for (int pick = 1; pick + 2 < count; pick += 2) {
        request.after[pick + 1] = {pick};
        request.load[pick] = 1;
        request.load[pick + 1] = -1;
      }
      request.capacity = 2;
      request.generations = 1;
      request.threads = 1;
      const TourResult tour = plan_tour(planner, request);
      ASSERT_EQ(tour.status, Status::solved);
      ASSERT_EQ(tour.order.size(), static_cast<std::size_t>(count));
      EXPECT_TRUE(kind % 2 == 0 || tour.order.front() == 0);
      EXPECT_TRUE(kind != 3 || tour.order.back() == count - 1);
      std::vector<char> done(count, 0);
      int carried = 0;
      for (const int stop : tour.order) {
        for (const int before : request.after[stop]) EXPECT_TRUE(done[before]);
        EXPECT_LE(carried += request.load[stop], 2);
        done[stop] = 1;
      }
      EXPECT_EQ(tour.optimal, count <= 12);
      ASSERT_TRUE(tour.lower_bound);
      request.threads = 3;
      EXPECT_EQ(plan_tour(planner, request).order, tour.order);
      request.after.clear();
      request.capacity.reset();
      if (count <= 12) {
        EXPECT_LE(plan_tour(planner, request).length, tour.length);
      }
    }
}

TEST(Tours, TellWhyNoOrderKeepsWhatIsGiven) {
  const Planner planner(rooms());
  TourRequest request = ask({{0, 0}, {20, 20}, {50, 30}, {40, 30}});
  request.open = true;
  request.start = 0;
  request.goal = 3;
  const auto why = [&](std::vector<std::vector<int>> after, std::vector<int> load) {
    request.after = std::move(after);
    request.load = std::move(load);
    const TourResult tour = plan_tour(planner, request);
    EXPECT_TRUE(tour.order.empty());
    EXPECT_EQ(tour.status, Status::unreachable);
    if (!tour.error.starts_with("no order keeps")) {  // so that ants find none either
      TourRequest by_ants = request;
      by_ants.ants = tour::AntParams("mmas");
      by_ants.ants.iterations = 2;
      const TourResult none = plan_tour(planner, by_ants);
      EXPECT_TRUE(none.order.empty());
      EXPECT_EQ(none.status, Status::unreachable);
      EXPECT_EQ(none.error, tour.error);
    }
    return tour.error;
  };
  EXPECT_EQ(
      why({{2}, {}, {}, {}}, {}),
      "stop 0 is the start, but stop 2 comes before it; start elsewhere, or let it come after");
  EXPECT_EQ(why({{}, {3}, {}, {}}, {}),
            "stop 3 is the goal, but stop 1 comes after it; end elsewhere, or let it come before");
  request.capacity = 2;
  EXPECT_EQ(why({}, {0, 3, 0, 0}), "stop 1 alone exceeds the capacity of 2");
  EXPECT_EQ(why({}, {0, 4, -1, 0}), "stop 1 exceeds the capacity of 2, whatever comes before it");
  EXPECT_EQ(why({}, {0, 2, 2, 0}), "no order keeps the capacity of 2");
  // What is left out still parts what comes before it from what comes behind.
  request.stops[1] = {30, 0};
  request.load.clear();
  request.start.reset();
  request.goal.reset();
  request.after = {{1}, {2}, {}, {}};
  const TourResult tour = plan_tour(planner, request);
  ASSERT_EQ(tour.order.size(), 3u);
  EXPECT_LT(std::ranges::find(tour.order, 2), std::ranges::find(tour.order, 0));
  for (const auto& [after, load, capacity, words] :
       {std::tuple(std::vector<std::vector<int>>{{1}, {2}, {0}, {}}, std::vector<int>{}, 1,
                   "the order is a circle: stop 0 before stop 2 before stop 1 before stop 0"),
        {{{0}, {}, {}, {}}, {}, 1, "the order is a circle: stop 0 before stop 0"},
        {{{4}, {}, {}, {}}, {}, 1, "there is no stop 4"},
        {{{0}}, {}, 1, "after has 1 entries"},
        {{}, {1, 2}, 1, "load has 2 entries"},
        {{}, {}, -1, "capacity is -1"}}) {
    request.after = after;
    request.load = load;
    request.capacity = capacity;
    expect_says(refusal([&] { (void)plan_tour(planner, request); }), words);
  }
}

TEST(Tours, OfSequentialOrderingGoFromTheFirstPlaceToTheLast) {
  // 1 before 2; the way over 2 first would be cheaper.
  Tsplib problem{.name = "s", .size = 4, .ordered = true};
  problem.matrix = {0, 9, 1, 100, -1, 0, 8, 7, -1, -1, 0, 3, -1, -1, -1, 0};
  const TourResult tour = plan_tour(problem, {});
  EXPECT_EQ(tour.order, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(tour.length, 9 + 8 + 3);
  EXPECT_TRUE(tour.optimal);
  EXPECT_EQ(tour.lower_bound, 20);
}

}  // namespace
}  // namespace lasius
