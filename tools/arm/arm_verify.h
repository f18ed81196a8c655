// A result of `lasius arm`, planned again from its recorded inputs.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <stop_token>
#include <string>

#include "tools/bitmap/report.h"

namespace lasius::tool {

/// Robot and scene are read from these files.
/// @throws Error, UsageError or Json::exception where the inputs are not usable, or a file is not
/// the one recorded.
Json arm_replay(const Json& result, const std::string& robot, const std::string& scene, int threads,
                const std::stop_token& token);

}  // namespace lasius::tool
