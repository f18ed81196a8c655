#include "tools/vehicle/path_file.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "core/base/did_you_mean.h"
#include "core/base/text_lines.h"
#include "lasius/error.h"
#include "tools/console/exit_code.h"
#include "tools/console/values.h"
#include "tools/record/queries.h"
#include "tools/record/recorded.h"
#include "tools/record/saved.h"
#include "tools/vehicle/vehicle_json.h"

namespace lasius::tool {
namespace {

constexpr std::string_view kSeparators = " \t\r\v\f,";

/// A table of points.
class TableReader {
 public:
  TableReader(const std::string& file, Frame frame)
      : path_{.file = file, .metres = frame == Frame::world} {}

  PathFile read() {
    auto in = opened(path_.file, "name a .csv of a path, or a saved result, .json");
    std::string text(std::istreambuf_iterator<char>(in), {});
    if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
    end_lines_in_lf(text);
    for (const std::string_view row : split(text, '\n')) {
      ++line_;
      const auto fields = words_of(row, kSeparators);
      if (fields.empty() || fields.front().starts_with('#')) continue;
      if (columns_ == 0)
        read_header(fields);
      else
        read_row(fields);
    }
    // As a plan that found nothing leaves it.
    if (path_.points.empty() && columns_ > 0)
      fail("holds a header alone: there is no path", "give the path of a plan that found one");
    if (path_.points.empty()) fail("holds no point", "write a header x,y,yaw and a line a pose");
    return std::move(path_);
  }

