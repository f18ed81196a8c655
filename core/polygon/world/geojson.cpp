#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "core/base/did_you_mean.h"
#include "core/base/json_text.h"
#include "core/polygon/world/world_maker.h"

namespace lasius::polygon {
namespace {

using Json = nlohmann::json;

constexpr const char* kShape =
    "give a FeatureCollection whose features have a \"role\": boundary, obstacle, start or goal";
constexpr std::array<std::string_view, 4> kRoles{"boundary", "obstacle", "start", "goal"};

class GeoJsonReader {
 public:
  GeoJsonReader(std::string_view text, const std::string& name, const ReadOptions& options)
      : text_(text),
        name_(name),
        maker_(options, [this](const auto& place, const auto& problem, const auto& remedy) {
          fail(place, problem, remedy);
        }) {}

  World read() {
    const Json json = read_json(text_, name_);
    if (!json.is_object() || text_of(json, "type") != "FeatureCollection")
      fail("", "is no FeatureCollection", kShape);
    const auto features = json.find("features");
    if (features == json.end() || !features->is_array())
      fail("", "has no list of features", kShape);
    read_crs(json);
    read_margin(json);
    if (const auto more = json.find("properties"); more != json.end()) read_margin(*more);
    for (std::size_t i = 0; i < features->size(); ++i) {
      path_ = "features[" + std::to_string(i) + "]";
      read_feature((*features)[i], i);
    }
    path_.clear();
    return maker_.finish();
  }

 private:
  [[noreturn]] void fail(const std::string& place, const std::string& problem,
                         const std::string& remedy) const {
    throw Error(ErrorCode::file_broken, {.file = name_, .line = json_line(text_, path_)},
                place.empty() ? problem : place + ": " + problem, remedy);
  }

  static std::string text_of(const Json& json, const char* key) {
    if (!json.is_object()) return {};
    const auto found = json.find(key);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
  }

  /// GeoJSON's older member, "crs": {"type": "name", "properties": {"name": "EPSG:4326"}}.
  void read_crs(const Json& json) {
    const auto crs = json.find("crs");
    if (crs == json.end() || !crs->is_object()) return;
    const auto properties = crs->find("properties");
    if (properties != crs->end()) maker_.set_crs(text_of(*properties, "name"));
  }

  void read_margin(const Json& json) {
    if (!json.is_object()) return;
    const auto margin = json.find("margin");
    if (margin == json.end() || margin->is_null()) return;
    if (!margin->is_number()) fail("", "margin is no number", "it must be a number from 0 to 1e12");
    maker_.set_margin(margin->get<double>(), "");
  }

  void read_feature(const Json& feature, std::size_t number) {
    std::string place = "feature " + std::to_string(number);
    if (!feature.is_object()) fail(place, "is no object", kShape);
    const auto properties = feature.find("properties");
    const std::string role =
        properties != feature.end() ? text_of(*properties, "role") : std::string();
    if (role.empty()) fail(place, "has no role", kShape);
    if (std::ranges::find(kRoles, role) == kRoles.end())
      fail(place, "has the role \"" + role + "\"", did_you_mean(role, kRoles));
    place += " (" + role + ")";
    const auto geometry = feature.find("geometry");
    if (geometry == feature.end() || !geometry->is_object())
      fail(place, "has no geometry", "give it one, or take the feature out");
    if (role == "obstacle") return add_obstacle(*geometry, place);
    const std::string type = type_of(*geometry);
    const char* wanted = role == "boundary" ? "Polygon" : "Point";
    if (type != wanted) fail(place, "is a " + type, std::string("give a ") + wanted);
    const Json& coordinates = list_of(*geometry, "coordinates", place);
    if (role == "boundary") {
      if (coordinates.empty()) fail(place, "is empty", "give it a list of rings");
      maker_.add_boundary(polygon(coordinates, place), place);
    } else {
      const Point p = position(coordinates, place);
      role == "start" ? maker_.add_start(p, place) : maker_.add_goal(p, place);
    }
  }

  static std::string type_of(const Json& geometry) {
    const std::string type = text_of(geometry, "type");
    return type.empty() ? "geometry without type" : type;
  }

  const Json& list_of(const Json& geometry, const char* member, const std::string& place) const {
    const auto found = geometry.find(member);
    if (found == geometry.end() || !found->is_array())
      fail(place, std::string("has no ") + member, "give it some, or take the feature out");
    return *found;
  }

