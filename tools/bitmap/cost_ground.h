// Costs as pictures and pages show them under paths.
#pragma once

#include <array>
#include <vector>

#include "lasius/cost_field.h"
#include "lasius/cost_proof.h"
#include "tools/bitmap/sheet.h"
#include "tools/draw/legend.h"

namespace lasius::tool {

/// Of the weights of the free cells of a map.
ColourScale cost_scale(const CostField& costs, const Grid& map);
/// The mean weight of the free cells under a pixel as a colour.
Colour cost_ground(const CostField& costs, const Grid& map, const ColourScale& scale, Span columns,
                   Span rows);

/// The lines on which a proof's widest level has round values, as short pieces in cells: equal
/// costs to where it begins.
std::vector<std::array<Point, 2>> level_lines(const CostProof& proof, const Grid& map);

/// The weights for pages: width, height, shares (a byte a pixel, 0 the least), least, most.
Json weights_view_json(const CostField& costs, const Grid& map, const Window& window);

}  // namespace lasius::tool
