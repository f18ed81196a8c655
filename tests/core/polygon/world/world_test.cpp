#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "lasius/base/error.h"
#include "lasius/grid/generate.h"
#include "lasius/polygon/plan.h"
#include "tests/core/base/made_files.h"
#include "tests/core/polygon/world/refusal.h"

namespace lasius::polygon {
namespace {

constexpr const char* kSquare = "[[[0,0],[10,0],[10,10],[0,10],[0,0]]]";

std::string feature(const std::string& role, const std::string& type, const std::string& at) {
  return R"({"type":"Feature","properties":{"role":")" + role + R"("},"geometry":{"type":")" +
         type + R"(","coordinates":)" + at + "}}";
}
std::string collection(const std::vector<std::string>& features, const std::string& more = "") {
  std::string text = R"({"type":"FeatureCollection",)" + more + R"("features":[)";
  for (std::size_t i = 0; i < features.size(); ++i) text += (i > 0 ? "," : "") + features[i];
  return text + "]}";
}
std::string boundary() { return feature("boundary", "Polygon", kSquare); }

TEST(PolygonNames, EveryChoiceHasOne) {
  EXPECT_EQ(to_string(Join::mitre), "mitre");
  EXPECT_EQ(to_string(Join::bevel), "bevel");
  EXPECT_EQ(to_string(Join::chords), "chords");
  EXPECT_EQ(to_string(Boundary::keep), "keep");
  EXPECT_EQ(to_string(GlobalBest::so_far), "so-far");
  EXPECT_EQ(to_string(GlobalBest::iteration), "iteration");
}

TEST(GeoJson, ReadsEveryRole) {
  const World world = parse_geojson(
      collection({feature("obstacle", "MultiPolygon",
                          "[[[[1,1],[2,1],[2,2],[1,1]]],[[[5,5],[9,5],[9,9],[5,9],[5,5]],"
                          "[[6,6],[7,6],[7,7],[6,6]]]]"),
                  boundary(), feature("start", "Point", "[0.5,0.25]"),
                  feature("goal", "Point", "[9,1,7]")},
                 R"("properties":{"margin":0.5},)"),
      "w");
  EXPECT_EQ(world.boundary.outer, (Ring{{0, 0}, {10, 0}, {10, 10}, {0, 10}}));
  ASSERT_EQ(world.obstacles.size(), 2u);
  EXPECT_EQ(world.obstacles[1].holes[0], (Ring{{6, 6}, {7, 6}, {7, 7}}));
  EXPECT_EQ(world.start, (Point{0.5, 0.25}));
  EXPECT_EQ(world.goal, (Point{9, 1}));
  EXPECT_EQ(world.margin, 0.5);
}

