// Polygon worlds: a boundary, obstacles, a start and a goal in the plane; GeoJSON and WKT.
//
// Coordinates are plain planar ones, x to the right and y up, in any unit (the figures of papers
// are metres).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"
#include "lasius/grid/map_io.h"
#include "lasius/polygon_export.h"

namespace lasius::polygon {

/// Vertices in order, the first not repeated at the end; either orientation.
using Ring = std::vector<Point>;

/// An area with straight edges.
struct Polygon {
  Ring outer;               ///< its outline
  std::vector<Ring> holes;  ///< inside of it, not part of the area
  friend bool operator==(const Polygon&, const Polygon&) = default;
};

/// What a planner plans in. Reading a world and `check` see to what is said of it here.
struct World {
  Polygon boundary;                ///< its holes are obstacles
  std::vector<Polygon> obstacles;  ///< they may overlap, and reach out of the boundary
  std::optional<Point> start;      ///< of a request that names none
  std::optional<Point> goal;       ///< likewise
  double margin = 0;               ///< of a disc, at least 0: its centre keeps that from obstacles
  /// Obstacles of no width, each a line of two points or more: a path may touch one and slide along
  /// it, but not cross it. A closed line ends with its first point.
  std::vector<Ring> walls = {};
  std::vector<std::string> notes = {};  ///< what reading it has to say to people; compared by none
  friend bool operator==(const World& a, const World& b) {
    return a.boundary == b.boundary && a.obstacles == b.obstacles && a.start == b.start &&
           a.goal == b.goal && a.margin == b.margin && a.walls == b.walls;
  }
};

/// A hash of all numbers of a world, and of nothing else.
LASIUS_POLYGON_EXPORT std::uint64_t hash(const World& world) noexcept;

/// How a world is read.
struct ReadOptions {
  bool repair = false;  ///< geometry that is not valid is repaired, not refused
};

/// Reads a world, GeoJSON or WKT told apart by content.
///
/// GeoJSON: a FeatureCollection in planar coordinates. Each feature's property `role` is `boundary`
/// (one Polygon), `obstacle` (Polygon, LineString, Multi- of both, GeometryCollection), `start` or
/// `goal` (Point); holes are allowed. The collection's member `margin`, or that of its member
/// `properties`, is the robot's.
///
/// WKT: one or more geometries, one after another or in GEOMETRYCOLLECTIONs, each with or without
/// EWKT's "SRID=NUMBER;". The first POLYGON is the boundary; all further POLYGONs, LINESTRINGs,
/// LINEARRINGs and MULTI- of them are obstacles; the first POINT is the start, the second the goal.
/// What follows a # is a comment, but for "margin NUMBER" alone: the robot's.
///
/// Lines become walls. Empty obstacles are passed over, an empty boundary or point is refused. A
/// coordinate system in degrees is told in World::notes.
///
/// Geometry is checked: every ring has at least three distinct corners, is closed, does not cross
/// itself or another ring of its polygon; every line has two distinct points. Zero-length edges are
/// dropped.
/// @throws Error(file_missing, file_broken, file_unsupported above 256 MiB), naming the file, the
///         line and byte or the feature, ring and point, and the remedy.
LASIUS_POLYGON_EXPORT World read_world(const std::string& path, const ReadOptions& options = {});

/// The same from GeoJSON; `name` stands for the file in errors.
LASIUS_POLYGON_EXPORT World parse_geojson(std::string_view text, const std::string& name,
                                          const ReadOptions& options = {});
/// The same from WKT.
LASIUS_POLYGON_EXPORT World parse_wkt(std::string_view text, const std::string& name,
                                      const ReadOptions& options = {});

/// A feature a line, readable by `parse_geojson`, of any world: it is not checked.
LASIUS_POLYGON_EXPORT std::string to_geojson(const World& world);
/// The world as WKT, a geometry a line, readable by `parse_wkt`; the margin is a comment.
/// @throws Error(invalid_parameter) for a world that `check` refuses, and a goal without a start,
///         which would be read as one.
LASIUS_POLYGON_EXPORT std::string to_wkt(const World& world);

/// Writes GeoJSON or, to names that end in .wkt, WKT; whole or not at all.
/// @throws Error(output_failed); to WKT as to_wkt.
LASIUS_POLYGON_EXPORT void write_world(const World& world, const std::string& path);

/// Checks a world that a program made. @throws Error(invalid_parameter) for what `read_world`
/// refuses.
LASIUS_POLYGON_EXPORT void check(const World& world);

/// The blocked cells of a bitmap as obstacles of `resolution` per cell, the map's lower left corner
/// at (origin_x, origin_y) of `frame`; its yaw must be 0. Cells that touch at a corner become
/// obstacles that touch there.
/// @throws Error(invalid_parameter) for a turned frame or a resolution that is not above 0.
LASIUS_POLYGON_EXPORT World from_grid(const Grid& grid, const WorldFrame& frame = {});

/// A bitmap of `resolution` per cell, its lower left corner at that of the boundary's bounding box:
/// a cell is free where its centre lies in the free space, obstacles grown by the margin included,
/// and no wall passes through it.
/// @throws Error(invalid_parameter) for a resolution that is not above 0 or gives too many cells.
LASIUS_POLYGON_EXPORT Map to_grid(const World& world, double resolution);

}  // namespace lasius::polygon
