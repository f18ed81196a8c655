// The shortest path of a disc on a small bitmap, by brute force: a yardstick that shares no code
// with the library but `Grid`.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "lasius/grid/geometry.h"
#include "lasius/grid/grid.h"

namespace lasius::oracle {

/// Whole circles about all vertices of blocked squares, and of the squares around the map; all
/// lines that touch two of them; Dijkstra over the points where they touch. Each test of a point, a
/// line or an arc is a distance to all squares.
class DiscPaths {
 public:
  enum class Lines { all, none };
  /// Without lines it knows distances alone.
  DiscPaths(const Grid& grid, double radius, Lines lines = Lines::all);

  /// From a point to the nearest square.
  double clearance(Point p) const;
  /// From a segment to the nearest square.
  double clearance(Point a, Point b) const;
  /// Of an arc of less than a full turn, between two angles, from < to.
  double arc_clearance(Point centre, double from, double to) const;
  bool clear(Point p) const;

  /// Of a direction away from an end.
  using Price = std::function<double(Point)>;
  /// The length of a shortest path between two clear points; nothing where there is none. With
  /// prices of where it goes at its ends, the least sum of all taut ones that are not straight.
  std::optional<double> shortest(Point start, Point goal, const Price& at_start = {},
                                 const Price& at_goal = {});

 private:
  struct Way {
    int to;
    double length;
    int leaves, arrives;  // by which turn: 1 by growing angle, else -1; 0: at a point
  };
  struct Touch {
    int circle;
    double angle;
    Point at;
    std::vector<Way> ways = {};
  };

  void lines_between(std::vector<Touch>& touches, int a, Point ca, double ra, int b, Point cb,
                     double rb) const;
  bool keeps(Point a, Point b) const;

  double radius_;
  double limit_;
  std::vector<Point> squares_;  // their lesser corners
  std::vector<Point> circles_;
  std::vector<Touch> touches_;  // between circles
};

}  // namespace lasius::oracle
