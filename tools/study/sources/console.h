// What the commands of studies find and tell alike.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>

#include "tools/options/options.h"
#include "tools/study/study.h"

namespace lasius::tool {

/// The folder of maps: the option's, else beside the installed program, else in the source tree.
std::filesystem::path find_maps(const std::string& option);

/// Says once which settings none of these contenders, of bitmaps, reads.
void tell_unread(std::span<const study::Contender> contenders);

/// Shows how much of the work is done and what just ran, where progress is wanted.
std::function<void(std::int64_t done, std::int64_t total, const std::string& note)> progress_shown(
    const Messages& messages);

/// "12 s", "3 min", "1.5 h".
std::string duration_text(double seconds);

}  // namespace lasius::tool
