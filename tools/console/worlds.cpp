#include "tools/console/worlds.h"

#include <algorithm>
#include <vector>

#include "core/base/output.h"
#include "tools/console/exit_code.h"
#include "tools/console/parameters.h"
#include "tools/console/values.h"
#ifdef LASIUS_WITH_ARM
#include "lasius/arm_plan.h"
#endif
#ifdef LASIUS_WITH_POLYGON
#include "lasius/polygon_plan.h"
#endif

namespace lasius::tool {
namespace {

bool has_algorithm(const World& world, std::string_view name) {
  return std::ranges::any_of(world.algorithms, [&](const auto& a) { return a.name == name; });
}

}  // namespace

std::span<const World> worlds() {
  static const std::vector<World> kAll = {
      {World::Kind::bitmap, "algorithms", "", "on bitmaps", "", "", algorithms(),
       [](const Algorithm& a, std::string_view parameter) {
         return get_parameter(Params(a.name), parameter);
       },
       [](const Algorithm& a) { return lasius::formulas(Params(a.name)); }},
#ifdef LASIUS_WITH_ARM
      {World::Kind::arm, "arm_algorithms", "Arms, see `lasius arm --help`", "for arms", "",
       "; use `lasius arm`", arm::algorithms(),
       [](const Algorithm& a, std::string_view parameter) {
         return arm::get_parameter(arm::Params(a.name), parameter);
       },
       [](const Algorithm& a) { return arm::formulas(arm::Params(a.name)); }},
#endif
#ifdef LASIUS_WITH_POLYGON
      {World::Kind::polygon, "polygon_algorithms", "Polygon worlds, by `lasius plan WORLD.geojson`",
       "among polygons", " (.geojson, .json, .wkt)", "", polygon::algorithms(),
       [](const Algorithm& a, std::string_view parameter) {
         return polygon::get_parameter(polygon::Params(a.name), parameter);
       },
       [](const Algorithm& a) { return polygon::formulas(polygon::Params(a.name)); }},
#endif
  };
  return kAll;
}

std::string_view algorithm_of(World::Kind kind, std::string_view name) {
  const auto here = std::ranges::find(worlds(), kind, &World::kind);
  if (here == worlds().end()) return name;  // the command says that it was not built
  if (name.empty()) return here->algorithms.front().name;
  if (!has_algorithm(*here, name))
    for (const World& other : worlds())
      if (has_algorithm(other, name))
        throw UsageError(std::string("--algorithm: ")
                             .append(name)
                             .append(" plans ")
                             .append(other.plans)
                             .append(other.detail)
                             .append(", not ")
                             .append(here->plans)
                             .append(other.advice));
  const auto known = names_of(here->algorithms);
  return known[choice_value("--algorithm", name, known)];
}

bool is_polygon_file(std::string_view file) {
  return std::ranges::any_of(kPolygonFileEndings,
                             [&](std::string_view ending) { return has_ending(file, ending); });
}

}  // namespace lasius::tool
