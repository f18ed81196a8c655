#include "lasius/tour/cover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "lasius/base/error.h"
#include "lasius/grid/generate.h"
#include "lasius/path/path.h"
#include "tests/core/base/counting_time.h"
#include "tests/core/tour/rooms.h"
#include "tests/oracle/disc_paths.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

CoverRequest ask(double width) {
  CoverRequest request;
  request.width = width;
  request.generations = 2;
  request.threads = 2;
  return request;
}

double distance(Point p, Point a, Point b) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const double t =
      square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

// Every end once, those of a swath side by side and joined by a straight leg; legs keep the radius.
void expect_valid(const Planner& planner, const CoverRequest& request, const CoverResult& cover) {
  const double radius = planner.robot().radius;
  const oracle::DiscPaths judge(planner.grid(), radius, oracle::DiscPaths::Lines::none);
  const auto& tour = cover.tour;
  std::vector<int> seen = tour.order;
  std::sort(seen.begin(), seen.end());
  ASSERT_EQ(seen.size(), cover.stops.size());
  for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_EQ(seen[i], static_cast<int>(i));
  ASSERT_EQ(tour.legs.size(), tour.order.size() - request.open);
  double swept = 0, sum = 0;
  for (std::size_t i = 0; i < tour.legs.size(); ++i) {
    const TourLeg& leg = tour.legs[i];
    EXPECT_EQ(leg.from, tour.order[i]);
    EXPECT_EQ(leg.to, tour.order[(i + 1) % tour.order.size()]);
    ASSERT_FALSE(leg.path.empty());
    EXPECT_EQ(leg.path.front(), cover.stops[leg.from]);
    EXPECT_EQ(leg.path.back(), cover.stops[leg.to]);
    sum += leg.length;
    if (radius == 0)
      EXPECT_EQ(path_fault(planner.grid(), leg.path).value_or(""), "");
    else
      for (std::size_t j = 1; j < leg.path.size(); ++j)
        EXPECT_GE(judge.clearance(leg.path[j - 1], leg.path[j]), radius - 2e-9);
    const bool back = !request.open && i + 1 == tour.legs.size();  // of a single swath
    if (leg.from / 2 != leg.to / 2 || leg.from / 2 >= cover.swaths() || back) continue;
    const Point from = cover.stops[leg.from], to = cover.stops[leg.to];
    const Result planned = planner.plan({.start_point = from, .goal_point = to}, Params("exact"));
    EXPECT_EQ(leg.path, planned.path);
    EXPECT_EQ(leg.length, planned.length);
    EXPECT_NEAR(leg.length, distance(from, to, to), 1e-9);
  }
  for (int i = 0; i < cover.swaths(); ++i) {
    const auto at = [&](int stop) {
      return std::find(tour.order.begin(), tour.order.end(), stop) - tour.order.begin();
    };
    EXPECT_EQ(std::abs(at(2 * i) - at(2 * i + 1)), 1) << i;
    const Point a = cover.stops[2 * i], b = cover.stops[2 * i + 1];
    swept += distance(a, b, b);
  }
  EXPECT_NEAR(cover.swept, swept, 1e-6);
  EXPECT_NEAR(tour.length, sum, 1e-9);
  ASSERT_TRUE(tour.lower_bound);
  EXPECT_LE(*tour.lower_bound, tour.length);
  EXPECT_GE(*tour.lower_bound, cover.swept - 1e-6);
}

// Samples of reachable free cells within half a width of the path: of those that are not just at
// it, and with those.
struct Share {
  double least, most;
};
Share covered(const Grid& grid, const CoverRequest& request, const CoverResult& cover, Cell from) {
  std::vector<Cell> waiting{from};
  std::vector<char> reached(static_cast<std::size_t>(grid.width()) * grid.height(), 0);
  reached[from.y * grid.width() + from.x] = 1;
  while (!waiting.empty()) {
    const Cell at = waiting.back();
    waiting.pop_back();
    for (const Cell to :
         {Cell{at.x + 1, at.y}, Cell{at.x - 1, at.y}, Cell{at.x, at.y + 1}, Cell{at.x, at.y - 1}}) {
      if (grid.blocked(to) || reached[to.y * grid.width() + to.x] != 0) continue;
      reached[to.y * grid.width() + to.x] = 1;
      waiting.push_back(to);
    }
  }
  double all = 0, least = 0, most = 0;
  const double step = cover.resolution;
  for (double y = step / 2; y < grid.height(); y += step)
    for (double x = step / 2; x < grid.width(); x += step) {
      if (reached[static_cast<int>(y) * grid.width() + static_cast<int>(x)] == 0) continue;
      double nearest = std::numeric_limits<double>::infinity();
      for (const TourLeg& leg : cover.tour.legs)
        for (std::size_t i = 1; i < leg.path.size(); ++i)
          nearest = std::min(nearest, distance({x, y}, leg.path[i - 1], leg.path[i]));
      ++all;
      least += nearest < request.width / 2 - 1e-7;
      most += nearest < request.width / 2 + 1e-7;
    }
  return {least / all, most / all};
}

