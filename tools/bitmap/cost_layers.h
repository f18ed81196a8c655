// Costs as the command line gives them: files of values with their factors, and inflation.
#pragma once

#include <string>
#include <vector>

#include "lasius/cost_field.h"
#include "tools/bitmap/map_file.h"

namespace lasius::tool {

struct CostLayers {
  std::vector<std::string> files;  ///< FILE[*FACTOR], in their order
  std::string inflation;           ///< RADIUS,SCALING[,WEIGHT] in cells; empty: none
};

/// The weights of a map's cells: 1, each file's values times its factor, and the inflation.
/// @throws Error for files that are missing, broken or of another size; UsageError for the rest.
CostField cost_field(const LoadedMap& map, const CostLayers& layers);

}  // namespace lasius::tool
