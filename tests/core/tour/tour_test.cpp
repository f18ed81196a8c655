#include "lasius/tour/tour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/tour/map_pricer.h"
#include "lasius/base/error.h"
#include "lasius/grid/generate.h"
#include "lasius/path/path.h"
#include "tests/core/base/counting_time.h"
#include "tests/core/tour/rooms.h"

namespace lasius {
namespace {

TEST(Distances, AreThoseOfPlans) {
  const Planner planner(rooms());
  const auto stops = some_stops(planner.grid(), 9);
  const auto one = planner.distances(stops, stops, 1), three = planner.distances(stops, stops, 3);
  ASSERT_TRUE(one && three);
  EXPECT_EQ(*one, *three);
  const auto other = planner.distances(std::span(stops).first(2), stops);
  for (int a = 0; a < 9; ++a)
    for (int b = 0; b < 9; ++b) {
      const double length = planner.plan({stops[a], stops[b]}, Params("exact")).length;
      EXPECT_NEAR((*one)[a * 9 + b], length, 1e-9 * length);
      if (a < 2) {
        EXPECT_EQ((*other)[a * 9 + b], length);
      }
    }
  EXPECT_THROW(static_cast<void>(planner.distances(stops, std::vector<Cell>{{30, 0}})), Error);
}

TEST(Distances, OfAPreparedMapAreByOneSearchASource) {
  for (const MapKind kind : {MapKind::blobs, MapKind::maze, MapKind::random}) {
    const Planner planner(generate(kind, {.width = 60, .height = 40, .seed = 3})),
        prepared = planner.prepared({.threads = 1});
    std::vector<Cell> stops = {{0, 0}};
    for (int i = 0; i < 2400 && stops.size() < 60; i += 37)
      if (planner.grid().free({i % 60, i / 60})) stops.push_back({i % 60, i / 60});
    if (!planner.grid().free(stops[0])) stops.erase(stops.begin());
    const auto one = prepared.distances(stops, stops, 1),
               three = prepared.distances(stops, stops, 3);
    const auto few = prepared.distances(std::span(stops).first(2), stops);
    ASSERT_TRUE(one && three && few);
    EXPECT_EQ(*one, *three);
    const std::size_t n = stops.size();
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = 0; b < n; ++b) {
        const Result best = planner.plan({stops[a], stops[b]}, Params("exact"));
        const double length =
            best.path.empty() ? std::numeric_limits<double>::infinity() : best.length;
        EXPECT_TRUE(length == (*one)[a * n + b] ||
                    std::abs((*one)[a * n + b] - length) <= 1e-9 * length)
            << a << " to " << b;
        EXPECT_EQ((*one)[a * n + b], (*one)[b * n + a]);
        if (a < 2) {
          EXPECT_TRUE(length == (*few)[a * n + b] ||
                      std::abs((*few)[a * n + b] - length) <= 1e-9 * length);
        }
      }
    EXPECT_FALSE(prepared.distances(stops, stops, 1, fired()));
  }
}

TEST(Distances, ThatArePricedNearByAreTheSame) {
  // The last has more corners than a search for all legs is for.
  for (const auto& [kind, side] :
       {std::pair(MapKind::blobs, 80), {MapKind::maze, 80}, {MapKind::random, 300}}) {
    const Planner planner = Planner(generate(kind, {.width = side, .height = side, .seed = 5}))
                                .prepared({.threads = 1});
    std::vector<Point> stops;  // of the largest region
    for (int first = 0; first < 40; ++first) {
      std::vector<Point> joined;
      for (int i = first; i < side * side && joined.size() < 170; i += (side * side / 389) | 1) {
        const Point p = centre({i % side, i / side});
        if (planner.clear_at(p) && (joined.empty() || planner.joined_at(joined.front(), p)))
          joined.push_back(p);
      }
      if (joined.size() > stops.size()) stops = std::move(joined);
    }
    const int n = static_cast<int>(stops.size());
    ASSERT_GT(n, 60);
    const auto all = planner.distances(stops, stops, 2);
    ASSERT_TRUE(all);
    tour::MapPricer one(planner, stops, {}), three(planner, stops, {});
    one.price_near(1);
    three.price_near(3);
    EXPECT_EQ(one.priced(), three.priced());
    EXPECT_EQ(one.priced() < n * (n - 1) / 2, side == 300) << n << " " << one.priced();
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b) {
        const tour::Cost cost = tour::grains((*all)[a * n + b]);
        EXPECT_LE(one.lower(a, b), cost + 1);
        EXPECT_EQ(one.lower(a, b), three.lower(a, b));
        if ((a * n + b) % 97 != 0 || a == b) continue;
        EXPECT_NEAR(one.price(a, b), cost, 1);
        EXPECT_EQ(three.price(b, a), one.price(a, b));
      }
  }
}

