// A map file made ready for planning.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "lasius/grid/clearance.h"
#include "lasius/grid/map_io.h"
#include "lasius/plan/planner.h"
#include "tools/bitmap/cost_layers.h"
#include "tools/options/options.h"

namespace lasius::tool {

struct LoadedMap {
  std::string file;
  std::string image;       ///< that a ROS map names
  std::uint64_t hash = 0;  ///< of the grid as read, before obstacles grow
  int width = 0;
  int height = 0;
  std::optional<WorldFrame> frame;
  bool unknown_is_free = false;
  double radius = 0;                 ///< cells
  bool prepare = false;              ///< more was asked for: see Planner::preparation
  bool labels = false;               ///< the same of hub labels
  std::string prepared = {};         ///< a file of them
  std::optional<Planner> planner{};  ///< nothing: the token fired before it was made
  std::optional<Grid> grid_alone{};  ///< without a planner: the grid as read
  std::optional<Grid> unknown{};     ///< as Map::unknown
  std::optional<LoadedCosts> costs{};
  double read_ms = 0;   ///< reading
  double ready_ms = 0;  ///< making the planner, growing obstacles
  /// Made when reasons.h needs them: of the map, with 4 and 8 neighbours; with unknown cells free.
  std::array<std::optional<WidestRadius>, 2> widest{};
  std::optional<Planner> with_unknown_free{};

  /// The cells that are planned on: grown by the radius, but for a drive's.
  const Grid& grid() const { return planner ? planner->passable() : *grid_alone; }
  /// Before obstacles grew.
  const Grid& as_read() const { return planner ? planner->grid() : *grid_alone; }
  bool grown() const { return planner && radius > 0; }

  // Precondition of these: the map has a frame.
  Point to_world(Point cells) const { return frame->to_world(cells, height); }
  std::vector<Point> to_world(const std::vector<Point>& path) const;
  double metres(double cells) const { return cells * frame->resolution; }

  /// A length in cells as `wanted` gives it: in metres in the world frame.
  double length_in(Frame wanted, double cells) const {
    return wanted == Frame::world ? metres(cells) : cells;
  }
  /// A length that was given in metres, or in cells, in cells.
  double cells_of(bool metres, double length) const;
};

/// Reads a map without growing obstacles: no planner, `radius` as asked for.
/// @throws Error; UsageError where metres are asked for and the file gives no frame.
LoadedMap read_map(const MapOptions& options, Frame frame);

/// Reads a map and makes it ready for plans under a rule of corners, by so many threads. `token`
/// ends what follows the reading. @throws as read_map.
LoadedMap load_map(const MapOptions& options, Frame frame = Frame::cell,
                   Corners corners = Corners::forbid, int threads = 1,
                   const std::stop_token& token = {});

/// Does what --prepare asks for, for a map with a planner.
void prepare(LoadedMap& map, int threads, const std::stop_token& token);

/// A start or a goal.
struct Place {
  Cell cell{};     ///< one far outside stays outside
  Point number{};  ///< its column and row, whole: told as they are, even where no map holds them
  Point asked{};   ///< as it was given: the cell's numbers, or metres in the world frame
  std::optional<Point> point{};  ///< in cells: where the path goes in place of the cell's centre

  Point at() const { return point.value_or(Point{number.x + 0.5, number.y + 0.5}); }
};

/// The place of a point of the command line or a query file, given in `frame`. A cell of a map
/// holds its left and its lower edge, in the map's own axes: so the world frame's origin is in the
/// first.
Place to_place(const LoadedMap& map, Point point, Frame frame);

/// The same where that may be a point: then the cell is one that it touches, a free one if there is
/// any. Metres that are a cell's centre or edge but for rounding are it.
Place end_place(const LoadedMap& map, const End& end, Frame frame);

/// The place of a cell, as if it had been given in `frame`.
Place place_of(const LoadedMap& map, Point cell, Frame frame);

}  // namespace lasius::tool
