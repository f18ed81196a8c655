// lasius check-path: is a path what it is to be?
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "lasius/base/error.h"
#include "lasius/version.h"
#include "tools/bitmap/map_ends.h"
#include "tools/bitmap/reasons.h"
#include "tools/command_line/option_table.h"
#include "tools/command_line/search_options.h"
#include "tools/console/exit_code.h"
#include "tools/console/streams.h"
#include "tools/console/values.h"
#include "tools/vehicle/path_file.h"
#include "tools/vehicle/vehicle_check.h"
#include "tools/vehicle/vehicle_file.h"
#include "tools/vehicle/vehicle_json.h"
#include "tools/vehicle/vehicle_kind.h"

namespace lasius::tool {
namespace {

struct Asked {
  MapOptions map;
  std::string path, vehicle;
  Frame frame = Frame::cell;
  bool radius_given = false;
  bool strict = false, json = false;
};

/// What was found.
struct Verdict {
  std::string judged_as;                    ///< "point", "disc", "vehicle"
  std::optional<VehicleFault> fault;        ///< the first
  bool has_pose = false;                    ///< of the fault
  std::string hint = {};                    ///< behind it
  std::optional<VehicleFault> remark = {};  ///< what is no fault of a table
  double length = 0;                        ///< cells
  std::size_t pieces = 0;
  int assumed_straight = 0;
};

lasius::Curve curve_of(const PathFile& file, const LoadedMap& map) {
  if (!file.curve.empty()) return file.curve;
  const std::vector<Point> points = points_of(file, map);
  const auto poses = poses_of(file, map);
  lasius::Curve curve = lines_between(points);
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    const auto motion = motion_between(poses[i], poses[i + 1]);
    if (!motion || motion->gear == 0 || std::abs(motion->curvature) < 1e-9) continue;
    CurvePiece& piece = curve[i];
    const double yaw = poses[i].yaw;
    piece.radius = 1 / std::abs(motion->curvature);
    piece.centre = {poses[i].x - std::sin(yaw) / motion->curvature,
                    poses[i].y + std::cos(yaw) / motion->curvature};
    piece.turn = motion->curvature * motion->gear > 0 ? 1 : -1;
    piece.angle = motion->length / piece.radius;
  }
  return curve;
}

Verdict verdict_of_vehicle(const Asked& asked, const LoadedMap& map, const PathFile& file) {
  if (file.segments.empty() && file.yaws.empty())
    throw UsageError(file.file + " tells no yaw; a vehicle's path has a column yaw, or segments");
  if (asked.vehicle.empty() && !file.vehicle)
    throw Error(ErrorCode::file_broken, {.file = file.file}, "tells \"segments\" and no vehicle",
                "name one with --vehicle");
  const vehicle::Vehicle vehicle =
      asked.vehicle.empty() ? *file.vehicle : read_vehicle(asked.vehicle, map, asked.frame).vehicle;
  const std::vector<double> curvatures = curvatures_of(file, map);
  const DrivenPath path =
      file.segments.empty() ? driven(poses_of(file, map), curvatures) : driven(file.segments);
  Verdict verdict{
      .judged_as = "vehicle",
      .fault = contact_fault(map.as_read(), vehicle::Space(map.as_read(), vehicle), path),
      .has_pose = true,
      .length = path.length,
      .pieces = path.pieces.size(),
      .assumed_straight = path.assumed_straight};
  auto other = motion_fault(vehicle, path, curvatures);
  const bool counts = !path.sampled || asked.strict;
  if (counts && other && (!verdict.fault || other->along < verdict.fault->along))
    verdict.fault = std::move(other);
  else if (!counts)
    verdict.remark = std::move(other);
  return verdict;
}

Verdict verdict_of(const Asked& asked, const LoadedMap& map, const PathFile& file) {
  if (!asked.vehicle.empty() || (!file.segments.empty() && !asked.radius_given))
    return verdict_of_vehicle(asked, map, file);
  const double radius = asked.radius_given ? map.radius : file.radius;
  Verdict verdict;
  std::optional<PathFault> fault;
  if (radius > 0) {
    const lasius::Curve curve = curve_of(file, map);
    verdict.judged_as = "disc";
    verdict.length = length_of(curve);
    verdict.pieces = curve.size();
    fault = disc_fault(map.as_read(), radius, curve);
  } else {
    const auto points = points_of(file, map);
    verdict.judged_as = "point";
    verdict.length = path_length(points);
    verdict.pieces = points.size() - 1;
    fault = point_fault(map.as_read(), points, file.squeezes);
  }
  if (fault) static_cast<PathFault&>(verdict.fault.emplace()) = *fault;
  return verdict;
}

/// As in ", 3.25 along the path, at (4.5, 2.25)".
std::string place_of_fault(const LoadedMap& map, const Asked& asked, const VehicleFault& fault,
                           bool has_pose) {
  const bool metres = asked.frame == Frame::world;
  const Point at = metres ? map.to_world(fault.at) : fault.at;
  std::string text = ", " + length_text(map, asked.frame, fault.along) + " along the path, at (" +
                     rounded_text(at.x, 4) + ", " + rounded_text(at.y, 4);
  if (has_pose)
    text += ", " + rounded_text(metres ? yaw_across(map, fault.pose.yaw) : fault.pose.yaw, 4);
  return text + ")";
}

std::string text_of(const LoadedMap& map, const Asked& asked, const Verdict& verdict) {
  if (verdict.fault)
    return "does not hold: " + verdict.fault->why +
           place_of_fault(map, asked, *verdict.fault, verdict.has_pose) + verdict.hint + "\n";
  return "holds: " + counted(static_cast<std::int64_t>(verdict.pieces), "piece") + ", " +
         length_text(map, asked.frame, verdict.length) + "\n";
}

Json fault_json(const LoadedMap& map, const Asked& asked, const std::optional<VehicleFault>& fault,
                bool has_pose) {
  if (!fault) return nullptr;
  Json json = {{"why", fault->why},
               {"along", number(fault->along)},
               {"at", has_pose ? pose_json(fault->pose) : point(fault->at)},
               {"cell", fault->cell ? Json{fault->cell->x, fault->cell->y} : Json()}};
  if (asked.frame == Frame::world) {
    json["along_m"] = number(map.metres(fault->along));
    json["at_world"] =
        has_pose ? pose_json(to_world(map, fault->pose)) : point(map.to_world(fault->at));
  }
  return json;
}

Json json_of(const LoadedMap& map, const Asked& asked, const Verdict& verdict) {
  Json fault = fault_json(map, asked, verdict.fault, verdict.has_pose);
  if (verdict.fault) fault["why"] = verdict.fault->why + verdict.hint;
  return {{"format", "lasius-check-path/1"},
          {"version", LASIUS_VERSION},
          {"map", map_json(map)},
          {"path", asked.path},
          {"judged_as", verdict.judged_as},
          {"holds", !verdict.fault},
          {"fault", std::move(fault)},
          {"cannot_drive", fault_json(map, asked, verdict.remark, true)},
          {"length", number(verdict.length)},
          {"pieces", verdict.pieces},
          {"assumed_straight", verdict.assumed_straight}};
}

int check(Asked& asked) {
  asked.map.radius_metres = asked.frame == Frame::world;
  PathFile file = read_path(asked.path, asked.frame);
  asked.map.unknown_is_free |= file.unknown_free;
  const LoadedMap map = read_map(asked.map, file.metres ? Frame::world : asked.frame);
  file.metres |= file.metres_of_map && map.frame.has_value();
  Verdict verdict = verdict_of(asked, map, file);
  if (verdict.fault && !file.metres && !asked.path.ends_with(".json")) {
    const Place first = end_place(map, {file.points.front(), true}, Frame::cell);
    if (!map.as_read().free(first.cell)) verdict.hint = metres_hint(map, asked.frame, first);
  }
  print_verdict(asked.json ? line(json_of(map, asked, verdict)) : text_of(map, asked, verdict));
  if (const std::string hint = radius_hint(map, asked.frame); !hint.empty()) message(hint);
  if (verdict.remark && !asked.json)
    message("no fault of a table without --strict: " + verdict.remark->why +
            place_of_fault(map, asked, *verdict.remark, true));
  return verdict.fault ? kInternal : kFound;
}

}  // namespace

