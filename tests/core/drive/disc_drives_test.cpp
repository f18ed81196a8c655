// Drives, walks and colonies' paths of discs keep the radius, by an independent distance.
//
// LASIUS_DISC_DRIVES=N with the shared folder: N drives, and each colony on each of its maps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "lasius/drive/drive.h"
#include "lasius/drive/navigator.h"
#include "lasius/grid/map_io.h"
#include "lasius/path/path.h"
#include "tests/core/base/counting_time.h"
#include "tests/oracle/near_clearance.h"
#include "tests/worlds/changing_world.h"
#include "tests/worlds/grids.h"
#include "tests/worlds/planning.h"
#include "tests/worlds/shared_maps.h"

namespace lasius {
namespace {

constexpr double kRoom = 1e-9;
constexpr double kRadii[] = {0.5, 1.7, 4.4, 8, 12.3};

struct NamedMap {
  std::string name;
  Grid grid;
};

int wanted_drives() {
  const char* const text = std::getenv("LASIUS_DISC_DRIVES");
  return text != nullptr ? std::atoi(text) : 0;
}

std::vector<NamedMap> maps() {
  std::vector<NamedMap> maps;
  const auto add = [&](const std::filesystem::path& file) {
    maps.push_back({file.stem().string(), read_map(file.string()).grid});
  };
  for (const char* name : {"free-space-complex.map", "fan400x200.map"})
    add(std::filesystem::path(LASIUS_MAPS_DIR) / name);
  maps.push_back({"blobs", blobs(160, 120)});
  Grid halls(220, 140);  // with room for the largest disc
  for (const Rectangle& wall : {Rectangle{50, 0, 20, 80}, {110, 60, 20, 80}, {165, 0, 9, 75}})
    halls.fill(wall, true);
  maps.push_back({"halls", std::move(halls)});
  if (wanted_drives() == 0) return maps;
  EXPECT_FALSE(bench_test::shared_tables().empty()) << "so many drives are for the shared maps";
  for (const auto& table : bench_test::shared_tables())
    add(std::filesystem::path(table).replace_extension(".map"));
  const auto nav2 = bench_test::shared_dir().parent_path() / "nav2";
  for (const char* name : {"depot.pgm", "tb3_sandbox.pgm"})
    if (std::filesystem::exists(nav2 / name)) add(nav2 / name);
  return maps;
}

/// Two cells that a walk joins, if some draws find such.
std::optional<Request> draw_ends(const Planner& planner, Draw& draw) {
  const Grid& grid = planner.passable();
  for (int i = 0; i < 2000; ++i) {
    const Cell start{draw.below(grid.width()), draw.below(grid.height())};
    const Cell goal{draw.below(grid.width()), draw.below(grid.height())};
    if (grid.free(start) && grid.free(goal) && start != goal && planner.connected(start, goal))
      return Request{start, goal};
  }
  return std::nullopt;
}

double least_clearance(const Grid& grid, const std::vector<Point>& path, double most) {
  double least = most;
  for (std::size_t i = 1; i < path.size(); ++i)
    least = std::min(least, oracle::near_clearance(grid, path[i - 1], path[i], most));
  return least;
}

TEST(DiscDrives, KeepTheRadius) {
  const bool all = wanted_drives() > 0;
  const std::vector<NamedMap> worlds = maps();
  const int drives = all ? wanted_drives() : 15;
  for (const double radius : kRadii) {
    int driven = 0, arrived = 0, replans = 0, judged = 0;
    double track = std::numeric_limits<double>::infinity(), paths = track;
    std::vector<Planner> planners;
    for (const NamedMap& world : worlds) planners.emplace_back(world.grid, Disc{radius});
    for (int i = 0; i < drives * 2 && driven < drives / 5; ++i) {
      Draw draw(static_cast<std::uint64_t>(i));
      const Planner& planner = planners[static_cast<std::size_t>(i) % worlds.size()];
      const Grid& truth = planner.grid();
      const auto ends = draw_ends(planner, draw);
      if (!ends) continue;
      // The robot does not know of some walls, and knows of some that are none.
      Grid known = truth;
      for (int n = 0; n < 6; ++n) known.fill(draw_part(draw, truth, 8), draw.one_in(2));
      const Cell goal = ends->goal;
      const int around = static_cast<int>(radius) + 2;
      for (const Cell c : {ends->start, goal})
        for (int y = c.y - around; y <= c.y + around; ++y)
          for (int x = c.x - around; x <= c.x + around; ++x)
            if (truth.contains({x, y})) known.set_blocked({x, y}, truth.blocked({x, y}));
      NavigatorOptions options{.params = Params(i % 10 == 9 ? "acs" : "exact"), .radius = radius};
      options.params.threads = 1;
      if (i % 10 == 9) options.params.iterations = 3;
      const auto judge = [&](const DriveTick& tick) {
        if (!tick.replanned || tick.way == nullptr || ++replans % 4 != 0) return;
        if (tick.way->way_out) return;
        ++judged;
        const Grid& seen = tick.robot_knows->map();
        paths = std::min(paths, least_clearance(seen, tick.way->path, radius + 1) - radius);
      };
      const auto result = drive(known, truth, ends->start, goal, {},
                                {.max_ticks = 4000, .observer = judge}, options);
      ++driven;
      arrived += result.status == Status::solved;
      EXPECT_TRUE(result.status == Status::solved || result.status == Status::limit)
          << i << " " << worlds[static_cast<std::size_t>(i) % worlds.size()].name << " "
          << result.error;
      std::vector<Point> line;
      for (const Cell c : result.track) line.push_back(centre(c));
      track = std::min(track, least_clearance(truth, line, radius + 1) - radius);
    }
    std::printf("radius %g: %d drives, %d arrived, least clearance - R: tracks %.3g, paths %.3g\n",
                radius, driven, arrived, track, paths);
    EXPECT_GE(track, -kRoom) << radius;
    EXPECT_GE(paths, -kRoom) << radius;
    EXPECT_GT(judged, 0) << radius;
    EXPECT_GE(arrived, driven * 9 / 10) << radius;
    EXPECT_GT(driven, 1);
  }
}

TEST(DiscDrives, ColoniesKeepTheRadius) {
  const bool all = wanted_drives() > 0;
  const std::vector<NamedMap> worlds = maps();
  for (const double radius : kRadii) {
    int plans = 0, n = 0;
    double least = std::numeric_limits<double>::infinity();
    for (const NamedMap& world : worlds) {
      const Planner planner(world.grid, Disc{radius});
      Draw draw(7);
      for (const char* name : colonies()) {
        const auto ends = draw_ends(planner, draw);
        if (!ends) continue;
        if (!all && world.name == "fan400x200") continue;
        for (const Neighbours neighbours : {Neighbours::eight, Neighbours::twenty_four}) {
          for (const Polish polish : {Polish::local, Polish::taut}) {
            if (!find_algorithm(name).has("polish") || !find_algorithm(name).has("neighbours"))
              continue;
            Params params(name);
            params.ants = std::min(params.ants, 6);
            params.iterations = 3;
            params.threads = 1;
            const Params usual = params;
            params.neighbours = neighbours;
            params.polish = polish;
            const Result result = planner.plan(*ends, n++ % 2 == 0 ? usual : params);
            if (result.path.empty()) continue;  // the few ants did not arrive
            ++plans;
            least = std::min(least, least_clearance(world.grid, result.path, radius + 1) - radius);
          }
        }
      }
    }
    std::printf("radius %g: %d plans of colonies, least clearance - R %.3g\n", radius, plans,
                least);
    EXPECT_GE(least, -kRoom) << radius;
    EXPECT_GT(plans, 8);
  }
}

/// The only way leads along a corridor exactly as wide as the disc, over centres of cells.
TEST(DiscDrives, GoWhereExactlyTheDiscFits) {
  Grid grid = walled(40, 21, {{10, 0, 20, 9}, {10, 12, 20, 9}});
  const Request request{{3, 3}, {36, 17}};
  for (const auto& [radius, open] : {std::pair{1.5, true}, {1.5 + 1e-6, false}}) {
    const Planner planner(grid, Disc{radius});
    for (const char* name : {"fan2004", "as", "acs"}) {
      Params params(name);
      params.iterations = 20;
      EXPECT_EQ(planner.plan(request, params).path.empty(), !open) << name << radius;
    }
    const auto result = drive(grid, grid, request.start, request.goal, {}, {}, {.radius = radius});
    EXPECT_EQ(result.status, open ? Status::solved : Status::unreachable);
  }
  // A door of four rows, its middle between two: a path leads through, but no walk.
  grid.fill({10, 8, 20, 1}, false);
  Navigator navigator(grid, request.goal, {.radius = 2});
  const Way& way = navigator.step(request.start);
  EXPECT_EQ(way.status, Status::solved);
  EXPECT_FALSE(way.curve.empty());
  EXPECT_EQ(way.walk, std::vector<Cell>{request.start});
  const auto result = drive(grid, grid, request.start, request.goal, {}, {}, {.radius = 2});
  EXPECT_EQ(result.status, Status::unreachable);
  EXPECT_EQ(result.ticks, 0) << "it does not set out";
  // Nor where the door is beyond what it walks at a time.
  Grid hall = walled(200, 21, {{170, 0, 20, 21}});
  hall.fill({170, 8, 20, 4}, false);
  EXPECT_EQ(drive(hall, hall, {3, 3}, {196, 17}, {}, {}, {.radius = 2}).ticks, 0);
}

// Centres of cells lie beside the path, from where its vertices cannot all be seen.
TEST(DiscDrives, AWayIsKeptWhereNothingChanges) {
  int steps = 0, plans = 0;
  for (const double radius : {0.5, 1.7, 4.4, 8.0}) {
    for (const NamedMap& world : maps()) {
      const Planner planner(world.grid, Disc{radius});
      Draw draw(11);
      for (int i = 0; i < 3; ++i) {
        const auto ends = draw_ends(planner, draw);
        if (!ends) continue;
        Navigator navigator(world.grid, ends->goal, {.radius = radius});
        double before = std::numeric_limits<double>::infinity();
        for (Cell robot = ends->start; robot != ends->goal; ++steps) {
          ASSERT_LT(steps, 20'000);
          const Way& way = navigator.step(robot);
          ASSERT_GT(way.walk.size(), 1u) << world.name << radius << way.error;
          plans += way.replanned && robot != ends->start;
          EXPECT_EQ(way.path.front(), centre(robot));
          EXPECT_EQ(way.path.back(), centre(ends->goal));
          EXPECT_GE(least_clearance(world.grid, way.path, radius + 1), radius - kRoom);
          EXPECT_EQ(way.length, way.replanned ? way.length : path_length(way.path));
          EXPECT_LE(way.length, before + 1.5);
          before = way.length;
          robot = way.walk[1 + static_cast<std::size_t>(steps) %
                                   std::min<std::size_t>(3, way.walk.size() - 1)];
        }
      }
    }
  }
  std::printf("%d of %d steps planned anew\n", plans, steps);
  EXPECT_LE(plans, steps / 100);
  EXPECT_GT(steps, 1000);
}

// A door between centres of cells is passed by a path, and by no walk, which leads around.
TEST(DiscDrives, AStepCanBeStopped) {
  Grid map = walled(900, 900, {{440, 0, 20, 860}});
  map.fill({440, 448, 20, 4}, false);
  const Cell start{430, 450}, goal{470, 450};
  const NavigatorOptions options{.radius = 2};
  const auto edit = [](Navigator& navigator) {
    navigator.observe(Rectangle{100, 100, 9, 9}, true);
  };
  Navigator whole(map, goal, options);
  edit(whole);
  const CountingTime counted(1 << 30);
  const Way way = whole.step(start, counted.is_up());
  EXPECT_EQ(way.status, Status::solved);
  EXPECT_GT(way.length, 800) << "around";
  EXPECT_EQ(way.length, path_length(way.path));
  ASSERT_GT(counted.polls(), 20);
  for (int polls = 0; polls < counted.polls(); polls += counted.polls() / 12) {
    Navigator navigator(map, goal, options);
    edit(navigator);
    const CountingTime time(polls);
    const Way& cut = navigator.step(start, time.is_up());
    EXPECT_EQ(cut.status, Status::limit) << polls;
    EXPECT_LE(time.polls(), polls + 4) << "what follows ends at once";
    const Way& then = navigator.step(start);
    EXPECT_EQ(then.path, way.path) << polls;
    EXPECT_EQ(then.walk, way.walk) << polls;
  }
}

// The same door and no way around: near the goal is as far as a walk leads.
TEST(DiscDrives, EndNearAGoalThatNoWalkLeadsTo) {
  Grid map = walled(60, 40, {{28, 0, 4, 40}});
  map.fill({28, 18, 4, 4}, false);
  const Cell start{10, 20}, goal{50, 20};
  ASSERT_EQ(Planner(Grid(map), Disc{2}).plan({start, goal}).status, Status::solved);
  const auto arrived = [&](double tolerance, Cell from = {10, 20}) {
    return drive(map, map, from, goal, {}, {}, {.radius = 2, .goal_tolerance = tolerance});
  };
  EXPECT_EQ(arrived(0).status, Status::unreachable);
  EXPECT_EQ(arrived(23).status, Status::unreachable);
  const DriveResult near = arrived(25);
  EXPECT_EQ(near.status, Status::solved);
  ASSERT_TRUE(near.goal_reached);
  EXPECT_EQ(*near.goal_reached, (Cell{26, 20}));
  EXPECT_EQ(near.track.back(), *near.goal_reached);
  const DriveResult there = arrived(25, *near.goal_reached);
  EXPECT_EQ(there.status, Status::solved);
  EXPECT_EQ(there.ticks, 0);
}

TEST(DiscDrives, AStepStoppedBeforeItPlannedHasNoWay) {
  Navigator navigator(Grid(600, 600), {590, 590}, {.radius = 2});
  const Cell robot{5, 5};
  ASSERT_EQ(navigator.step(robot).status, Status::solved);
  navigator.observe({100, 0, 300, 550}, true);
  std::stop_source source;
  source.request_stop();
  const Way& way = navigator.step(robot, {.token = source.get_token()});
  EXPECT_EQ(way.status, Status::interrupted);
  EXPECT_TRUE(way.path.empty());
  EXPECT_EQ(navigator.step(robot).status, Status::solved);
}

}  // namespace
}  // namespace lasius
