// Random numbers for generated maps, by what they are for: no state, so any order, any machine.
#pragma once

#include <array>
#include <cstdint>

#include "kernels/base/random_stream.h"

namespace lasius {

/// A use of random numbers; two uses never share any.
enum class MapStream : std::uint32_t {
  noise,
  maze,
  maze_loops,
  rooms,
  city,
  buildings,
  cells,
  samples
};

class MapRandom {
 public:
  explicit MapRandom(std::uint64_t seed) : seed_(seed) {}

  /// Four random words of the place (a, b, c) in a stream.
  std::array<std::uint32_t, 4> at(MapStream stream, std::uint32_t a, std::uint32_t b = 0,
                                  std::uint32_t c = 0) const {
    return kernels::random_words(seed_, {a, b, c, static_cast<std::uint32_t>(stream)});
  }

  std::uint64_t seed() const { return seed_; }

 private:
  std::uint64_t seed_;
};

/// Random numbers one after another, of one place in a stream.
class MapDraws : public kernels::RandomStream {
 public:
  MapDraws(const MapRandom& random, MapStream stream, std::uint32_t a = 0, std::uint32_t b = 0)
      : RandomStream(random.seed(), a, b, static_cast<std::uint32_t>(stream)) {}

  /// Uniform in [low, high], low where the range is empty.
  int between(int low, int high) { return high <= low ? low : low + below(high - low + 1); }
  /// True in `share` of 256 cases.
  bool chance(int share) { return below(256) < share; }
};

}  // namespace lasius
