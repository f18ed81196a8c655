#include "tools/study/sources/console.h"

#include <algorithm>
#include <map>
#include <memory>

#include "tools/console/progress.h"
#include "tools/console/streams.h"
#include "tools/draw/text.h"
#include "tools/study/runner.h"

namespace lasius::tool {

std::filesystem::path find_maps(const std::string& option) {
  if (!option.empty()) return option;
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  const fs::path installed = program.parent_path() / LASIUS_INSTALLED_MAPS;
  return fs::is_directory(installed, ignored) ? installed : fs::path(LASIUS_SOURCE_MAPS);
}

void tell_unread(std::span<const study::Contender> contenders) {
  std::map<std::pair<std::string, std::string>, std::string> reasons;  // empty: one reads it
  for (const study::Contender& c : contenders) {
    const Params params = study::configured(Params(c.algorithm, c.preset), c);
    for (const auto& [name, value] : c.settings) {
      const std::string why = why_unread(params, name);
      const auto at = reasons.try_emplace({c.algorithm, name}, why).first;
      if (why.empty()) at->second.clear();
    }
  }
  for (const auto& [setting, why] : reasons)
    if (!why.empty()) message(setting.second + " of " + setting.first + " has no effect: " + why);
}

std::function<void(std::int64_t, std::int64_t, const std::string&)> progress_shown(
    const Messages& messages) {
  constexpr std::int64_t kParts = 1000;
  const auto bar = std::make_shared<ProgressLine>(wants_progress(messages), kParts);
  return [bar](std::int64_t done, std::int64_t total, const std::string& note) {
    bar->update(done * kParts / std::max<std::int64_t>(total, 1), note);
  };
}

std::string duration_text(double seconds) {
  if (seconds < 90) return fixed(std::max(1.0, seconds), 0) + " s";
  if (seconds < 5400) return fixed(seconds / 60, 0) + " min";
  return fixed(seconds / 3600, 1) + " h";
}

}  // namespace lasius::tool