TEST(Cover, OfAnEmptyRoomIsItsAreaOverTheWidthAndTheTurns) {
  const Planner planner{Grid(60, 40)};
  CoverRequest request = ask(3);
  request.open = true;
  const CoverResult cover = plan_cover(planner, request);
  expect_valid(planner, request, cover);
  EXPECT_EQ(cover.tour.status, Status::solved);
  EXPECT_EQ(cover.angle, 90);
  EXPECT_EQ(cover.swaths(), 20);
  EXPECT_NEAR(cover.swept, 60 * 40 / 3.0, 1e-9);
  EXPECT_NEAR(cover.tour.length, 60 * 40 / 3.0 + 19 * 3, 1e-9);
  EXPECT_EQ(cover.covered, 1);
  EXPECT_EQ(cover.overlap, 0);
  EXPECT_EQ(cover.unreachable, 0);
  EXPECT_LT(*cover.tour.gap(), 0.001);
}

TEST(Cover, IsASingleSwathInACorridor) {
  const Grid grid = walled(20, 3, {{0, 0, 20, 1}, {0, 2, 20, 1}});
  for (const double radius : {0.0, 0.5}) {  // one as wide as the tool
    const Planner planner(grid, Disc{radius});
    CoverRequest request = ask(1);
    request.open = true;
    const CoverResult cover = plan_cover(planner, request);
    expect_valid(planner, request, cover);
    EXPECT_EQ(cover.swaths(), 1);
    EXPECT_NEAR(cover.tour.length, 20 - 2 * radius, 3e-3);
    EXPECT_TRUE(cover.tour.optimal);
    EXPECT_GE(cover.covered, 0.99);
    request.open = false;  // there and back
    const CoverResult closed = plan_cover(planner, request);
    EXPECT_TRUE(closed.tour.optimal);
    EXPECT_NEAR(closed.tour.length, 2 * cover.tour.length, 1e-9);
  }
}

TEST(Cover, PassesWhatIsJustAsWideAsTheTool) {
  Grid grid(30, 12);  // two rooms, and two cells between them
  grid.fill({10, 0, 8, 12}, true);
  grid.fill({10, 5, 8, 2}, false);
  const Planner planner(grid, Disc{1});
  const CoverRequest request = ask(2);
  const CoverResult cover = plan_cover(planner, request);
  expect_valid(planner, request, cover);
  EXPECT_LT(cover.unreachable, 0.02);  // the rooms' corners
  EXPECT_GE(cover.covered, 0.98);
}

TEST(Cover, KeepsToFreeSpaceAndTellsWhatABruteForceCountTells) {
  int cases = 0;
  for (const MapKind kind :
       {MapKind::blobs, MapKind::maze, MapKind::rooms, MapKind::random, MapKind::open})
    for (const double radius : {0.0, 0.5, 1.3})
      for (const double width : {1.5, 4.0}) {
        if (radius == 0.5 && width == 4) continue;  // takes its time
        const Planner planner(generate(kind, {.width = 20, .height = 14, .seed = 5}), Disc{radius});
        CoverRequest request = ask(width);
        request.open = ++cases % 2 == 0;
        Cell from{0, 0};
        for (int i = 0; i < 20 * 14; ++i)
          if (planner.clear({(i * 7) % 20, (i * 11) % 14})) from = {(i * 7) % 20, (i * 11) % 14};
        if (!planner.clear(from)) continue;
        request.start = centre(from);
        const CoverResult cover = plan_cover(planner, request);
        if (cover.tour.order.empty()) continue;  // room to stand in, none for a swath
        SCOPED_TRACE(std::string(to_string(kind)) + ", radius " + std::to_string(radius) +
                     ", width " + std::to_string(width));
        expect_valid(planner, request, cover);
        EXPECT_EQ(cover.tour.order.size(), cover.stops.size());
        if (radius > 0) continue;
        const Share share = covered(planner.grid(), request, cover, from);
        EXPECT_GE(cover.covered, share.least - 1e-9);
        EXPECT_LE(cover.covered, share.most + 1e-9);
        EXPECT_GE(cover.covered, 0.97);
      }
  EXPECT_EQ(cases, 25);
}