TEST(Tours, VisitEveryStopOnceByShortestLegs) {
  const Planner planner(rooms());
  int cases = 0;
  for (const int count : {1, 2, 3, 8, 14, 40, 120})
    for (const int kind : {0, 1, 2, 3}) {
      if (count == 1 && kind == 3) continue;
      TourRequest request = ask(some_stops(planner.grid(), count));
      request.open = kind > 0;
      if (kind > 1) request.start = 0;
      if (kind > 2) request.goal = count - 1;
      request.generations = 2;
      const TourResult tour = plan_tour(planner, request);
      EXPECT_EQ(tour.status, Status::solved);
      EXPECT_EQ(std::set<int>(tour.order.begin(), tour.order.end()).size(), tour.order.size());
      ASSERT_EQ(tour.order.size(), static_cast<std::size_t>(count));
      EXPECT_TRUE(kind < 2 || tour.order.front() == 0);
      EXPECT_TRUE(kind < 3 || tour.order.back() == count - 1);
      double sum = 0;
      for (std::size_t i = 0; i < tour.legs.size(); ++i) {
        const TourLeg& leg = tour.legs[i];
        EXPECT_EQ(leg.from, tour.order[i]);
        EXPECT_EQ(leg.to, tour.order[(i + 1) % count]);
        const Result best =
            planner.plan({request.stops[leg.from], request.stops[leg.to]}, Params("exact"));
        EXPECT_NEAR(leg.length, best.length, 1e-9 * best.length);
        EXPECT_EQ(leg.path.front(), centre(request.stops[leg.from]));
        EXPECT_EQ(leg.path.back(), centre(request.stops[leg.to]));
        sum += leg.length;
      }
      EXPECT_EQ(tour.length, sum);
      ASSERT_TRUE(tour.gap());
      EXPECT_GE(*tour.gap(), 0);
      EXPECT_LE(*tour.gap(), 0.1) << count << " stops, kind " << kind;
      EXPECT_TRUE(tour.optimal || count > 12);
      if (tour.optimal) {
        EXPECT_EQ(tour.gap(), 0.0);
      }
      ++cases;
    }
  EXPECT_EQ(cases, 27);
}

TEST(Tours, AStoppedPricerMakesNoLegCheaper) {
  const Planner planner(rooms());
  const auto stops = some_stops(planner.grid(), 30);
  std::vector<Point> points;
  for (const Cell c : stops) points.push_back(centre(c));
  tour::MapPricer pricer(planner, points, fired()), asked(planner, points, {});
  for (int a = 0; a < 30; ++a)
    for (int b = 0; b < a; ++b) EXPECT_GE(pricer.price(a, b), asked.price(a, b));
  // Those that nobody priced are told apart by straight distances.
  for (int a = 0; a < 30; ++a)
    for (int b = 0; b < a; ++b)
      EXPECT_EQ(pricer.price(a, b) - pricer.price(1, 0),
                tour::grains(std::hypot(stops[a].x - stops[b].x, stops[a].y - stops[b].y)) -
                    tour::grains(std::hypot(stops[1].x - stops[0].x, stops[1].y - stops[0].y)));
  EXPECT_LT(pricer.priced(), asked.priced());
}

TEST(Tours, AreTheSameOnAnyThreads) {
  const Planner planner(rooms());
  TourRequest request = ask(some_stops(planner.grid(), 110));
  request.generations = 1;
  request.threads = 1;
  const TourResult one = plan_tour(planner, request);
  request.threads = 3;
  const TourResult three = plan_tour(planner, request);
  EXPECT_EQ(one.order, three.order);
  EXPECT_EQ(one.lower_bound, three.lower_bound);
}

TEST(Tours, NameWhatTheyLeaveOut) {
  Grid grid = rooms();
  for (const Cell c : {Cell{4, 0}, {4, 1}, {3, 1}, {3, 2}, {0, 2}, {1, 2}, {2, 2}})
    grid.set_blocked(c);
  for (int x = 0; x < 4; ++x) grid.set_blocked({x, 2});
  grid.set_blocked({4, 2});
  const Planner planner(grid);
  TourRequest request = ask({{0, 0}, {20, 20}, {30, 0}, {-1, 5}, {40, 30}});
  const TourResult tour = plan_tour(planner, request);
  ASSERT_EQ(tour.left_out.size(), 3u);
  EXPECT_EQ(tour.left_out[0].why, "stop 0 at (0, 0) cannot be reached from the others");
  EXPECT_EQ(tour.left_out[1].why, "stop 2 at (30, 0) is blocked");
  EXPECT_EQ(tour.left_out[2].why, "stop 3 at (-1, 5) is outside the map");
  EXPECT_EQ(tour.order.size(), 2u);
  request.start = 2;
  EXPECT_EQ(plan_tour(planner, request).status, Status::invalid);
  request.open = true;
  request.start = 0;
  request.goal = 1;  // another region
  EXPECT_EQ(plan_tour(planner, request).status, Status::unreachable);
  request.start = 9;
  EXPECT_THROW(plan_tour(planner, request), Error);
}

