#include <algorithm>
#include <array>
#include <cctype>
#include <ostream>

#include "core/base/file_kind.h"
#include "core/base/output.h"
#include "core/map_files/byte_reader.h"
#include "lasius/base/error.h"
#include "lasius/polygon/world.h"

namespace lasius::polygon {
namespace {

/// By its content; by its name where that could be neither. Precondition: it begins with no blank.
bool is_wkt(std::string_view text, const std::string& name) {
  const char first = text.front();
  if (first == '{') return false;
  if (first == '#') return true;
  constexpr std::array<std::string_view, 3> kJsonWords{"null", "true", "false"};
  const bool word = std::isalpha(static_cast<unsigned char>(first)) != 0 &&
                    std::ranges::none_of(kJsonWords, [&](auto w) { return text.starts_with(w); });
  return word || has_ending(name, ".wkt");
}

}  // namespace

World read_world(const std::string& path, const ReadOptions& options) {
  constexpr std::int64_t kMostBytes = 256 << 20;
  const std::string text = read_text(path, kMostBytes);
  std::size_t first = 0;
  while (first < text.size() && std::isspace(static_cast<unsigned char>(text[first])) != 0) ++first;
  if (first == text.size())
    throw Error(ErrorCode::file_broken, {.file = path}, "is empty", "give a GeoJSON or WKT world");
  refuse_other_kinds(text, path, {FileKind::geojson}, "give a GeoJSON or WKT world");
  const bool wkt = is_wkt(std::string_view(text).substr(first), path);
  return wkt ? parse_wkt(text, path, options) : parse_geojson(text, path, options);
}

void write_world(const World& world, const std::string& path) {
  write_file(path, [&](std::ostream& out) {
    out << (has_ending(path, ".wkt") ? to_wkt(world) : to_geojson(world));
  });
}

}  // namespace lasius::polygon