// Ends of swaths that are a rounding off a wall are at it; a start between two regions is of the
// larger.
TEST(Cover, PlansLegsFromWallsAndBetweenRegions) {
  const auto plan = [](Grid grid, std::initializer_list<Cell> blocked, double width,
                       std::optional<Point> start) {
    for (const Cell at : blocked) grid.fill({at.x, at.y, 1, 1}, true);
    const Planner planner(std::move(grid));
    CoverRequest request = ask(width);
    request.start = start;
    const CoverResult cover = plan_cover(planner, request);
    expect_valid(planner, request, cover);
    EXPECT_GT(cover.covered, 0.97);
    return cover;
  };
  static_cast<void>(plan(Grid(13, 10), {{4, 1}, {9, 4}, {3, 5}, {2, 6}}, 3, std::nullopt));
  const Grid meeting = walled(6, 7, {{3, 0, 3, 3}, {0, 3, 3, 4}});
  const CoverResult larger = plan(meeting, {}, 1, Point{3, 3});
  EXPECT_DOUBLE_EQ(larger.unreachable, 9.0 / 21);
}

// The judge's samples are its own.
TEST(Cover, TellsTheSharesOfNarrowToolsAndOfTightDeadEnds) {
  const Grid slots = walled(6, 5, {{1, 1, 2, 3}});
  CoverRequest request = ask(0.2);
  request.generations = 0;
  const CoverResult narrow = plan_cover(Planner(slots), request);
  EXPECT_LE(narrow.resolution, 0.2 / 4);
  EXPECT_GT(narrow.covered, 0.97);
  EXPECT_GT(narrow.swept, 0.95 * 24 / 0.2);

  Grid dead_end = walled(15, 5, {{5, 0, 10, 5}});
  dead_end.fill({5, 2, 10, 1}, false);
  const Planner planner(dead_end, Disc{0.5});
  const CoverResult tight = plan_cover(planner, ask(2));
  EXPECT_GT(tight.covered, 0.97);
  double furthest = 0;
  for (const Point stop : tight.stops) furthest = std::max(furthest, stop.x);
  EXPECT_GT(furthest, 13.4);
}

TEST(Cover, IsTheSameOnAnyThreads) {
  const Planner planner(generate(MapKind::blobs, {.width = 36, .height = 28, .seed = 2}),
                        Disc{0.7});
  CoverRequest request = ask(3);
  std::vector<CoverResult> all;
  for (const int threads : {1, 2, 5}) {
    request.threads = threads;
    all.push_back(plan_cover(planner, request));
  }
  ASSERT_GT(all[0].swaths(), 10);
  for (const CoverResult& other : all) {
    EXPECT_EQ(other.stops, all[0].stops);
    EXPECT_EQ(other.tour.order, all[0].tour.order);
    EXPECT_EQ(other.tour.length, all[0].tour.length);
    EXPECT_EQ(other.tour.lower_bound, all[0].tour.lower_bound);
    EXPECT_EQ(other.covered, all[0].covered);
    EXPECT_EQ(other.overlap, all[0].overlap);
  }
}

