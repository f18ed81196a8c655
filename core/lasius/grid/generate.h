// Maps made from a seed: the same bits on every machine.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "lasius/base/stop.h"
#include "lasius/export.h"
#include "lasius/grid/grid.h"

namespace lasius {

/// The kinds of generated maps; in brackets the density by default, and at most.
enum class MapKind {
  blobs,   ///< many irregular obstacles, cut from smooth noise (0.33, 0.999)
  maze,    ///< corridors some cells wide, a tree with a few loops (0.25, 0.8)
  rooms,   ///< rectangular rooms of many sizes with doors (0.1, 0.35)
  city,    ///< blocks, streets, avenues at odd angles; buildings of many outlines (0.4, 0.5)
  random,  ///< every cell by itself (0.2, 0.999)
  open,    ///< a few large obstacles (0.12, 0.999)
};

/// What is made.
struct GenerateOptions {
  int width = 512;   ///< in cells, 1 to Grid::kMaxSide
  int height = 512;  ///< likewise
  /// Share of blocked cells that is aimed at, from 0 to max_density; negative: the kind's own
  /// default. Noise (blobs, random, open) meets it. From 0.1 and 200 x 200 cells on, maze and
  /// rooms stay up to a quarter below it; city scatters about it, the less the larger the map.
  double density = -1;
  std::uint64_t seed = 1;  ///< another one, another map
};

/// The names of the kinds, in the order of MapKind.
LASIUS_EXPORT std::span<const std::string_view> map_kind_names() noexcept;

/// The name of one, as in "maze".
LASIUS_EXPORT std::string_view to_string(MapKind kind) noexcept;

/// The largest density that a kind can be asked for. Precondition: it is one of MapKind.
LASIUS_EXPORT double max_density(MapKind kind) noexcept;

/// Makes a map. Integer arithmetic and Philox only, so equal on every machine.
/// @throws Error(invalid_parameter) for a size or density out of range.
LASIUS_EXPORT Grid generate(MapKind kind, const GenerateOptions& options = {});
/// The same, or empty if stopped.
[[nodiscard]] LASIUS_EXPORT std::optional<Grid> generate(MapKind kind,
                                                         const GenerateOptions& options,
                                                         const StopCondition& stop);

}  // namespace lasius
