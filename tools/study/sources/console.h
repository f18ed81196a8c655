// What the commands of studies find and tell alike.
#pragma once

#include <filesystem>
#include <string>

namespace lasius::tool {

/// Maps are looked for in the option's folder, else beside the installed program, else in the
/// source tree.
std::filesystem::path find_maps(const std::string& option);

/// "12 s", "3 min", "1.5 h".
std::string duration_text(double seconds);

}  // namespace lasius::tool
