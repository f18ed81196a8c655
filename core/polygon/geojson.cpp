#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "core/base/did_you_mean.h"
#include "core/base/json_text.h"
#include "core/polygon/world_maker.h"

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
        maker_(options, [this](const auto& place, const auto& problem,
                               const auto& remedy) { fail(place, problem, remedy); }),
        repair_(options.repair) {}

  World read() {
    const Json json = read_json(text_, name_);
    if (!json.is_object() || text_of(json, "type") != "FeatureCollection") {
      fail("", "is no FeatureCollection", kShape);
    }
    const auto features = json.find("features");
    if (features == json.end() || !features->is_array()) {
      fail("", "has no list of features", kShape);
    }
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
    if (std::ranges::find(kRoles, role) == kRoles.end()) {
      fail(place, "has the role \"" + role + "\"", did_you_mean(role, kRoles));
    }
    place += " (" + role + ")";
    const auto geometry = feature.find("geometry");
    if (geometry == feature.end() || !geometry->is_object()) {
      fail(place, "has no geometry", "give it one, or take the feature out");
    }
    const std::string type = text_of(*geometry, "type");
    const auto found = geometry->find("coordinates");
    if (found == geometry->end() || !found->is_array()) {
      fail(place, "has no coordinates", "give it some, or take the feature out");
    }
    if (role == "start" || role == "goal") {
      if (type != "Point") fail(place, "is a " + type, "give a Point");
      const Point p = position(*found, place);
      role == "start" ? maker_.add_start(p, place) : maker_.add_goal(p, place);
    } else if (type == "Polygon") {
      Polygon p = polygon(*found, place);
      role == "boundary" ? maker_.add_boundary(std::move(p), place)
                         : maker_.add_obstacle(std::move(p), place);
    } else if (type == "MultiPolygon" && role == "obstacle") {
      for (std::size_t i = 0; i < found->size(); ++i) {
        const std::string part = std::string(place) + ", polygon " + std::to_string(i);
        maker_.add_obstacle(polygon((*found)[i], part), part);
      }
    } else {
      fail(place, "is a " + (type.empty() ? "geometry without type" : type),
           role == "boundary" ? "give a Polygon" : "give a Polygon or a MultiPolygon");
    }
  }

  Point position(const Json& json, const std::string& place) const {
    if (!json.is_array() || json.size() < 2 || !json[0].is_number() || !json[1].is_number()) {
      fail(place, "has a position that is no list of two numbers", "write it as [x, y]");
    }
    return {json[0].get<double>(), json[1].get<double>()};
  }

  Polygon polygon(const Json& json, const std::string& place) const {
    if (!json.is_array() || json.empty()) {
      fail(place, "has no rings", "give a list of rings, the outer one first");
    }
    Polygon result;
    for (std::size_t r = 0; r < json.size(); ++r) {
      Ring points = ring(json[r], place + ", ring " + std::to_string(r));
      if (r == 0) {
        result.outer = std::move(points);
      } else {
        result.holes.push_back(std::move(points));
      }
    }
    return result;
  }

  Ring ring(const Json& json, const std::string& place) const {
    if (!json.is_array()) fail(place, "is no list of positions", "write it as [[x, y], ...]");
    Ring points;
    for (std::size_t i = 0; i < json.size(); ++i) {
      points.push_back(position(json[i], std::string(place) + ", point " + std::to_string(i)));
    }
    if (points.size() > 1 && points.front() == points.back()) {
      points.pop_back();
    } else if (!repair_) {
      fail(place, "is not closed", "end it with its first point, or read the world with --repair");
    }
    return points;
  }

  std::string_view text_;
  const std::string& name_;
  std::string path_;  // of the feature that is read
  WorldMaker maker_;
  bool repair_;
};

std::string position(Point p) {
  return std::string("[").append(json_text(p.x)).append(",").append(json_text(p.y)).append("]");
}

/// Closed, as the format has it.
std::string positions(const Ring& ring) {
  std::string text = "[";
  for (const Point p : ring) text += position(p) + ",";
  return text + (ring.empty() ? "]" : position(ring[0]) + "]");
}

std::string rings(const Polygon& polygon) {
  std::string text = "[";
  text += positions(polygon.outer);
  for (const Ring& hole : polygon.holes) text.append(",").append(positions(hole));
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
