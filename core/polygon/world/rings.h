// What is asked of rings and points in several places: area, bounds, words.
#pragma once

#include <string>
#include <vector>

#include "lasius/polygon/world.h"

namespace lasius::polygon {

/// Twice the area, positive where the ring runs counter-clockwise.
double doubled_area(const Ring& ring) noexcept;

/// The smallest upright box around a ring. Precondition: it has a point.
struct Bounds {
  Point low, high;
};
Bounds bounds_of(const Ring& ring) noexcept;

/// The outer ring, then the holes.
std::vector<const Ring*> rings_of(const Polygon& polygon);

/// From the segment ab to p.
double distance_to(Point a, Point b, Point p) noexcept;

/// Even-odd rule; the ring itself is inside, as far as numbers tell. For messages alone.
bool inside(const Ring& ring, Point p) noexcept;

/// A point in messages: "(3, 4.5)".
std::string text(Point p);

}  // namespace lasius::polygon
