#include <gtest/gtest.h>

#include <string>

#include "lasius/base/error.h"
#include "tests/core/polygon/world/refusal.h"

namespace lasius::polygon {
namespace {

TEST(Wkt, ReadsWhatItWrites) {
  World world;
  world.boundary.outer = {{0, 0}, {10.1, 0}, {10, 10}, {0, 10}};
  world.obstacles = {{{{1, 1}, {2, 1}, {2, 2}}, {}},
                     {{{4, 4}, {8, 4}, {8, 8}, {4, 8}}, {{{5, 5}, {6, 5}, {6, 6}}}}};
  world.start = Point{0.1, 0.2};
  world.goal = Point{9, 9.3};
  world.margin = 0.125;
  world.walls = {{{1, 5}, {2, 5.5}}, {{3, 3}, {4, 3}, {4, 3.5}, {3, 3}}};
  EXPECT_EQ(parse_wkt(to_wkt(world), "w"), world);
  EXPECT_EQ(parse_geojson(to_geojson(world), "w"), world);
  EXPECT_EQ(hash(parse_wkt(to_wkt(world), "w")), hash(world));
}

TEST(Wkt, RefusesToWriteWhatItCouldNotRead) {
  World world;
  EXPECT_THROW(to_wkt(world), Error) << "no boundary";
  world.boundary.outer = {{0, 0}, {4, 0}, {4, 4}};
  world.goal = Point{3, 1};
  EXPECT_THROW(to_wkt(world), Error) << "a goal without a start";
  EXPECT_EQ(parse_geojson(to_geojson(world), "w"), world);
  world.obstacles = {{{{1, 1}, {2, 1}}, {}}};
  world.start = Point{2, 1};
  EXPECT_THROW(to_wkt(world), Error) << "an obstacle of two corners";
}

TEST(Wkt, CollectionsAndComments) {
  const World world = parse_wkt(
      "# drawn by hand\nGEOMETRYCOLLECTION (POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0)),\n POINT (1 1),"
      " MULTIPOLYGON (((2 2, 3 2, 3 3, 2 2)), ((5 5, 6 5, 6 6, 5 5))));\nPOINT (8 8)\n",
      "w");
  EXPECT_EQ(world.obstacles.size(), 2u);
  EXPECT_EQ(world.start, (Point{1, 1}));
  EXPECT_EQ(world.goal, (Point{8, 8}));
  const World folded = parse_wkt("POLYGON\n ((0 0, 9 0, 9 9, 0 9,\n 0 0))\nPOINT\r\n(1 1)", "w");
  EXPECT_EQ(folded.boundary.outer.size(), 4u);
  EXPECT_EQ(folded.start, world.start);
  const World cr =
      parse_wkt("# margin 2\r# by hand\rPOLYGON\r((0 0, 9 0, 9 9, 0 0))\rPOINT (1 1)", "w");
  EXPECT_EQ(cr.margin, 2);
  EXPECT_EQ(cr.start, world.start);
}

TEST(Wkt, OnlyACommentThatIsAMarginIsOne) {
  const auto margin = [](const std::string& comment) {
    return parse_wkt(comment + "\nPOLYGON ((0 0, 9 0, 9 9, 0 0))", "w").margin;
  };
  for (const char* is : {"# margin 5", "#margin 5\r", "# margin  5 ", "#\tmargin\t5"}) {
    EXPECT_EQ(margin(is), 5) << is;
  }
  for (const char* no : {"# margin of the robot: 5", "# margin", "# margins 5"}) {
    EXPECT_EQ(margin(no), 0) << no;
  }
  EXPECT_THROW(margin("# margin -1"), Error);
  EXPECT_THROW(margin("# margin 5abc"), Error);
  EXPECT_THROW(margin("# margin 1,5"), Error);
  EXPECT_THROW(margin("# margin 1e999"), Error);
  EXPECT_THROW(margin("# margin nan"), Error);
}

TEST(Wkt, NamesWhatIsWrong) {
  expect_refusal("MULTIPOLYGON (((0 0, 9 0, 9 9, 0 0)), ((20 0, 29 0, 29 9, 20 0)))",
                 "geometry 0 is in several parts", true);
  expect_refusal("POLYGON ((0 0, 1 0, 1 1, 0 0))\nPOLYGON ((0 0, 1 0",
                 "line 2, byte 31: geometry 1: the file ends where \")\" must stand", true);
  expect_refusal("POLYGON ((0 0, 1 0, 1 1))", "line 1, byte 0: geometry 0, ring 0: is not closed",
                 true);
  expect_refusal("MULTIPOINT ((0 0), (1 1))", "is a MULTIPOINT", true);
  expect_refusal("POINT (1 1)", "no boundary", true);
  expect_refusal("POINT EMPTY", "empty", true);
  expect_refusal("POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))", "Self-intersection", true);
  std::string nested;
  for (int i = 0; i < 17; ++i) nested += "GEOMETRYCOLLECTION (";
  expect_refusal(nested, "nested too deep", true);
}

TEST(Wkt, NamesLineAndByteOfATokenOrOfTheGeometry) {
  struct Case {
    const char* text;
    std::int64_t line, offset;
  };
  for (const Case& c :
       {Case{"POLYGON ((0 0, 1 0, 0 0))", 1, 0},
        {"\n\n  POINT EMPTY", 3, 4},
        {"# margin 1\n# margin 2\nPOINT (0 0)", 2, 11},
        {"# here\r\nPOINT (0 0); POINT (0)", 2, 29},
        {"# here\rPOINT (0 0)\rPOINT (0)", 3, 27},
        {"POLYGON ((0 0, 9 0,\n9 9 0 9, 0 0))", 2, 24},
        {"POLYGON ((0 0, 9 0, 9 9, 0 0))\nPOLYGON ((0 0, 9 9,\n9 0, 0 9, 0 0))", 2, 31}}) {
    const Error error = error_of([&] { return parse_wkt(c.text, "w"); }, c.text);
    EXPECT_EQ(error.place().line, c.line) << error.what();
    EXPECT_EQ(error.place().offset, c.offset) << error.what();
  }
}

}  // namespace
}  // namespace lasius::polygon
