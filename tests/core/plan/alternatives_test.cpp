// Ways beside the shortest one, against brute force.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "lasius/base/error.h"
#include "lasius/cost/planner.h"
#include "lasius/grid/generate.h"
#include "lasius/path/path.h"
#include "lasius/plan/batch.h"
#include "lasius/plan/planner.h"
#include "tests/core/exact/exact_answers.h"
#include "tests/oracle/visibility_graph.h"
#include "tests/worlds/grids.h"

namespace lasius {
namespace {

constexpr double kDetour = 1.3, kShared = 0.7, kBeside = 0.01, kPart = 0.25;

double apart(Point a, Point b) { return std::hypot(b.x - a.x, b.y - a.y); }

double to_way(Point p, const std::vector<Point>& way) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Point a = way[i - 1], b = way[i];
    const double square = apart(a, b) * apart(a, b);
    const double t = ((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / square;
    const double s = std::fmin(1, std::fmax(0, t));
    least = std::fmin(least, apart(p, {a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)}));
  }
  return least;
}

/// The share of a way near others, by samples.
double near_share(const std::vector<Point>& way, const std::vector<std::vector<Point>>& others,
                  double within) {
  constexpr int kSamples = 400;
  double sum = 0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Point a = way[i - 1], b = way[i];
    int near = 0;
    for (int k = 0; k < kSamples; ++k) {
      const double t = (k + 0.5) / kSamples;
      const Point p{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
      for (const auto& other : others)
        if (to_way(p, other) <= within) {
          ++near;
          break;
        }
    }
    sum += apart(a, b) * near / kSamples;
  }
  return sum / path_length(way);
}

/// Is there a blocked cell inside the bend at v? Half way between the directions to its neighbours.
bool bends_around(const Grid& grid, Point a, Point v, Point b) {
  const double da = apart(a, v), db = apart(b, v);
  const double x = (a.x - v.x) / da + (b.x - v.x) / db, y = (a.y - v.y) / da + (b.y - v.y) / db;
  if (std::hypot(x, y) < 1e-9) return true;  // straight on
  const double step = 0.01 / std::hypot(x, y);
  return grid.blocked(
      {static_cast<int>(std::floor(v.x + step * x)), static_cast<int>(std::floor(v.y + step * y))});
}

bool is_taut(const Grid& grid, const std::vector<Point>& way) {
  for (std::size_t i = 1; i + 1 < way.size(); ++i)
    if (!bends_around(grid, way[i - 1], way[i], way[i + 1])) return false;
  return true;
}

/// The place so far along a way from a vertex, in steps of -1 or 1; its end if it is shorter.
std::pair<Point, double> along(const std::vector<Point>& way, std::size_t from, int step,
                               double far) {
  double gone = 0;
  for (std::size_t i = from; step < 0 ? i > 0 : i + 1 < way.size(); i += step) {
    const Point a = way[i], b = way[i + step];
    if (gone + apart(a, b) >= far) {
      const double t = (far - gone) / apart(a, b);
      return {{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}, far};
    }
    gone += apart(a, b);
  }
  return {step < 0 ? way.front() : way.back(), gone};
}

bool is_corner(const Grid& grid, int x, int y) {
  return grid.blocked({x, y}) + grid.blocked({x - 1, y}) + grid.blocked({x, y - 1}) +
             grid.blocked({x - 1, y - 1}) ==
         1;
}

/// The way with a vertex at a point on it; the way itself where it is not on it.
std::vector<Point> with_vertex(const std::vector<Point>& way, Point at) {
  std::vector<Point> more = way;
  for (std::size_t i = 1; i < way.size(); ++i) {
    if (way[i] == at) break;
    if (apart(way[i - 1], at) + apart(at, way[i]) > apart(way[i - 1], way[i]) + 1e-12) continue;
    more.insert(more.begin() + static_cast<std::ptrdiff_t>(i), at);
    break;
  }
  return more;
}

/// Corners of obstacles that a way touches, those among them that it passes straight.
std::vector<Point> corners_on(const Grid& grid, const std::vector<Point>& way) {
  std::vector<Point> found;
  for (int y = 1; y < grid.height(); ++y)
    for (int x = 1; x < grid.width(); ++x) {
      const Point at{1.0 * x, 1.0 * y};
      if (is_corner(grid, x, y) && to_way(at, way) < 1e-12) found.push_back(at);
    }
  return found;
}

void expect_alternatives(const Planner& planner, const Request& request, const Result& result) {
  const Grid& grid = planner.grid();
  const oracle::VisibilityGraph graph(grid);
  const double within = std::fmax(1, kBeside * result.length);
  std::vector<std::vector<Point>> taken{result.path};
  double before = 0;
  for (const auto& [path, length] : result.alternatives) {
    EXPECT_EQ(path.front(), result.path.front());
    EXPECT_EQ(path.back(), result.path.back());
    EXPECT_EQ(path_fault(grid, path), std::nullopt);
    EXPECT_EQ(length, path_length(path));
    EXPECT_TRUE(is_taut(grid, path));
    EXPECT_GE(length, before);
    EXPECT_GE(length, result.length * (1 - 1e-9));
    EXPECT_LE(length, kDetour * result.length * (1 + 1e-9));
    EXPECT_LE(near_share(path, taken, within), kShared + 0.01);
    before = length;
    // It is two shortest ways that meet in a corner, around which it is shortest.
    bool over_a_corner = false;
    for (const Point at : corners_on(grid, path)) {
      if (over_a_corner) break;
      const auto out = graph.shortest(path.front(), at), back = graph.shortest(at, path.back());
      if (!out || !back || std::abs(out->length + back->length - length) > 1e-9 * length) continue;
      const double half = 0.5 * kPart * result.length;
      const std::vector<Point> way = with_vertex(path, at);
      const auto i = static_cast<std::size_t>(std::ranges::find(way, at) - way.begin());
      const auto [from, first] = along(way, i, -1, half);
      const auto [to, second] = along(way, i, 1, half);
      const Result part = planner.plan({.start_point = from, .goal_point = to});
      over_a_corner = part.path.empty() || part.length >= (first + second) * (1 - 1e-6);
    }
    EXPECT_TRUE(over_a_corner) << "from " << request.start.x << ", " << request.start.y;
    taken.push_back(path);
  }
}

Request ask(Cell start, Cell goal, int count) {
  return {.start = start, .goal = goal, .alternatives = count};
}

TEST(Alternatives, RoundABlockThereIsOneOnTheOtherSide) {
  // 20 x 12, a block of 4 x 6 a little above the middle line: below it is shorter.
  const Grid grid =
      grid_of(20, 12, [](int x, int y) { return x >= 8 && x < 12 && y >= 2 && y < 8; });
  const Result result = Planner(grid).plan(ask({1, 5}, {18, 5}, 3));
  // From (1.5, 5.5) over (8, 8) and (12, 8) to (18.5, 5.5), and over (8, 2) and (12, 2).
  const double below = 2 * std::hypot(6.5, 2.5) + 4, above = 2 * std::hypot(6.5, 3.5) + 4;
  EXPECT_NEAR(result.length, below, 1e-12);
  ASSERT_EQ(result.alternatives.size(), 1);
  EXPECT_NEAR(result.alternatives[0].length, above, 1e-12);
  EXPECT_EQ(result.alternatives[0].path,
            (std::vector<Point>{{1.5, 5.5}, {8, 2}, {12, 2}, {18.5, 5.5}}));
  EXPECT_TRUE(Planner(grid).plan(ask({1, 5}, {18, 5}, 0)).alternatives.empty());
}

TEST(Alternatives, AreValidTautAndDifferOnRandomMaps) {
  std::mt19937 random(11);
  int found = 0;
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    const int side = random_in(16, 40, random);
    Grid grid = i % 2 == 0 ? random_grid(side, side, random_in(5, 35, random), random)
                           : generate(i % 4 == 1 ? MapKind::rooms : MapKind::blobs,
                                      {2 * side, 2 * side, -1, 1u + static_cast<unsigned>(i)});
    const Planner plain(grid), prepared(grid, PrepareOptions{.threads = 1}),
        labelled(grid, PrepareOptions{.threads = 1, .labels = true});
    const Request request = ask(*random_free(grid, random), *random_free(grid, random), 4);
    const Result result = plain.plan(request);
    if (result.status != Status::solved) continue;
    expect_alternatives(plain, request, result);
    found += static_cast<int>(result.alternatives.size());
    for (const Planner* other : {&prepared, &labelled}) {
      const Result again = other->plan(request);
      EXPECT_NEAR(again.length, result.length, 1e-9 * result.length);
      expect_alternatives(*other, request, again);
    }
  }
  EXPECT_GT(found, 25);
}

