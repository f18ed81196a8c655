#include <cctype>
#include <ostream>

#include "core/base/output.h"
#include "core/map_files/byte_reader.h"
#include "lasius/error.h"
#include "lasius/polygon_world.h"

namespace lasius::polygon {

World read_world(const std::string& path, const ReadOptions& options) {
  constexpr std::int64_t kMostBytes = 256 << 20;
  const std::string text = read_text(path, kMostBytes);
  std::size_t first = 0;
  while (first < text.size() && std::isspace(static_cast<unsigned char>(text[first])) != 0) ++first;
  if (first == text.size()) {
    throw Error(ErrorCode::file_broken, {.file = path}, "is empty", "give a GeoJSON or WKT world");
  }
  const char c = text[first];
  const bool json = std::isalpha(static_cast<unsigned char>(c)) == 0 && c != '#';
  return json ? parse_geojson(text, path, options) : parse_wkt(text, path, options);
}

void write_world(const World& world, const std::string& path) {
  write_file(path, [&](std::ostream& out) {
    out << (has_ending(path, ".wkt") ? to_wkt(world) : to_geojson(world));
  });
}

}  // namespace lasius::polygon
