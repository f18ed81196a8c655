// Costs as pictures and pages show them under paths.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "lasius/cost/field.h"
#include "lasius/cost/proof.h"
#include "tools/bitmap/sheet.h"
#include "tools/draw/legend.h"

namespace lasius::tool {

/// Of the weights of the free cells of a map.
ColourScale cost_scale(const CostField& costs, const Grid& map);
/// The mean weight of the free cells under a pixel as a colour.
Colour cost_ground(const CostField& costs, const Grid& map, const ColourScale& scale, Span columns,
                   Span rows);

/// What has the lines of equal cost of an answer: its own proof, or one made for them, between the
/// centres of cells and of a point, without a target gap, whose search would look at fewer cells;
/// null where there is no path, or one through points. `stop` is the plan's, whose limit begins
/// anew.
std::shared_ptr<const CostProof> shown_proof(const LoadedMap& map, const RunOptions& run,
                                             const Answer& answer, const StopCondition& stop);

/// The lines on which a proof's potential has round values, so far apart; short pieces in cells.
struct ShownLines {
  double apart = 0;
  std::vector<std::array<Point, 2>> lines = {};
};
ShownLines shown_lines(const CostProof& proof, const Grid& map);

/// The weights for pages: width, height, shares (a byte a pixel, 0 the least), least, most.
Json weights_view_json(const CostField& costs, const Grid& map, const Window& window);

}  // namespace lasius::tool
