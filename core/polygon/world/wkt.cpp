#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <system_error>
#include <utility>

#include "core/base/invalid_parameter.h"
#include "core/base/number_text.h"
#include "core/base/text_lines.h"
#include "core/polygon/world/world_maker.h"

namespace lasius::polygon {
namespace {

constexpr int kMostDepth = 16;
constexpr std::string_view kMarks = "(),;=", kBlanks = " \t\r\n\v\f";
constexpr std::array<std::string_view, 8> kKinds{
    "POINT",      "LINESTRING",      "LINEARRING",   "POLYGON",
    "MULTIPOINT", "MULTILINESTRING", "MULTIPOLYGON", "GEOMETRYCOLLECTION"};

std::string upper(std::string_view word) {
  std::string text(word);
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

/// By recursive descent: each token is looked at where it is taken, so none is passed over. (GEOS'
/// own reader ignores what follows EMPTY, tells no line, and reads numbers by the locale.)
class WktReader {
 public:
  WktReader(std::string_view text, const std::string& name, const ReadOptions& options)
      : text_(text),
        name_(name),
        maker_(options, [this](const auto& place, const auto& problem, const auto& remedy) {
          fail(begin_, place.empty() ? problem : place + ": " + problem, remedy);
        }) {}

  World read() {
    for (step(); !token_.empty();) {
      begin_ = at_;
      if (took(";")) continue;
      place_ = "geometry " + std::to_string(number_++);
      if (took("SRID")) read_srid();
      read_geometry(1);
    }
    begin_ = at_;
    return maker_.finish();
  }

 private:
  [[noreturn]] void fail(std::size_t at, const std::string& problem,
                         const std::string& remedy) const {
    throw Error(
        ErrorCode::file_broken,
        {.file = name_, .line = line_at(text_, at), .offset = static_cast<std::int64_t>(at)},
        problem, remedy);
  }
  /// A fault of the geometry that is read.
  [[noreturn]] void refuse(const std::string& problem, const std::string& remedy) const {
    fail(begin_, place_ + " " + problem, remedy);
  }
  /// A token in the place of another; where the file ends, its place is that of the geometry.
  [[noreturn]] void miss(const std::string& wanted) const {
    constexpr std::size_t kMostShown = 40;
    std::string here = token_.empty() ? "the file ends" : "\"";
    if (!token_.empty()) here.append(token_.substr(0, kMostShown)).append("\" stands");
    fail(token_.empty() ? begin_ : at_, place_ + ": " + here + " where " + wanted + " must stand",
         "write it as POLYGON ((0 0, 1 0, 1 1, 0 0)), LINESTRING (0 0, 1 1) or POINT (0 0)");
  }

  /// On to the next token: a mark, or what stands between marks and blanks; nothing at the end.
  void step() {
    const auto find = [&](std::string_view any) {
      return std::min(text_.find_first_of(any, at_), text_.size());
    };
    for (at_ += token_.size();; at_ = find("\r\n")) {
      at_ = std::min(text_.find_first_not_of(kBlanks, at_), text_.size());
      if (!text_.substr(at_).starts_with('#')) break;
      read_comment(text_.substr(at_ + 1, find("\r\n") - at_ - 1));
    }
    token_ = text_.substr(at_, std::max<std::size_t>(find(" \t\r\n\v\f(),;=#") - at_, 1));
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
    if (read.ptr != number.data() + number.size())
      fail(at_, "margin " + std::string(number) + " is no number", "write it as in \"margin 1.5\"");
    maker_.set_margin(read.ec == std::errc() ? margin : HUGE_VAL, "");
  }

  /// Takes the token if it is that mark or word, in letters of either size.
  bool took(std::string_view word) {
    if (token_.size() != word.size() || upper(token_) != word) return false;
    step();
    return true;
  }
  void need(std::string_view mark) {
    if (!took(mark)) miss("\"" + std::string(mark) + "\"");
  }

  /// "=4326;" of EWKT's "SRID=4326;".
  void read_srid() {
    need("=");
    if (!number_of<int>(token_)) miss("the number of a coordinate system");
    maker_.set_crs("SRID:" + std::string(token_));
    step();
    need(";");
  }

  /// One of kKinds, with what says how many numbers make a point: Z, M or ZM, joined on or apart.
  std::string_view read_kind() {
    constexpr std::array<std::pair<std::string_view, std::size_t>, 4> kFlags{
        {{"", 0}, {"Z", 3}, {"M", 3}, {"ZM", 4}}};
    for (const std::string_view kind : kKinds) {
      for (const auto& [joined, count] : kFlags) {
        if (!took(std::string(kind).append(joined))) continue;
        numbers_ = count;
        for (const auto& [apart, count_apart] : kFlags)
          if (numbers_ == 0 && count_apart > 0 && took(apart)) numbers_ = count_apart;
        return kind;
      }
    }
    miss("the name of a geometry");
  }

  void read_geometry(int depth) {
    if (depth > kMostDepth) refuse("is nested too deep", "take parentheses away");
    const std::string_view kind = read_kind();
    const bool multiple = kind.starts_with("MULTI"), area = kind.ends_with("POLYGON");
    const bool opens_world = area && !maker_.has_boundary();
    const auto pass_over = [&] {
      if (kind == "POINT") refuse("is empty", "give it coordinates");
      if (opens_world) refuse("is empty", "give the boundary first, as one polygon");
    };
    const auto part = [&] {
      if (took("EMPTY")) return pass_over();
      need("(");
      if (kind == "POINT") return add_point();
      if (kind == "GEOMETRYCOLLECTION") {
        list([&] { read_geometry(depth + 1); });
        return need(")");
      }
      if (!area) return add_wall(kind == "LINEARRING");
      if (opens_world && maker_.has_boundary())
        refuse("is in several parts", "give the boundary first, as one polygon");
      add_polygon();
    };
    if (kind == "MULTIPOINT") refuse("is a MULTIPOINT", "give the start and the goal as POINTs");
    if (!multiple) return part();
    if (took("EMPTY")) return pass_over();
    need("(");
    list(part);
    need(")");
  }

  void list(const auto& read_item) {
    do read_item();
    while (took(","));
  }

  void add_point() {
    const Point p = read_position();
    need(")");
    if (!maker_.so_far().start) return maker_.add_start(p, place_);
    if (maker_.so_far().goal) refuse("is a third point", "give start and goal only");
    maker_.add_goal(p, place_);
  }

  void add_polygon() {
    Polygon polygon;
    int rings = 0;
    list([&] {
      const std::string place = place_ + ", ring " + std::to_string(rings);
      if (rings > 0 && took("EMPTY")) return;  // an empty hole
      need("(");
      Ring ring = maker_.closed(read_positions(), place);
      if (rings++ == 0)
        polygon.outer = std::move(ring);
      else
        polygon.holes.push_back(std::move(ring));
    });
    need(")");
    maker_.has_boundary() ? maker_.add_obstacle(std::move(polygon), place_)
                          : maker_.add_boundary(std::move(polygon), place_);
  }

  void add_wall(bool loop) {
    Ring line = read_positions();
    if (loop) {
      line = maker_.closed(std::move(line), place_);
      line.push_back(line.front());
    }
    maker_.add_wall(std::move(line), place_);
  }

  /// To the ")" after them.
  Ring read_positions() {
    Ring points;
    list([&] { points.push_back(read_position()); });
    need(")");
    return points;
  }

  /// 2 to 4 numbers, as many as the points before; x and y of them.
  Point read_position() {
    std::array<double, 4> read{};
    std::size_t count = 0;
    for (; !token_.empty() && kMarks.find(token_[0]) == kMarks.npos; ++count, step()) {
      if (count == (numbers_ > 0 ? numbers_ : read.size())) miss("\",\" or \")\"");
      const bool plus = token_.starts_with('+') && !token_.starts_with("+-");
      const auto number = number_of<double>(token_.substr(plus ? 1 : 0));
      if (!number) miss("a number");
      read[count] = *number;
    }
    if (count < std::max<std::size_t>(numbers_, 2)) miss("a number");
    numbers_ = count;
    return {read[0], read[1]};
  }

  std::string_view text_;
  const std::string& name_;
  WorldMaker maker_;
  std::string_view token_;
  std::size_t at_ = 0;     // of the token
  std::size_t begin_ = 0;  // of the geometry that is read
  std::string place_;      // its name
  std::size_t numbers_ = 0;
  int number_ = 0;
};

}  // namespace

World parse_wkt(std::string_view text, const std::string& name, const ReadOptions& options) {
  return WktReader(text, name, options).read();
}

std::string to_wkt(const World& world) {
  check(world);
  if (world.goal && !world.start)
    refuse("the world has a goal but no start",
           "give it a start, or write GeoJSON: WKT reads its first point as the start");
  const Geos geos;
  std::string lines = "# margin " + number_text(world.margin) + "\n";
  const auto add = [&](const GEOSGeometry* g) { lines += geos.write_wkt(g) + "\n"; };
  add(geos.polygon(world.boundary).get());
  for (const Polygon& p : world.obstacles) add(geos.polygon(p).get());
  for (const Ring& wall : world.walls) add(geos.line(wall).get());
  for (const auto& p : {world.start, world.goal}) {
    if (!p) continue;
    add(geos.own(GEOSGeom_createPointFromXY_r(geos.context(), p->x, p->y)).get());
  }
  return lines;
}

}  // namespace lasius::polygon
