// Polygon worlds of 5 to 500 obstacles: the same paths at every scale, gaps, and margins against a
// disc that is swept over a fine bitmap.
#pragma once

#include <vector>

#include "bench/figure_table.h"

namespace lasius::bench {

/// `faults` counts paths that change with the scale.
std::vector<Figure> measure_scales(int worlds, int& faults);

/// `faults` counts plans that say unreachable or blocked where a disc passes.
std::vector<Figure> check_discs(int worlds, int& faults);

}  // namespace lasius::bench
