// Why a start or a goal is refused or not reached, and what would help.
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include "tools/bitmap/map_file.h"
#include "tools/record/json_values.h"

namespace lasius::tool {

/// A length in the unit of `frame`, as in "0.2855 m": to so many decimals, zeros at the end left
/// out; rounded down where `down`, so that --radius takes it for no more.
std::string length_text(const LoadedMap& map, Frame frame, double cells, int decimals = 3,
                        bool down = false);

/// A start or goal as it was given, as in "(3, 4)" or "1.2,0.5 m, in cell (3, 4),".
std::string place_text(const Place& place, Frame frame);

/// A place of a map, in metres too where those are in use: as in "(3, 4)" of a cell's centre, else
/// "the point (3.25, 4.5)".
std::string spot_text(const LoadedMap& map, Frame frame, Point at);

/// How an algorithm goes about: `exact` along a disc's curves from centre to centre, the others on
/// cells of the grown map, under a rule of corners.
struct Route {
  bool curved = false;
  Corners corners = Corners::forbid;  ///< unless curved

  bool joined(const Planner& planner, Cell start, Cell goal) const;
};

/// What keeps a place from being planned on.
struct Obstruction {
  std::string_view by = {};  ///< "outside", "obstacle", "unknown", "radius"; empty: nothing here
  double clearance = 0;      ///< with "radius": of its centre to what is blocked, cells
  std::string_view nearest = {};  ///< with "radius": what is so near
  bool in_part = false;           ///< the centre keeps the radius; `clearance` is the whole cell's
};
/// Of algorithms that go along a disc's curves, or on cells.
Obstruction obstruction_of(const LoadedMap& map, const Place& place, bool curved);
/// As in " is outside the map", to follow a place.
std::string obstruction_text(const LoadedMap& map, Frame frame, const Obstruction& why);

/// Where a cell's numbers would be in metres, if that is a free cell: they may have been meant.
std::string metres_hint(const LoadedMap& map, Frame frame, const Place& place);

/// That a radius below a cell may have been meant in metres; else empty.
std::string radius_hint(const LoadedMap& map, Frame frame);

/// What would join a start and a goal that lie in different regions.
struct Remedy {
  /// Maps of more cells are not searched for the widest radius: a colony's takes 24 bytes a cell.
  static constexpr std::int64_t kMostCells = std::int64_t{1} << 26;

  bool searched = false;                  ///< for the widest radius
  std::optional<double> widest_radius{};  ///< cells; nothing: no radius joins them
  bool unknown_free = false;              ///< --unknown-free would, with the radius as it is
};
/// The most metres that are at most so many cells, as --radius takes them. Precondition: a frame.
double metres_within(const LoadedMap& map, double cells);
/// Of free cells of the map as it was read. What it makes of the map stays with that.
Remedy remedy_of(LoadedMap& map, Cell start, Cell goal, const Route& route,
                 const std::stop_token& token);
/// The widest radius alone; nothing where none joins them, the map is too large, or an end outside.
Remedy widest_of(LoadedMap& map, Cell start, Cell goal, const Route& route,
                 const std::stop_token& token);
/// As in "; the widest radius that joins start and goal is 0.371 m", or empty.
std::string remedy_text(const LoadedMap& map, Frame frame, const Remedy& remedy);

}  // namespace lasius::tool
