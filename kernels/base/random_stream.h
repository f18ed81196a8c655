// Random words by what they are for: Philox4x32-10, no state but a counter.
#pragma once

#include <Random123/philox.h>

#include <array>
#include <cstdint>
#include <cstring>

namespace lasius::kernels {

/// Four random words: Philox4x32-10 of the counter with the seed as key.
inline std::array<std::uint32_t, 4> random_words(
    std::uint64_t seed, const std::array<std::uint32_t, 4>& counter) noexcept {
  const r123::Philox4x32::key_type key{
      {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}};
  const r123::Philox4x32::ctr_type at{{counter[0], counter[1], counter[2], counter[3]}};
  const auto drawn = philox4x32(at, key);
  std::array<std::uint32_t, 4> words;
  std::memcpy(words.data(), drawn.v, sizeof drawn.v);
  return words;
}

/// Uniform in [0, count) up to a bias of count / 2^32, from one random word.
constexpr int below(int count, std::uint32_t word) noexcept {
  return static_cast<int>(static_cast<std::uint64_t>(count) * word >> 32);
}

/// Random words one after another. Word n of ant `ant` in iteration `iteration` is word n % 4 of
/// the counter (n / 4, ant, iteration, use), as in the walk kernel, where the use is 0.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::uint32_t ant, std::uint32_t iteration,
               std::uint32_t use = 0) noexcept
      : seed_(seed), ant_(ant), iteration_(iteration), use_(use) {}

  std::uint32_t next() noexcept {
    if (used_ == 4) {
      words_ = random_words(seed_, {block_++, ant_, iteration_, use_});
      used_ = 0;
    }
    return words_[used_++];
  }
  /// Uniform in [0, count).
  int below(int count) noexcept { return kernels::below(count, next()); }
  /// True with this probability.
  bool chance(double share) noexcept { return next() < share * 0x1p32; }

 private:
  std::uint64_t seed_;
  std::uint32_t ant_;
  std::uint32_t iteration_;
  std::uint32_t use_;
  std::uint32_t block_ = 0;
  std::uint32_t used_ = 4;
  std::array<std::uint32_t, 4> words_{};
};

}  // namespace lasius::kernels
