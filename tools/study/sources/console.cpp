#include "tools/study/sources/console.h"

#include <algorithm>

#include "tools/draw/text.h"

namespace lasius::tool {

std::filesystem::path find_maps(const std::string& option) {
  if (!option.empty()) return option;
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  const fs::path installed = program.parent_path() / LASIUS_INSTALLED_MAPS;
  return fs::is_directory(installed, ignored) ? installed : fs::path(LASIUS_SOURCE_MAPS);
}

std::string duration_text(double seconds) {
  if (seconds < 90) return study::fixed(std::max(1.0, seconds), 0) + " s";
  if (seconds < 5400) return study::fixed(seconds / 60, 0) + " min";
  return study::fixed(seconds / 3600, 1) + " h";
}

}  // namespace lasius::tool