TEST(Tours, EndAtTheGapThatIsAsked) {
  const Planner planner(rooms());
  TourRequest request = ask(some_stops(planner.grid(), 60));
  const TourResult best = plan_tour(planner, request);
  std::int64_t tours = 0, wide = 0;
  const auto count = [](std::int64_t& told) {
    return [&told](std::span<const int>, double) { ++told; };
  };
  (void)plan_tour(planner, request, count(tours));
  request.target_gap = 0.5;
  const TourResult first = plan_tour(planner, request, count(wide));
  EXPECT_LE(*first.gap(), 0.5);
  EXPECT_LE(wide, tours);
  EXPECT_GE(first.length, best.length);
  request.target_gap = 1e-9;  // out of reach: all of the search is done
  EXPECT_EQ(plan_tour(planner, request).length, best.length);
  request.target_gap = -1;
  EXPECT_THROW(plan_tour(planner, request), Error);
}

// Two orders whose lengths differ by 4e-6.
TEST(Tours, OfFewStopsAreShortestToTheLastDigit) {
  TourRequest request;
  request.stops = {{7, 3}, {171, 194}, {133, 139}, {123, 47}, {15, 74}};
  const TourResult tour = plan_tour(Planner(Grid(200, 200)), request);
  const auto length = [&](const std::vector<int>& order) {
    double sum = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
      const Cell a = request.stops[order[i]], b = request.stops[order[(i + 1) % order.size()]];
      sum += std::hypot(a.x - b.x, a.y - b.y);
    }
    return sum;
  };
  EXPECT_NEAR(tour.length, length({0, 3, 1, 2, 4}), 1e-9);
  EXPECT_LT(tour.length, length({0, 4, 1, 2, 3}) - 3e-6);
  EXPECT_TRUE(tour.optimal);
  EXPECT_EQ(tour.lower_bound, tour.length);
}

TEST(Tours, OfTsplibHaveItsLengthAndNoLegs) {
  // A rectangle of 3 by 4.
  Tsplib problem{.name = "rectangle", .size = 4, .places = {{0, 0}, {3, 4}, {3, 0}, {0, 4}}};
  problem.matrix = {0, 5, 3, 4, 5, 0, 4, 3, 3, 4, 0, 5, 4, 3, 5, 0};
  TourRequest request;
  TourResult tour = plan_tour(problem, request);
  EXPECT_EQ(tour.length, 14);
  EXPECT_EQ(tour.lower_bound, 14);
  EXPECT_TRUE(tour.optimal);
  EXPECT_TRUE(tour.legs.empty());
  request.open = true;
  request.start = 1;
  request.goal = 0;
  request.generations = 0;
  tour = plan_tour(problem, request);
  EXPECT_EQ(tour.length, 11);  // 3 + 5 + 3
  EXPECT_EQ(tour.order.front(), 1);
  EXPECT_EQ(tour.order.back(), 0);
  request.goal = 4;
  EXPECT_THROW(plan_tour(problem, request), Error);
}

TEST(Tours, OfTsplibHaveNoBoundBeforeOneIsThere) {
  constexpr int kCities = 300;
  Tsplib problem{.name = "line", .size = kCities, .places = {}};
  for (int a = 0; a < kCities; ++a) problem.places.push_back({static_cast<double>(a), 0});
  for (int a = 0; a < kCities; ++a)
    for (int b = 0; b < kCities; ++b) problem.matrix.push_back(std::abs(a - b));
  TourRequest request;
  request.stop.deadline = std::chrono::steady_clock::now();
  TourResult tour = plan_tour(problem, request);
  EXPECT_EQ(tour.status, Status::limit);
  EXPECT_EQ(tour.order.size(), kCities);
  EXPECT_FALSE(tour.lower_bound);
  EXPECT_FALSE(tour.gap());
  problem.matrix.assign(problem.matrix.size(), 0);  // no tour is below 0
  tour = plan_tour(problem, request);
  EXPECT_EQ(tour.lower_bound, 0);
  EXPECT_EQ(tour.gap(), 0);
  EXPECT_TRUE(tour.optimal);
}

