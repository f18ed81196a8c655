// What every reader of geometry owes: whatever is cut off, empty or foreign, the world is read
// rightly or refused with line and remedy; no obstacle is lost.
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "lasius/base/error.h"
#include "lasius/polygon/world.h"

namespace lasius::polygon {
namespace {

/// A geometry of a file, and what the world holds once it is read.
struct Given {
  std::string text;
  std::size_t obstacles, walls, points;
};

struct Format {
  bool wkt;
  std::string before, between, after;
  std::vector<Given> given;

  std::string text(std::size_t count) const {
    std::string all = before;
    for (std::size_t i = 0; i < count; ++i) all += (i > 0 ? between : "") + given[i].text;
    return all + after;
  }
  std::string text() const { return text(given.size()); }

  /// Nothing where it is refused as it should be.
  std::optional<World> read(const std::string& text) const {
    try {
      return wkt ? parse_wkt(text, "w") : parse_geojson(text, "w");
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::file_broken);
      EXPECT_EQ(error.place().file, "w");
      EXPECT_GE(error.place().line, 1) << error.what();
      EXPECT_FALSE(error.remedy().empty()) << error.what();
      return std::nullopt;
    }
  }

  void expect_holds(const World& world, std::size_t count, const std::string& text) const {
    const Given& last = given[count - 1];
    EXPECT_EQ(world.obstacles.size(), last.obstacles) << text;
    EXPECT_EQ(world.walls.size(), last.walls) << text;
    EXPECT_EQ((world.start ? 1u : 0u) + (world.goal ? 1u : 0u), last.points) << text;
  }

