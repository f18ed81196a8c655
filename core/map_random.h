// Random numbers for generated maps, by what they are for: no state, so any order, any machine.
#pragma once

#include <Random123/philox.h>

#include <array>
#include <cstdint>

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
  using Draw = std::array<std::uint32_t, 4>;

  explicit MapRandom(std::uint64_t seed)
      : key_{{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}} {}

  /// Four random words of the place (a, b, c) in a stream.
  Draw at(MapStream stream, std::uint32_t a, std::uint32_t b = 0, std::uint32_t c = 0) const {
    const auto words = r123::Philox4x32()({{a, b, c, static_cast<std::uint32_t>(stream)}}, key_);
    return {words[0], words[1], words[2], words[3]};
  }

 private:
  r123::Philox4x32::key_type key_;
};

/// Uniform in [0, count) up to a bias of count / 2^32, from one random word.
constexpr int below(int count, std::uint32_t word) noexcept {
  return static_cast<int>(static_cast<std::uint64_t>(count) * word >> 32);
}

/// Random numbers one after another, of one place in a stream.
class MapDraws {
 public:
  MapDraws(const MapRandom& random, MapStream stream, std::uint32_t a = 0, std::uint32_t b = 0)
      : random_(&random), stream_(stream), a_(a), b_(b) {}

  std::uint32_t next() {
    if (used_ % 4 == 0) words_ = random_->at(stream_, used_ / 4, a_, b_);
    return words_[used_++ % 4];
  }
  /// Uniform in [0, count).
  int below(int count) { return lasius::below(count, next()); }
  /// Uniform in [low, high], low where the range is empty.
  int between(int low, int high) { return high <= low ? low : low + below(high - low + 1); }
  /// True in `share` of 256 cases.
  bool chance(int share) { return below(256) < share; }

 private:
  const MapRandom* random_;
  MapStream stream_;
  std::uint32_t a_;
  std::uint32_t b_;
  std::uint32_t used_ = 0;
  MapRandom::Draw words_{};
};

}  // namespace lasius
