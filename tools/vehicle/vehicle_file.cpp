#include "tools/vehicle/vehicle_file.h"

#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "lasius/base/error.h"
#include "tools/console/values.h"
#include "tools/record/json_values.h"
#include "tools/vehicle/vehicle_json.h"
#include "tools/yaml/document.h"

namespace lasius::tool {
namespace {

using vehicle::Vehicle;

constexpr double kMost = 1e9;     // of a length or a price in the file's unit
constexpr double kLeast = 1e-9;   // of what is above 0
constexpr double kWidest = 1024;  // cells from the reference point

constexpr std::array<std::string_view, 3> kTypes{"car", "differential", "omni"};
constexpr std::array<std::string_view, 2> kUnits{"cells", "metres"};

std::vector<std::string_view> all_keys() {
  std::vector<std::string_view> keys{
      "type",         "units",     "footprint",       "turning_radius", "reverse",
      "reverse_cost", "cusp_cost", "rotate_in_place", "rotation_cost",  "curvature_rate"};
  for (const SpeedKey& speed : speed_keys()) keys.push_back(speed.key);
  return keys;
}

/// Cells a unit of the file.
double cells_a_unit(const Node& file, const LoadedMap& map) {
  const Node* const units = file.find("units");
  const bool metres = units != nullptr ? units->choice(kUnits) == 1 : map.frame.has_value();
  if (!metres) return 1;
  if (!map.frame)
    units->fail("is metres, and " + map.file + " has no resolution",
                "name the .yaml file of a ROS map, or write units: cells and give cells");
  return 1 / map.frame->resolution;
}

std::vector<Point> corners(const Node& list, double scale, bool mirrored) {
  if (!list.is_list()) list.fail("is no list of corners", "write [[x, y], [x, y], [x, y], ...]");
  std::vector<Point> polygon;
  for (const Node& item : list.items()) {
    if (!item.is_list() || item.items().size() != 2)
      item.fail("has a corner that is not [x, y]", "write [[x, y], [x, y], [x, y], ...]");
    const double x = scale * item.items()[0].number(-kMost, kMost);
    const double y = scale * item.items()[1].number(-kMost, kMost);
    if (!(std::hypot(x, y) <= kWidest))
      item.fail("has a corner " + to_text(std::hypot(x, y)) + " cells from the reference point",
                "at most " + to_text(kWidest) + "; look at units");
    polygon.push_back({x, mirrored ? -y : y});
  }
  if (polygon.size() > 1 && polygon.front() == polygon.back()) polygon.pop_back();  // closed so
  if (polygon.size() < 3)
    list.fail("has " + counted(static_cast<std::int64_t>(polygon.size()), "corner"),
              "give at least 3");
  return polygon;
}

std::vector<Point> footprint_of(const Node& file, double scale, bool mirrored) {
  const Node& list = file.at("footprint");
  if (list.kind() != Node::Kind::text) return corners(list, scale, mirrored);
  return corners(parse_document(list.text(), list.file()), scale, mirrored);
}

/// The usual of a type; without one by what else the file says.
Vehicle usual_of(const Node& file, double scale, std::vector<Point> footprint) {
  const Node* const type = file.find("type");
  const double radius = scale * file.number_or("turning_radius", 0, 0, kMost);
  const bool steers =
      type != nullptr ? type->choice(kTypes) == 0 : !file.flag_or("rotate_in_place", false);
  if (!steers) {
    Vehicle turning = type != nullptr && type->choice(kTypes) == 2
                          ? vehicle::omni(std::move(footprint))
                          : vehicle::differential(std::move(footprint));
    turning.turning_radius = radius;
    if (turning.sideways && radius > 0)
      file.at("turning_radius")
          .fail("is of no use to omni, which drives to any side",
                "leave it out, or write type: differential");
    return turning;
  }
  const Node& given = file.at("turning_radius");  // said to be missing
  if (!(radius > 0)) given.fail("is 0", "a car needs one above 0; or write type: differential");
  return vehicle::car(std::move(footprint), radius);
}

}  // namespace

LoadedVehicle read_vehicle(const std::string& name, const LoadedMap& map, Frame frame) {
  const Node file = read_document(name, "a vehicle in YAML or JSON");
  static const std::vector<std::string_view> kKeys = all_keys();
  file.allow(kKeys);
  const double scale = cells_a_unit(file, map);
  LoadedVehicle loaded{.file = name, .hash = file_hash(name)};
  loaded.vehicle = usual_of(file, scale, footprint_of(file, scale, frame == Frame::world));
  Vehicle& to = loaded.vehicle;
  to.reverse = file.flag_or("reverse", to.reverse);
  to.reverse_cost = file.number_or("reverse_cost", to.reverse_cost, 1, 1000);
  to.cusp_cost = scale * file.number_or("cusp_cost", to.cusp_cost / scale, 0, kMost);
  to.curvature_rate = file.number_or("curvature_rate", 0, 0, kMost) / (scale * scale);
  loaded.speeds.steady_curvature = to.curvature_rate > 0;
  to.rotate_in_place = file.flag_or("rotate_in_place", to.rotate_in_place);
  to.rotation_cost =
      scale * file.number_or("rotation_cost", to.rotation_cost / scale, kLeast, kMost);
  if (!to.rotate_in_place && !(to.turning_radius > 0))
    file.at("rotate_in_place")
        .fail("is false, and there is no turning_radius", "give a turning_radius above 0");
  for (const SpeedKey& speed : speed_keys()) {
    const double in_cells = speed.length ? scale : 1;
    double& value = loaded.speeds.*speed.value;
    if (const Node* const given = file.find(speed.key))
      value = in_cells * given->number(kLeast, kMost);
    else if (std::isfinite(value))
      value *= in_cells;  // a unit a second
  }
  try {
    validate(to);
  } catch (const Error& error) {
    std::string_view key = "footprint";
    for (const auto each : kKeys)
      if (error.problem().starts_with(each) && file.find(each) != nullptr) key = each;
    file.at(key).fail("cannot be, in cells: " + error.problem(), error.remedy());
  }
  return loaded;
}

}  // namespace lasius::tool
