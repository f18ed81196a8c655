#include "tools/tour/tour_legs.h"

namespace lasius::tool {
namespace {

std::vector<Point> metres_of(const TourAnswer& answer, const TourLeg& leg) {
  const auto asked = [&](int stop) { return answer.stops[static_cast<std::size_t>(stop)].asked; };
  std::vector<Point> path = answer.map.to_world(leg.path);
  path.front() = asked(leg.from);
  path.back() = asked(leg.to);
  return path;
}

}  // namespace

std::vector<Point> tour_path(const TourAnswer& answer, bool in_metres) {
  const TourResult& tour = answer.tour;
  std::vector<Point> path;
  for (const TourLeg& leg : tour.legs) {
    const std::vector<Point> told = in_metres ? metres_of(answer, leg) : leg.path;
    path.insert(path.end(), told.begin() + (path.empty() ? 0 : 1), told.end());
  }
  if (path.empty() && !tour.order.empty()) {
    const Place& only = answer.stops[static_cast<std::size_t>(tour.order.front())];
    path = {in_metres ? only.asked : only.at()};
  }
  return path;
}

Json legs_json(const TourAnswer& answer, bool in_metres) {
  Json legs = Json::array();
  for (const TourLeg& leg : answer.tour.legs) {
    legs.push_back({{"from", leg.from},
                    {"to", leg.to},
                    {"length", number(leg.length)},
                    {"path", points(leg.path)}});
    if (answer.tour.cost) legs.back()["cost"] = number(leg.cost);
    if (in_metres) legs.back()["path_world"] = points(metres_of(answer, leg));
  }
  return legs;
}

}  // namespace lasius::tool
