// Arrays as a page holds them: zlib streams in base64, see page/packed.js.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace lasius::tool {

/// @throws std::runtime_error where zlib has no memory.
std::string packed(std::span<const std::uint8_t> bytes);

/// Numbers, as floats of four bytes, little-endian.
std::string packed(std::span<const float> values);

/// Frames of one size, one after another, each as its difference to the one before, modulo 256.
std::string packed_frames(const std::vector<std::vector<std::uint8_t>>& frames);

}  // namespace lasius::tool
