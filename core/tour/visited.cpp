#include "core/tour/visited.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/base/number_text.h"
#include "core/base/poller.h"

namespace lasius {

namespace {

// As it was given.
std::string stop_name(const TourRequest& request, int i) {
  if (!request.points.empty()) return pair_text(request.points[i].x, request.points[i].y);
  return pair_text(request.stops[i].x, request.stops[i].y);
}

// The stops of each task.
std::vector<std::vector<int>> tasks_of(const TourRequest& request, int stops) {
  std::map<int, std::size_t> known;
  std::vector<std::vector<int>> tasks;
  for (int i = 0; i < stops; ++i) {
    const int group = request.group.empty() ? -1 : request.group[i];
    const auto [at, is_new] = known.try_emplace(group, tasks.size());
    if (group < 0 || is_new)
      tasks.push_back({i});
    else
      tasks[at->second].push_back(i);
  }
  return tasks;
}

bool holds(const StopPlaces& places, int stop, int region) {
  const std::vector<int>& own = places.regions[stop];
  return std::find(own.begin(), own.end(), region) != own.end();
}

// The region that holds most ends, of these the first robot's or the start; then most tasks. -1: no
// stop lies in one.
int chosen_region(const StopPlaces& places, const TourRequest& request,
                  const std::vector<std::vector<int>>& tasks, const std::vector<int>& ends) {
  int regions = 0;
  for (const auto& own : places.regions)
    for (const int region : own) regions = std::max(regions, region + 1);
  std::vector<std::array<std::int64_t, 4>> worth(static_cast<std::size_t>(regions));
  const auto count = [&](int stop, int what) {
    for (const int region : places.regions[stop]) ++worth[region][what];
  };
  if (!request.robots.empty()) {
    for (const int end : ends) count(end, 0);
    count(request.robots.front(), 1);
  }
  if (request.start) count(*request.start, 1);
  if (request.goal) count(*request.goal, 2);
  std::vector<int> of_task;
  for (const std::vector<int>& stops : tasks) {
    of_task.clear();
    for (const int stop : stops)
      of_task.insert(of_task.end(), places.regions[stop].begin(), places.regions[stop].end());
    std::ranges::sort(of_task);
    of_task.erase(std::unique(of_task.begin(), of_task.end()), of_task.end());
    for (const int region : of_task) ++worth[region][3];
  }
  const auto best = std::ranges::max_element(worth);
  return best == worth.end() ? -1 : static_cast<int>(best - worth.begin());
}

}  // namespace

void tell_of_group(LeftOut& out, int group) {
  out.group = group;
  out.why = "no stop of group " + number_text(group) + " can be visited: " + out.why;
}

std::vector<Point> anchors_of(const Planner& planner, Point p) {
  const bool meeting = p.x == std::floor(p.x) && p.y == std::floor(p.y);
  if (!meeting || planner.robot().radius > 0) return {p};
  std::vector<Point> anchors;
  for (const double dy : {0.5, -0.5})
    for (const double dx : {0.5, -0.5})
      if (const Point at{p.x + dx, p.y + dy}; planner.clear_at(at)) anchors.push_back(at);
  return anchors;
}

std::vector<int> ends_of(const TourRequest& request) {
  std::vector<int> ends = request.robots;
  for (const auto& end : {request.start, request.goal})
    if (end) ends.push_back(*end);
  return ends;
}

StopPlaces places_of(const Planner& planner, std::span<const Point> points,
                     const StopCondition& stop) {
  StopPlaces places{std::vector<std::vector<int>>(points.size()), {}};
  const Grid& map = planner.grid();
  std::vector<Point> regions;  // a place of each
  Poller poller(stop, 1 << 20);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point p = points[i];
    const bool inside = p.x >= 0 && p.x <= map.width() && p.y >= 0 && p.y <= map.height();
    places.outside.push_back(!inside);
    if (!planner.clear_at(p)) continue;
    std::vector<int>& own = places.regions[i];
    for (const Point at : anchors_of(planner, p)) {
      const auto joined = [&](Point other) { return planner.joined_at(other, at); };
      const auto found = std::find_if(regions.begin(), regions.end(), joined);
      const int region = static_cast<int>(found - regions.begin());
      if (found == regions.end()) regions.push_back(at);
      if (poller.stop_after(region)) {
        places.cause = poller.cause();
        return places;
      }
      if (std::find(own.begin(), own.end(), region) == own.end()) own.push_back(region);
    }
  }
  return places;
}

StopPlaces places_of(const TourWorld& world, std::span<const Point> points) {
  StopPlaces places{world.regions(points), {}};
  for (const Point p : points) places.outside.push_back(!world.inside(p));
  return places;
}

std::vector<int> visited(const StopPlaces& places, const TourRequest& request, TourResult& tour) {
  const int n = static_cast<int>(places.regions.size());
  const std::vector<std::vector<int>> tasks = tasks_of(request, n);
  const std::vector<int> ends = ends_of(request);
  const int chosen = chosen_region(places, request, tasks, ends);
  const auto in = [&](int stop) { return chosen >= 0 && holds(places, stop, chosen); };
  const auto why_not = [&](int i) {
    return "stop " + number_text(i) + " at " + stop_name(request, i) +
           (places.outside[i]           ? " is outside the map"
            : places.regions[i].empty() ? " is blocked"
                                        : " cannot be reached from the others");
  };
  for (const std::vector<int>& stops : tasks) {
    const bool done = std::any_of(stops.begin(), stops.end(), in);
    for (const int i : stops) {
      const bool is_end = std::count(ends.begin(), ends.end(), i) > 0;
      if (in(i) || (!is_end && (done || i != stops.front()))) continue;
      tour.left_out.push_back({i, why_not(i)});
      if (is_end)
        tour.error = tour.left_out.back().why;
      else if (stops.size() > 1)
        tell_of_group(tour.left_out.back(), request.group[i]);
    }
  }
  std::ranges::sort(tour.left_out, {}, &LeftOut::stop);
  std::vector<int> indices;
  for (int i = 0; i < n; ++i)
    if (in(i)) indices.push_back(i);
  return indices;
}

}  // namespace lasius
