// Files read whole.
#pragma once

#include <cstdint>
#include <string>

namespace lasius::arm {

/// @throws Error(file_missing) where it cannot be opened, (file_unsupported) above `most` bytes.
std::string read_text(const std::string& path, std::int64_t most);

/// `name` beside the file that names it.
std::string beside(const std::string& file, const std::string& name);

}  // namespace lasius::arm