TEST(Cover, TellsWhatIsWalledOff) {
  Grid grid = walled(20, 10, {{15, 0, 1, 10}});
  const Planner planner(grid);
  CoverRequest request = ask(2);
  const CoverResult larger = plan_cover(planner, request);
  EXPECT_DOUBLE_EQ(larger.unreachable, 40.0 / 190);
  EXPECT_EQ(larger.covered, 1);
  request.start = Point{18, 5};
  const CoverResult smaller = plan_cover(planner, request);
  EXPECT_DOUBLE_EQ(smaller.unreachable, 150.0 / 190);
  EXPECT_EQ(smaller.tour.order.front(), static_cast<int>(smaller.stops.size()) - 1);
  EXPECT_EQ(smaller.stops.back(), (Point{18, 5}));
  request.start = Point{15.5, 5};
  const CoverResult none = plan_cover(planner, request);
  EXPECT_EQ(none.tour.status, Status::invalid);
  EXPECT_NE(none.tour.error.find("blocked"), std::string::npos);
  EXPECT_TRUE(none.tour.order.empty() && none.stops.empty());
  EXPECT_EQ(plan_cover(Planner(grid, Disc{7}), ask(2)).tour.status, Status::invalid);
  grid.fill(true);
  EXPECT_EQ(plan_cover(Planner(grid), ask(2)).tour.status, Status::invalid);
  grid.set_blocked({0, 0}, false);
  EXPECT_EQ(plan_cover(Planner(grid), ask(4)).covered, 1);  // of one sample
}

TEST(Cover, RefusesWhatIsNoWidth) {
  const Planner planner(rooms());
  for (const double width :
       {0.0, -1.0, 60.001, std::nan(""), 1e-300, std::numeric_limits<double>::infinity()})
    EXPECT_THROW(static_cast<void>(plan_cover(planner, ask(width))), Error) << width;
  CoverRequest request = ask(3);
  request.generations = -1;
  EXPECT_THROW(static_cast<void>(plan_cover(planner, request)), Error);
}

TEST(Cover, EndsWithTheBestSoFar) {
  const Planner planner(rooms());
  CoverRequest request = ask(3);
  request.stop = fired();
  EXPECT_EQ(plan_cover(planner, request).tour.status, Status::interrupted);
  for (const int polls : {0, 3, 40}) {
    const CountingTime time(polls);
    request.stop = time.is_up();
    const CoverResult cover = plan_cover(planner, request);
    EXPECT_EQ(cover.tour.status, Status::limit);
    expect_valid(planner, request, cover);
  }
  // A disc's swaths whose way there was not looked at in time are left out, and that is told.
  const Planner disc(rooms(), Disc{1});
  request.stop = {};
  const CoverResult whole = plan_cover(disc, request);
  EXPECT_EQ(whole.tour.status, Status::solved);
  ASSERT_TRUE(whole.tour.lower_bound);
  EXPECT_GT(*whole.tour.lower_bound, whole.swept + 1);
  int cut = 0, kept = 0;
  // Interrupted whenever it is, the first swaths are laid and joined.
  for (int reads = 1; reads < 1 << 14; reads += 1 + reads / 2) {
    const FiringTime time(reads);
    request.stop = time.fires();
    const CoverResult cover = plan_cover(disc, request);
    if (cover.tour.status == Status::solved) break;
    EXPECT_EQ(cover.tour.status, Status::interrupted);
    ASSERT_FALSE(cover.stops.empty()) << reads;
    ++kept;
    expect_valid(disc, request, cover);
    EXPECT_GT(*cover.tour.lower_bound, cover.swept);
  }
  EXPECT_GT(kept, 10);
  for (int polls = 1; polls < 1 << 16; polls += 1 + polls / 4) {
    const CountingTime time(polls);
    request.stop = time.is_up();
    const CoverResult cover = plan_cover(disc, request);
    cut += cover.tour.status == Status::limit;
    if (cover.tour.status == Status::solved) {
      EXPECT_EQ(cover.stops.size(), whole.stops.size()) << polls;
    }
  }
  EXPECT_GT(cut, 5);
  // The first heading's lines are laid past any deadline, gaps are not filled then.
  request.start = Point{1.5, 1.5};
  request.width = 0.5;
  const CountingTime up(0);
  request.stop = up.is_up();
  const CoverResult laid = plan_cover(Planner(Grid(60, 8)), request);
  EXPECT_EQ(laid.tour.status, Status::limit);
  EXPECT_GT(laid.covered, 0.9);
  request = ask(3);
  std::vector<double> told;
  const CoverResult cover = plan_cover(
      planner, request, [&](std::span<const int>, double length) { told.push_back(length); });
  ASSERT_FALSE(told.empty());
  EXPECT_NEAR(told.back(), cover.tour.length, 1e-3 * static_cast<double>(cover.stops.size()));
}

}  // namespace
}  // namespace lasius