/// The shortest way over one corner that keeps to the bounds, by brute force: nothing where there
/// is none; `sure` is false where it hangs on a measure that is near its bound.
std::optional<double> shortest_other(const Planner& planner, const Result& result, bool& sure) {
  const Grid& grid = planner.grid();
  const oracle::VisibilityGraph graph(grid);
  const Point start = result.path.front(), goal = result.path.back();
  const double within = std::fmax(1, kBeside * result.length);
  std::optional<double> least;
  sure = true;
  for (int y = 1; y < grid.height(); ++y)
    for (int x = 1; x < grid.width(); ++x) {
      const Point at{1.0 * x, 1.0 * y};
      if (!is_corner(grid, x, y)) continue;
      const auto out = graph.shortest(start, at), back = graph.shortest(at, goal);
      if (!out || !back || out->path.size() < 2 || back->path.size() < 2) continue;
      const double length = out->length + back->length;
      if (std::abs(length - kDetour * result.length) < 1e-6) sure = false;
      if (length > kDetour * result.length || (least && length > *least)) continue;
      std::vector<Point> way = out->path;
      const std::size_t corner = way.size() - 1;
      way.insert(way.end(), back->path.begin() + 1, back->path.end());
      if (!is_taut(grid, way)) continue;
      const double from_path = to_way(at, result.path);
      if (std::abs(from_path - within) < 1e-6) sure = false;
      if (from_path <= within) continue;
      const double share = near_share(way, {result.path}, within);
      if (std::abs(share - kShared) < 0.01) sure = false;
      if (share > kShared) continue;
      const double half = 0.5 * kPart * result.length;
      const auto [from, first] = along(way, corner, -1, half);
      const auto [to, second] = along(way, corner, 1, half);
      const Result part = planner.plan({.start_point = from, .goal_point = to});
      if (part.path.empty()) sure = false;
      if (part.length < (first + second) * (1 - 1e-6)) continue;
      least = length;
    }
  return least;
}

