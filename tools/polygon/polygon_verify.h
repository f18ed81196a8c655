// A result on a polygon world, planned again from its recorded inputs.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <stop_token>
#include <string>

#include "tools/bitmap/report.h"

namespace lasius::tool {

/// @throws Error, UsageError or Json::exception where the inputs are not usable, or the world in
/// `file` is not the one recorded.
Json polygon_replay(const Json& result, const std::string& file, int threads,
                    const std::stop_token& token);

}  // namespace lasius::tool
