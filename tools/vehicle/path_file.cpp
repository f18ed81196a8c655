#include "tools/vehicle/path_file.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "core/base/did_you_mean.h"
#include "core/base/text_lines.h"
#include "lasius/base/error.h"
#include "tools/console/exit_code.h"
#include "tools/console/values.h"
#include "tools/record/outputs.h"
#include "tools/record/queries.h"
#include "tools/record/recorded.h"
#include "tools/record/saved.h"
#include "tools/vehicle/vehicle_json.h"
#include "tools/yaml/document.h"

namespace lasius::tool {
namespace {

constexpr const char* kRemedyMissing =
    "name a .csv of a path, a path.yaml or a saved result, .json";

/// Of coordinates and curvatures: of greater ones lengths do not add up.
constexpr double kMostRead = 1e15;

/// A table of points.
class TableReader {
 public:
  TableReader(const std::string& file, Frame frame)
      : path_{.file = file, .metres = frame == Frame::world} {}

  PathFile read() {
    const std::string text = table_text(path_.file, kRemedyMissing);
    for (const std::string_view row : split(text, '\n')) {
      ++line_;
      const auto first = words_of(row, kBlanksAndCommas);
      if (first.empty() || first.front().starts_with('#')) continue;
      if (columns_ == 0) separator_ = separator_of(row);
      Fields fields = fields_of(row, separator_, kBlanksAndCommas);
      if (columns_ == 0) {
        read_header(fields);
      } else {
        leave_out_empty(fields, columns_);
        read_row(fields);
      }
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
  using Fields = std::vector<std::string>;

  void read_header(const Fields& names) {
    columns_ = names.size();
    const auto column = [&](std::string_view name) {
      if (std::ranges::count(names, name) > 1)
        fail("the header names " + std::string(name) + " twice", "name each column once");
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
    robot_ = column("robot");
  }

  void read_row(const Fields& fields) {
    if (fields.size() != columns_)
      fail(counted(static_cast<std::int64_t>(fields.size()), "field") + " instead of " +
               std::to_string(columns_),
           "give every line what the header names");
    if (path_.points.empty() && robot_) robot_of_path_ = fields[*robot_];
    if (robot_ && fields[*robot_] != robot_of_path_)
      fail("is of robot " + fields[*robot_] + ", the path of robot " + robot_of_path_,
           "give the rows of one");
    path_.points.push_back({number("x", fields[*x_]), number("y", fields[*y_])});
    if (yaw_) path_.yaws.push_back(number("yaw", fields[*yaw_], kMostTurned, "radians"));
    if (kappa_) path_.curvatures.push_back(number("kappa", fields[*kappa_]));
  }

  double number(std::string_view name, std::string_view field, double most = kMostRead,
                const std::string& wanted = "a number") const {
    const auto value = parse_real(field);
    if (!value || std::abs(*value) > most)
      fail(std::string(name) + " is '" + std::string(field) + "'",
           "give " + wanted + ", at most " + to_text(most));
    return *value;
  }

  PathFile path_;
  int line_ = 0;
  std::size_t columns_ = 0;
  char separator_ = ' ';
  std::optional<std::size_t> x_, y_, yaw_, kappa_, robot_;
  std::string robot_of_path_;
};

/// @throws UsageError naming the key
Point recorded_place(const Json& result, const std::string& key) {
  const Point at = recorded_point(result, key);
  if (!(std::abs(at.x) <= kMostRead && std::abs(at.y) <= kMostRead))
    throw UsageError("\"" + key + "\" holds " + dumped(result[key]) + "; coordinates are at most " +
                     to_text(kMostRead));
  return at;
}

/// Points, and arcs between them, as `plan --radius` tells a curve. @throws UsageError
lasius::Curve recorded_curve(const Json& list) {
  lasius::Curve curve;
  const auto refuse = [] { throw UsageError("\"curve\" is no list of points and arcs"); };
  const auto point_at = [&](std::size_t i) {
    return recorded_place(Json{{"curve", list[i]}}, "curve");
  };
  if (!list.is_array() || list.empty() || !list[0].is_array()) refuse();
  Point from = point_at(0);
  if (list.size() == 1) curve.push_back({.from = from, .to = from});
  for (std::size_t i = 1; i < list.size(); ++i) {
    CurvePiece piece{.from = from, .to = from};
    if (list[i].is_object()) {
      piece.centre = recorded_place(list[i], "centre");
      piece.radius = recorded_real(list[i], "radius", 0, kNoLimit);
      piece.turn = static_cast<int>(recorded_integer(list[i], "turn", -1, 1));
      if (piece.turn == 0) refuse();
      if (++i == list.size()) refuse();
    }
    from = piece.to = point_at(i);
    if (piece.turn != 0) {
      const Point c = piece.centre, a = piece.from, b = piece.to;
      for (const Point end : {a, b})
        if (!(std::abs(std::hypot(end.x - c.x, end.y - c.y) - piece.radius) <= kOnePlace))
          throw UsageError("an arc of \"curve\" does not join its points");
      const double turned = std::atan2(b.y - c.y, b.x - c.x) - std::atan2(a.y - c.y, a.x - c.x);
      piece.angle = std::fmod(piece.turn * turned + 2 * std::numbers::pi, 2 * std::numbers::pi);
      if (piece.angle > 2 * std::numbers::pi - 1e-6) piece.angle = 0;  // rounding, of a short one
    }
    curve.push_back(piece);
  }
  return curve;
}

bool told(const Json& in, const std::string& key) {
  return in.is_object() && in.contains(key) && !in[key].is_null();
}

/// Where its path is: "path" of a plan, "track" of a drive, "legs" of a tour.
std::string path_key(const Json& result) {
  for (const char* key : {"path", "track", "legs"})
    if (result.is_object() && result.contains(key)) return key;
  throw UsageError("it has no \"path\"");
}

/// @throws UsageError naming the key
const Json& list_at(const Json& result, const std::string& key, const std::string& of = "points") {
  const Json& list = value_at(result, key);
  if (!list.is_array()) throw UsageError("\"" + key + "\" is no list of " + of);
  return list;
}

bool apart(Point a, Point b) { return !(std::hypot(a.x - b.x, a.y - b.y) <= kOnePlace); }

/// Appends its points and segments. @throws UsageError naming the key
void take_path(PathFile& path, const Json& part, const std::string& key) {
  const std::size_t from = path.points.size();
  for (const Json& vertex : list_at(part, key)) {
    if (!vertex.is_array() || vertex.size() < 2)
      throw UsageError("\"" + key + "\" is no list of points");
    const Point at = recorded_place(Json{{key, {vertex[0], vertex[1]}}}, key);
    const bool cell = key == "track" && vertex.size() == 2;
    path.points.push_back(cell ? Point{at.x + 0.5, at.y + 0.5} : at);
  }
  if (!part.contains("segments")) return;
  const auto segments = recorded_segments(part);
  if (!segments.empty() && from < path.points.size()) {
    const vehicle::Pose begin = segments.front().begin, end = segments.back().end();
    if (apart({begin.x, begin.y}, path.points[from]) || apart({end.x, end.y}, path.points.back()))
      throw UsageError("\"segments\" begin or end elsewhere than \"" + key + "\"");
  }
  path.segments.insert(path.segments.end(), segments.begin(), segments.end());
}

/// Of a tour without legs: its only stop. @throws UsageError naming the key
void take_stop(PathFile& path, const Json& result) {
  path.metres = told(result, "stops_world");
  const std::string key = path.metres ? "stops_world" : "stops";
  const Json &stops = list_at(result, key), &order = list_at(result, "order", "stops");
  if (order.empty()) return;
  const Json first = {{"order", order.front()}};
  const auto last = static_cast<std::int64_t>(stops.size()) - 1;
  const Json& stop = stops[static_cast<std::size_t>(recorded_integer(first, "order", 0, last))];
  const Point at = recorded_place(Json{{key, stop}}, key);
  const bool cell = stop.front().is_number_integer() && stop.back().is_number_integer();
  path.points.push_back(cell && !path.metres ? Point{at.x + 0.5, at.y + 0.5} : at);
}

/// Of a tour all legs, which lead from stop to stop of its order; without any its only stop.
/// @throws UsageError naming the key, or a leg that is missing
void take_legs(PathFile& path, const Json& result) {
  const Json &legs = list_at(result, "legs", "legs"), &order = list_at(result, "order", "stops");
  const auto end = [&](const std::string& key) {
    return result.value(key + "_world", result.value(key, Json()));
  };
  const Json goal = end("goal"), parameters = result.value("parameters", Json());
  const bool closed = goal.is_null() ? told(parameters, "open") && parameters["open"] == false
                                     : goal == end("start");
  const std::size_t stops = order.size(), least = stops < 2 ? 0 : stops - (closed ? 0 : 1);
  for (std::size_t i = 0; i < std::max(least, legs.size()); ++i) {
    const std::string name = "leg " + std::to_string(i);
    if (i >= legs.size()) throw UsageError(name + " of " + std::to_string(least) + " is missing");
    if (i >= least || value_at(legs[i], "from") != order[i] ||
        value_at(legs[i], "to") != order[(i + 1) % stops])
      throw UsageError(name + " joins other stops than \"order\"");
    const std::size_t points = path.points.size(), segments = path.segments.size();
    take_path(path, legs[i], "path");
    if (path.points.size() == points || (of_vehicle(result) && path.segments.size() == segments))
      throw UsageError(name + " has no path");
  }
  if (legs.empty() && !of_vehicle(result)) take_stop(path, result);
}

/// @throws UsageError naming the key
PathFile path_of(const std::string& file, const Json& result, const std::string& key) {
  PathFile path{.file = file};
  if (key == "legs")
    take_legs(path, result);
  else
    take_path(path, result, key);
  if (told(result, "curve")) {
    path.curve = recorded_curve(result["curve"]);
    if (path.points.empty() || apart(path.curve.front().from, path.points.front()) ||
        apart(path.curve.back().to, path.points.back()))
      throw UsageError("\"curve\" begins or ends elsewhere than \"path\"");
  }
  if (of_vehicle(result) && path.segments.empty()) {  // a drive or tour that only stands
    if (key == "path" || (told(result, "length") && result["length"] != 0))
      throw UsageError("\"segments\" are none");
    const Json& poses = value_at(result, key == "legs" ? "poses" : key);
    if (!poses.is_array() || poses.empty()) throw UsageError("it has no pose");
    const PoseEnd at = recorded_pose(Json{{"pose", poses.front()}}, "pose");
    path.points = {{at.x, at.y}};
    path.segments = {{.begin = {at.x, at.y, at.yaw}}};
  }
  if (path.points.empty()) throw UsageError("its path has no point");
  const Json parameters = result.value("parameters", Json::object());
  if (!parameters.is_object()) throw UsageError("\"parameters\" is " + dumped(parameters));
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
  if (told(result, "tours"))
    throw UsageError(file +
                     " has tours of several robots; save them as .csv and give the rows of one");
  std::string status;
  try {
    if (told(result, "format") &&
        !(result["format"].is_string() && result["format"].get<std::string>().ends_with("/1")))
      throw UsageError("\"format\" is " + dumped(result["format"]));
    const std::string key = path_key(result);
    const bool none = !told(result, key) || (result[key].empty() && key != "legs");
    if (!none || !result.contains("status")) return path_of(file, result, key);
    status = recorded<std::string>(result, "status");
  } catch (const UsageError& error) {
    throw Error(ErrorCode::file_broken, {.file = file, .offset = results.front().offset},
                std::string("is no result of `lasius plan`, `drive` or `tour`: ") + error.what(),
                "give one as it was saved");
  }
  throw UsageError(file + " has no path to judge: its status is " + status);
}

/// A nav_msgs/Path.
PathFile read_ros_path(const std::string& file) {
  auto in = opened(file, kRemedyMissing);
  std::string text(std::istreambuf_iterator<char>(in), {});
  text.resize(text.find_last_not_of(" \t\r\n") + 1);
  if (text.ends_with("\n---")) text.resize(text.size() - 3);  // as `ros2 topic echo` ends
  const Node document = parse_document(text, file);
  PathFile path{.file = file, .metres_of_map = true};
  for (const Node& stamped : document.at("poses").items()) {
    const Node& pose = stamped.at("pose");
    const auto real = [&pose](const char* of, const char* key) {
      return pose.at(of).at(key).number(-kMostRead, kMostRead);
    };
    const auto turned = [&real](const char* axis) { return real("orientation", axis); };
    const double x = turned("x"), y = turned("y"), z = turned("z"), w = turned("w");
    if (x == 0 && y == 0 && z == 0 && w == 0)
      pose.at("orientation").fail("is all zero", "give the quaternion of its yaw");
    path.points.push_back({real("position", "x"), real("position", "y")});
    path.yaws.push_back(std::atan2(2 * (w * z + x * y), w * w + x * x - y * y - z * z));
  }
  if (path.points.empty())
    document.at("poses").fail("are none: there is no path",
                              "give the path of a plan that found one");
  return path;
}

}  // namespace

PathFile read_path(const std::string& file, Frame frame) {
  if (is_yaml(file)) return read_ros_path(file);
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

std::vector<double> curvatures_of(const PathFile& path, const LoadedMap& map) {
  std::vector<double> curvatures = path.curvatures;
  if (path.metres)
    for (double& curvature : curvatures) curvature *= -map.metres(1);  // y up: the other sense
  return curvatures;
}

}  // namespace lasius::tool