TEST(Alternatives, TheFirstIsTheShortestThatBruteForceFinds) {
  std::mt19937 random(12);
  int compared = 0, some = 0;
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    const Grid grid = random_grid(18, 14, random_in(5, 25, random), random);
    const Planner planner(grid, PrepareOptions{.threads = 1});
    const Result result =
        planner.plan(ask(*random_free(grid, random), *random_free(grid, random), 1));
    if (result.path.size() < 2) continue;
    bool sure = true;
    const auto other = shortest_other(planner, result, sure);
    // Of ways of one length to a corner the library may know another one than brute force.
    if (!sure) continue;
    ++compared;
    if (!other) {
      EXPECT_TRUE(result.alternatives.empty());
    } else if (!result.alternatives.empty()) {
      EXPECT_NEAR(result.alternatives[0].length, *other, 1e-9);
      ++some;
    } else {
      ADD_FAILURE() << "there is one of length " << *other;
    }
  }
  EXPECT_GT(compared, 20);
  EXPECT_GT(some, 10);
}

TEST(Alternatives, AreTheSameOnAnyNumberOfThreadsAndInBatches) {
  const Grid grid = generate(MapKind::rooms, {120, 90, -1, 4});
  std::mt19937 random(3);
  std::vector<Request> requests;
  for (int i = 0; i < 12; ++i)
    requests.push_back(ask(*random_free(grid, random), *random_free(grid, random), 3));
  std::size_t found = 0;
  for (const bool labels : {false, true}) {
    std::vector<Result> first;
    for (const int threads : {1, 2, 5}) {
      const Planner planner(grid, PrepareOptions{.threads = threads, .labels = labels});
      const auto answers = plan_batch(planner, requests, {}, {.threads = threads});
      for (std::size_t i = 0; i < answers.size(); ++i) {
        if (threads == 1) first.push_back(planner.plan(requests[i]));
        EXPECT_EQ(answers[i].result.path, first[i].path);
        EXPECT_EQ(answers[i].result.alternatives, first[i].alternatives);
        found += answers[i].result.alternatives.size();
      }
    }
  }
  EXPECT_GT(found, 20);
}

