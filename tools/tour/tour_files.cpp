#include "tools/tour/tour_files.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

#include "tools/bitmap/bitmap_report.h"
#include "tools/bitmap/poses_file.h"
#include "tools/bitmap/sheet.h"
#include "tools/console/values.h"
#include "tools/report/report.h"

namespace lasius::tool {
namespace {

const Place& place_at(const TourAnswer& answer, int stop) {
  return answer.stops[static_cast<std::size_t>(stop)];
}

std::vector<Point> path_of(const TourAnswer& answer, const TourLeg& leg, bool metres) {
  if (!metres) return leg.path;
  std::vector<Point> path = answer.map.to_world(leg.path);
  path.front() = place_at(answer, leg.from).asked;
  path.back() = place_at(answer, leg.to).asked;
  return path;
}

}  // namespace

std::vector<std::vector<Point>> tour_paths(const TourAnswer& answer, bool metres) {
  const TourResult& tour = answer.tour;
  std::vector<std::vector<Point>> paths;
  const auto add = [&](int first_stop, int first, int count) {
    std::vector<Point>& path = paths.emplace_back();
    for (int i = first; i < first + count; ++i) {
      const auto leg = path_of(answer, tour.legs[static_cast<std::size_t>(i)], metres);
      path.insert(path.end(), leg.begin() + (path.empty() ? 0 : 1), leg.end());
    }
    const Place& only = place_at(answer, first_stop);
    if (path.empty()) path = {metres ? only.asked : only.at()};
  };
  for (const RobotTour& robot : tour.tours) add(robot.start, robot.first_leg, robot.legs);
  if (tour.tours.empty() && !tour.order.empty())
    add(tour.order.front(), 0, static_cast<int>(tour.legs.size()));
  return paths;
}

Json legs_json(const TourAnswer& answer, bool metres) {
  Json legs = Json::array();
  for (const TourLeg& leg : answer.tour.legs) {
    legs.push_back({{"from", leg.from},
                    {"to", leg.to},
                    {"length", number(leg.length)},
                    {"path", points(leg.path)}});
    if (answer.tour.cost) legs.back()["cost"] = number(leg.cost);
    if (metres) legs.back()["path_world"] = points(path_of(answer, leg, true));
  }
  return legs;
}

Json tours_json(const TourAnswer& answer, bool metres) {
  Json tours = Json::array();
  for (const RobotTour& robot : answer.tour.tours) {
    Json legs = Json::array();
    for (int i = 0; i < robot.legs; ++i) legs.push_back(robot.first_leg + i);
    tours.push_back({{"start", robot.start},
                     {"order", robot.order},
                     {"legs", legs},
                     {"length", number(robot.length)}});
    if (metres) tours.back()["length_m"] = number(answer.map.metres(robot.length));
    if (answer.tour.cost) tours.back()["cost"] = number(robot.cost);
  }
  return tours;
}

std::string robots_text(const TourResult& tour) {
  if (tour.tours.empty()) return {};
  const auto going =
      std::ranges::count_if(tour.tours, [](const RobotTour& robot) { return robot.legs > 0; });
  return std::to_string(going) + " of " +
         counted(static_cast<std::int64_t>(tour.tours.size()), "robot") + ", ";
}

void write_robot_table(std::ostream& out, const TourAnswer& answer, bool metres) {
  out << (metres ? "robot,x_m,y_m\n" : "robot,x,y\n");
  int robot = 0;
  for (const auto& path : tour_paths(answer, metres)) {
    for (const Point p : path) out << robot << "," << to_text(p.x) << "," << to_text(p.y) << "\n";
    ++robot;
  }
}

void write_tour_page(std::ostream& out, const Record& record, const TourAnswer& answer,
                     const RunOptions& run, const Json& vehicle) {
  std::vector<Cell> cells;
  for (const Place& stop : answer.stops) cells.push_back(stop.cell);
  const LoadedMap& map = answer.map;
  Json content = run_json(record, "tour", "tour, " + map_title(map, run, record.algorithm.name));
  content["map"] = map_view_json(map, shown_of(map, cells));
  if (!vehicle.is_null()) content["vehicle"] = vehicle;
  write_report_page(out, content);
}

void write_tour_poses(std::ostream& out, const TourAnswer& answer, const RunOptions& run) {
  const bool metres = answer.map.frame.has_value();
  const auto paths = tour_paths(answer, false);
  if (paths.empty()) return write_ros_path(out, {});
  for (const auto& path : paths) {
    if (paths.size() > 1) out << "---\n";
    std::vector<Pose> along = poses(path, spacing_of(answer.map, run));
    if (metres)
      for (Pose& pose : along) pose = to_world(*answer.map.frame, pose, answer.map.height);
    write_ros_path(out, along);
  }
}

}  // namespace lasius::tool
