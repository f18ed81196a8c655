// Smooth noise in integers, a row at a time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/generate/map_random.h"

namespace lasius {

/// A sum of octaves of gradient noise (Perlin 1985, interpolated by 3t^2 - 2t^3), in fixed point.
class MapNoise {
 public:
  struct Octave {
    int pitch;   ///< cells between lattice points, >= 1
    int weight;  ///< 1 .. 16
  };

  MapNoise(int width, const MapRandom& random, std::span<const Octave> octaves);

  /// The values of row y, `width` of them, within +-2^28. Quick for rows in order.
  void row(int y, std::span<std::int32_t> values);

 private:
  struct Gradient {
    std::int32_t x, y;
  };
  struct Layer {
    Octave octave;
    std::vector<std::int32_t> offset;    // of a cell's centre from the lattice point, by cell
    std::vector<std::int32_t> blend;     // share of the next lattice point there
    std::vector<Gradient> above, below;  // of the lattice rows around the last row asked for
    int lattice_row = -1;
    std::vector<std::int32_t> base, slope;  // of each lattice column, on that row
  };

  void load_gradients(Layer& layer, std::uint32_t index, int lattice_row);
  void add_row(Layer& layer, int y, std::span<std::int32_t> values) const;

  const MapRandom random_;
  std::vector<Layer> layers_;
};

}  // namespace lasius