  /// What is empty stands for no obstacle.
  void add_obstacle(const Json& geometry, const std::string& place) {
    if (!geometry.is_object()) fail(place, "is no geometry", "give polygons or lines");
    const std::string type = type_of(geometry);
    if (type == "GeometryCollection") {
      each(list_of(geometry, "geometries", place), place, ", geometry ",
           [&](const Json& part, const std::string& at) { add_obstacle(part, at); });
      return;
    }
    const bool multiple = type.starts_with("Multi");
    const std::string one = multiple ? type.substr(5) : type;
    const bool area = one == "Polygon";
    if (!area && one != "LineString" && type != "LinearRing")
      fail(place, "is a " + type, "give polygons, lines, or Multi- or GeometryCollections of them");
    const Json& coordinates = list_of(geometry, "coordinates", place);
    const auto add = [&](const Json& part, const std::string& at) {
      if (part.is_array() && part.empty()) return;
      area ? maker_.add_obstacle(polygon(part, at), at) : maker_.add_wall(positions(part, at), at);
    };
    multiple ? each(coordinates, place, area ? ", polygon " : ", line ", add)
             : add(coordinates, place);
  }

  static void each(const Json& list, const std::string& place, const char* kind, const auto& take) {
    for (std::size_t i = 0; i < list.size(); ++i)
      take(list[i], std::string(place).append(kind).append(std::to_string(i)));
  }

  Point position(const Json& json, const std::string& place) const {
    const auto is_number = [](const Json& value) { return value.is_number(); };
    if (!json.is_array() || json.size() < 2 || !std::ranges::all_of(json, is_number))
      fail(place, "has a position that is no list of two numbers", "write it as [x, y]");
    return {json[0].get<double>(), json[1].get<double>()};
  }

  Polygon polygon(const Json& json, const std::string& place) const {
    if (!json.is_array() || json.empty())
      fail(place, "has no rings", "give a list of rings, the outer one first");
    Polygon result;
    for (std::size_t r = 0; r < json.size(); ++r) {
      const std::string at = place + ", ring " + std::to_string(r);
      Ring points = maker_.closed(positions(json[r], at), at);
      if (r == 0)
        result.outer = std::move(points);
      else
        result.holes.push_back(std::move(points));
    }
    return result;
  }

  Ring positions(const Json& json, const std::string& place) const {
    if (!json.is_array()) fail(place, "is no list of positions", "write it as [[x, y], ...]");
    Ring points;
    each(json, place, ", point ",
         [&](const Json& point, const std::string& at) { points.push_back(position(point, at)); });
    return points;
  }

  std::string_view text_;
  const std::string& name_;
  std::string path_;  // of the feature that is read
  WorldMaker maker_;
};

std::string position(Point p) {
  return std::string("[").append(json_text(p.x)).append(",").append(json_text(p.y)).append("]");
}

/// `closed` by its first point, as the format has rings.
std::string positions(const Ring& points, bool closed) {
  std::string text = "[";
  for (const Point p : points) text.append(text.size() > 1 ? "," : "").append(position(p));
  if (closed && !points.empty()) text.append(",").append(position(points[0]));
  return text + "]";
}

std::string rings(const Polygon& polygon) {
  std::string text = "[";
  text += positions(polygon.outer, true);
  for (const Ring& hole : polygon.holes) text.append(",").append(positions(hole, true));
  return text + "]";
}

std::string feature(const char* role, const char* type, const std::string& coordinates) {
  return std::string(R"({"type":"Feature","properties":{"role":")") + role +
         R"("},"geometry":{"type":")" + type + R"(","coordinates":)" + coordinates + "}}";
}

}  // namespace

World parse_geojson(std::string_view text, const std::string& name, const ReadOptions& options) {
  return GeoJsonReader(text, name, options).read();
}

std::string to_geojson(const World& world) {
  std::vector<std::string> features{feature("boundary", "Polygon", rings(world.boundary))};
  for (const Polygon& p : world.obstacles)
    features.push_back(feature("obstacle", "Polygon", rings(p)));
  for (const Ring& wall : world.walls)
    features.push_back(feature("obstacle", "LineString", positions(wall, false)));
  if (world.start) features.push_back(feature("start", "Point", position(*world.start)));
  if (world.goal) features.push_back(feature("goal", "Point", position(*world.goal)));
  // A line a feature, for people and for diffs.
  std::string text = R"({"type": "FeatureCollection", "margin": )" + json_text(world.margin) +
                     ", \"features\": [\n";
  for (std::size_t i = 0; i < features.size(); ++i)
    text += features[i] + (i + 1 < features.size() ? ",\n" : "\n");
  return text + "]}\n";
}

}  // namespace lasius::polygon
