#include "tools/bitmap/reasons.h"

#include <algorithm>
#include <cmath>

#include "tools/console/values.h"

namespace lasius::tool {
namespace {

bool is_unknown(const LoadedMap& map, Cell c) {
  return map.unknown && map.unknown->contains(c) && map.unknown->blocked(c);
}

/// The map with its unknown cells free, and grown as it is.
std::optional<Planner> with_unknown_free(const LoadedMap& map, const StopCondition& stop) {
  Grid grid = map.as_read();
  std::vector<std::uint64_t> words(grid.words());
  for (int y = 0; y < grid.height(); ++y) {
    for (int i = 0; i < grid.words(); ++i) words[i] = grid.row(y)[i] & ~map.unknown->row(y)[i];
    grid.set_row(y, words.data());
  }
  return Planner::make(std::move(grid), Disc{map.radius}, stop);
}

}  // namespace

std::string length_text(const LoadedMap& map, Frame frame, double cells, int decimals, bool down) {
  const bool metres = frame == Frame::world;
  const double length = metres && down ? metres_within(map, cells) : map.length_in(frame, cells);
  const std::string text = rounded_text(length, decimals, down);
  return text + (metres ? " m" : text == "1" ? " cell" : " cells");
}

std::string place_text(const Place& place, Frame frame) {
  const auto& told = place.point;
  const std::string cell =
      told && frame == Frame::cell
          ? "(" + to_text(told->x) + ", " + to_text(told->y) + ")"
          : "(" + whole_text(place.number.x) + ", " + whole_text(place.number.y) + ")";
  if (frame == Frame::cell) return cell;
  return to_text(place.asked.x) + "," + to_text(place.asked.y) + " m, in cell " + cell + ",";
}

std::string spot_text(const LoadedMap& map, Frame frame, Point at) {
  const Cell cell{static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y))};
  const bool middle = at == centre(cell);
  std::string metres;
  if (frame == Frame::world) {
    const Point world = map.to_world(at);
    metres = decimal_text(world.x, 3) + "," + decimal_text(world.y, 3) + " m";
    if (!middle) return metres;
    metres = ", its centre at " + metres;
  }
  if (middle) return printed("(%d, %d)", cell.x, cell.y) + metres;
  return "the point (" + rounded_text(at.x, 3) + ", " + rounded_text(at.y, 3) + ")";
}

bool Route::joined(const Planner& planner, Cell start, Cell goal) const {
  if (curved) return planner.joined(start, goal);
  const Grid& grid = planner.passable();
  return grid.free(start) && grid.free(goal) && planner.connected(start, goal, corners);
}

Obstruction obstruction_of(const LoadedMap& map, const Place& place, bool curved) {
  const Grid& grid = map.as_read();
  const Cell cell = place.cell;
  const Point at = place.at();
  const bool middle = at == centre(cell);
  if (!grid.contains(cell)) return {.by = "outside"};
  if (grid.blocked(cell)) return {.by = is_unknown(map, cell) ? "unknown" : "obstacle"};
  const auto near_to = [&](double beside) {
    const auto [clearance, nearest] =
        nearest_blocked(grid, at, std::min(map.radius, 1e6) + 1, beside);
    return Obstruction{.by = "radius",
                       .clearance = clearance,
                       .nearest = !grid.contains(nearest)    ? "the edge of the map"
                                  : is_unknown(map, nearest) ? "an unknown cell"
                                                             : "an obstacle"};
  };
  const Obstruction centre_near = near_to(0);
  if (curved && middle) return map.planner->clear(cell) ? Obstruction{} : centre_near;
  if (centre_near.clearance < map.radius) return centre_near;
  if (!middle) return {};
  Obstruction cell_near = near_to(0.5);
  cell_near.in_part = true;
  return cell_near.clearance < map.radius ? cell_near : Obstruction{};
}

std::string obstruction_text(const LoadedMap& map, Frame frame, const Obstruction& why) {
  if (why.by == "outside") return " is outside the map";
  if (why.by == "unknown") return " is unknown, and blocked without --unknown-free";
  if (why.by == "radius")
    return " is " + std::string(why.in_part ? "in part " : "") + "too near to " +
           std::string(why.nearest) + ", " + length_text(map, frame, why.clearance, 3, true) +
           " away: the radius is " + length_text(map, frame, map.radius, 6);
  return map.unknown || map.radius > 0 ? " is blocked by an obstacle" : " is blocked";
}

std::string metres_hint(const LoadedMap& map, Frame frame, const Place& place) {
  if (frame == Frame::world || !map.frame) return {};
  const Place meant = to_place(map, place.point.value_or(place.number), Frame::world);
  if (map.grid().blocked(meant.cell)) return {};
  return "; taken as metres, with --frame world, it is in the free cell " +
         place_text(meant, Frame::cell);
}

std::string radius_hint(const LoadedMap& map, Frame frame) {
  if (frame == Frame::world || !map.frame || !(map.radius > 0 && map.radius < 1)) return {};
  return "the radius is " + to_text(map.radius) + " cells, " +
         rounded_text(map.metres(map.radius), 6) + " m; with --frame world it is taken in metres";
}

double metres_within(const LoadedMap& map, double cells) {
  double metres = std::nextafter(map.metres(cells), kNoLimit);
  while (metres / map.frame->resolution > cells) metres = std::nextafter(metres, 0);
  return metres;
}

Remedy widest_of(LoadedMap& map, Cell start, Cell goal, const Route& route,
                 const std::stop_token& token) {
  const Grid& grid = map.as_read();
  if (std::int64_t{map.width} * map.height > Remedy::kMostCells) return {};
  if (!grid.contains(start) || !grid.contains(goal)) return {};
  if (route.curved) {
    const auto widest = map.planner->widest_disc(start, goal, {.token = token});
    return {.searched = widest || !token.stop_requested(), .widest_radius = widest};
  }
  auto& widest = map.widest[route.corners == Corners::allow ? 1 : 0];
  if (!widest) widest = WidestRadius::make(grid, route.corners, {.token = token});
  if (!widest) return {};
  return {.searched = true, .widest_radius = widest->between(start, goal)};
}

Remedy remedy_of(LoadedMap& map, Cell start, Cell goal, const Route& route,
                 const std::stop_token& token) {
  Remedy remedy;
  if (map.radius > 0) remedy = widest_of(map, start, goal, route, token);
  if (map.unknown && !map.unknown_is_free && !map.with_unknown_free)
    map.with_unknown_free = with_unknown_free(map, {.token = token});
  remedy.unknown_free = map.with_unknown_free && route.joined(*map.with_unknown_free, start, goal);
  return remedy;
}

std::string remedy_text(const LoadedMap& map, Frame frame, const Remedy& remedy) {
  std::string text;
  if (remedy.widest_radius)
    text = "; the widest radius that joins start and goal is " +
           length_text(map, frame, *remedy.widest_radius, 3, true);
  else if (remedy.searched)
    text = "; no radius joins start and goal";
  if (remedy.unknown_free) text += "; with --unknown-free they are joined";
  return text;
}

}  // namespace lasius::tool
