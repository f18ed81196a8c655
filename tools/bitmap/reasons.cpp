#include "tools/bitmap/reasons.h"

#include <cmath>

#include "tools/bitmap/path_clearance.h"
#include "tools/console/values.h"

namespace lasius::tool {
namespace {

/// Before obstacles grew.
const Grid& true_grid(const LoadedMap& map) { return map.as_read ? *map.as_read : map.grid(); }

bool is_unknown(const LoadedMap& map, Cell c) {
  return map.unknown && map.unknown->contains(c) && map.unknown->blocked(c);
}

/// The map with its unknown cells free, and grown as it is.
std::optional<Planner> with_unknown_free(const LoadedMap& map, const StopCondition& stop) {
  Grid grid = true_grid(map);
  std::vector<std::uint64_t> words(grid.words());
  for (int y = 0; y < grid.height(); ++y) {
    for (int i = 0; i < grid.words(); ++i) words[i] = grid.row(y)[i] & ~map.unknown->row(y)[i];
    grid.set_row(y, words.data());
  }
  auto grown = grow_obstacles(grid, map.radius, stop);
  return grown ? Planner::make(std::move(*grown), stop) : std::nullopt;
}

}  // namespace

std::string length_text(const LoadedMap& map, Frame frame, double cells, int decimals, bool down) {
  const bool metres = frame == Frame::world;
  const double length = metres && down ? metres_within(map, cells) : map.length_in(frame, cells);
  const std::string text = rounded_text(length, decimals, down);
  return text + (metres ? " m" : text == "1" ? " cell" : " cells");
}

std::string place_text(const Place& place, Frame frame) {
  const std::string cell =
      "(" + whole_text(place.number.x) + ", " + whole_text(place.number.y) + ")";
  if (frame == Frame::cell) return cell;
  return to_text(place.asked.x) + "," + to_text(place.asked.y) + " m, in cell " + cell + ",";
}

Obstruction obstruction_of(const LoadedMap& map, Cell cell) {
  const Grid& grid = true_grid(map);
  if (!grid.contains(cell)) return {"outside", 0, {}};
  if (grid.blocked(cell)) return {is_unknown(map, cell) ? "unknown" : "obstacle", 0, {}};
  const auto [clearance, nearest] = nearest_blocked(grid, centre(cell), map.radius + 1);
  if (clearance > map.radius && map.grid().free(cell)) return {};  // a drive's grid has not grown
  return {"radius", clearance,
          !grid.contains(nearest)    ? "the edge of the map"
          : is_unknown(map, nearest) ? "an unknown cell"
                                     : "an obstacle"};
}

std::string obstruction_text(const LoadedMap& map, Frame frame, const Obstruction& why) {
  if (why.by == "outside") return " is outside the map";
  if (why.by == "unknown") return " is unknown, and blocked without --unknown-free";
  if (why.by == "radius")
    return " is too near to " + std::string(why.nearest) + ", " +
           length_text(map, frame, why.clearance) + " away: the radius is " +
           length_text(map, frame, map.radius, 6);
  return map.unknown || map.radius > 0 ? " is blocked by an obstacle" : " is blocked";
}

std::string metres_hint(const LoadedMap& map, Frame frame, const Place& place) {
  if (frame == Frame::world || !map.frame) return {};
  const Place meant = to_place(map, place.number, Frame::world);
  if (map.grid().blocked(meant.cell)) return {};
  return "; taken as metres, with --frame world, it is in the free cell " +
         place_text(meant, Frame::cell);
}

double metres_within(const LoadedMap& map, double cells) {
  double metres = std::nextafter(map.metres(cells), kNoLimit);
  while (metres / map.frame->resolution > cells) metres = std::nextafter(metres, 0);
  return metres;
}

Remedy widest_of(LoadedMap& map, Cell start, Cell goal, Corners corners,
                 const std::stop_token& token) {
  const Grid& grid = true_grid(map);
  if (std::int64_t{map.width} * map.height > Remedy::kMostCells) return {};
  auto& widest = map.widest[corners == Corners::allow ? 1 : 0];
  if (!widest) widest = WidestRadius::make(grid, corners, {.token = token});
  if (!widest || !grid.contains(start) || !grid.contains(goal)) return {};
  return {.searched = true, .widest_radius = widest->between(start, goal)};
}

Remedy remedy_of(LoadedMap& map, Cell start, Cell goal, Corners corners,
                 const std::stop_token& token) {
  Remedy remedy;
  if (map.radius > 0) remedy = widest_of(map, start, goal, corners, token);
  if (map.unknown && !map.unknown_is_free && !map.with_unknown_free)
    map.with_unknown_free = with_unknown_free(map, {.token = token});
  remedy.unknown_free =
      map.with_unknown_free && map.with_unknown_free->connected(start, goal, corners);
  return remedy;
}

std::string remedy_text(const LoadedMap& map, Frame frame, const Remedy& remedy) {
  std::string text;
  if (remedy.widest_radius)
    text = "; the widest radius that joins them is " +
           length_text(map, frame, *remedy.widest_radius, 3, true);
  else if (remedy.searched)
    text = "; no radius joins them";
  if (remedy.unknown_free) text += "; with --unknown-free they are joined";
  return text;
}

}  // namespace lasius::tool