  /// `with` before each token, and at the end.
  void expect_whole_or_refused(const std::string& with) const {
    const std::string all = text();
    const World whole = read(all).value();
    int read_as_whole = 0;
    for (std::size_t at = 0; at <= all.size(); ++at) {
      const auto word = [&](std::size_t i) {
        return std::isalnum(static_cast<unsigned char>(all[i])) != 0 || all[i] == '"';
      };
      if (at > 0 && at < all.size() && word(at - 1) && word(at)) continue;
      const std::string text = all.substr(0, at) + ' ' + with + ' ' + all.substr(at);
      const auto world = read(text);
      if (!world) continue;
      EXPECT_EQ(*world, whole) << text;
      ++read_as_whole;
    }
    ::testing::Test::RecordProperty(with, read_as_whole);
  }
};

std::string feature(const std::string& role, const std::string& geometry) {
  return R"({"properties":{"role":")" + role + R"("},"geometry":{"type":)" + geometry + "}}";
}

Format wkt(const std::string& between) {
  return {true,
          "",
          between,
          "",
          {{"POLYGON ((0 0, 40 0, 40 40, 0 40, 0 0), (1 1, 2 1, 2 2, 1 1))", 0, 0, 0},
           {"POLYGON Z ((4 4 1, 6 4 1, 6 6 1, 4 4 1))", 1, 0, 0},
           {"MULTIPOLYGON (((8 4, 9 4, 9 6, 8 4)), ((10 4, 11 4, 11 6, 10 4)))", 3, 0, 0},
           {"LINESTRING (4 10, 6 12, 8 10)", 3, 1, 0},
           {"LINEARRING (14 10, 16 12, 18 10, 14 10)", 3, 2, 0},
           {"MULTILINESTRING ((4 20, 6 22), (4 24, 8 24))", 3, 4, 0},
           {"GEOMETRYCOLLECTION (POLYGON ((20 4, 22 4, 22 6, 20 4)), LINESTRING (20 10, 22 10), "
            "GEOMETRYCOLLECTION (MULTILINESTRING ((30 10, 32 10))), POINT (3 3))",
            4, 6, 1},
           {"POINTZ (39 39 0)", 4, 6, 2}}};
}

Format geojson() {
  return {
      false,
      R"({"type":"FeatureCollection","features":[)",
      ",\n",
      "]}",
      {{feature(
            "boundary",
            R"("Polygon","coordinates":[[[0,0],[40,0],[40,40],[0,40],[0,0]],[[1,1],[2,1],[2,2],[1,1]]])"),
        0, 0, 0},
       {feature("obstacle", R"("Polygon","coordinates":[[[4,4,1],[6,4,1],[6,6,1],[4,4,1]]])"), 1, 0,
        0},
       {feature(
            "obstacle",
            R"("MultiPolygon","coordinates":[[[[8,4],[9,4],[9,6],[8,4]]],[[[10,4],[11,4],[11,6],[10,4]]]])"),
        3, 0, 0},
       {feature("obstacle", R"("LineString","coordinates":[[4,10],[6,12],[8,10]])"), 3, 1, 0},
       {feature("obstacle", R"("MultiLineString","coordinates":[[[4,20],[6,22]],[[4,24],[8,24]]])"),
        3, 3, 0},
       {feature(
            "obstacle",
            R"("GeometryCollection","geometries":[{"type":"Polygon","coordinates":[[[20,4],[22,4],[22,6],[20,4]]]},)"
            R"({"type":"GeometryCollection","geometries":[{"type":"LineString","coordinates":[[20,10],[22,10]]}]}])"),
        4, 4, 0},
       {feature("start", R"("Point","coordinates":[3,3])"), 4, 4, 1},
       {feature("goal", R"("Point","coordinates":[39,39,0])"), 4, 4, 2}}};
}

TEST(Readers, CountWhatEachGeometryBrings) {
  for (const Format& format : {wkt(" "), wkt("\n"), wkt(";"), geojson()}) {
    for (std::size_t n = 1; n <= format.given.size(); ++n)
      format.expect_holds(format.read(format.text(n)).value(), n, format.text(n));
  }
}

TEST(Readers, AFileCutAtAnyByteIsAShorterFileOrRefused) {
  for (const Format& format : {wkt(" "), wkt("\n"), geojson()}) {
    const std::string all = format.text();
    std::size_t count = 0, read = 0;  // geometries that are whole
    for (std::size_t size = 0; size < all.size(); ++size) {
      const std::string cut = all.substr(0, size);
      const auto world = format.read(cut);
      if (count < format.given.size() && format.wkt && size == format.text(count + 1).size())
        ++count;
      const bool blank_behind =
          count > 0 && cut.find_first_not_of(" \n", format.text(count).size()) == cut.npos;
      EXPECT_EQ(world.has_value(), format.wkt && blank_behind) << cut;
      if (!world || count == 0) continue;
      format.expect_holds(*world, count, cut);
      ++read;
    }
    EXPECT_EQ(count, format.wkt ? format.given.size() - 1 : 0u);
    EXPECT_GE(read, count);
  }
}

TEST(Readers, WhatIsEmptyIsPassedOverOrRefused) {
  for (const Format& whole : {wkt(" "), wkt("\n"), geojson()}) {
    const World world = whole.read(whole.text()).value();
    for (const std::string kind : {"Point", "LineString", "LinearRing", "Polygon", "MultiPoint",
                                   "MultiLineString", "MultiPolygon", "GeometryCollection"}) {
      const char* member =
          kind == "GeometryCollection" ? R"(","geometries":[])" : R"(","coordinates":[])";
      std::vector<std::string> empty{feature("obstacle", '"' + kind + member)};
      if (whole.wkt) empty = {kind + " EMPTY", kind + " Z\nempty", kind + "ZM EMPTY"};
      for (const std::string& text : empty) {
        for (std::size_t at = 0; at <= whole.given.size(); ++at) {
          Format format = whole;
          format.given.insert(format.given.begin() + static_cast<std::ptrdiff_t>(at),
                              Given{text, 0, 0, 0});
          const auto read = format.read(format.text());
          const bool area = kind.ends_with("Polygon"), point = kind.ends_with("Point");
          // An empty boundary must not make one of an obstacle.
          const bool refused = point || (whole.wkt && area && at == 0);
          EXPECT_EQ(read.has_value(), !refused) << format.text();
          EXPECT_EQ(read.value_or(world), world) << format.text();
        }
      }
    }
  }
  EXPECT_EQ(geojson().read(geojson().text(2)).value().obstacles.size(), 1u);
  for (const char* empty :
       {R"("Polygon","coordinates":[])", R"("GeometryCollection","geometries":[])"})
    EXPECT_FALSE(geojson().read(geojson().before + feature("boundary", empty) + "]}"));
}

TEST(Readers, ForeignWordsAreRefusedWhereverTheyChangeAnything) {
  for (const char* word : {"EMPTY",
                           "EMPTY,",
                           "POLYGON EMPTY",
                           "POLYGON EMPTY,",
                           "LINESTRING EMPTY,",
                           "MULTIPOLYGON EMPTY",
                           "GEOMETRYCOLLECTION EMPTY",
                           "POINT EMPTY",
                           "POLYGON",
                           "POINT",
                           "foo",
                           ",",
                           "(",
                           ")",
                           "()",
                           ";",
                           "=",
                           "Z",
                           "ZM",
                           "nan",
                           "1e",
                           "0x1",
                           "\"",
                           "SRID=5;",
                           "SRID=",
                           "\xff"}) {
    for (const char* between : {" ", "\n"}) wkt(between).expect_whole_or_refused(word);
  }
  for (const char* word :
       {"[],", ",[]", "[[]],", "{},", "null,", ",null", "\"foo\",", "\"foo\":1,", "foo", ",", "[",
        "]", "{", "}", ":", "true,", R"({"type":"Polygon","coordinates":[]},)", "\xff"})
    geojson().expect_whole_or_refused(word);
}

TEST(Readers, APointHasAsManyNumbersAsTheFirst) {
  const std::string square = "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0)) ";
  for (const char* good : {"POINT (1 2)", "POINT (1 2 3)", "POINT Z (1 2 3)", "POINT M(1 2 3)",
                           "pointzm(+1 2.0e0 3 4)", "SRID=32632;POINT (1 2)", "POINT(1 2)#3"})
    EXPECT_EQ(parse_wkt(square + good, "w").start, (Point{1, 2})) << good;
  for (const char* bad :
       {"POINT (1)", "POINT (1 2 3 4 5)", "POINT Z (1 2)", "POINT ZM (1 2 3)", "POINT (1 2, 3 4)",
        "POINT (1 1e999)", "POINT (1 +-2)", "POINT (1 2,)", "LINESTRING (0 0, 1 1 1)",
        "LINESTRING (0 0 1 1, 2 2)", "LINESTRING ()", "LINESTRING (1 1, 1 1)",
        "LINEARRING (0 0, 1 1, 2 0)", "POLYGON ()", "POLYGON (EMPTY)",
        "CIRCULARSTRING (0 0, 1 1, 2 0)", "SRID=5 POINT (1 2)"})
    EXPECT_FALSE(wkt(" ").read(square + bad)) << bad;
}

TEST(Readers, DegreesAreTold) {
  const auto notes = [](const Format& format, const std::string& from, const std::string& to) {
    std::string text = format.text();
    text.insert(text.find(from), to);
    return format.read(text).value().notes;
  };
  const auto named = [&](const std::string& crs) {
    return notes(geojson(), "\"features\"",
                 R"("crs":{"type":"name","properties":{"name":")" + crs + "\"}},");
  };
  for (const char* degrees :
       {"urn:ogc:def:crs:OGC:1.3:CRS84", "EPSG:4326", "urn:ogc:def:crs:EPSG::4258",
        "http://www.opengis.net/def/crs/EPSG/0/4326"}) {
    ASSERT_EQ(named(degrees).size(), 1u) << degrees;
    EXPECT_NE(named(degrees)[0].find(degrees), std::string::npos);
  }
  for (const char* metres : {"EPSG:32632", "urn:ogc:def:crs:EPSG::3857", "", "local"})
    EXPECT_TRUE(named(metres).empty()) << metres;
  EXPECT_EQ(notes(wkt(" "), "POLYGON", "SRID=4326;").size(), 1u);
  EXPECT_EQ(notes(wkt(" "), "MULTIPOLYGON", "srid = 4326 ; ").size(), 1u);
  EXPECT_TRUE(notes(wkt(" "), "POLYGON", "SRID=32632;").empty());
  EXPECT_TRUE(geojson().read(geojson().text()).value().notes.empty());
}

}  // namespace
}  // namespace lasius::polygon
