// How deep a JSON text nests, before anything that recurses is done with it.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace lasius {

/// Deeper than any document of ours.
inline constexpr int kDeepestJson = 64;

/// The byte at which lists and objects nest deeper than that, if they do.
inline std::optional<std::size_t> too_deep(std::string_view json) noexcept {
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (quoted && c == '\\') ++i;
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    depth += (c == '[' || c == '{') - (c == ']' || c == '}');
    if (depth > kDeepestJson) return i;
  }
  return std::nullopt;
}

}  // namespace lasius
