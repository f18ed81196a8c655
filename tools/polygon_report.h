// Results on polygon worlds as JSON and plain text.
#pragma once

#include <string>

#include "options.h"
#include "polygon_answer.h"
#include "report.h"

namespace lasius::tool {

/// Keys in the order of the contract; `maklink` holds what polygon worlds add.
Json polygon_json(const PreparedWorld& world, const PolygonCommand& command,
                  const PolygonAnswer& answer);

/// Status, length and path, one vertex a line.
std::string polygon_text(const PolygonAnswer& answer);

}  // namespace lasius::tool
