// Maps made from a seed: the same bits on every machine.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "lasius/export.h"
#include "lasius/grid.h"

namespace lasius {

/// The kinds of generated maps; in brackets the density by default.
enum class MapKind {
  blobs,   ///< many irregular obstacles, cut from smooth noise (0.33)
  maze,    ///< corridors some cells wide, a tree with a few loops (0.25)
  rooms,   ///< rectangular rooms of many sizes with doors (0.1)
  city,    ///< blocks, streets and a few avenues at odd angles; buildings of many outlines (0.4)
  random,  ///< every cell by itself (0.2)
  open,    ///< a few large obstacles (0.12)
};

struct GenerateOptions {
  int width = 512;
  int height = 512;
  /// Share of blocked cells in [0, 1) that is aimed at; negative: the kind's own default. Noise
  /// (blobs, random, open) meets it; maze, rooms and city come as near as their shapes allow.
  double density = -1;
  std::uint64_t seed = 1;
};

/// The names of the kinds, in the order of MapKind.
LASIUS_EXPORT std::span<const std::string_view> map_kind_names() noexcept;

/// Makes a map. Integer arithmetic and Philox only, so equal on every machine.
/// @throws Error(invalid_parameter) for a size or density out of range.
LASIUS_EXPORT Grid generate(MapKind kind, const GenerateOptions& options = {});

}  // namespace lasius