TEST(Alternatives, EndAtPointsAndWhereATargetAllows) {
  const Grid grid =
      grid_of(20, 12, [](int x, int y) { return x >= 8 && x < 12 && y >= 2 && y < 8; });
  Request request = ask({0, 0}, {0, 0}, 1);
  request.start_point = Point{1.25, 5.125};
  request.goal_point = Point{18, 5};
  const Result result = Planner(grid).plan(request);
  ASSERT_EQ(result.alternatives.size(), 1);
  EXPECT_EQ(result.alternatives[0].path.front(), (Point{1.25, 5.125}));
  EXPECT_EQ(result.alternatives[0].path.back(), (Point{18, 5}));
  request.goal_point = request.start_point;
  EXPECT_TRUE(Planner(grid).plan(request).alternatives.empty());
}

TEST(Alternatives, AStopLeavesThoseFoundAndSaysSo) {
  const Planner planner(generate(MapKind::blobs, {400, 200, -1, 61}));
  Request request = ask({14, 14}, {380, 179}, 5);
  const Result whole = planner.plan(request);
  ASSERT_GT(whole.alternatives.size(), 1);
  int cut = 0;
  for (int polls = 0;; ++polls) {
    const CountingTime time(polls);
    request.stop = time.is_up();
    const Result result = planner.plan(request);
    if (result.status == Status::solved) {
      EXPECT_EQ(result.alternatives, whole.alternatives);
      break;
    }
    EXPECT_EQ(result.status, Status::limit);
    ASSERT_LE(result.alternatives.size(), whole.alternatives.size());
    if (result.optimal) ++cut;
  }
  EXPECT_GT(cut, 0);
}

TEST(Alternatives, AreRefusedWhereThereAreNone) {
  const Grid grid(10, 10);
  const Request one = ask({1, 1}, {8, 8}, 1);
  const auto refusal = [&](const Planner& planner, const Request& request, const Params& params) {
    try {
      planner.plan(request, params);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::invalid_parameter);
      return error.problem();
    }
    return std::string();
  };
  EXPECT_EQ(refusal(Planner(grid), one, {}), "");
  EXPECT_EQ(refusal(Planner(grid), one, Params("mmas")), "alternatives are asked for of mmas");
  EXPECT_EQ(refusal(Planner(grid, Disc{1}), one, {}), "alternatives are asked for of a disc");
  Request other = one;
  other.target_gap = 0.1;
  EXPECT_EQ(refusal(Planner(grid), other, {}), "alternatives are asked for with a target gap");
  other = one;
  other.via = {{3.5, 3.5}};
  EXPECT_EQ(refusal(Planner(grid), other, {}),
            "alternatives are asked for of a path through points");
  EXPECT_EQ(refusal(Planner(grid), ask({1, 1}, {8, 8}, -1), {}), "alternatives is -1");
  EXPECT_EQ(refusal(Planner(grid), ask({1, 1}, {8, 8}, 101), {}), "alternatives is 101");
  EXPECT_THROW(CostPlanner(Planner(grid), CostField(10, 10)).plan(one), Error);
  const std::vector<Request> requests{one};
  EXPECT_THROW(plan_batch(Planner(grid), requests, Params("mmas")), Error);
}

}  // namespace
}  // namespace lasius
