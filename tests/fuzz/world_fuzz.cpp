// Polygon worlds in GeoJSON and WKT. What is read is valid, and stays the same when it is written
// and read again; repaired worlds are valid too.
#include "lasius/polygon/world.h"
#include "tests/fuzz/reading.h"

namespace lasius::fuzz {
namespace {

std::optional<polygon::World> read(const std::string& text, bool json, bool repair) {
  try {
    return json ? polygon::parse_geojson(text, "fuzz", {.repair = repair})
                : polygon::parse_wkt(text, "fuzz", {.repair = repair});
  } catch (const Error& error) {
    require_named(error, text.size());
    return std::nullopt;
  }
}

}  // namespace

void check(const std::string& text) {
  const bool json = text.find('{') < text.find('(');
  if (const auto world = read(text, json, false)) {
    polygon::check(*world);
    require(read(polygon::to_geojson(*world), true, false) == world);
    if (world->start || !world->goal) require(read(polygon::to_wkt(*world), false, false) == world);
  }
  if (const auto world = read(text, json, true)) polygon::check(*world);
}

}  // namespace lasius::fuzz
