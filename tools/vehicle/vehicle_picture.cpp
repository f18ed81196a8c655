#include "tools/vehicle/vehicle_picture.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "tools/bitmap/bitmap_report.h"
#include "tools/bitmap/cost_ground.h"
#include "tools/bitmap/poses_file.h"
#include "tools/bitmap/sheet.h"
#include "tools/console/values.h"
#include "tools/draw/colours.h"
#include "tools/draw/page.h"
#include "tools/draw/text.h"
#include "tools/report/report.h"
#include "tools/vehicle/vehicle_answer.h"

namespace lasius::tool {
namespace {

constexpr Colour kSweep{0.1, 0.32, 0.62};
constexpr Colour kBackwards{0.75, 0.35, 0.05};

std::vector<Point> footprint_at(const Axes& axes, const vehicle::Vehicle& vehicle,
                                const vehicle::Pose& pose) {
  const double c = std::cos(pose.yaw), s = std::sin(pose.yaw);
  std::vector<Point> corners;
  for (const Point p : vehicle.footprint)
    corners.push_back(axes.at(pose.x + c * p.x - s * p.y, pose.y + s * p.x + c * p.y));
  return corners;
}

std::string caption(const Sheet& sheet, const VehicleMap& on, const VehicleAnswer& answer) {
  const vehicle::Result& found = answer.result;
  if (!answer.has_path()) return no_path_text(found.status);
  std::string text =
      "length " + sheet.length(found.length) + ", " + counted(found.cusps, "cusp") +
      printed(", %.1f s", vehicle::Profile(found.segments, on.vehicle.speeds).duration());
  if (found.over_costs) {
    text += ", cost " + decimal_text(found.cost, 3);
    if (const auto gap = found.gap())
      text += printed(", at most %.3f%% above the least", 100 * *gap);
    return text + "; colours: weight of cells";
  }
  if (found.lower_bound)
    text +=
        against(found.length, *found.lower_bound, "lower bound", sheet.length(*found.lower_bound));
  return text;
}

void draw_vehicle(Canvas& canvas, const Box& box, const Sheet& sheet, const VehicleMap& on,
                  const VehicleCommand& command, const VehicleAnswer& answer) {
  const Axes axes = sheet.axes(box);
  const vehicle::Vehicle& vehicle = on.vehicle.vehicle;
  const auto along = timed_poses(on, command, answer);
  canvas.clip(box);
  std::vector<vehicle::Pose> poses;
  for (const auto& timed : along) poses.push_back(timed.at.pose);
  draw_sweep(canvas, axes, vehicle, poses, answer.start.pose, answer.goal().pose);
  for (std::size_t i = 1; i < along.size(); ++i) {
    const vehicle::Pose &a = along[i - 1].at.pose, &b = along[i].at.pose;
    canvas.line(axes.at(a.x, a.y), axes.at(b.x, b.y), along[i].at.gear < 0 ? kBackwards : kPath,
                2.5);
  }
  canvas.unclip();
}

std::string title_of(const VehicleMap& on) {
  return file_name(on.vehicle.file) + " on " + file_name(on.map.file) + ", " +
         std::to_string(on.map.width) + " x " + std::to_string(on.map.height) + " cells";
}

}  // namespace

Key sweep_key() { return area_key("swept by the footprint", kSweep); }

void draw_sweep(Canvas& canvas, const Axes& axes, const vehicle::Vehicle& vehicle,
                std::span<const vehicle::Pose> poses, const vehicle::Pose& start,
                const vehicle::Pose& goal) {
  constexpr double kFaint = 0.1, kEnd = 0.35;
  // So far apart that outlines tell where it looks.
  const double apart = vehicle::circumscribed_radius(vehicle) / 2;
  vehicle::Pose last = start;
  for (const vehicle::Pose& pose : poses) {
    const double turned = std::abs(pose.yaw - last.yaw) * apart;
    if (std::hypot(pose.x - last.x, pose.y - last.y) + turned < apart) continue;
    canvas.area(footprint_at(axes, vehicle, pose), kSweep, kFaint);
    last = pose;
  }
  for (const vehicle::Pose& end : {start, goal})
    canvas.area(footprint_at(axes, vehicle, end), kSweep, kEnd);
}

Json vehicle_view_json(const VehicleMap& on, const VehicleCommand& command,
                       std::span<const VehicleAnswer> answers) {
  constexpr double kMostPoses = 3000;
  double length = 0, begun = 0;
  for (const VehicleAnswer& answer : answers)
    length += answer.has_path() ? answer.result.length : 0;
  const double spacing = std::max(spacing_of(on.map, command.run), length / kMostPoses);
  Json poses = Json::array();
  for (const VehicleAnswer& answer : answers) {
    if (!answer.has_path()) continue;
    const vehicle::Profile profile(answer.result.segments, on.vehicle.speeds);
    for (const vehicle::TimedPose& timed : profile.samples(spacing)) {
      const vehicle::PathPose& at = timed.at;
      Json row = Json::array();
      for (const double value :
           {at.pose.x, at.pose.y, at.pose.yaw, at.curvature, timed.speed, begun + timed.time})
        row.push_back(std::round(1e6 * value) / 1e6);
      row.push_back(at.gear);
      poses.push_back(std::move(row));
    }
    begun += profile.duration();
  }
  return {{"footprint", points(on.vehicle.vehicle.footprint)}, {"poses", std::move(poses)}};
}

void write_vehicle_page(std::ostream& out, const Record& record, const VehicleMap& on,
                        const VehicleCommand& command, const VehicleAnswer& answer) {
  Json content = run_json(record, "vehicle", title_of(on));
  const Window window = shown_of(on.map, {answer.start.place.cell, answer.goal().place.cell});
  content["map"] = map_view_json(on.map, window);
  if (on.map.costs)
    content["map"]["weights"] = weights_view_json(on.map.costs->field, on.map.as_read(), window);
  content["vehicle"] = vehicle_view_json(on, command, {&answer, 1});
  write_report_page(out, content);
}

void write_vehicle_picture(const std::string& file, const VehicleMap& on,
                           const VehicleCommand& command, const VehicleAnswer& answer) {
  const std::vector<Cell> ends{answer.start.place.cell, answer.goal().place.cell};
  const Sheet sheet{on.map, on.map.grid(), command.run, shown_of(on.map, ends)};
  const LoadedCosts* const costs = on.map.costs ? &*on.map.costs : nullptr;
  const auto draw = [&](Canvas& canvas, const Box& box) {
    if (costs != nullptr) {
      const ColourScale scale = cost_scale(costs->field, on.map.as_read());
      paint_map(canvas, box, sheet, [&](Span columns, Span rows) {
        return cost_ground(costs->field, on.map.as_read(), scale, columns, rows);
      });
      draw_bar(canvas, box, scale);
    } else {
      paint_map(canvas, box, sheet, free_ground);
    }
    draw_vehicle(canvas, box, sheet, on, command, answer);
    draw_marks(canvas, box, sheet, answer.start.place.at(), answer.goal().place.at(), false);
  };
  Page page = sheet.page(title_of(on));
  if (answer.has_path()) {
    page.legend.push_back(line_key("forwards", kPath, 2.5));
    if (answer.result.cusps > 0) page.legend.push_back(line_key("backwards", kBackwards, 2.5));
    page.legend.push_back(sweep_key());
  }
  page.bands = {{{{{.caption = caption(sheet, on, answer),
                    .draw = draw,
                    .below = costs != nullptr ? kBarHeight : 0}}}}};
  write_page(file, page);
}

}  // namespace lasius::tool
