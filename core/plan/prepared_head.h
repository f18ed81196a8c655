// What a file of a map's preparation begins with.
#pragma once

#include <string>
#include <string_view>

#include "lasius/grid/grid.h"

namespace lasius {

/// Before `text`, which holds the graph and, where `labels`, labels.
std::string prepared_head(const Grid& map, bool labels, std::string_view text);

}  // namespace lasius