// Legs are the disc's shortest curves, walls that it does not pass part the stops.
TEST(Tours, OfADiscGoWhereItFits) {
  Grid grid = rooms();
  for (int x = 5; x <= 15; ++x) grid.set_blocked({x, 12}, x == 5 || x == 15);
  for (int y = 17; y <= 23; ++y) grid.set_blocked({30, y}, y == 17 || y == 23);
  for (const double radius : {0.4, 1.5, 2.5})
    for (const bool prepared : {false, true}) {
      const Planner planner =
          prepared ? Planner(grid, {.threads = 1}, Disc{radius}) : Planner(grid, Disc{radius});
      for (const int count : {9, 20}) {
        TourRequest request = ask(some_stops(grid, count));
        request.generations = 1;
        request.after.resize(count);
        request.after[1] = {2};
        const TourResult tour = plan_tour(planner, request);
        ASSERT_EQ(tour.status, Status::solved);
        EXPECT_EQ(tour.order.size() + tour.left_out.size(), static_cast<std::size_t>(count));
        for (const LeftOut& out : tour.left_out)
          EXPECT_FALSE(planner.clear(request.stops[out.stop]) &&
                       planner.joined(request.stops[out.stop], request.stops[tour.order[0]]));
        double sum = 0;
        for (const TourLeg& leg : tour.legs) {
          const Result best =
              planner.plan({request.stops[leg.from], request.stops[leg.to]}, Params("exact"));
          EXPECT_NEAR(leg.length, best.length, 1e-9 * best.length);
          EXPECT_LE(leg.length, path_length(leg.path) * (1 + 1e-12));
          EXPECT_LE(path_length(leg.path), leg.length * 1.001);
          sum += leg.length;
        }
        EXPECT_EQ(tour.length, sum);
        ASSERT_TRUE(tour.lower_bound);
        EXPECT_LE(*tour.lower_bound, tour.length);
        const auto at = [&](int stop) { return std::ranges::find(tour.order, stop); };
        EXPECT_TRUE(at(1) == tour.order.end() || at(2) == tour.order.end() || at(2) < at(1));
        if (radius > 1) {
          EXPECT_FALSE(tour.left_out.empty());
        }
      }
    }
}

TEST(Tours, StoppedHaveTheLegsOfTheirOrder) {
  const Planner plain(rooms()), ready = plain.prepared({});
  int cut = 0;
  for (const int count : {40, 120})
    for (const bool given : {false, true})
      for (const int look : {1, 2, 3, 5, 20, 100}) {
        const Planner& planner = look % 2 == 0 ? ready : plain;  // which a tour prepares
        TourRequest request = ask(some_stops(planner.grid(), count));
        request.generations = 2;
        if (given) {
          request.after.resize(count);
          request.after[3] = {5, 7};
        }
        const FiringTime signal(look - 1);
        const CountingTime time(look);
        for (const Status status : {Status::interrupted, Status::limit}) {
          request.stop = status == Status::limit ? time.is_up() : signal.fires();
          const TourResult tour = plan_tour(planner, request);
          EXPECT_TRUE(tour.status == status || tour.status == Status::solved);
          cut += tour.status == status;
          ASSERT_EQ(tour.order.size(), static_cast<std::size_t>(count)) << look;
          ASSERT_EQ(tour.legs.size(), tour.order.size());
          double sum = 0;
          for (const TourLeg& leg : tour.legs) sum += path_length(leg.path);
          EXPECT_NEAR(tour.length, sum, 1e-9 * sum);
          EXPECT_GT(tour.length, 0);
          EXPECT_FALSE(tour.optimal);
        }
      }
  EXPECT_GT(cut, 24);
  TourRequest request = ask(some_stops(plain.grid(), 40));
  request.stop = fired();  // before there is any order
  EXPECT_EQ(plan_tour(plain, request).status, Status::interrupted);
  EXPECT_TRUE(plan_tour(plain, request).order.empty());
}

// Of legs that are priced when they are asked for; by more looks at the clock, not by its time.
TEST(Tours, AreNotLongerTheLaterTheyAreCut) {
  const Planner planner(rooms(), Disc{0.5});
  TourRequest request = ask(some_stops(planner.grid(), 130));
  request.generations = 1;
  request.threads = 1;
  double before = 0, first = 0;
  int cut = 0;
  for (int looks = 0; looks < 1 << 20; looks += 1 + looks) {
    const CountingTime time(looks);
    request.stop = time.is_up();
    const TourResult tour = plan_tour(planner, request);
    ASSERT_EQ(tour.order.size(), tour.legs.size());
    ASSERT_GT(tour.order.size(), 100u);
    if (before > 0) {
      EXPECT_LE(tour.length, before + 1e-3 * static_cast<double>(tour.order.size())) << looks;
    } else {
      first = tour.length;
    }
    before = tour.length;
    if (tour.status == Status::solved) break;
    ++cut;
  }
  EXPECT_GT(cut, 8);
  EXPECT_LT(before, first);
}

}  // namespace
}  // namespace lasius