TEST(GeoJson, NamesWhatIsWrong) {
  expect_refusal("{\n\"type\": oops}", "line 2, byte 10");
  expect_refusal("{\"x\":\n" + std::string(500'000, '[') + std::string(500'000, ']') + "}",
                 "line 2, byte 69: the document nests too deep");
  expect_refusal("[]", "FeatureCollection");
  expect_refusal(R"({"type":"FeatureCollection"})", "list of features");
  expect_refusal(collection({}), "no boundary");
  expect_refusal(collection({boundary(), boundary()}), "feature 1 (boundary): is a second");
  expect_refusal(collection({boundary(), feature("obstacel", "Polygon", kSquare)}),
                 "did you mean \"obstacle\"");
  expect_refusal(collection({R"({"type":"Feature"})"}), "feature 0: has no role");
  expect_refusal(collection({feature("boundary", "LineString", "[[0,0],[1,1]]")}), "LineString");
  expect_refusal(collection({feature("boundary", "Polygon", "[[[0,0],[1,0],[1,1]]]")}),
                 "ring 0: is not closed");
  expect_refusal(collection({feature("boundary", "Polygon", "[[[0,0],[1,0],[\"a\",1],[0,0]]]")}),
                 "ring 0, point 2");
  expect_refusal(collection({feature("boundary", "Polygon", "[[[0,0],[1,0],[0,0]]]")}),
                 "only 2 distinct points");
  expect_refusal(collection({feature("boundary", "Polygon", "[[[0,0],[1e13,0],[1,1],[0,0]]]")}),
                 "point 1");
  expect_refusal(collection({feature("boundary", "Polygon", "[[[0,0],[1e999,0],[1,1],[0,0]]]")}),
                 "byte 147: a number is too large");
  expect_refusal(
      collection({feature("boundary", "Polygon", "[[[0,0],[1e-200,0],[0,1e-200],[0,0]]]")}),
      "ring 0, at (0, 0), is less than 1e-100 wide");
  expect_refusal(collection({boundary(), feature("start", "Point", "[1]")}), "two numbers");
  expect_refusal(collection({boundary()}, R"("margin":-1,)"), "margin");
  expect_refusal(collection({boundary()}, R"("margin":1,"properties":{"margin":1},)"), "again");
  expect_refusal(collection({boundary()}, R"("margin":"wide",)"), "margin");
}

TEST(GeoJson, NamesTheLineOfEachFault) {
  // A member or a feature a line.
  const std::string good = "{\"type\":\"FeatureCollection\",\n\"margin\":0,\n\"features\":[\n" +
                           boundary() + ",\n" + feature("start", "Point", "[1,1]") + ",\n" +
                           feature("obstacle", "Polygon", "[[[1,1],[5,1],\n[5,5],[1,1]]]") + "]}";
  EXPECT_NO_THROW(parse_geojson(good, "w"));
  struct Case {
    std::string from, to;
    std::int64_t line, offset;
  };
  const auto at = [&](const std::string& part) {
    return static_cast<std::int64_t>(good.find(part));
  };
  for (const Case& c : {Case{"FeatureCollection", "Feature", 1, -1},
                        {"\"features\"", "\"featurs\"", 1, -1},
                        {"\"margin\":0", "\"margin\":-1", 1, -1},
                        {"[1,1]}", "[1]}", 5, -1},
                        {"\"obstacle\"", "\"wall\"", 6, -1},
                        {"[5,1],", "[1,1],", 6, -1},
                        {"[1,1]]]", "[1,1]]", 7, at("[1,1]]]") + 6},
                        {"\"margin\":0", "\"type\":0", 2, at("\"margin\"") + 5},
                        {"\"margin\":0", "\"margin\":1e999", 2, at("\"margin\"") + 13}}) {
    std::string text = good;
    text.replace(text.find(c.from), c.from.size(), c.to);
    for (const bool only_cr : {false, true}) {
      if (only_cr) std::ranges::replace(text, '\n', '\r');
      const Error error = error_of([&] { return parse_geojson(text, "w"); }, text);
      EXPECT_EQ(error.place().line, c.line) << error.what();
      EXPECT_EQ(error.place().offset, c.offset) << error.what();
    }
  }
}

TEST(GeoJson, EveryNameIsGivenOnce) {
  expect_refusal(R"({"type":"FeatureCollection","type":"FeatureCollection","features":[]})",
                 "line 1, byte 33: \"type\" is given again");
  const std::string twice =
      collection({boundary(), "{\"properties\":{\"role\":\"start\",\n\"role\":\"goal\"}}"});
  const auto last = twice.find("\"role\":\"goal\"") + std::string("\"role").size();
  expect_refusal(twice, "line 2, byte " + std::to_string(last) + ": \"role\" is given again");
  EXPECT_NO_THROW(parse_geojson(collection({boundary()}, R"("x":{"x":1,"y":[{"x":2}]},)"), "w"));
  expect_refusal(collection({boundary()}) + std::string("\0 more", 6), "a zero byte");
  std::string members;
  for (int i = 0; i <= 2000; ++i) members += "\"k" + std::to_string(i) + "\":0,";
  expect_refusal(collection({boundary()}, members), "too many members");
}

TEST(GeoJson, NamesRingAndPointOfBadGeometry) {
  const std::string bow = "[[[1,1],[5,5],[5,1],[1,5],[1,1]]]";
  expect_refusal(
      collection({boundary(), feature("obstacle", "Polygon", bow)}),
      "feature 1 (obstacle): Self-intersection near (3, 3), on ring 0 between its points "
      "0 and 1");
  const std::string hole = "[[[1,1],[5,1],[5,5],[1,5],[1,1]],[[7,7],[8,7],[8,8],[7,7]]]";
  expect_refusal(collection({boundary(), feature("obstacle", "Polygon", hole)}), "on ring 1");
}

TEST(GeoJson, ARepairIsNotAdvisedWhereItWasAskedFor) {
  const auto remedy = [](const std::string& text, bool repair) {
    return error_of([&] { return parse_geojson(text, "w", {.repair = repair}); }).remedy();
  };
  const std::string far =
      collection({feature("boundary", "Polygon", "[[[0,0],[1e13,0],[1,1],[0,0]]]")});
  const std::string thin = collection({feature("boundary", "Polygon", "[[[0,0],[1,0],[0,0]]]")});
  EXPECT_EQ(remedy(far, true), "correct the ring");
  EXPECT_EQ(remedy(far, false), "correct the ring") << "no repair helps";
  expect_says(remedy(thin, false), "--repair");
  EXPECT_EQ(remedy(thin, true).find("--repair"), std::string::npos);
}

TEST(GeoJson, RepairsOnRequest) {
  const std::string bow = "[[[1,1],[5,5],[5,1],[1,5]]]";  // not closed either
  const World world = parse_geojson(collection({boundary(), feature("obstacle", "Polygon", bow)}),
                                    "w", {.repair = true});
  ASSERT_EQ(world.obstacles.size(), 2u);  // both wings
  EXPECT_NO_THROW(check(world));
}

TEST(World, TheHashIsOfEveryNumber) {
  World world;
  world.boundary = {{{0, 0}, {10, 0}, {10, 10}}, {{{1, 2}, {3, 2}, {3, 4}}}};
  world.obstacles = {{{{1, 1}, {2, 1}, {2, 2}}, {}},
                     {{{4, 4}, {8, 4}, {8, 8}}, {{{5, 5}, {6, 5}, {6, 6}}}}};
  world.start = Point{0.1, 0.2};
  world.margin = 0.125;
  world.walls = {{{6, 1}, {7, 2}}};
  std::vector<std::uint64_t> seen{hash(world)};
  const auto expect_another = [&](const World& other, const std::string& changed) {
    const std::uint64_t value = hash(other);
    EXPECT_EQ(std::ranges::count(seen, value), 0) << changed;
    seen.push_back(value);
  };
  World other = world;
  const auto change = [&](double& number, const std::string& what) {
    const double before = std::exchange(number, number + 0.5);
    expect_another(other, what);
    number = before;
  };
  const auto change_polygon = [&](Polygon& polygon, const std::string& what) {
    std::vector<Ring*> rings{&polygon.outer};
    for (Ring& hole : polygon.holes) rings.push_back(&hole);
    for (Ring* ring : rings) {
      for (Point& p : *ring) {
        change(p.x, what + ", x");
        change(p.y, what + ", y");
        std::swap(p.x, p.y);
        if (p.x != p.y) expect_another(other, what + ", x and y");
        std::swap(p.x, p.y);
      }
    }
  };
  change_polygon(other.boundary, "boundary");
  for (Polygon& p : other.obstacles) change_polygon(p, "obstacle");
  change(other.start->x, "start's x");
  change(other.start->y, "start's y");
  change(other.margin, "margin");
  for (Point& p : other.walls[0]) change(p.x, "wall's x");
  std::swap(other.start, other.goal);
  expect_another(other, "a goal in place of the start");
  std::swap(other.start, other.goal);
  std::swap(other.obstacles[0], other.obstacles[1]);
  expect_another(other, "order of the obstacles");
  other.obstacles.clear();
  expect_another(other, "no obstacles");
}

TEST(World, IsRefusedWhereItsNumbersAreNone) {
  World good;
  good.boundary.outer = {{0, 0}, {4, 0}, {4, 4}};
  EXPECT_NO_THROW(check(good));
  const double nan = std::nan("");
  for (const double margin : {-1.0, nan, 1e13}) {
    World world = good;
    world.margin = margin;
    EXPECT_THROW(check(world), Error) << margin;
    EXPECT_THROW(to_grid(world, 1), Error) << "free space without the margin, " << margin;
  }
  World world = good;
  world.start = Point{nan, 1};
  EXPECT_THROW(check(world), Error);
  world.start = Point{3, 1};
  world.goal = Point{3, 1e13};
  EXPECT_THROW(check(world), Error);
  for (const Ring& wall : {Ring{}, Ring{{1, 1}, {1, 1}}, Ring{{1, 1}, {nan, 1}}}) {
    world = good;
    world.walls = {wall};
    expect_says(error_of([&] { check(world); }), "wall 0: the line has ");
  }
}

using WorldFile = Files;

TEST_F(WorldFile, ReadsByContentAndReportsMissingFiles) {
  const std::string name = path("world.wkt");
  World world;
  world.boundary.outer = {{0, 0}, {4, 0}, {4, 4}};
  write_world(world, name);
  EXPECT_EQ(read_world(name), world);
  std::ofstream(name) << "  " << to_geojson(world);
  EXPECT_EQ(read_world(name), world);
  std::ofstream(name) << " \n";
  EXPECT_THROW(read_world(name), Error);
  for (const auto& [ending, content, says] : {std::tuple{".wkt", "((((", "the name of a geometry"},
                                              {".wkt", "null", "the name of a geometry"},
                                              {".geojson", "null", "no FeatureCollection"},
                                              {".geojson", "((((", "not JSON"},
                                              {".json", "POINT EMPTY", "is empty"},
                                              {".wkt", "{}", "no FeatureCollection"}}) {
    const std::string other = path(std::string("other") + ending);
    std::ofstream(other) << content;
    expect_says(error_of([&] { return read_world(other); }, content), says);
    std::filesystem::remove(other);
  }
  std::filesystem::remove(name);
  EXPECT_EQ(error_of([&] { return read_world(name); }).code(), ErrorCode::file_missing);
  EXPECT_EQ(error_of([&] { return read_world(path(".")); }).code(), ErrorCode::file_broken);
}

TEST(Check, RefusesWorldsThatProgramsMade) {
  World world;
  EXPECT_THROW(check(world), Error);
  world.boundary.outer = {{0, 0}, {4, 0}, {4, std::numeric_limits<double>::quiet_NaN()}};
  EXPECT_THROW(check(world), Error);
  EXPECT_THROW(Planner{world}, Error);
}

TEST(Bitmap, BecomesAWorldAndBackAgain) {
  const Grid grid = generate(MapKind::rooms, {.width = 60, .height = 40, .seed = 3});
  for (const double resolution : {1.0, 0.05}) {
    const World world = from_grid(grid, {.resolution = resolution, .origin_x = -3, .origin_y = 2});
    EXPECT_NO_THROW(check(world));
    const Map map = to_grid(world, resolution);
    EXPECT_EQ(map.grid, grid);
    EXPECT_EQ(map.frame->origin_x, -3);
  }
  EXPECT_THROW(from_grid(grid, {.yaw = 0.1}), Error);
  EXPECT_THROW(to_grid(from_grid(grid), 0), Error);
  EXPECT_THROW(to_grid(from_grid(grid), 1e-4), Error);
}

}  // namespace
}  // namespace lasius::polygon
