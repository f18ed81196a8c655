// Results on polygon worlds as JSON and plain text.
#pragma once

#include <string>

#include "tools/bitmap/report.h"
#include "tools/options/options.h"
#include "tools/polygon/polygon_answer.h"

namespace lasius::tool {

/// Keys in the order of the contract; `maklink` holds what polygon worlds add.
Json polygon_json(const PreparedWorld& world, const PolygonCommand& command,
                  const PolygonAnswer& answer);

/// Status, length and path, one vertex a line.
std::string polygon_text(const PolygonAnswer& answer);

}  // namespace lasius::tool
