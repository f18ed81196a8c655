#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <system_error>

#include "core/base/invalid_parameter.h"
#include "core/base/number_text.h"
#include "core/base/text_lines.h"
#include "core/polygon/world_maker.h"

namespace lasius::polygon {
namespace {

constexpr int kMostDepth = 16;

class WktReader {
 public:
  WktReader(std::string_view text, const std::string& name, const ReadOptions& options)
      : text_(text),
        name_(name),
        maker_(options, [this](const auto& place, const auto& problem, const auto& remedy) {
          fail(place.empty() ? problem : place + ": " + problem, remedy);
        }) {}

  World read() {
    while (skip_blank()) {
      begin_ = at_;
      const std::string geometry = next_geometry();
      ++number_;
      const auto read = maker_.geos().read_wkt(geometry);
      if (!read) {
        fail("is no geometry (GEOS: " + maker_.geos().said() + ")",
             "write it as POLYGON ((0 0, 1 0, 1 1, 0 0)) or POINT (0 0)");
      }
      add(read.get());
    }
    return maker_.finish();
  }

 private:
  [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const {
    throw Error(ErrorCode::file_broken,
                {.file = name_,
                 .line = line_at(text_, begin_),
                 .offset = static_cast<std::int64_t>(begin_)},
                problem, remedy);
  }

  /// Steps over blanks, separators and comments; false at the end.
  bool skip_blank() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '#') {
        const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
        read_comment(text_.substr(at_ + 1, end - at_ - 1));
        at_ = end;
      } else if (std::isspace(static_cast<unsigned char>(c)) != 0 || c == ';') {
        ++at_;
      } else {
        return true;
      }
    }
    return false;
  }

  /// "margin NUMBER" and nothing else is the robot's margin. What only begins as a number, as
  /// "1,5", is no remark: a robot must not lose its margin to it.
  void read_comment(std::string_view comment) {
    const auto words = words_of(comment, " \t\r");
    if (words.size() != 2 || words[0] != "margin") return;
    const std::string_view number = words[1];
    double margin = 0;
    const auto read = std::from_chars(number.data(), number.data() + number.size(), margin);
    if (read.ec == std::errc::invalid_argument) return;
    begin_ = at_;
    if (read.ptr != number.data() + number.size()) {
      fail("margin " + std::string(number) + " is no number", "write it as in \"margin 1.5\"");
    }
    maker_.set_margin(read.ec == std::errc() ? margin : HUGE_VAL, "");
  }

  /// The text of one geometry: a word and what is in its parentheses.
  std::string next_geometry() {
    int depth = 0;
    const std::size_t from = at_;
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '(' && ++depth > kMostDepth) fail("is nested too deep", "take parentheses away");
      if (c == ')' && --depth <= 0) {
        ++at_;
        break;
      }
      const bool ends_line = c == '\n' || c == '\r';
      if (depth == 0 && (c == ';' || (ends_line && !goes_on(at_)))) break;
    }
    return std::string(text_.substr(from, at_ - from));
  }

  /// White space may stand anywhere: before the parentheses of a geometry, or its EMPTY.
  bool goes_on(std::size_t at) const {
    const auto next = text_.find_first_not_of(" \t\r\n", at);
    return next != text_.npos && (text_[next] == '(' || text_.substr(next).starts_with("EMPTY"));
  }

  void add(const GEOSGeometry* g) {
    const Geos& geos = maker_.geos();
    const auto context = geos.context();
    const std::string place = "geometry " + std::to_string(number_ - 1);
    switch (GEOSGeomTypeId_r(context, g)) {
      case GEOS_POINT: {
        if (GEOSisEmpty_r(context, g) == 1) fail(place + " is empty", "give it coordinates");
        Point p;
        GEOSGeomGetX_r(context, g, &p.x);
        GEOSGeomGetY_r(context, g, &p.y);
        if (!maker_.so_far().start) return maker_.add_start(p, place);
        if (maker_.so_far().goal) fail(place + " is a third point", "give start and goal only");
        return maker_.add_goal(p, place);
      }
      case GEOS_POLYGON:
      case GEOS_MULTIPOLYGON:
        if (!maker_.has_boundary() && GEOSGetNumGeometries_r(context, g) > 1) {
          fail(place + " is in several parts", "give the boundary first, as one polygon");
        }
        for (Polygon& p : geos.polygons(g)) {
          maker_.has_boundary() ? maker_.add_obstacle(std::move(p), place)
                                : maker_.add_boundary(std::move(p), place);
        }
        return;
      case GEOS_GEOMETRYCOLLECTION:
        for (int i = 0; i < GEOSGetNumGeometries_r(context, g); ++i) {
          add(GEOSGetGeometryN_r(context, g, i));
        }
        return;
      default:
        fail(place + " is neither polygon nor point", "take it out");
    }
  }

  std::string_view text_;
  const std::string& name_;
  WorldMaker maker_;
  std::size_t at_ = 0;
  std::size_t begin_ = 0;
  int number_ = 0;
};

}  // namespace

World parse_wkt(std::string_view text, const std::string& name, const ReadOptions& options) {
  return WktReader(text, name, options).read();
}

std::string to_wkt(const World& world) {
  check(world);
  if (world.goal && !world.start) {
    throw invalid_parameter(
        "the world has a goal but no start",
        "give it a start, or write GeoJSON: WKT reads its first point as the start");
  }
  const Geos geos;
  std::string lines = "# margin " + number_text(world.margin) + "\n";
  const auto add = [&](const GEOSGeometry* g) { lines += geos.write_wkt(g) + "\n"; };
  add(geos.polygon(world.boundary).get());
  for (const Polygon& p : world.obstacles) add(geos.polygon(p).get());
  for (const auto& p : {world.start, world.goal}) {
    if (!p) continue;
    add(geos.own(GEOSGeom_createPointFromXY_r(geos.context(), p->x, p->y)).get());
  }
  return lines;
}

}  // namespace lasius::polygon
