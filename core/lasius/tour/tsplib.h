// Problems of TSPLIB (Reinelt 1991): files .tsp and .sop.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "lasius/export.h"
#include "lasius/grid/geometry.h"

namespace lasius {

/// A problem as its file tells it.
struct Tsplib {
  std::string name = {};           ///< NAME
  int size = 0;                    ///< places: DIMENSION
  std::vector<Point> places = {};  ///< of its NODE_COORD_SECTION, or empty
  /// Of its own rounding, row by row: symmetric but for .sop, where -1 from a to b says that b
  /// comes before a.
  std::vector<std::int32_t> matrix = {};
  bool ordered = false;  ///< TYPE: SOP
};

/// Reads TYPE TSP (EDGE_WEIGHT_TYPE EUC_2D, CEIL_2D, MAN_2D, MAX_2D, ATT, GEO, EXPLICIT) and SOP
/// (EXPLICIT, FULL_MATRIX). `name` is the file's in messages.
/// @throws Error(file_broken, file_unsupported) with the line.
LASIUS_EXPORT Tsplib read_tsplib(std::istream& in, const std::string& name);

}  // namespace lasius