Subcommand add_check_path(CLI::App& app) {
  auto asked = std::make_shared<Asked>();
  OptionTable table(app, "check-path", "Judge anybody's path: whether it touches anything");
  table
      .file("MAP", asked->map.file, "The map: .map, PBM, PGM, PNG, BMP or ROS YAML",
            map_endings(false))
      ->required();
  table
      .file("PATH", asked->path,
            "The path: a table with a header, x,y[,yaw,kappa,...], a nav_msgs/Path, or a saved "
            "result of plan, drive or tour",
            {".csv", ".json", ".yaml", ".yml"})
      ->required();
  table.file("--vehicle", asked->vehicle,
             "The footprint that keeps from what is blocked, over its whole sweep (default: the "
             "result's)",
             kDocuments);
  table.real("--radius", asked->map.radius, 0, kNoLimit,
             "A disc's centre keeps R cells (metres with --frame world) along the whole path "
             "(default: the result's)",
             "R");
  table.choice("--frame", asked->frame, kFrames,
               "Unit of a table, of --radius and of what is printed, as of plan", "cell|world");
  table.flag("--unknown-free", asked->map.unknown_is_free,
             "Unknown cells of a ROS map count as free");
  table.flag("--strict", asked->strict,
             "What the vehicle cannot drive is a fault of a table, too, whose poses are rounded: "
             "sharper turns, driving aside, backwards or turning in place where it does not");
  table.flag("--json", asked->json, "Print one JSON object");
  return table.command(
      {.detail = "Between two poses of a table the arc, line or rotation is assumed that joins "
                 "them, with a column kappa also the clothoid; where none does, x, y and yaw "
                 "change in proportion. Without yaw, and for "
                 "a point, straight lines.",
       .examples = {{"lasius check-path maps/fan400x200.map run.json",
                     "whether a saved path keeps what it was planned with"},
                    {"lasius check-path maps/fan400x200.map path.csv --radius 1.5",
                     "whether a disc may follow another planner's points"}},
       .exits = {{kFound, "the path holds"},
                 {kInternal, "it does not: the first fault is printed; internal error"},
                 {kBadFile, "map, path or vehicle is missing or broken"}}},
      [=](const Call&) {
        asked->radius_given = table.given("--radius");
        if (asked->radius_given && !asked->vehicle.empty())
          throw UsageError("--radius is for discs; leave it or --vehicle out");
        return check(*asked);
      });
}

}  // namespace lasius::tool
