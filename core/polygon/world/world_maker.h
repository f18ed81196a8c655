// Puts together the world that a file describes, whatever its format; every fault by its place.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "core/polygon/world/geos.h"
#include "core/polygon/world/repair.h"
#include "lasius/base/error.h"

namespace lasius::polygon {

class WorldMaker {
 public:
  /// Throws for a fault of the file; `place` says where, "feature 3 (obstacle)".
  using Fail = std::function<void(const std::string& place, const std::string& problem,
                                  const std::string& remedy)>;

  WorldMaker(const ReadOptions& options, Fail fail) : options_(options), fail_(std::move(fail)) {}

  const Geos& geos() const noexcept { return geos_; }
  bool has_boundary() const noexcept { return has_boundary_; }
  const World& so_far() const noexcept { return world_; }

  void add_boundary(Polygon polygon, const std::string& place);
  void add_obstacle(Polygon polygon, const std::string& place);
  void add_wall(Ring line, const std::string& place);
  void add_start(Point p, const std::string& place) { add_point(world_.start, p, "start", place); }
  void add_goal(Point p, const std::string& place) { add_point(world_.goal, p, "goal", place); }
  void set_margin(double margin, const std::string& place);
  /// A ring as a file has it, ended by its first point: without that.
  Ring closed(Ring points, const std::string& place) const;
  /// A coordinate system by name or code: one of degrees is noted, once.
  void set_crs(std::string_view name);
  World finish();

 private:
  Repair checked(Polygon polygon, bool is_boundary, const std::string& place);
  void add_point(std::optional<Point>& to, Point p, const std::string& what,
                 const std::string& place);

  ReadOptions options_;
  Fail fail_;
  Geos geos_;
  World world_;
  bool has_boundary_ = false;
  bool has_margin_ = false;
};

}  // namespace lasius::polygon
