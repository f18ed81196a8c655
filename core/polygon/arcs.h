// How corners are rounded when an outline grows: an arc is made of tangents, so it lies inside.
#pragma once

#include <vector>

#include "lasius/polygon/world.h"

namespace lasius::polygon {

/// How many tangents an arc is made of.
enum class Tangents {
  many,  ///< their corners are at most 0.5% of the margin outside of the arc
  /// Corners at most the margin outside of the arc, so that lines are few; but `many` where another
  /// outline is so near that a corner could reach its growth. So no passage is lost.
  few,
};

/// By ring and corner: where the tangents meet, the edges' own among them; empty where the way
/// turns to the right. Rings have what grows on their left.
using Arcs = std::vector<std::vector<Ring>>;
Arcs arcs_of(const std::vector<Ring>& rings, double margin, Tangents tangents);

/// Of the edge from corner i on, to its right.
Point normal(const Ring& ring, std::size_t i);

}  // namespace lasius::polygon
