#include "lasius/grid/generate.h"

#include <array>
#include <string>

#include "core/base/invalid_parameter.h"
#include "core/base/number_text.h"
#include "core/base/poller.h"
#include "core/generate/generate_kinds.h"
#include "lasius/base/enum_names.h"

namespace lasius {
namespace {

struct Kind {
  std::string_view name;
  double density;  // by default
  double most;
  void (*make)(Grid&, BlockedShare, const MapRandom&, Poller&);
};

constexpr std::array<Kind, 6> kKinds = {{{"blobs", 0.33, 0.999, make_blobs},
                                         {"maze", 0.25, 0.8, make_maze},
                                         {"rooms", 0.1, 0.35, make_rooms},
                                         {"city", 0.4, 0.5, make_city},
                                         {"random", 0.2, 0.999, make_random},
                                         {"open", 0.12, 0.999, make_open}}};

constexpr auto kNames = [] {
  std::array<std::string_view, kKinds.size()> names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = kKinds[i].name;
  return names;
}();

}  // namespace

std::span<const std::string_view> map_kind_names() noexcept { return kNames; }

std::string_view to_string(MapKind kind) noexcept { return name_of(kind, kNames); }

double max_density(MapKind kind) noexcept { return kKinds[static_cast<std::size_t>(kind)].most; }

Grid generate(MapKind kind, const GenerateOptions& options) { return *generate(kind, options, {}); }

std::optional<Grid> generate(MapKind kind, const GenerateOptions& options,
                             const StopCondition& stop) {
  if (static_cast<std::size_t>(kind) >= kKinds.size())
    refuse("the kind of map is none", "take one of MapKind");
  const Kind& entry = kKinds[static_cast<std::size_t>(kind)];
  if (!(options.density <= entry.most))
    refuse("the density of " + std::string(entry.name) + " is " + number_text(options.density),
           "it is at most " + number_text(entry.most) + "; negative: the kind's own");
  const double density = options.density < 0 ? entry.density : options.density;
  Grid grid(options.width, options.height);
  Poller poller(stop);
  entry.make(grid, static_cast<BlockedShare>(density * 4294967296.0), MapRandom(options.seed),
             poller);
  if (poller.stopped()) return std::nullopt;
  return grid;
}

std::uint32_t integer_sqrt(std::uint64_t n) noexcept {
  std::uint64_t root = 0;
  for (std::uint64_t bit = std::uint64_t{1} << 31; bit != 0; bit >>= 1)
    if ((root + bit) * (root + bit) <= n) root += bit;
  return static_cast<std::uint32_t>(root);
}

}  // namespace lasius
