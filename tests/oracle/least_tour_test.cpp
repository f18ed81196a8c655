#include "tests/oracle/least_tour.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <optional>
#include <random>

namespace lasius::oracle {
namespace {

constexpr int kStops = 6;

struct Asked {
  bool open = false;
  std::optional<int> start = {}, goal = {}, capacity = {};
  std::vector<std::vector<int>> after = {};
  std::vector<int> load = {}, group = {}, robots = {};
  int most_stops = 0;
};

/// Of one robot, or of those that begin in this order; infinite for an order that is not asked for.
double length_of(const Asked& asked, const std::vector<double>& legs, const std::vector<int>& all) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  std::vector<std::vector<int>> tours(1);
  std::vector<bool> visited(kStops, false);
  int carried = 0;
  for (const int stop : all) {
    if (!asked.after.empty())
      for (const int before : asked.after[stop])
        if (!visited[before]) return kNone;
    if (asked.capacity && (carried += asked.load[stop]) > *asked.capacity) return kNone;
    visited[stop] = true;
    const auto same = [&](int other) { return asked.group[other] == asked.group[stop]; };
    if (!asked.group.empty() && std::ranges::any_of(tours[0], same)) continue;
    if (std::ranges::count(asked.robots, stop) > 0 && !tours[0].empty()) tours.emplace_back();
    tours.back().push_back(stop);
  }
  if (asked.start && tours[0].front() != *asked.start) return kNone;
  if (asked.goal && tours[0].back() != *asked.goal) return kNone;
  double sum = 0;
  for (std::size_t r = 0; r < tours.size(); ++r) {
    const auto& tour = tours[r];
    if (!asked.robots.empty() && tour.front() != asked.robots[r]) return kNone;
    if (asked.most_stops > 0 && std::ssize(tour) > asked.most_stops + 1) return kNone;
    if (!asked.open) sum += legs[tour.back() * kStops + tour.front()];
    for (std::size_t i = 1; i < tour.size(); ++i) sum += legs[tour[i - 1] * kStops + tour[i]];
  }
  return sum;
}

TEST(LeastTour, IsTheLeastOfAllOrders) {
  std::mt19937 random(5);
  const std::vector<Asked> questions{{},
                                     {.open = true},
                                     {.start = 3},
                                     {.open = true, .start = 3},
                                     {.open = true, .goal = 2},
                                     {.open = true, .start = 3, .goal = 2},
                                     {.after = {{}, {0, 4}, {}, {2}, {}, {}}},
                                     {.open = true,
                                      .capacity = 2,
                                      .after = {{1}, {}, {}, {}, {3}, {}},
                                      .load = {1, 1, 1, -1, -2, 1}},
                                     {.capacity = 0, .load = {1, 0, 0, -1, 0, 0}},
                                     {.capacity = 0, .load = {1, 0, 0, 0, 0, 0}},
                                     {.group = {0, 0, 1, 2, 1, 2}},
                                     {.open = true, .start = 2, .group = {0, 0, 5, 2, 0, 2}},
                                     {.robots = {4, 1}},
                                     {.open = true, .robots = {4, 1, 2}},
                                     {.robots = {1, 4}, .most_stops = 2}};
  for (int i = 0; i < 5; ++i) {
    std::vector<double> legs;
    while (legs.size() < kStops * kStops) legs.push_back(static_cast<double>(random() % 100));
    for (const Asked& asked : questions) {
      std::vector<int> order(kStops);
      std::iota(order.begin(), order.end(), 0);
      double least = std::numeric_limits<double>::infinity();
      do {
        least = std::min(least, length_of(asked, legs, order));
      } while (std::next_permutation(order.begin(), order.end()));
      EXPECT_EQ(LeastTour(asked, legs).length(), least) << &asked - questions.data();
    }
  }
}

}  // namespace
}  // namespace lasius::oracle
