// The random stream of one ant.
#pragma once

#include <Random123/philox.h>

#include <array>
#include <cstdint>
#include <cstring>

namespace lasius::kernels {

/// Random words of ant `ant` in iteration `iteration`: word n is word n % 4 of Philox4x32-10 with
/// key = seed and counter (n / 4, ant, iteration, 0), as in the walk kernel.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::uint32_t ant, std::uint32_t iteration) noexcept
      : key_{{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}},
        ant_(ant),
        iteration_(iteration) {}

  std::uint32_t next() noexcept {
    if (used_ == 4) {
      const r123::Philox4x32::ctr_type counter{{block_++, ant_, iteration_, 0}};
      const auto words = philox4x32(counter, key_);
      std::memcpy(words_.data(), words.v, sizeof words.v);
      used_ = 0;
    }
    return words_[used_++];
  }

 private:
  r123::Philox4x32::key_type key_;
  std::uint32_t ant_;
  std::uint32_t iteration_;
  std::uint32_t block_ = 0;
  std::uint32_t used_ = 4;
  std::array<std::uint32_t, 4> words_{};
};

}  // namespace lasius::kernels