 private:
  [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const {
    throw Error(ErrorCode::file_broken, {.file = path_.file, .line = std::max(line_, 1)}, problem,
                remedy);
  }
  using Fields = std::vector<std::string_view>;

  void read_header(const Fields& names) {
    columns_ = names.size();
    const auto column = [&](std::string_view name) {
      const auto found = std::ranges::find(names, name);
      return found == names.end() ? std::nullopt
                                  : std::optional<std::size_t>(found - names.begin());
    };
    x_ = column("x");
    y_ = column("y");
    if (!x_ && !y_) {
      x_ = column("x_m");
      y_ = column("y_m");
      path_.metres = path_.metres || x_ || y_;
    }
    if (!x_ || !y_)
      fail(std::string("the header has no column ") + (x_ ? "y" : "x"),
           "begin with a line x,y or x,y,yaw or x,y,yaw,kappa,v,t,gear");
    yaw_ = column("yaw");
    kappa_ = column("kappa");
  }

  void read_row(const Fields& fields) {
    if (fields.size() != columns_)
      fail(counted(static_cast<std::int64_t>(fields.size()), "field") + " instead of " +
               std::to_string(columns_),
           "give every line what the header names");
    path_.points.push_back({number("x", fields[*x_]), number("y", fields[*y_])});
    if (yaw_) path_.yaws.push_back(number("yaw", fields[*yaw_], kMostTurned));
    if (kappa_) path_.curvatures.push_back(number("kappa", fields[*kappa_]));
  }

  double number(std::string_view name, std::string_view field, double most = kNoLimit) const {
    const auto value = parse_real(field);
    if (!value || std::abs(*value) > most)
      fail(std::string(name) + " is '" + std::string(field) + "'",
           most < kNoLimit ? "give radians, at most " + to_text(most) : "give a finite number");
    return *value;
  }

  PathFile path_;
  int line_ = 0;
  std::size_t columns_ = 0;
  std::optional<std::size_t> x_, y_, yaw_, kappa_;
};

/// Points, and arcs between them, as `plan --radius` tells a curve. @throws UsageError
lasius::Curve recorded_curve(const Json& list) {
  lasius::Curve curve;
  const auto refuse = [] { throw UsageError("\"curve\" is no list of points and arcs"); };
  const auto point_at = [&](std::size_t i) {
    return recorded_point(Json{{"curve", list[i]}}, "curve");
  };
  if (!list.is_array() || list.empty() || !list[0].is_array()) refuse();
  Point from = point_at(0);
  for (std::size_t i = 1; i < list.size(); ++i) {
    CurvePiece piece{.from = from, .to = from};
    if (list[i].is_object()) {
      piece.centre = recorded_point(list[i], "centre");
      piece.radius = recorded_real(list[i], "radius", 0, kNoLimit);
      piece.turn = recorded<int>(list[i], "turn") < 0 ? -1 : 1;
      if (++i == list.size()) refuse();
    }
    from = piece.to = point_at(i);
    if (piece.turn != 0) {
      const Point c = piece.centre, a = piece.from, b = piece.to;
      const double turned = std::atan2(b.y - c.y, b.x - c.x) - std::atan2(a.y - c.y, a.x - c.x);
      piece.angle = std::fmod(piece.turn * turned + 2 * std::numbers::pi, 2 * std::numbers::pi);
      if (piece.angle > 2 * std::numbers::pi - 1e-6) piece.angle = 0;  // rounding, of a short one
    }
    curve.push_back(piece);
  }
  return curve;
}

/// @throws UsageError naming the key
PathFile path_of(const std::string& file, const Json& result) {
  PathFile path{.file = file};
  for (const Json& vertex : result["path"])
    path.points.push_back(recorded_point(Json{{"path", vertex}}, "path"));
  const auto told = [](const Json& in, const char* key) {
    return in.is_object() && in.contains(key) && !in[key].is_null();
  };
  if (told(result, "curve")) path.curve = recorded_curve(result["curve"]);
  if (result.contains("segments")) {
    path.segments = recorded_segments(result);
    if (path.segments.empty()) throw UsageError("\"segments\" are none");
  }
  const Json parameters = result.value("parameters", Json());
  if (told(parameters, "vehicle")) path.vehicle = recorded_vehicle(parameters);
  if (told(parameters, "radius")) path.radius = recorded_real(parameters, "radius", 0, kNoLimit);
  path.unknown_free = told(parameters, "unknown") && parameters["unknown"] == "free";
  path.squeezes = told(parameters, "corners") && parameters["corners"] == "allow";
  return path;
}

PathFile read_result(const std::string& file) {
  const auto results = read_results(file);
  if (results.size() != 1)
    throw UsageError(file + " holds " + std::to_string(results.size()) +
                     " results; give one with one result");
  const Json& result = results.front().json;
  const bool has_path = result.is_object() && result.contains("path");
  const bool none = has_path && (result["path"].is_null() || result["path"] == Json::array());
  if (none && result.contains("status"))
    throw UsageError(file + " has no path to judge: its status is " +
                     recorded<std::string>(result, "status"));
  try {
    if (!has_path || none || !result["path"].is_array()) throw UsageError("it has no \"path\"");
    return path_of(file, result);
  } catch (const UsageError& error) {
    throw Error(ErrorCode::file_broken, {.file = file, .offset = results.front().offset},
                std::string("is no result of `lasius plan`: ") + error.what(),
                "give one as it was saved");
  }
}

}  // namespace

PathFile read_path(const std::string& file, Frame frame) {
  return file.ends_with(".json") ? read_result(file) : TableReader(file, frame).read();
}

std::vector<Point> points_of(const PathFile& path, const LoadedMap& map) {
  std::vector<Point> points = path.points;
  if (path.metres)
    for (Point& p : points) p = map.frame->to_cells(p, map.height);
  return points;
}

std::vector<vehicle::Pose> poses_of(const PathFile& path, const LoadedMap& map) {
  std::vector<vehicle::Pose> poses;
  const auto points = points_of(path, map);
  for (std::size_t i = 0; i < path.yaws.size(); ++i)
    poses.push_back(
        {points[i].x, points[i].y, path.metres ? yaw_across(map, path.yaws[i]) : path.yaws[i]});
  return poses;
}

std::optional<vehicle::Segment> motion_between(const vehicle::Pose& from, const vehicle::Pose& to) {
  constexpr double kStill = 1e-9;  // cells
  constexpr double kNear = 1e-3;   // cells
  vehicle::Segment motion{.begin = from};
  const double x = to.x - from.x, y = to.y - from.y;
  const double turned = std::remainder(to.yaw - from.yaw, 2 * std::numbers::pi);
  if (std::hypot(x, y) <= kStill) {
    motion.gear = turned == 0 ? 1 : 0;
    motion.angle = turned;
    return motion;
  }
  // An arc's chord looks half way between its ends.
  const double middle = from.yaw + turned / 2;
  const double along = x * std::cos(middle) + y * std::sin(middle);
  const double across = y * std::cos(middle) - x * std::sin(middle);
  if (std::abs(across) > kNear) return std::nullopt;
  const double half = turned / 2;
  const double stretch = std::abs(half) < 1e-6 ? 1 + half * half / 6 : half / std::sin(half);
  motion.gear = along < 0 ? -1 : 1;
  motion.length = std::abs(along) * stretch;
  if (motion.length <= kStill) return std::nullopt;
  motion.curvature = motion.gear * turned / motion.length;
  return motion;
}

}  // namespace lasius::tool
