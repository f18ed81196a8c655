// Maps made from a seed: the same bits on every machine.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "lasius/export.h"
#include "lasius/grid.h"

namespace lasius {

/// The kinds of generated maps.
enum class MapKind { blobs, maze, rooms, city, random, open };

struct GenerateOptions {
  int width = 512;
  int height = 512;
  /// Share of blocked cells in [0, 1) that is aimed at; negative: the kind's own default.
  double density = -1;
  std::uint64_t seed = 1;
};

/// The names of the kinds, in the order of MapKind.
LASIUS_EXPORT std::span<const std::string_view> map_kind_names() noexcept;

/// Makes a map. Integer arithmetic and Philox only, so equal on every machine.
/// @throws Error(invalid_parameter) for a size or density out of range.
LASIUS_EXPORT Grid generate(MapKind kind, const GenerateOptions& options = {});

}  // namespace lasius
